"""The check of the rooms finds what it is there to find."""

import pathlib
import tempfile
import unittest

import check_rooms

TABLE = """
| folder | what lives there | may include |
| --- | --- | --- |
| `oc_core/base/` | | nothing |
| `oc_core/scene/` | | `oc_core/base/` |
| `oc_core/render/` | | `oc_core/scene/` |
| `display_sim/` | | `oc_core/` |
| `analysis/` | | nothing |
| `cli/` | | everything |
| `examples/` | | everything |
"""


class CheckRooms(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.root = pathlib.Path(self.folder.name)
        self.write("docs/architecture.md", TABLE)
        self.write("oc_core/base/image.h", "#include <vector>\n#include <glm/vec3.hpp>\n")
        self.write("oc_core/base/json_fields.h", "#include <nlohmann/json.hpp>\n")
        self.write("oc_core/base/png.cpp", '#include "oc_core/base/image.h"\n#include <png.h>\n#include <sys/stat.h>\n')
        self.write("oc_core/base/CMakeLists.txt",
                   "ocelli_room(base\n  SOURCES png.cpp\n  PUBLIC glm::glm\n  PRIVATE PNG::PNG nlohmann_json::nlohmann_json)\n")
        self.write("oc_core/scene/mesh.h", '#include "oc_core/base/image.h"\n')
        self.write("oc_core/scene/CMakeLists.txt", "ocelli_room(scene\n  SOURCES mesh.cpp\n  PUBLIC Ocelli::base)\n")
        self.write("oc_core/render/raster.cpp", '#include "oc_core/base/image.h"\n#include "oc_core/scene/mesh.h"\n')
        self.write("oc_core/render/CMakeLists.txt", "ocelli_room(render\n  SOURCES raster.cpp\n  PUBLIC Ocelli::scene)\n")
        self.write("cli/main.cpp", '#include <CLI/CLI.hpp>\n#include "oc_core/render/raster.h"\n')
        self.write("oc_core/render/raster.h", "")

    def write(self, path, text):
        file = self.root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")

    def assertFinds(self, part):
        found = list(check_rooms.violations(self.root))
        self.assertTrue(any(part in line for line in found), f"{part!r} is not in {found}")

    def test_accepts_what_the_table_allows(self):
        self.assertEqual(list(check_rooms.violations(self.root)), [])

    def test_finds_an_include_against_the_flow(self):
        self.write("oc_core/base/bad.cpp", '#include "oc_core/scene/mesh.h"\n')
        self.assertFinds("oc_core/base/bad.cpp:1: oc_core/base/ may not include oc_core/scene/")

    def test_finds_an_include_of_a_room_by_one_that_includes_nothing(self):
        self.write("analysis/report.cpp", '#include "oc_core/base/image.h"\n')
        self.assertFinds("analysis/ may not include oc_core/base/")

    def test_finds_an_include_of_the_program(self):
        self.write("cli/command.h", "")
        self.write("display_sim/slicer.cpp", '#include "cli/command.h"\n')
        self.assertFinds("display_sim/ may not include cli/")

    def test_finds_a_relative_include(self):
        self.write("oc_core/scene/bad.cpp", '#include "mesh.h"\n')
        self.assertFinds("give the path from the top")

    def test_allows_files_beside_it_in_a_project_of_its_own(self):
        self.write("examples/mine/mine.h", "")
        self.write("examples/mine/main.cpp", '#include "mine.h"\n#include "oc_core/scene/mesh.h"\n')
        self.assertEqual(list(check_rooms.violations(self.root)), [])
        self.write("examples/other/main.cpp", '#include "mine.h"\n')
        self.assertFinds('examples/other/main.cpp:1: "mine.h" is no file of a room')

    def test_finds_a_third_party_in_a_public_header(self):
        self.write("oc_core/scene/bad.h", "#include <assimp/scene.h>\n")
        self.assertFinds("<assimp/scene.h> may not stand in a public header")

    def test_allows_json_in_its_one_header_only(self):
        self.write("oc_core/base/bad.h", "#include <nlohmann/json.hpp>\n")
        self.assertFinds("oc_core/base/bad.h:1")

    def test_finds_a_header_that_spreads_a_source_only_header(self):
        self.write("oc_core/scene/bad.h", '#include "oc_core/base/json_fields.h"\n')
        self.assertFinds("is for .cpp files only")

    def test_finds_a_library_nobody_knows(self):
        self.write("oc_core/scene/bad.cpp", "#include <ace/Any.h>\n")
        self.assertFinds("<ace/Any.h> is not known")

    def test_finds_an_included_library_that_is_not_linked(self):
        self.write("oc_core/scene/bad.cpp", "#include <assimp/scene.h>\n")
        self.assertFinds("oc_core/scene/ includes headers of assimp::assimp but does not link it")

    def test_finds_an_included_room_that_is_not_linked(self):
        self.write("oc_core/scene/CMakeLists.txt", "ocelli_room(scene\n  SOURCES mesh.cpp\n  PUBLIC glm::glm)\n")
        self.assertFinds("oc_core/scene/ includes headers of oc_core/base/ but does not link it")

    def test_finds_a_link_against_the_flow(self):
        self.write("oc_core/base/CMakeLists.txt",
                   "ocelli_room(base\n  SOURCES a.cpp\n  PUBLIC glm::glm Ocelli::render\n"
                   "  PRIVATE PNG::PNG nlohmann_json::nlohmann_json)\n")
        self.assertFinds("oc_core/base/ may not link Ocelli::render")

    def test_finds_code_outside_of_every_room(self):
        self.write("extra/main.cpp", "")
        self.assertFinds("extra/ holds code but is no room")

    def test_finds_a_missing_table(self):
        self.write("docs/architecture.md", "nothing\n")
        self.assertFinds("the table of rooms is missing")


if __name__ == "__main__":
    unittest.main()
