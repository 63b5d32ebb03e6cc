"""Is the checkout ready to be released under a tag? Needs Python 3.11 or later and git, and nothing else.

    python3 packaging/ready.py v0.1.0            says what is missing; exit code 1 if anything is
    python3 packaging/ready.py --notes v0.1.0    prints what the changelog says of this version
"""

import re
import subprocess
import sys
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PLACEHOLDER = re.compile(r"\bOWNER(?:/soilctl|\.github\.io)")


def read(name):
    return (ROOT / name).read_text(encoding="utf-8")


def notes(version):
    """The section of a version in the changelog, without its heading; None if there is none with a date."""
    found = re.search(rf"^## \[{re.escape(version)}\] - \d{{4}}-\d\d-\d\d\n(.*?)(?=^## |^\[|\Z)", read("CHANGELOG.md"), re.M | re.S)
    return found and found.group(1).strip() + "\n"


def missing(tag):
    """What is not ready, in words."""
    workspace = tomllib.loads(read("Cargo.toml"))["workspace"]
    version = workspace["package"]["version"]
    if tag != f"v{version}":
        yield f"the tag is {tag}, but the version in Cargo.toml is {version}"
    for name, dependency in workspace["dependencies"].items():
        if "path" in dependency and dependency.get("version") != version:
            yield f"Cargo.toml asks for version {dependency.get('version')} of {name}, which is {version}"
    for name in ["Cargo.lock", "fuzz/Cargo.lock"]:
        for package in tomllib.loads(read(name))["package"]:
            if "source" not in package and package["name"] != "soilctl-fuzz" and package["version"] != version:
                yield f"{name} has version {package['version']} of {package['name']}"
    for name, pattern in [("CITATION.cff", r"^version: \"?([^\"\s]+)"), ("packaging/conda/recipe.yaml", r"^  version: \"?([^\"\s]+)")]:
        found = re.search(pattern, read(name), re.M)
        if not found or found.group(1) != version:
            yield f"{name} does not name the version {version}"
    if not notes(version):
        yield f"CHANGELOG.md has no section \"## [{version}] - YEAR-MONTH-DAY\" with anything in it"
    files = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, check=True).stdout.decode().split("\0")
    for name in filter(None, files):
        if not (ROOT / name).is_file():
            continue
        try:
            text = read(name)
        except UnicodeDecodeError:
            continue
        if PLACEHOLDER.search(text):
            yield f"{name} still has the placeholder for the owner of the repository: see RELEASING.md"


def main(words):
    if len(words) == 2 and words[0] == "--notes":
        text = notes(words[1].removeprefix("v"))
        if text is None:
            sys.exit(f"CHANGELOG.md has no section for {words[1]}")
        print(text, end="")
    elif len(words) == 1 and not words[0].startswith("-"):
        problems = list(missing(words[0]))
        print("\n".join(problems) or "ready")
        sys.exit(bool(problems))
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main(sys.argv[1:])
