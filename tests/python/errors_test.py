"""Errors have three parts."""

import unittest

import ocelli


class Errors(unittest.TestCase):
    def test_a_missing_file(self):
        with self.assertRaises(ocelli.InputError) as caught:
            ocelli.ocri.read("/nowhere/image.exr")
        error = caught.exception
        self.assertIn("/nowhere/image.exr", error.where)
        self.assertTrue(error.what)
        self.assertTrue(error.next)
        self.assertIn(error.what, str(error))
        self.assertIn("try: " + error.next, str(error))
        self.assertIsInstance(error, ValueError)

    def test_what_cannot_be_written(self):
        mesh = ocelli.scene.load("builtin:teapot").mesh
        with self.assertRaises(ocelli.WorkError) as caught:
            mesh.write_ply("/nowhere/teapot.ply")
        self.assertIn("/nowhere", caught.exception.where)
        self.assertIn("try: ", str(caught.exception))
        self.assertIsInstance(caught.exception, OSError)

    def test_an_unknown_scene_lists_the_names(self):
        with self.assertRaises(ocelli.InputError) as caught:
            ocelli.scene.load("builtin:moon")
        self.assertIn("teapot", str(caught.exception))
        self.assertIn("teapot", ocelli.scene.builtins())

    def test_made_by_hand(self):
        error = ocelli.InputError("no", "here", "there")
        self.assertEqual((error.what, error.where, error.next), ("no", "here", "there"))


if __name__ == "__main__":
    unittest.main()
