"""Checks that a task of the studies is known by its row alone: no code outside of it decides by its name.

Usage: check_tasks.py ROOT. Prints one line a violation and exits with 1 where there is one.

The names come from the rows (study/tasks/NAME_task.cpp, `.name = "..."`). Code of the folders below may not hold a text
that is the name of a task, or that begins with it and "_" or ":" ("find_ppc"): whatever compares, branches or looks up by
it would not know the next task. Tests and benchmarks may, as they are of particular studies.
"""

import pathlib
import re
import sys

ROWS = "study/tasks"
FOLDERS = ("study", "cli")
NAME = re.compile(r'\.name = "(\w+)"')
TEXT = re.compile(r'(?<!R)"((?:[^"\\]|\\.)*)"')
# Names of fields that have a word in common with a task, and no more: no code decides by them.
OTHER_MEANINGS = {
    "study/outline/screen_fields.cpp": {"distance", "distance_millimeters"},  # from the eye to the screen
    "study/screen/calibration.cpp": {"distance", "distance_millimeters", "distance_spread"},
    "study/views/display_view.cpp": {"distance_meters"},  # from the eye to the display
}
# These report on the tasks of one study, until their room has a registry too.
NOT_YET = {"cli/analyse_command.cpp"}


def task_names(root):
    return {match.group(1) for file in sorted((root / ROWS).glob("*_task.cpp"))
            for match in NAME.finditer(file.read_text(encoding="utf-8"))}


def code_of(line):
    """The line without its comment; texts may hold "//"."""
    kept, rest = "", line
    while rest:
        text = TEXT.search(rest)
        comment = rest.find("//")
        if comment >= 0 and (text is None or comment < text.start()):
            return kept + rest[:comment]
        if text is None:
            return kept + rest
        kept, rest = kept + rest[:text.end()], rest[text.end():]
    return kept


def violations(root):
    root = pathlib.Path(root)
    names = task_names(root)
    if not names:
        yield f"{ROWS}/: no row of a task was found"
        return
    bad = re.compile(rf"({'|'.join(sorted(names))})([_:].*)?")
    for folder in FOLDERS:
        for file in sorted((root / folder).rglob("*")):
            path = file.relative_to(root).as_posix()
            if file.suffix not in (".h", ".cpp") or path.startswith(ROWS + "/") or path in NOT_YET:
                continue
            for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
                if line.lstrip().startswith("#include"):
                    continue
                for text in TEXT.findall(code_of(line)):
                    if bad.fullmatch(text) and text not in OTHER_MEANINGS.get(path, set()):
                        yield (f'{path}:{number}: "{text}" is of a task: ask its row in {ROWS}/task_registry.h instead')


if __name__ == "__main__":
    found = list(violations(sys.argv[1]))
    print("\n".join(found) if found else "tasks are known by their rows alone")
    sys.exit(1 if found else 0)
