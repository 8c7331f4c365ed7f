#!/usr/bin/env python3
"""Makes the pictures of docs/gallery.md by the commands that stand there, or compares what they make with what is there.

Usage: gallery.py make|check [PROGRAM]

Below each picture of the page, images/gallery/NAME.png, stand the commands that make NAME.png, indented; they run in a
folder of their own in which the project's folders are. PROGRAM is `ocelli`, build/release/cli/ocelli by default. `check` exits
with 1 where a picture differs: compilers and processors may round a pixel at an edge differently, but no more than that.
"""

import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

PICTURE = re.compile(r"!\[[^]]+\]\(images/gallery/([^)/]+)\)")
COMMAND = re.compile(r" {4,}(\S.*)")
FOLDERS = ("docs", "examples", "protocols")
# Of the pixels, those of which a channel differs by more than MUCH.
MUCH = 8
MOST_PIXELS = 0.002


def entries(page):
    """(picture, its commands) in the order of the page."""
    found = []
    goes_on = False
    for number, line in enumerate(page.splitlines(), 1):
        picture = PICTURE.match(line)
        if "images/gallery/" in line and picture is None:
            raise ValueError(f"docs/gallery.md:{number}: a picture is ![what it shows](images/gallery/NAME.png)")
        command = COMMAND.fullmatch(line)
        if command and goes_on:
            found[-1][1][-1] += " " + command.group(1).rstrip("\\").rstrip()
        if picture:
            found.append((picture.group(1), []))
        elif command and found and not goes_on:
            found[-1][1].append(command.group(1).rstrip("\\").rstrip())
        goes_on = line.endswith("\\")
    without = [name for name, commands in found if not commands]
    if without:
        raise ValueError(f"no command stands below {', '.join(without)}")
    return found


def run(command, program, folder):
    words = shlex.split(command)
    words[:1] = [str(program), "--quiet"] if words[0] == "ocelli" else [sys.executable] if words[0] == "python3" else words[:1]
    done = subprocess.run(words, cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise ValueError(f"`{command}` ended with {done.returncode}: {done.stderr.strip()}")


def difference(made, kept):
    """What is different about two pictures, in words; empty where nothing is."""
    import numpy
    from PIL import Image

    pixels = [numpy.asarray(Image.open(path).convert("RGB")).astype(int) for path in (made, kept)]
    if pixels[0].shape != pixels[1].shape:
        return f"has {pixels[0].shape[1]}x{pixels[0].shape[0]} pixels, and had {pixels[1].shape[1]}x{pixels[1].shape[0]}"
    share = float((numpy.abs(pixels[0] - pixels[1]).max(axis=2) > MUCH).mean())
    return f"differs in {100 * share:.2f} % of its pixels" if share > MOST_PIXELS else ""


def main(arguments):
    root = pathlib.Path(__file__).resolve().parent.parent
    if not 1 <= len(arguments) <= 2 or arguments[0] not in ("make", "check"):
        print(__doc__, file=sys.stderr)
        return 2
    program = pathlib.Path(arguments[1] if len(arguments) > 1 else root / "build/release/cli/ocelli").resolve()
    kept = root / "docs/images/gallery"
    violations = []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for part in FOLDERS:
            (folder / part).symlink_to(root / part)
        pictures = entries((root / "docs/gallery.md").read_text(encoding="utf-8"))
        for picture, commands in pictures:
            print(picture, flush=True)
            try:
                for command in commands:
                    run(command, program, folder)
                if arguments[0] == "make":
                    kept.mkdir(exist_ok=True)
                    shutil.copyfile(folder / picture, kept / picture)
                elif (told := difference(folder / picture, kept / picture)):
                    violations.append(f"{picture} {told}: if that is right, run scripts/gallery.py make")
            except (OSError, ValueError) as error:
                violations.append(f"{picture}: {error}")
    stray = {path.name for path in kept.glob("*")} - {picture for picture, _ in pictures}
    violations += [f"docs/images/gallery/{name} is not in docs/gallery.md" for name in sorted(stray)]
    print("\n".join(violations) or f"{len(pictures)} pictures")
    return 1 if violations else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
