"""Makes the reference of the API, of which no comment may be a warning of Doxygen, and looks at what came out.

Usage: check_reference.py ROOT ROOMS.csv OUT. Exits with 77, for skipped, where there is no Doxygen.
"""

import csv
import html
import pathlib
import re
import shutil
import subprocess
import sys

MAKE = "cmake/api_reference/make_reference.py"
TABLES = """| folder | what lives there | may include |
| --- | --- | --- |
| `oc_core/one/` | a room | nothing |
| `core` | what it has | |
"""


def make(root, rooms, source, out):
    command = [sys.executable, "-B", root / MAKE, "--rooms", rooms, "--version", "0", source, out]
    return subprocess.run(command, capture_output=True, text=True, check=False)


def words_of(page):
    """The text of a page, without tags."""
    return re.sub(r"\s+", " ", html.unescape(re.sub(r"<[^>]*>", "", page.read_text(encoding="utf-8"))))


def missing_pages(root, rooms, pages):
    front = words_of(pages / "index.html")
    for needed in ("a ray is a polyline from near to far", "buildReferenceImages(camera, reference, scene)", "registerDevice(textDevice())",
                   "static_assert(ocelli::Camera<FisheyeCamera>)", "Right-handed, y up", "the work itself failed"):
        if needed not in front:
            yield f"the front page lacks: {needed}"
    architecture = (root / "docs/architecture.md").read_text(encoding="utf-8")
    for name, folder, _ in csv.reader(rooms.read_text(encoding="utf-8").splitlines()):
        page = pages / f"group__room__{name.replace('_', '__')}.html"
        if not page.exists():
            yield f"{folder} has no page"
            continue
        text = words_of(page)
        purpose = re.search(rf"^\| `{folder}/` \| ([^|]*?) \|", architecture, re.MULTILINE)[1].replace("`", "")
        # Its first letter is a capital there.
        if purpose[1:] not in text:
            yield f"{page.name} does not say what {folder} is for: {purpose}"
        for header in (root / folder).glob("*.h"):
            if not header.name.endswith(("-inl.h", "gl_api.h")) and header.name not in text:
                yield f"{page.name} does not list {header.name}"
    if "optional< ImagePoint >" not in words_of(pages / "classocelli_1_1PinholeCamera.html").replace("std::", ""):
        yield "PinholeCamera has no project()"


def planted_warning_is_found(root, out):
    """A source of one header, whose comment begins what it does not end."""
    source = out / "planted"
    for folder in ("oc_core/one", "docs"):
        (source / folder).mkdir(parents=True)
    for file in ("architecture.md", "install.md"):
        (source / "docs" / file).write_text(TABLES + "\n## Errors\n\nNone.\n", encoding="utf-8")
    for folder in ("examples", "oc_core/camera", "oc_core/base"):
        shutil.copytree(root / folder, source / folder)
    (source / "oc_core/one/one.h").write_text("// One.\n//\n// ~~~\n// and more\n#pragma once\n", encoding="utf-8")
    rooms = source / "rooms.csv"
    rooms.write_text("one,oc_core/one,core\n", encoding="utf-8")
    result = make(root, rooms, source, out / "planted_out")
    return result.returncode == 1 and "oc_core/one/one.h" in result.stderr and not (out / "planted_out/html").exists()


def main():
    root, rooms, out = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
    if shutil.which("doxygen") is None:
        print("the reference of the API needs Doxygen: install the package doxygen")
        return 77
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    problems = [] if planted_warning_is_found(root, out) else ["a comment that Doxygen warns of was no error"]
    result = make(root, rooms, root, out)
    print(result.stdout, result.stderr)
    problems += list(missing_pages(root, rooms, out / "html")) if result.returncode == 0 else ["it was not made"]
    print("\n".join(problems) if problems else "the reference is whole")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
