"""What check_names.py finds, and what it leaves alone."""

import pathlib
import tempfile
import unittest

import check_names

FIRST = """namespace ocelli {
class Ranks;
struct Ranks {
  struct Row {
  };
};
}  // namespace ocelli
"""


class CheckNames(unittest.TestCase):
    def names(self, second):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for room, text in (("oc_core", FIRST), ("analysis", second)):
                (root / room).mkdir()
                (root / room / "ranks.h").write_text(text, encoding="utf-8")
            return [name for name, _ in check_names.shared_names(root)]

    def test_finds_a_name_that_stands_twice(self):
        for second in ("class Ranks {", "struct Ranks final : public Base {", "class Ranks final\n    : public Base {", "class Ranks : Base {"):
            self.assertEqual(self.names("namespace ocelli {\n" + second), ["ocelli::Ranks"], second)

    def test_leaves_alone_what_is_another_class_or_none(self):
        for second in (
            "namespace ocelli {\nclass Ranks;",
            "namespace ocelli {\nstruct SampleRanks {",
            "namespace ocelli {\nstruct Ranks::Row {",
            "namespace ocelli::serial {\nstruct Ranks {",
            "namespace ocelli {\nstruct Row {",
        ):
            self.assertEqual(self.names(second), [], second)


if __name__ == "__main__":
    unittest.main()
