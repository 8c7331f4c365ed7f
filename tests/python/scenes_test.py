"""Scenes with labels and textures."""

import pathlib
import tempfile
import unittest
import warnings

import numpy

import ocelli

SQUARE = """mtllib square.mtl
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
vt 0 0
vt 1 0
vt 1 1
vt 0 1
usemtl m
f 1/1 2/2 3/3 4/4
"""
# Of 32 x 32 pixels: an uncompressed TGA.
GREY = bytes([0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 32, 0, 32, 0, 24, 0]) + bytes([128] * 32 * 32 * 3)


class LoadedScenes(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_labels_are_geometry(self):
        table = self.folder / "labels.csv"
        table.write_text("x,y,z,text,color\n0,2,0,Hi,#00ff00\n")
        labelled = ocelli.scene.load("builtin:box", labels=table)
        plain = ocelli.scene.load("builtin:box")
        self.assertGreater(len(labelled.mesh), len(plain.mesh) + 10)
        self.assertTrue((numpy.asarray(labelled.mesh.colors) == (0, 1, 0)).all(axis=1).any())
        table.write_text("x,y,z\n0,2,0\n")
        with self.assertRaisesRegex(ocelli.InputError, "text"):
            ocelli.scene.load("builtin:box", labels=table)

    def test_textures_add_as_many_triangles_as_they_may(self):
        (self.folder / "square.obj").write_text(SQUARE)
        (self.folder / "square.mtl").write_text("newmtl m\nmap_Kd grey.tga\n")
        (self.folder / "grey.tga").write_bytes(GREY)
        whole = ocelli.scene.load(self.folder / "square.obj")
        self.assertEqual(len(whole.mesh), 8 * 32 * 32)
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            few = ocelli.scene.load(self.folder / "square.obj", texture_triangles=600)
        self.assertEqual(len(few.mesh), 2 * 16 * 16)
        self.assertIn("1/2 of their width", str(told[0].message))


if __name__ == "__main__":
    unittest.main()
