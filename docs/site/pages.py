"""Hooks of the site's generator: pages link to each other as files of the project, docs/viewer.md to ../README.md. What they link to
outside of docs/ becomes part of the site, Markdown as pages and the rest as files; docs/ itself is the root of the site."""

import pathlib
import posixpath
import re

from mkdocs.exceptions import PluginError
from mkdocs.structure.files import File

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
LINK = re.compile(r"\[([^][]*)\]\(([^)#\s]+)(#[^)\s]*)?\)")
# Where a reader begins; it stands above docs/, and is the site's first page.
FIRST = "README.md"


def in_project(site_path):
    """The path of a page in the project."""
    inside = posixpath.join("docs", site_path)
    return inside if (ROOT / inside).is_file() else site_path


def in_site(path):
    return path[len("docs/"):] if path.startswith("docs/") else path


def targets(path):
    """What the page links to within the project: (as it is written, path in the project)."""
    for match in LINK.finditer((ROOT / path).read_text(encoding="utf-8")):
        target = match.group(2)
        if "://" not in target and not target.startswith("mailto:"):
            yield target, posixpath.normpath(posixpath.join(posixpath.dirname(path), target))


def on_files(files, config):
    left_out = [file for file in files if file.src_path.startswith("site/")]
    for file in left_out:
        files.remove(file)
    known = {in_project(file.src_path) for file in files}
    todo = [FIRST] + sorted(path for path in known if path.endswith(".md"))
    seen = set(todo)
    while todo:
        path = todo.pop()
        if path not in known:
            known.add(path)
            files.append(File(path, str(ROOT), config["site_dir"], config["use_directory_urls"]))
        if path.endswith(".md"):
            linked = [target for _, target in targets(path) if (ROOT / target).is_file() and target not in seen]
            seen.update(linked)
            todo += linked
    return files


def on_nav(nav, config, files):
    shown = {page.file.src_path for page in nav.pages}
    missing = sorted(path.name for path in (ROOT / "docs").glob("*.md") if path.name not in shown)
    if missing:
        raise PluginError(f"docs/site/mkdocs.yml has no place for {', '.join(missing)}")
    return nav


def on_page_markdown(markdown, page, config, files):
    here = in_project(page.file.src_path)
    folder = posixpath.dirname(page.file.src_path)
    paths = dict(targets(here))

    def moved(match):
        text, target, place = match.groups()
        path = paths.get(target)
        if path is None:
            return match.group()
        if not (ROOT / path).is_file():
            return text  # a folder: its name is all there is to see
        return f"[{text}]({posixpath.relpath(in_site(path), folder or '.')}{place or ''})"

    return LINK.sub(moved, markdown)
