"""Makes the reference of the API from the headers' comments, with Doxygen.

Usage: make_reference.py --rooms ROOMS.csv --version VERSION --doxygen PROGRAM ROOT OUT

ROOMS.csv has a line a room: name, folder, component. Writes OUT/html; OUT/headers holds what Doxygen read. Each room is a group,
with what docs/architecture.md says of it, in the group of its component, with what docs/install.md says of that. A warning
of Doxygen is an error: then this prints them and exits with 1.
"""

import argparse
import csv
import pathlib
import re
import shutil
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import comments

HERE = pathlib.Path(__file__).parent
# For .cpp files that are compiled several times over, or stand for a library's.
LEFT_OUT = re.compile(r"-inl\.h$|/gl_api\.h$")


def second_cells(file):
    """{name: second cell} of the tables of a Markdown file whose first cell is a name in backticks."""
    rows = re.findall(r"^\| `([\w/]+)` \| ([^|]*) \|", file.read_text(encoding="utf-8"), re.MULTILINE)
    return {name.strip("/"): cell for name, cell in rows}


def sentence(text):
    """A cell as a sentence, which does not end before its end: what a list shows is its first one."""
    return text[0].upper() + text[1:].rstrip(".") + "."


def in_order(rooms, contents):
    """The components that were built, as the table has them."""
    built = {room["component"] for room in rooms}
    missing = built - set(contents)
    if missing:
        sys.exit(f"make_reference: docs/install.md has no row of the component {', '.join(sorted(missing))}: add it")
    return [component for component in contents if component in built]


def purpose_of(room, purposes):
    if room["folder"] not in purposes:
        sys.exit(f"make_reference: docs/architecture.md has no row of `{room['folder']}/`: add it")
    return purposes[room["folder"]]


def groups(rooms, purposes, contents):
    lines = []
    for component in in_order(rooms, contents):
        lines += [f"\\defgroup component_{component} {component}",
                  f"\\brief {comments.escaped(sentence(contents[component]))}", "",
                  f"`find_package(Ocelli COMPONENTS {component})` finds it, and `Ocelli::{component}` has all of its rooms.", ""]
    for room in rooms:
        lines += [f"\\defgroup room_{room['name']} {room['folder']}",
                  f"\\ingroup component_{room['component']}",
                  f"\\brief {comments.escaped(sentence(purpose_of(room, purposes)))}", "",
                  f"The library `Ocelli::{room['name']}`, of the component `{room['component']}`.", ""]
    return "\n".join(f"/// {line}".rstrip() if not line.startswith("\\defgroup") else f"\n/// {line}" for line in lines) + "\n"


def excerpt(text, start, end):
    """The lines from one that begins with `start` to the next that begins or ends with `end`."""
    lines = text.split("\n")
    first = next(i for i, line in enumerate(lines) if line.startswith(start))
    last = next(i for i in range(first + 1, len(lines)) if lines[i].startswith(end) or lines[i].endswith(end))
    return "\n".join(lines[first:last + 1])


def front_page(root, rooms, contents):
    def read(path):
        return (root / path).read_text(encoding="utf-8").rstrip("\n")

    def example(match):
        code = read(match["file"])
        if match["start"]:
            code = excerpt(code, match["start"], match["end"])
        return f"`{match['file']}`:\n\n```cpp\n{code}\n```"

    def head(match):
        lines = read(match[1]).split("\n")
        top = next(i for i, line in enumerate(lines) if not line.startswith("//"))
        return "\n".join(comments.marked([line[3:] for line in lines[:top]]))

    def section(match):
        after = read(match[1]).split(match[2] + "\n", 1)[1]
        return re.split(r"^## ", after, flags=re.MULTILINE)[0].strip()

    text = (HERE / "front_page.md").read_text(encoding="utf-8")
    components = in_order(rooms, contents)
    rows = "\n".join(f"| \\ref component_{name} | {comments.escaped(contents[name])} |" for name in components)
    text = text.replace("@components@", f"| component | what it has |\n| --- | --- |\n{rows}")
    text = re.sub(r'@example (?P<file>\S+?)(?: from "(?P<start>.*)" to "(?P<end>.*)")?@', example, text)
    text = re.sub(r"@head (\S+)@", head, text)
    return re.sub(r'@section (\S+) "(.*)"@', section, text)


def prepare(root, rooms, out):
    """Writes what Doxygen reads."""
    purposes = second_cells(root / "docs/architecture.md")
    contents = second_cells(root / "docs/install.md")
    shutil.rmtree(out, ignore_errors=True)
    folders = {room["folder"] for room in rooms}
    for room in rooms:
        for file in sorted((root / room["folder"]).rglob("*.h")):
            path = file.relative_to(root).as_posix()
            inner = any(other != room["folder"] and path.startswith(other + "/") and other.startswith(room["folder"] + "/")
                        for other in folders)
            if inner or LEFT_OUT.search(path):
                continue
            (out / path).parent.mkdir(parents=True, exist_ok=True)
            text = comments.for_doxygen(file.read_text(encoding="utf-8"), f"room_{room['name']}")
            (out / path).write_text(text, encoding="utf-8")
    (out / "groups.h").write_text(groups(rooms, purposes, contents), encoding="utf-8")
    (out / "front_page.md").write_text(front_page(root, rooms, contents), encoding="utf-8")


def run_doxygen(program, settings, out):
    text = (HERE / "Doxyfile").read_text(encoding="utf-8")
    for name, value in settings.items():
        text = text.replace(f"@{name}@", str(value))
    (out / "Doxyfile").write_text(text, encoding="utf-8")
    shutil.rmtree(out / "html", ignore_errors=True)
    subprocess.run([program, str(out / "Doxyfile")], check=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rooms", type=pathlib.Path, required=True)
    parser.add_argument("--version", required=True)
    parser.add_argument("--doxygen", default="doxygen")
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    options = parser.parse_args()
    out = options.out.resolve()
    out.mkdir(parents=True, exist_ok=True)
    rooms = list(csv.DictReader(options.rooms.read_text(encoding="utf-8").splitlines(), ["name", "folder", "component"]))
    prepare(options.root, rooms, out / "headers")
    log = out / "warnings.txt"
    run_doxygen(options.doxygen, {"input": out / "headers", "output": out, "log": log, "folder": HERE,
                                  "version": options.version,
                                  "logo": HERE.parent / "package/ocelli.svg"}, out)
    warnings = log.read_text(encoding="utf-8") if log.exists() else ""
    if warnings.strip():
        shutil.rmtree(out / "html")
        print(warnings.replace(f"{out}/headers/", ""), file=sys.stderr)
        print(f"make_reference: Doxygen warns of the comments above; lines are those of {out}/headers", file=sys.stderr)
        sys.exit(1)


if __name__ == "__main__":
    main()
