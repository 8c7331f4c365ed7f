"""The analysis of studies: the same numbers as in the files that `ocelli analyse` writes."""

import builtins
import csv
import json
import os
import pathlib
import signal
import subprocess
import tempfile
import unittest
from unittest import mock

import ocelli

PROGRAM = os.environ["OCELLI_PROGRAM"]
PROTOCOL = pathlib.Path(__file__).parents[2] / "protocols" / "short.json"


def run(*arguments):
    subprocess.run([PROGRAM, *map(str, arguments), "--quiet"], check=True)


class Analyses(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        cls.database = cls.folder / "study.db"
        run("study", "simulate", PROTOCOL, "--kind", "generator", "--subjects", 3, "--seed", 3, "--db", cls.database)
        cls.before = cls.database.read_bytes()
        cls.analysis = ocelli.analyse(cls.database, progress=False)
        cls.after = cls.database.read_bytes()
        run("analyse", cls.database, "--csv", "-o", cls.folder / "report")
        cls.report = json.loads((cls.folder / "report" / "report.json").read_text(encoding="utf-8"))

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def test_nothing_is_written(self):
        self.assertEqual(self.before, self.after)

    def test_the_report_is_that_of_the_program(self):
        ours = {**self.analysis.report, "created": ""}
        self.assertEqual(ours, {**self.report, "created": ""})

    def test_tables_have_the_numbers_of_the_report(self):
        tables = {each["id"]: each for each in self.report["elements"] if each["type"] == "table"}
        self.assertEqual(set(self.analysis.tables), set(tables))
        self.assertGreater(len(tables), 30)
        numbers = 0
        for name, theirs in tables.items():
            ours = self.analysis.tables[name]
            self.assertEqual(ours.title, theirs["caption"])
            self.assertEqual({len(column) for column in ours.values()}, {len(theirs["rows"])}, name)
            found = [value for column in ours.values() for value in column if isinstance(value, float)]
            written = []
            for row in theirs["rows"]:
                for cell in row:
                    written += [cell[key] for key in ("value",) if cell.get(key) is not None]
                    written += [bound for bound in cell.get("interval", ()) if bound is not None]
            self.assertEqual(sorted(found), sorted(written), name)
            numbers += len(found)
        self.assertGreater(numbers, 300)

    def test_columns_say_what_they_are(self):
        table = self.analysis.tables["find-time"]
        self.assertEqual(list(table)[:5], ["What", "Estimate", "95 % interval lower", "95 % interval upper", "SE"])
        self.assertLess(table["95 % interval lower"][0], table["Estimate"][0])
        self.assertLess(table["Estimate"][0], table["95 % interval upper"][0])

    def test_cells_are_those_of_the_file(self):
        for name in ("cells", "trials", "answers", "exclusions"):
            with (self.folder / "report" / "tables" / f"{name}.csv").open(newline="", encoding="utf-8") as file:
                rows = list(csv.DictReader(file))
            ours = getattr(self.analysis, name)
            for column, values in ours.items():
                for value, row in zip(values, rows, strict=True):
                    expected = row[column]
                    if isinstance(value, bool):
                        self.assertEqual(value, expected == "1")
                    elif isinstance(value, (int, float)):
                        self.assertEqual(value, float(expected), f"{name}.{column}")
                    else:
                        self.assertEqual(value or "", expected, f"{name}.{column}")
        self.assertGreater(len(self.analysis.cells["cell"]), 500)
        self.assertGreater(len(self.analysis.trials["trial_id"]), 20)

    def test_who_was_analysed(self):
        self.assertEqual((self.analysis.subjects, self.analysis.simulated, self.analysis.failures), (3, True, []))
        self.assertGreater(self.analysis.trial_count, 20)
        self.assertEqual(len(self.analysis.data_sha256), 64)
        self.assertIn("simulated", repr(self.analysis))

    def test_pandas_takes_them(self):
        frame = self.analysis.tables["find-means"].frame()
        self.assertEqual(list(frame["objects"]), ["stationary", "moving"])
        self.assertEqual(frame["Pinhole"].dtype.kind, "f")

    def test_without_pandas_an_error_says_so(self):
        imported = builtins.__import__

        def without(name, *arguments, **keywords):
            if name == "pandas":
                raise ImportError("No module named 'pandas'")
            return imported(name, *arguments, **keywords)

        with mock.patch.object(builtins, "__import__", without), self.assertRaises(ocelli.WorkError) as caught:
            self.analysis.cells.frame()
        self.assertIn("pandas", caught.exception.next)

    def test_some_tasks_and_another_seed(self):
        some = ocelli.analyse([self.database], only=["count"], seed=7, progress=False)
        self.assertIn("count-means", some.tables)
        self.assertNotIn("find-time", some.tables)
        resampled = "count-right-resampled"
        self.assertNotEqual(some.tables[resampled], self.analysis.tables[resampled])

    def test_tables_of_an_export_are_the_same_study(self):
        run("study", "export", "--db", self.database, "-o", self.folder / "export")
        again = ocelli.analyse(self.folder / "export", protocol=PROTOCOL, only=["find"], progress=False)
        self.assertEqual(again.data_sha256, self.analysis.data_sha256)
        self.assertEqual(again.tables["find-means"], self.analysis.tables["find-means"])

    def test_what_is_wrong(self):
        wrong = {
            "no task": lambda: ocelli.analyse(self.database, only=["dance"]),
            "missing.db": lambda: ocelli.analyse(self.folder / "missing.db"),
            "unless-people": lambda: ocelli.analyse(self.database, simulated="all"),
            "protocol": lambda: ocelli.analyse(self.database, columns=ocelli.column_maps()[0], protocol=PROTOCOL),
        }
        for message, call in wrong.items():
            with self.subTest(message), self.assertRaises(ocelli.InputError) as caught:
                call()
            self.assertIn(message, str(caught.exception))

    def test_progress_and_its_end(self):
        class Enough(Exception):
            pass

        told = []

        def stop(stage, fraction):
            told.append(stage)
            if len(told) > 2:
                raise Enough

        with self.assertRaises(Enough):
            ocelli.analyse(self.database, progress=stop)
        self.assertEqual(len(told), 3)

    def test_ctrl_c_ends_it(self):
        # From its own progress, so that the work has begun for sure.
        told = []

        def interrupt(stage, fraction):
            told.append(stage)
            if len(told) == 2:
                signal.raise_signal(signal.SIGINT)

        with self.assertRaises(KeyboardInterrupt):
            ocelli.analyse(self.database, progress=interrupt)
        self.assertEqual(len(told), 2)


if __name__ == "__main__":
    unittest.main()
