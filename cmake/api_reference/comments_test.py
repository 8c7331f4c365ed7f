"""How comments of headers become those of Doxygen."""

import unittest

import comments


class Comments(unittest.TestCase):
    def test_what_would_be_a_command_is_escaped_but_in_code(self):
        self.assertEqual(comments.escaped(r"a < b & c, \u2013, @x, #1"), r"a \< b \& c, \\u2013, \@x, \#1")
        self.assertEqual(comments.escaped(r"`vector<int>` and <b>"), r"`vector<int>` and \<b\>")

    def test_indented_lines_stand_as_they_are(self):
        text = ["A law:", "", "  x < y", "    + z", "", "where x is so."]
        self.assertEqual(
            [line for line in comments.marked(text) if line],
            ["A law:", "~~~{.txt}", "  x < y", "    + z", "~~~", "where x is so."],
        )

    def test_lists_are_lists_and_end(self):
        text = ["Two places:", "  1. a.h, which", "     goes on;", "  2. b.h.", "Then all is done."]
        self.assertEqual(comments.marked(text), text[:4] + ["", text[4]])

    def test_columns_stand_as_they_are(self):
        table = ["Space    y is up", "         and z in front", "Colour   is linear"]
        self.assertEqual([line for line in comments.marked(table) if line], ["~~~{.txt}"] + table + ["~~~"])

    def test_a_header_is_in_its_group(self):
        text = "// What it is.\n#pragma once\nnamespace ocelli {\n/// Below <1>.\nint f();  ///< a & b\n}  // namespace ocelli\n"
        self.assertEqual(
            [line for line in comments.for_doxygen(text, "g").split("\n") if line not in ("", "///")],
            ["/// \\file", "/// \\ingroup g", "/// What it is.", "#pragma once", "namespace ocelli {",
             "/** \\addtogroup g", "@{ */", "/// Below \\<1\\>.", "int f();  ///< a \\& b", "/** @} */", "}  // namespace ocelli"],
        )


if __name__ == "__main__":
    unittest.main()
