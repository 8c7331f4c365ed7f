"""Makes the site of the guide and follows its links: each leads to a page, a file, or a heading that is there, and nothing is loaded
from elsewhere.

Usage: check_site.py ROOT. Prints one line a violation and exits with 1 where there is one, with 77 where the generator is missing.
"""

import html.parser
import pathlib
import subprocess
import sys
import tempfile
import urllib.parse

SKIPPED = 77
# What a browser loads by itself.
LOADS = {("img", "src"), ("script", "src"), ("link", "href"), ("video", "src"), ("source", "src"), ("iframe", "src")}


class Page(html.parser.HTMLParser):
    """The links, what is loaded, and the places of a page."""

    def __init__(self, path):
        super().__init__()
        self.links = []  # (tag, target)
        self.places = set()
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name == "id":
                self.places.add(value)
            elif name in ("href", "src") and value:
                self.links.append(((tag, name), value))


def violations(site):
    pages = {path: Page(path) for path in site.rglob("*.html")}
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
        found = list(violations(site))
        pages = len(list(site.rglob("*.html")))
    print("\n".join(found) or f"every link of {pages} pages leads somewhere")
    return 1 if found or pages < 50 else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
