"""Checks every source file with clang-format. Skipped (exit code 77) without clang-format 14, whose output .clang-format fits.

Usage: check_format.py ROOT
"""

import pathlib
import re
import shutil
import subprocess
import sys

VERSION = 14  # others break lines differently
FOLDERS = ("oc_core", "display_sim", "display_driver", "study", "analysis", "cli", "tests", "bench", "fuzz", "examples")


def find_clang_format():
    for name in (f"clang-format-{VERSION}", "clang-format"):
        program = shutil.which(name)
        if program:
            version = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout
            if re.search(rf"version {VERSION}\.", version):
                return program
    return None


def main(root):
    program = find_clang_format()
    if program is None:
        print(f"skipped: clang-format {VERSION} is not installed")
        return 77
    files = [file for folder in FOLDERS for file in sorted((root / folder).rglob("*")) if file.suffix in (".h", ".cpp")]
    return subprocess.run([program, "--dry-run", "-Werror", *map(str, files)], cwd=root, check=False).returncode


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve()))
