"""Checks that no two headers define a class of one name in one namespace.

Such classes are one to the linker, which takes the functions of either for both: the first that needs another size writes
over what lies behind it. Nothing warns of it.

Usage: check_names.py ROOT
"""

import pathlib
import re
import sys

FOLDERS = ("oc_core", "display_sim", "display_driver", "study", "analysis", "cli")
NAMESPACE = re.compile(r"(?:inline )?namespace\s+([\w:]+)\s*\{")
END_OF_NAMESPACE = re.compile(r"\}\s*// namespace")
CLASS = re.compile(r"(?:struct|class|union)\s+(?:\[\[\w+\]\]\s+)?(\w+)(?: final)?\s*(?:\{|:[^:]|$)")


def classes(text):
    """The full name of each class that is defined in a namespace, not those within classes."""
    namespaces = []
    for line in text.splitlines():
        if opened := NAMESPACE.match(line):
            namespaces.append(opened.group(1))
        elif END_OF_NAMESPACE.match(line) and namespaces:
            namespaces.pop()
        elif namespaces and (found := CLASS.match(line)) and not line.rstrip().endswith(";"):
            yield "::".join(namespaces + [found.group(1)])


def shared_names(root):
    """(name, headers) of each class name that several headers define."""
    headers = {}
    for folder in FOLDERS:
        for file in sorted((root / folder).rglob("*.h")):
            for name in classes(file.read_text(encoding="utf-8")):
                headers.setdefault(name, []).append(file.relative_to(root))
    return [(name, files) for name, files in sorted(headers.items()) if len(files) > 1]


def main(root):
    found = shared_names(root)
    for name, files in found:
        print(f"{name} stands in {' and in '.join(map(str, files))}: give one of them another name")
    if not found:
        print("every class has a name of its own")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve()))
