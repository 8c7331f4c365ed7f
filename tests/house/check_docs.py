"""Checks that recipes and links hold: every file that a recipe in a header names exists, every relative link leads somewhere.

Usage: check_docs.py ROOT. Prints one line a violation and exits with 1 where there is one.

A recipe is a comment that starts with "Recipe for". In its paths NAME stands for any name, and at least one such file must
exist: the recipe's steps have then been followed once. The table of CONTRIBUTING.md names the files that the numbered steps of
each recipe touch, three at most besides tests, documentation, schemas and lists of sources.
"""

import pathlib
import re
import sys

LINK = re.compile(r"\]\(([^)#\s]+)(?:#[^)]*)?\)")
PATH = re.compile(r"\b(?:[\w]+/)+[\w]+\.(?:cpp|h|json|md|txt|py|cmake)\b")
SUFFIX = re.compile(r"^,? (?:and|or) (\.\w+)\b")  # "NAME_camera.h and .cpp"
STEP = re.compile(r"^//\s+\d+\. ")
BESIDES = re.compile(r"^(tests|docs|examples|protocols)/|\.schema\.json$|\.md$|/CMakeLists\.txt$")
MAX_FILES = 3
BUILD = re.compile(r"(^|/)(build[^/]*|demo|\.git)/")


def files_of(root, pattern):
    for file in sorted(root.rglob(pattern)):
        path = file.relative_to(root).as_posix()
        if not BUILD.search(path):
            yield path, file


def recipes_of(text):
    """The lines of each recipe: from "Recipe for" to the end of its comment."""
    recipe = None
    for number, line in enumerate(text.splitlines(), 1):
        comment = line.lstrip().startswith("//")
        if comment and "Recipe for" in line:
            recipe = []
        if recipe is not None and not comment:
            yield recipe
            recipe = None
        if recipe is not None:
            recipe.append((number, line))
    if recipe:
        yield recipe


def named_paths(line):
    for match in PATH.finditer(line):
        yield match.group()
        more = SUFFIX.match(line[match.end():])
        if more:
            yield match.group().rsplit(".", 1)[0] + more.group(1)


def recipe_violations(root):
    count = 0
    for path, file in files_of(root, "*.h"):
        for recipe in recipes_of(file.read_text(encoding="utf-8")):
            count += 1
            if not any(True for _, line in recipe for _ in named_paths(line)):
                yield f"{path}:{recipe[0][0]}: this recipe names no file"
            for number, line in recipe:
                for named in named_paths(line):
                    if not any(root.glob(named.replace("NAME", "*"))):
                        yield f"{path}:{number}: the recipe names {named}, which does not exist"
    if count == 0:
        yield "no header holds a recipe"


def touched_files(recipe):
    """What the numbered steps of a recipe name, besides tests and the like; what stands in parentheses is there to read."""
    files = set()
    indent = None  # of the step that goes on
    for _, line in recipe:
        if STEP.match(line):
            indent = len(STEP.match(line).group())
        elif len(line[2:]) - len(line[2:].lstrip()) + 2 < (indent or 0):
            indent = None
        if indent is not None:
            files.update(path for path in named_paths(re.sub(r"\([^)]*\)", "", line)) if not BESIDES.search(path))
    return files


def count_violations(root):
    table = root / "CONTRIBUTING.md"
    if not table.exists():
        return
    for number, line in enumerate(table.read_text(encoding="utf-8").splitlines(), 1):
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        header = LINK.search(cells[1]) if len(cells) > 2 else None
        if header is None or not header.group(1).endswith(".h") or not (root / header.group(1)).exists():
            continue
        for recipe in recipes_of((root / header.group(1)).read_text(encoding="utf-8")):
            touched = touched_files(recipe)
            told = set(re.findall(r"`([^`]+)`", cells[2]))
            if touched != told:
                yield f"CONTRIBUTING.md:{number}: the recipe touches {', '.join(sorted(touched))}; the table says otherwise"
            if len(touched) > MAX_FILES:
                yield f"{header.group(1)}: the recipe touches {len(touched)} files, more than {MAX_FILES}"


def link_violations(root):
    for path, file in files_of(root, "*.md"):
        for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
            for target in LINK.findall(line):
                if re.match(r"[a-z]+:", target) is None and not (file.parent / target).exists():
                    yield f"{path}:{number}: the link to {target} leads nowhere"


def violations(root):
    root = pathlib.Path(root)
    yield from recipe_violations(root)
    yield from count_violations(root)
    yield from link_violations(root)


if __name__ == "__main__":
    found = list(violations(sys.argv[1]))
    print("\n".join(found) if found else "every recipe and link holds")
    sys.exit(1 if found else 0)
