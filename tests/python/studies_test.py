"""Tables of studies: those of the export, as values."""

import csv
import os
import pathlib
import subprocess
import tempfile
import unittest

import ocelli

PROGRAM = os.environ["OCELLI_PROGRAM"]
PROTOCOL = pathlib.Path(__file__).parents[2] / "protocols" / "short.json"
FORMULA = ("=", "+", "-", "@", "\t", "\r")  # what the export puts a ' before


def run(*arguments):
    subprocess.run([PROGRAM, *map(str, arguments), "--quiet"], check=True)


def text_of(value):
    """A value as the export writes it."""
    if value is None:
        return ""
    if isinstance(value, str):
        return "'" + value if value.startswith(FORMULA) else value
    return value


class Studies(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        cls.database = cls.folder / "study.db"
        run("study", "simulate", PROTOCOL, "--kind", "generator", "--subjects", 3, "--seed", 3, "--db", cls.database)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def test_they_are_those_of_the_export(self):
        run("study", "export", "--db", self.database, "-o", self.folder / "tables", "--frames", "--inputs", "--gaze")
        tables = ocelli.study.tables(self.database, frames=True, inputs=True, gaze=True)
        files = {path.stem for path in (self.folder / "tables").glob("*.csv")} - {"columns"}
        self.assertEqual(set(tables), files)
        self.assertGreater(len(tables["trials"]["trial_id"]), 20)
        for name, table in tables.items():
            with (self.folder / "tables" / f"{name}.csv").open(newline="", encoding="utf-8") as file:
                rows = list(csv.DictReader(file))
            self.assertEqual({len(values) for values in table.values()}, {len(rows)}, name)
            for column, values in table.items():
                for value, row in zip(values, rows, strict=True):
                    expected = row[column]
                    if isinstance(value, float):
                        self.assertEqual(value, float(expected), f"{name}.{column}")
                    else:
                        self.assertEqual(str(text_of(value)), expected, f"{name}.{column}")

    def test_columns_say_what_they_mean(self):
        run("study", "export", "--db", self.database, "-o", self.folder / "meanings")
        with (self.folder / "meanings" / "columns.csv").open(newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        tables = ocelli.study.tables(self.database)
        said = {(f"{name}.csv", column): meaning for name, table in tables.items() for column, meaning in table.meanings.items()}
        self.assertEqual({(row["file"], row["column"]): (row["unit"], row["meaning"]) for row in rows}, said)

    def test_simulated_subjects_say_so(self):
        for table in ocelli.study.tables(self.database).values():
            if "simulated" in table:
                self.assertEqual(set(table["simulated"]) - {1}, set())

    def test_pandas_takes_them(self):
        import pandas

        trials = pandas.DataFrame(ocelli.study.tables(self.database)["trials"])
        self.assertEqual(trials["trial_id"].dtype.kind, "i")
        self.assertGreater(trials[trials.counts == 1].groupby("view").size().sum(), 20)

    def test_nothing_is_written(self):
        before = self.database.read_bytes()
        mode = self.database.stat().st_mode
        self.database.chmod(0o400)
        try:
            ocelli.study.tables(self.database)
        finally:
            self.database.chmod(mode)
        self.assertEqual(self.database.read_bytes(), before)

    def test_what_is_no_study(self):
        (self.folder / "none.db").write_text("no database at all, but some text of a page or so" * 100)
        for path, message in ((self.folder / "none.db", "none.db"), (self.folder / "missing.db", "missing.db")):
            with self.assertRaises(ocelli.InputError) as raised:
                ocelli.study.tables(path)
            self.assertIn(message, str(raised.exception))


if __name__ == "__main__":
    unittest.main()
