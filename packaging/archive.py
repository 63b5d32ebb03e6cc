"""Packs the program for a release. Needs Python 3.11 or later; `cargo xtask dist` runs it.

    python3 packaging/archive.py --target T --version V --program FILE --runs-here FILE --objcopy FILE --cargo FILE --out FOLDER

Two archives are written to FOLDER: soilctl-V-T with the program stripped of its symbols, completions for shells, man pages and the
notices of everything that is linked into it, and soilctl-V-T-symbols. What is in them depends on the source alone: files have one
date, one owner and a fixed order.
"""

import argparse
import gzip
import io
import json
import os
import subprocess
import sys
import tarfile
import tempfile
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
SHELLS = {"bash": "soilctl.bash", "zsh": "_soilctl", "fish": "soilctl.fish", "powershell": "_soilctl.ps1", "elvish": "soilctl.elv"}
# The first day that a zip file can name.
DATE = (1980, 1, 1, 0, 0, 0)
DATE_S = 315532800


def stripped(program, objcopy, target, folder):
    """The program without symbols, and its symbols by name."""
    small, symbols = folder / program.name, folder / f"{program.name}.debug"
    if "apple" in target:
        # The linker left the symbols beside the object files; dsymutil gathers them.
        bundle = folder / f"{program.name}.dSYM"
        subprocess.run(["dsymutil", program, "-o", bundle], check=True)
        subprocess.run(["strip", "-S", "-x", "-o", small, program], check=True)
        files = [file for file in sorted(bundle.rglob("*")) if file.is_file()]
        return small, {str(file.relative_to(folder)): file.read_bytes() for file in files}
    if "msvc" in target:
        database = program.with_suffix(".pdb")
        return program, {database.name: database.read_bytes()}
    # It comes with the compiler, and so does what it is linked with, which it does not find by itself.
    environment = {**os.environ, "LD_LIBRARY_PATH": str(objcopy.resolve().parents[3])}
    subprocess.run([objcopy, "--only-keep-debug", program, symbols], check=True, env=environment)
    subprocess.run([objcopy, "--strip-all", f"--add-gnu-debuglink={symbols}", program, small], check=True, env=environment)
    return small, {symbols.name: symbols.read_bytes()}


def said(program, *words):
    return subprocess.run([program, *words], check=True, capture_output=True).stdout


def beside(runs_here):
    """What comes with the program, by name."""
    files = {f"completions/{name}": said(runs_here, "completions", shell) for shell, name in SHELLS.items()}
    with tempfile.TemporaryDirectory() as folder:
        said(runs_here, "man", folder)
        files |= {f"man/{page.name}": page.read_bytes() for page in Path(folder).iterdir()}
    for name in ["README.md", "CHANGELOG.md", "LICENSE-MIT", "LICENSE-APACHE"]:
        files[name] = (ROOT / name).read_bytes()
    return files


def notices(cargo, target):
    """Licence texts of the packages that are linked into the program, as they came with them."""
    words = ["metadata", "--format-version", "1", "--locked", "--filter-platform", target]
    told = json.loads(subprocess.run([cargo, *words], check=True, capture_output=True, cwd=ROOT).stdout)
    packages = {package["id"]: package for package in told["packages"]}
    nodes = {node["id"]: node for node in told["resolve"]["nodes"]}
    linked, left = set(), [next(p["id"] for p in told["packages"] if p["name"] == "soilctl" and p["source"] is None)]
    while left:
        one = left.pop()
        if one in linked:
            continue
        linked.add(one)
        for needed in nodes[one]["deps"]:
            if any(kind["kind"] is None for kind in needed["dep_kinds"]):
                left.append(needed["pkg"])
    text = io.StringIO()
    print("The program contains these packages, under the licences given with each.", file=text)
    for package in sorted((packages[one] for one in linked), key=lambda p: (p["name"], p["version"])):
        if package["source"] is None:
            continue
        print(f"\n{'=' * 100}\n{package['name']} {package['version']}: {package['license'] or 'see below'}", file=text)
        if package["authors"]:
            print(f"by {', '.join(package['authors'])}", file=text)
        folder = Path(package["manifest_path"]).parent
        for file in sorted(folder.iterdir(), key=lambda file: file.name):
            if file.is_file() and file.name.upper().startswith(("LICENSE", "LICENCE", "COPYING", "NOTICE", "UNLICENSE")):
                print(f"\n--- {file.name}\n{file.read_text(encoding='utf-8', errors='replace').strip()}", file=text)
    return text.getvalue().encode()


def pack(file, files, programs):
    """Writes an archive of files by name; those in `programs` may be run."""
    top = file.name.removesuffix(".zip").removesuffix(".tar.gz")
    if file.suffix == ".zip":
        with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as packed:
            for name in sorted(files):
                info = zipfile.ZipInfo(f"{top}/{name}", DATE)
                info.compress_type = zipfile.ZIP_DEFLATED
                info.create_system = 3
                info.external_attr = (0o755 if name in programs else 0o644) << 16
                packed.writestr(info, files[name])
        return
    tarred = io.BytesIO()
    with tarfile.open(fileobj=tarred, mode="w", format=tarfile.USTAR_FORMAT) as packed:
        for name in sorted(files):
            info = tarfile.TarInfo(f"{top}/{name}")
            info.size, info.mtime, info.mode = len(files[name]), DATE_S, 0o755 if name in programs else 0o644
            packed.addfile(info, io.BytesIO(files[name]))
    with open(file, "wb") as out, gzip.GzipFile("", "wb", 9, out, mtime=DATE_S) as zipped:
        zipped.write(tarred.getvalue())


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ["target", "version"]:
        parser.add_argument(f"--{name}", required=True)
    for name in ["program", "runs-here", "objcopy", "cargo", "out"]:
        parser.add_argument(f"--{name}", required=True, type=Path)
    asked = parser.parse_args()
    asked.out.mkdir(parents=True, exist_ok=True)
    ending = ".zip" if "windows" in asked.target else ".tar.gz"
    name = f"soilctl-{asked.version}-{asked.target}"
    with tempfile.TemporaryDirectory() as folder:
        small, symbols = stripped(asked.program, asked.objcopy, asked.target, Path(folder))
        files = {asked.program.name: small.read_bytes(), "THIRD-PARTY-NOTICES.txt": notices(asked.cargo, asked.target)}
        size = small.stat().st_size
    files |= beside(asked.runs_here)
    pack(asked.out / f"{name}{ending}", files, {asked.program.name})
    pack(asked.out / f"{name}-symbols{ending}", symbols, set())
    print(f"{name}{ending}: {len(files)} files, the program has {size / 1e6:.1f} MB", file=sys.stderr)


if __name__ == "__main__":
    main()
