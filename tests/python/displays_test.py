"""Slices of displays, and what an eye sees of them."""

import pathlib
import tempfile
import unittest

import numpy

import ocelli


class Displays(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.volume = ocelli.slice("builtin:teapot", "perspecta-99", progress=False)

    def test_levels(self):
        volume = self.volume
        self.assertEqual(len(volume), volume.slices)
        levels = volume.levels(0)
        self.assertEqual(levels.shape, (volume.height, volume.width, 3))
        lit = sum(int((volume.levels(i).max(axis=2) > 0).sum()) for i in range(volume.slices))
        self.assertEqual(lit, volume.lit_voxels)
        with self.assertRaises(IndexError):
            volume.levels(volume.slices)

    def test_bit_planes_are_the_volumes_memory(self):
        planes = self.volume.bit_planes(3)
        again = self.volume.bit_planes(3)
        self.assertEqual(planes.__array_interface__["data"][0], again.__array_interface__["data"][0])
        bits = numpy.unpackbits(planes, axis=2, bitorder="little")[..., : self.volume.width]
        lit = self.volume.levels(3).max(axis=2) > 0
        numpy.testing.assert_array_equal(bits.max(axis=0) > 0, lit)

    def test_files(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "teapot.svol"
            self.volume.write(path)
            self.assertEqual(ocelli.DisplayVolume.read(path), self.volume)

    def test_observed(self):
        image = ocelli.observe(self.volume, size=(96, 96))
        self.assertEqual(image.shape, (96, 96, 3))
        self.assertGreater(image.max(), 0.5)
        with self.assertRaises(ocelli.InputError):
            ocelli.observe(self.volume, eye=(0, 0, 0))

    def test_profiles(self):
        self.assertIn("perspecta", ocelli.profiles())
        with self.assertRaises(ocelli.InputError):
            ocelli.slice("builtin:teapot", "television", progress=False)


if __name__ == "__main__":
    unittest.main()
