"""Makes the site of the guide and follows its links: each leads to a page, a file, or a heading that is there, and nothing is loaded
from elsewhere. What is typed is there as the guide has it.

Usage: check_site.py ROOT. Prints one line a violation and exits with 1 where there is one, with 77 where the generator is missing.
"""

import html.parser
import pathlib
import subprocess
import sys
import tempfile
import urllib.parse

SKIPPED = 77
# The guide has more.
FEWEST_PAGES = 50
# What a browser loads by itself.
LOADS = {("img", "src"), ("script", "src"), ("link", "href"), ("video", "src"), ("source", "src"), ("iframe", "src")}


class Page(html.parser.HTMLParser):
    """The links, what is loaded, the places and the text of a page."""

    def __init__(self, path):
        super().__init__()
        self.links = []  # (tag, target)
        self.places = set()
        self.text = ""
        self.feed(path.read_text(encoding="utf-8"))

    def handle_data(self, data):
        self.text += data

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name == "id":
                self.places.add(value)
            elif name in ("href", "src") and value:
                self.links.append(((tag, name), value))


def lost_commands(root, site):
    """Lines of commands in the guide that its page does not have."""
    for source in sorted((root / "docs").glob("*.md")):
        text = Page(site / f"{source.stem}.html").text
        for line in source.read_text(encoding="utf-8").splitlines():
            if line.startswith("    ocelli ") and line.strip() not in text:
                yield f"{source.name}: its page lacks {line.strip()}"


def broken_links(site):
    pages = {path: Page(path) for path in site.rglob("*.html")}
    if len(pages) < FEWEST_PAGES:
        yield f"there are {len(pages)} pages only"
    for path, page in sorted(pages.items()):
        # The server shows it for any address, so its links begin at the root.
        if path.name == "404.html":
            continue
        for kind, link in page.links:
            parts = urllib.parse.urlsplit(link)
            if parts.scheme or parts.netloc:
                if kind in LOADS and parts.scheme != "data" and ("link", "canonical") != kind:
                    yield f"{path.name}: loads {link} from elsewhere"
                continue
            target = (path.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else path
            if not target.exists():
                yield f"{path.name}: {link} leads nowhere"
            elif parts.fragment and target in pages and parts.fragment not in pages[target].places:
                yield f"{path.name}: {link} has no such heading"


def main(root):
    with tempfile.TemporaryDirectory() as folder:
        site = pathlib.Path(folder).resolve() / "site"
        made = subprocess.run([root / "scripts/build_site.sh", site], check=False)
        if made.returncode != 0:
            return made.returncode
        found = list(broken_links(site)) + list(lost_commands(root, site))
    print("\n".join(found) or "every link leads somewhere, and every command is there")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
