"""The check of the tasks finds what it is there to find."""

import pathlib
import tempfile
import unittest

import check_tasks


class CheckTasks(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.root = pathlib.Path(self.folder.name)
        self.write("study/tasks/find_task.cpp", 'TaskKind findTask() {\n  return {.name = "find",\n};}\n')
        self.write("study/tasks/seek_task.cpp", 'TaskKind seekTask() {\n  return {.name = "seek"};}\n')
        self.write("study/tasks/find_images.cpp", 'auto images = {"find_ppc"};\n')
        self.write("study/subject/observer.cpp", '#include "find"\n// not "find"\nauto a = "to find // it";  // "seek"\n')
        self.write("oc_core/base/other.cpp", 'fields.has("seek");\n')

    def write(self, path, text):
        file = self.root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")

    def found(self):
        return list(check_tasks.violations(self.root))

    def assertFinds(self, line, where):
        self.write(where, "\n" + line + "\n")
        self.assertEqual(len(self.found()), 1, line)
        self.assertTrue(self.found()[0].startswith(f"{where}:2: "), self.found())

    def test_accepts_rows_and_what_is_no_name(self):
        self.assertEqual(self.found(), [])

    def test_accepts_fields_that_share_a_word_in_the_files_that_have_them(self):
        self.write("study/tasks/distance_task.cpp", 'TaskKind distanceTask() {\n  return {.name = "distance"};}\n')
        self.write("study/views/display_view.cpp", 'fields.number("distance_meters", 1, 2);\n')
        self.assertEqual(self.found(), [])
        self.assertFinds('fields.number("distance_meters", 1, 2);', "study/views/other_view.cpp")

    def test_finds_decisions_by_a_name(self):
        for line in ('if (plan.task == "find") {', 'return "seek" != task;', 'name.starts_with("find_") ? 1 : 2;',
                     'CLI::IsMember({"find"})', 'effects.at("seek", "graph")', 'std::map{{"seek", 1}};',
                     'auto help = "find: geometric mean time";'):
            self.assertFinds(line, "study/subject/bad.cpp")
            self.assertFinds(line, "study/subject/bad.cpp")
        self.write("study/subject/bad.cpp", "")
        self.assertFinds('if (task == "find") {', "cli/bad.cpp")

    def test_finds_the_names_of_new_rows(self):
        self.write("study/tasks/third_task.cpp", '.name = "third"')
        self.assertFinds('case_of("third")', "study/screen/bad.h")

    def test_a_tree_without_rows_is_wrong(self):
        for file in (self.root / "study/tasks").glob("*_task.cpp"):
            file.unlink()
        self.assertEqual(len(self.found()), 1)


if __name__ == "__main__":
    unittest.main()
