"""Makes one folder, with one list of checksums, of what several machines built. Needs Python 3.11 or later.

    python3 packaging/gather.py BUILT RELEASE

Each folder in BUILT holds what one machine left in target/dist. Files that a SHA256SUMS there lists are checked against it. RELEASE is
made, with all files side by side and a new SHA256SUMS. Two different files of one name are an error.
"""

import hashlib
import shutil
import sys
from pathlib import Path

LIST = "SHA256SUMS"


def digest(file):
    with open(file, "rb") as opened:
        return hashlib.file_digest(opened, "sha256").hexdigest()


def listed(file):
    """What a list of checksums says, by path from its folder."""
    rows = (line.split(maxsplit=1) for line in file.read_text(encoding="utf-8").splitlines() if line.strip())
    return {name.lstrip("*"): checksum for checksum, name in rows}


def check(folder):
    """Compares a folder with the lists in it."""
    for file in sorted(folder.rglob(LIST)):
        for name, checksum in listed(file).items():
            there = file.parent / name
            if not there.is_file():
                sys.exit(f"{file} lists {name}, which is not there")
            if digest(there) != checksum:
                sys.exit(f"{there} is not what {file} says: {digest(there)}")


def gather(built, release):
    release.mkdir(parents=True)
    sums = {}
    for folder in sorted(path for path in built.iterdir() if path.is_dir()):
        check(folder)
        for file in sorted(path for path in folder.rglob("*") if path.is_file() and path.name != LIST):
            checksum = digest(file)
            if sums.setdefault(file.name, checksum) != checksum:
                sys.exit(f"there are two different files of the name {file.name}; the second is {file}")
            shutil.copyfile(file, release / file.name)
    if not sums:
        sys.exit(f"there is nothing in {built}")
    text = "".join(f"{checksum}  {name}\n" for name, checksum in sorted(sums.items()))
    (release / LIST).write_text(text, encoding="utf-8")
    print(text, end="")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    gather(Path(sys.argv[1]), Path(sys.argv[2]))
