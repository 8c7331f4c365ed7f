"""The check of test results finds what it is there to find, in what ctest really writes."""

import pathlib
import shutil
import subprocess
import tempfile
import unittest

import check_results

PROJECT = """cmake_minimum_required(VERSION 3.25)
project(tests_of_all_outcomes NONE)
enable_testing()
add_test(NAME passes COMMAND sh -c "exit 0")
add_test(NAME fails COMMAND sh -c "exit 1")
add_test(NAME hangs COMMAND sleep 5)
set_tests_properties(hangs PROPERTIES TIMEOUT 1)
add_test(NAME is_not_built COMMAND /nonexistent)
add_test(NAME skips COMMAND sh -c "echo no such device; exit 77")
set_tests_properties(skips PROPERTIES SKIP_RETURN_CODE 77)
add_test(NAME is_disabled COMMAND sh -c "exit 0")
set_tests_properties(is_disabled PROPERTIES DISABLED TRUE)
"""

PROGRAM = """<testsuites><testsuite name="Mesh">
<testcase name="Closes" status="run" result="completed" classname="Mesh" />
<testcase name="Opens/0" status="run" result="completed" classname="All/Mesh"><failure message="3 is not 4" /></testcase>
<testcase name="Scans" status="run" result="skipped" classname="Mesh"><skipped message="set OCELLI_DATA_DIR" /></testcase>
<testcase name="DISABLED_Bends" status="notrun" result="suppressed" classname="Mesh" />
</testsuite></testsuites>"""


def expected(least=1, **skip):
    defaults = {"tests": "skips", "prints": "no such device", "if": "always", "reason": "a device"}
    return {"least_tests": {"release": least}, "skips": [{**defaults, **skip}]}


def check(wanted, *results):
    lines, good = check_results.check(wanted, "release", results, {"always": lambda: True, "root": lambda: False})
    return "\n".join(lines), good


PASSED = ("passes", "ran", "")
SKIPPED = ("skips", "skipped", "no such device")


class CheckResults(unittest.TestCase):
    def test_reads_what_ctest_writes(self):
        if shutil.which("ctest") is None:
            self.fail("ctest is not on the path")
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "CMakeLists.txt").write_text(PROJECT, encoding="utf-8")
            subprocess.run(["cmake", "-G", "Ninja", "-S", folder, "-B", folder], check=True, stdout=subprocess.DEVNULL)
            file = pathlib.Path(folder, "results.xml")
            subprocess.run(
                ["ctest", "--test-dir", folder, "--output-junit", file],
                check=False,
                stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL,
            )
            self.assertEqual(
                {name: outcome for name, outcome, _ in check_results.outcomes(file)},
                {
                    "passes": "ran",
                    "fails": "failed",
                    "hangs": "failed",
                    "is_not_built": "failed",
                    "skips": "skipped",
                    "is_disabled": "skipped",
                },
            )

    def test_reads_what_test_programs_write(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "mesh_test.xml")
            file.write_text(PROGRAM, encoding="utf-8")
            self.assertEqual(
                list(check_results.outcomes(file)),
                [
                    ("Mesh.Closes", "ran", ""),
                    ("All/Mesh.Opens/0", "failed", "3 is not 4"),
                    ("Mesh.Scans", "skipped", "set OCELLI_DATA_DIR"),
                    ("Mesh.DISABLED_Bends", "skipped", ""),
                ],
            )

    def test_counts_each_case_once(self):
        told = """<testsuite><testcase name="mesh_test" status="{}"/><testcase name="house.docs" status="run"/></testsuite>"""
        with tempfile.TemporaryDirectory() as folder:
            program, ctest = pathlib.Path(folder, "mesh_test.xml"), pathlib.Path(folder, "fast.xml")
            program.write_text(PROGRAM, encoding="utf-8")
            for status, more in (("run", ["house.docs"]), ("fail", ["mesh_test", "house.docs"])):
                ctest.write_text(told.format(status), encoding="utf-8")
                names = [name for name, _, _ in check_results.all_outcomes([program, ctest])]
                self.assertEqual(names, ["Mesh.Closes", "All/Mesh.Opens/0", "Mesh.Scans", "Mesh.DISABLED_Bends", *more])

    def test_counts_what_ran(self):
        text, good = check(expected(), PASSED, ("more", "ran", ""))
        self.assertTrue(good)
        self.assertIn("2 passed, 0 failed, 0 skipped", text)
        self.assertIn("raise least_tests.release to 2", text)

    def test_accepts_the_skips_of_the_list_and_tells_of_them(self):
        text, good = check(expected(), PASSED, SKIPPED)
        self.assertTrue(good)
        self.assertIn("1 (a device)", text)

    def test_finds_skips_that_are_not_on_the_list(self):
        for wanted in (
            expected(tests="skip"),  # the name is another
            expected(prints="another reason"),
            expected(**{"if": "root"}),  # this is another machine
            expected(builds=["asan"]),  # and this another build
        ):
            text, good = check(wanted, PASSED, SKIPPED)
            self.assertFalse(good)
            self.assertIn("should have run: skips: no such device", text)

    def test_finds_fewer_tests(self):
        text, good = check(expected(least=3), PASSED, SKIPPED)
        self.assertFalse(good)
        self.assertIn("there are 2 tests, and there were 3", text)

    def test_finds_failures(self):
        text, good = check(expected(), PASSED, ("fails", "failed", ""))
        self.assertFalse(good)
        self.assertIn("FAILED: fails", text)

    def test_the_list_is_as_it_must_be(self):
        import json

        file = pathlib.Path(__file__).parent.parent / "expected_results.json"
        wanted = json.loads(file.read_text(encoding="utf-8"))
        self.assertEqual(set(wanted["least_tests"]), {"release", "asan", "asan-light", "asan-all", "thorough"})
        for skip in wanted["skips"]:
            self.assertIn(skip["if"], check_results.CONDITIONS)
            self.assertTrue(skip["reason"])
            self.assertTrue(skip["prints"])


if __name__ == "__main__":
    unittest.main()
