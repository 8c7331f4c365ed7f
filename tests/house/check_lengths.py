"""Checks that no source file is longer than one idea takes: 600 lines.

Usage: check_lengths.py ROOT
"""

import pathlib
import sys

MAX_LINES = 600
FOLDERS = ("oc_core", "display_sim", "display_driver", "study", "analysis", "cli", "tests", "bench", "fuzz", "examples", "cmake", "scripts")
SUFFIXES = {".h", ".cpp", ".in", ".py", ".cmake", ".txt", ".sh", ".comp", ".vert", ".frag", ".glsl"}


def long_files(root):
    """(lines, path) of each file that is too long, the longest first."""
    found = []
    for folder in FOLDERS:
        for file in sorted((root / folder).rglob("*")):
            if file.is_file() and file.suffix in SUFFIXES:
                lines = file.read_bytes().count(b"\n")
                if lines > MAX_LINES:
                    found.append((lines, file.relative_to(root)))
    return sorted(found, reverse=True)


def main(root):
    found = long_files(root)
    for lines, file in found:
        print(f"{file}: {lines} lines, more than {MAX_LINES}: take it apart along its jobs")
    if not found:
        print(f"no source file has more than {MAX_LINES} lines")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve()))
