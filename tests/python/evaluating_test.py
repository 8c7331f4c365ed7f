"""Evaluation as rows of a table."""

import itertools
import unittest

import numpy

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

    def test_one_camera_needs_no_list(self):
        rows = ocelli.evaluate(
            "builtin:fence", "di", size=(72, 48), interior_views=2, runs=1, compare_images=False, progress=False
        )
        self.assertEqual([row["name"] for row in rows], ["di"])

    def test_a_cell_that_reaches_into_an_object(self):
        corners = numpy.array(list(itertools.product([-0.5, 0.5], repeat=3)))
        faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
        cube = ocelli.Mesh(corners, [triangle for a, b, c, d in faces for triangle in ((a, b, c), (a, c, d))])
        # Four of the cell's corners are at (+-0.4, +-0.4, 0.4).
        view = ocelli.View(eye=(0, 0, 0.8), fov_vertical_degrees=60)
        with self.assertRaisesRegex(ocelli.InputError, "inside"):
            ocelli.evaluate(cube, ["di"], view=view, cell_side=0.8, size=(36, 24), progress=False)


if __name__ == "__main__":
    unittest.main()
