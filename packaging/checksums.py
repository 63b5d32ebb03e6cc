"""Writes SHA256SUMS for all files of a folder. Needs Python 3.11 or later; `cargo xtask dist` and `wheels` run it.

    python3 packaging/checksums.py FOLDER
"""

import sys
from pathlib import Path

from gather import LIST, digest

folder = Path(sys.argv[1])
files = sorted(file for file in folder.iterdir() if file.is_file() and file.name != LIST)
text = "".join(f"{digest(file)}  {file.name}\n" for file in files)
(folder / LIST).write_bytes(text.encode())
print(text, end="")
