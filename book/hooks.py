"""Hooks of MkDocs: pages made from the code, and links out of the documentation.

Called by `mkdocs build`, see mkdocs.yml.
"""

import os
import re
import sys
from pathlib import Path

from mkdocs.plugins import get_plugin_logger
from mkdocs.structure.files import File

sys.path.insert(0, str(Path(__file__).parent))
import notebooks  # noqa: E402
import reference  # noqa: E402
import verification  # noqa: E402

ROOT = Path(__file__).resolve().parents[1]
DOCS = ROOT / "docs"
TABLE = re.compile(r"^<!-- table: (\w+) -->$", flags=re.MULTILINE)
# Code, which stays as it is, or a link, whose text may be code.
CODE_OR_LINK = re.compile(
    r"^```.*?^```|`[^`\n]*`|(?P<mark>!?)\[(?P<text>[^\]]*)\]\((?P<target>[^)\s]+)\)", flags=re.MULTILINE | re.DOTALL
)
log = get_plugin_logger("soilctl")


def on_files(files, config):
    """Adds the front page, which is the README, the reference, the notebooks and the figures."""
    front = (ROOT / "README.md").read_text(encoding="utf-8")
    pages = {
        "index.md": front,
        "reference/cli.md": reference.command_line(),
        "reference/python.md": reference.python(),
        "reference/schemas.md": reference.schemas(DOCS / "schemas"),
    }
    pages |= {f"figures/{name}.svg": image for name, image in reference.figures().items()}
    for source in sorted(notebooks.SOURCES.glob("*.ipynb")):
        text, images = notebooks.page(source)
        pages[f"notebooks/{source.stem}.md"] = text
        pages |= {f"notebooks/{name}": image for name, image in images.items()}
    for name, text in pages.items():
        files.append(File.generated(config, name, content=text))
    return files


def on_page_markdown(markdown, page, config, files):
    """Links to files of the repository that are no documentation become their names; they must be there all the same."""
    here = DOCS / page.file.src_uri
    origin = ROOT if page.file.src_uri == "index.md" else here.parent

    def changed(match):
        mark, text, target = match.group("mark", "text", "target")
        if target is None:
            return match.group(0)
        path, hash_, anchor = target.partition("#")
        if not path or ":" in path:
            return match.group(0)
        there = (origin / path).resolve()
        if there == DOCS / "schemas":
            there = DOCS / "reference" / "schemas.md"
        if there.parent == notebooks.SOURCES and there.parent != here.parent and there.exists():
            # The page, with what the notebook showed; the file itself is linked there.
            there = there.with_suffix(".md")
        if there.is_relative_to(DOCS):
            # MkDocs warns if it is not there.
            return f"{mark}[{text}]({os.path.relpath(there, here.parent)}{hash_}{anchor})"
        if not there.exists():
            log.warning(f"{page.file.src_uri}: the link to {target} leads nowhere")
        name = there.relative_to(ROOT) if there.is_relative_to(ROOT) else target
        return f"`{name}`" if text.strip("`") == str(name) else f"{text} (`{name}`)"

    tables = verification.tables()
    markdown = TABLE.sub(lambda match: tables[match.group(1)], markdown)
    return CODE_OR_LINK.sub(changed, markdown)
