"""Evaluation as rows of a table."""

import unittest

import ocelli


class Evaluation(unittest.TestCase):
    def test_rows_for_pandas(self):
        rows = ocelli.evaluate(
            "builtin:fence", ["di", {"camera": "ddoc", "name": "mine"}], size=(72, 48), interior_views=2, runs=1,
            compare_images=False, progress=False,
        )
        self.assertEqual([row["name"] for row in rows], ["di", "mine"])
        self.assertGreater(rows[0]["triangles"], 0)
        import pandas

        table = pandas.json_normalize(rows)
        self.assertEqual(len(table), 2)
        self.assertIn("name", table.columns)

    def test_a_cell_that_reaches_into_an_object(self):
        with self.assertRaises(ocelli.InputError):
            ocelli.evaluate("builtin:statues", ["di"], view=ocelli.View(eye=(0, 0, 1.5), fov_vertical_degrees=60),
                            cell_side=4, size=(36, 24), progress=False)


if __name__ == "__main__":
    unittest.main()
