"""The check of recipes and links finds what it is there to find."""

import pathlib
import tempfile
import unittest

import check_docs

RECIPE = """// The contract.
//
// Recipe for a new camera:
//   1. src/NAME_camera.h and .cpp: the class.
//   2. tests/contract_test.cpp: add it.
#pragma once
"""


class CheckDocs(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.root = pathlib.Path(self.folder.name)
        self.write("src/camera.h", RECIPE)
        self.write("src/pinhole_camera.h", "")
        self.write("src/pinhole_camera.cpp", "")
        self.write("tests/contract_test.cpp", "")
        self.write("README.md", "See [the guide](docs/guide.md#start) and [the web](https://example.org/x).\n")
        self.write("docs/guide.md", "Back to the [start](../README.md).\n")

    def write(self, path, text):
        file = self.root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")

    def found(self):
        return list(check_docs.violations(self.root))

    def test_accepts_what_holds(self):
        self.assertEqual(self.found(), [])

    def test_finds_a_recipe_whose_file_is_gone(self):
        (self.root / "tests/contract_test.cpp").unlink()
        self.assertEqual(self.found(), ["src/camera.h:5: the recipe names tests/contract_test.cpp, which does not exist"])

    def test_finds_a_pattern_that_no_file_follows(self):
        (self.root / "src/pinhole_camera.cpp").unlink()
        self.assertEqual(self.found(), ["src/camera.h:4: the recipe names src/NAME_camera.cpp, which does not exist"])

    def test_finds_a_recipe_without_files(self):
        self.write("src/other.h", "// Recipe for nothing in particular.\n")
        self.assertEqual(self.found(), ["src/other.h:1: this recipe names no file"])

    def test_finds_a_link_that_leads_nowhere(self):
        self.write("docs/guide.md", "\n[gone](gone.md)\n")
        self.assertEqual(self.found(), ["docs/guide.md:2: the link to gone.md leads nowhere"])

    def test_finds_a_table_that_does_not_name_what_a_recipe_touches(self):
        row = "| a camera | [src/camera.h](src/camera.h) | {} |\n"
        self.write("CONTRIBUTING.md", row.format("`src/NAME_camera.h`, `src/NAME_camera.cpp`"))
        self.assertEqual(self.found(), [])
        self.write("CONTRIBUTING.md", row.format("`src/NAME_camera.h`"))
        self.assertEqual(
            self.found(),
            ["CONTRIBUTING.md:1: the recipe touches src/NAME_camera.cpp, src/NAME_camera.h; the table says otherwise"],
        )

    def test_finds_a_recipe_that_touches_too_much(self):
        self.write("src/a/list.h", "")
        steps = "".join(f"//   {i}. src/{name}/list.h: a line.\n" for i, name in enumerate("abcd", 1))
        for name in "abcd":
            self.write(f"src/{name}/list.h", "")
        self.write("src/wide.h", "// Recipe for a new one:\n" + steps + "// Then src/camera.h shows it.\n")
        named = ", ".join(f"`src/{name}/list.h`" for name in "abcd")
        self.write("CONTRIBUTING.md", f"| a wide one | [src/wide.h](src/wide.h) | {named} |\n")
        self.assertEqual(self.found(), ["src/wide.h: the recipe touches 4 files, more than 3"])

    def test_leaves_build_folders_alone(self):
        self.write("build/release/notes.md", "[gone](gone.md)\n")
        self.assertEqual(self.found(), [])


if __name__ == "__main__":
    unittest.main()
