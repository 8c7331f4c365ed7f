"""Seas of images: the same images as those of `ocelli sea`."""

import os
import pathlib
import subprocess
import tempfile
import unittest

import numpy

import ocelli

PROGRAM = os.environ["OCELLI_PROGRAM"]
SCENE = "builtin:boxes,count=6,floor=1"
PLACES = [[0.1 * i, 0.5, 0.05 * (i % 3)] for i in range(7)]


def build(path, **options):
    options = {"positions": PLACES, "size": (64, 32), "proxy_triangles": 200, "progress": False} | options
    return ocelli.sea.build(SCENE, path, **options)


class Seas(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name) / "boxes.sea"

    def test_images_are_those_of_the_program(self):
        sea = build(self.path)
        self.assertEqual(len(sea), 7)
        numpy.testing.assert_array_equal(sea.positions, PLACES)
        self.assertEqual(sea.names, [])
        self.assertEqual(sea.bytes, self.path.stat().st_size)
        sea.verify(decode=True)
        import matplotlib.image

        picture = pathlib.Path(self.folder.name) / "theirs.png"
        for number in (0, 6):
            run = [PROGRAM, "sea", "get", str(self.path), "--image", str(number), "-o", str(picture), "--quiet"]
            subprocess.run(run, check=True, stdout=subprocess.DEVNULL)
            theirs = (matplotlib.image.imread(picture)[..., :3] * 255).round().astype(numpy.uint8)
            numpy.testing.assert_array_equal(sea[number], theirs)
        self.assertEqual(sea[0].shape, (32, 64, 3))
        numpy.testing.assert_array_equal(sea[-1], sea[6])
        self.assertGreater(numpy.ptp(sea[0]), 50, "something is to be seen")

    def test_views_between_images_and_turned(self):
        sea = build(self.path)
        between = sea.view((sea.positions[0] + sea.positions[3]) / 2)
        self.assertEqual(between.shape, (32, 64, 3))
        at = sea.view(sea.positions[2]).astype(int)
        self.assertLess(abs(at - sea[2]).mean(), 3)
        # A quarter to the left: columns move to the right by a quarter of the panorama.
        turned = sea.view(sea.positions[2], yaw=90).astype(int)
        self.assertLess(abs(numpy.roll(at, 16, axis=1) - turned).mean(), 8)
        self.assertGreater(abs(at - turned).mean(), 8)

    def test_settings_are_keywords(self):
        sea = build(self.path, way="direct", i_quality=80, p_codec="jxl", hidden="ddoc", hidden_views=1)
        found = ocelli.sea.settings(sea)
        self.assertEqual((found["i_quality"], found["p_codec"], found["hidden"]), (80, "jxl", "ddoc"))
        plain = build(self.path.with_name("plain.sea"), way="direct", i_quality=80, p_codec="jxl")
        self.assertNotEqual(sea.bytes, plain.bytes, "hidden samples are there")
        self.assertEqual(found["projection"]["width"], 64)

    def test_a_table_and_a_grid_do_as_well(self):
        table = pathlib.Path(self.folder.name) / "places.csv"
        table.write_text("x,y,z\n0,0.5,0\n0.2,0.5,0.1\n", encoding="utf-8")
        self.assertEqual(len(build(self.path, positions=table)), 2)
        other = self.path.with_name("grid.sea")
        self.assertEqual(len(build(other, positions=None, grid=(0, 0, 0.2, 0.1, 0.1), eye_height=0.5)), 6)

    def test_what_is_wrong(self):
        wrong = {
            "way": lambda: build(self.path, way="around"),
            "glow": lambda: build(self.path, glow=1),
            "projection": lambda: build(self.path, projection="pinhole"),
            "positions": lambda: build(self.path, positions=[1, 2, 3]),
            "missing.sea": lambda: ocelli.sea.read("missing.sea"),
        }
        for message, call in wrong.items():
            with self.subTest(message), self.assertRaisesRegex(ocelli.InputError, message):
                call()
        sea = build(self.path)
        with self.assertRaisesRegex(IndexError, "0 to 6"):
            sea[7]
        damaged = bytearray(self.path.read_bytes())
        damaged[len(damaged) // 2] ^= 1
        self.path.with_name("damaged.sea").write_bytes(damaged)
        with self.assertRaises(ocelli.InputError):
            ocelli.sea.read(self.path.with_name("damaged.sea")).verify()


if __name__ == "__main__":
    unittest.main()
