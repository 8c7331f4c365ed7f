"""Cameras by name and options, and the same images as the program `ocelli` makes."""

import os
import pathlib
import subprocess
import tempfile
import unittest

import numpy

import ocelli

PROGRAM = os.environ["OCELLI_PROGRAM"]
SIZE = (72, 48)


def run(*arguments):
    subprocess.run([PROGRAM, *arguments, "--quiet"], check=True)


class Cameras(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.teapot = ocelli.scene.load("builtin:teapot")
        cls.maze = ocelli.scene.load("builtin:maze")

    def test_every_representation_with_images(self):
        for name in ocelli.camera.representations():
            with self.subTest(name):
                try:
                    images = ocelli.ocri.build(self.teapot, name, size=SIZE)
                except ocelli.InputError as error:
                    self.assertIn("is a mesh and has no image", error.what)
                    continue
                self.assertGreater(sum(image.sample_count for image in images), 0)
                self.assertGreater(len(ocelli.ocri.mesh(images)), 0)

    def test_constructors_are_cameras_too(self):
        image = ocelli.render(self.maze, "comprehensive", size=SIZE)
        self.assertGreater(image.sample_count, SIZE[0] * SIZE[1] / 4)
        self.assertEqual(image.position.shape, (48, 72, 3))
        self.assertIn("portal", ocelli.camera.constructors())

    def test_raster_agrees_with_rays(self):
        raster = ocelli.render(self.teapot, size=SIZE)
        rays = ocelli.render(self.teapot, size=SIZE, method="raycast")
        # Pixels on outlines may go either way.
        both = (raster.held == 1) & (rays.held == 1)
        self.assertLess((raster.held != rays.held).mean(), 0.005)
        # What float32 leaves of a distance of 10 at a grazing triangle: 0.0007 is the largest here.
        self.assertLess(numpy.abs(raster.t - rays.t)[both].max(), 2e-3)

    def test_the_program_makes_the_same_image(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "teapot.exr"
            run("ocri", "build", "builtin:teapot", "--camera", "ddoc", "--size", "72x48", "-o", str(path))
            theirs = ocelli.ocri.read(path)[0]
            images = ocelli.ocri.build("builtin:teapot", "ddoc", size=SIZE, progress=False)
            numpy.testing.assert_array_equal(theirs.color, images[0].color)
            numpy.testing.assert_array_equal(theirs.displacement, images[0].displacement)
            ocelli.ocri.write(pathlib.Path(folder) / "again.exr", images)
            again = ocelli.ocri.read(pathlib.Path(folder) / "again.exr")[0]
            numpy.testing.assert_array_equal(again.t, images[0].t)

    def test_options_are_keywords_fields_and_files(self):
        fence = ocelli.scene.load("builtin:fence")
        by_keyword = ocelli.ocri.build(fence, "cell", cell_side_radii=0.4, size=SIZE)
        by_field = ocelli.ocri.build(fence, {"camera": "cell", "cell_side_radii": 0.4}, size=SIZE)
        numpy.testing.assert_array_equal(by_keyword[0].color, by_field[0].color)
        with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
            file.write('{"camera": "cell", "cell_side_radii": 0.4}')
            file.flush()
            by_file = ocelli.ocri.build(fence, file.name, size=SIZE)
        numpy.testing.assert_array_equal(by_keyword[0].color, by_file[0].color)
        other = ocelli.ocri.build(fence, "cell", cell_side_radii=1.6, size=SIZE)
        self.assertNotEqual(by_keyword[0].sample_count, other[0].sample_count)

    def test_options_are_listed(self):
        for name in ocelli.camera.representations():
            for option in ocelli.camera.options(name):
                with self.subTest(name + "." + option["name"]):
                    self.assertTrue(option["meaning"])
        [side] = [option for option in ocelli.camera.options("cell") if option["name"] == "cell_side_radii"]
        self.assertAlmostEqual(side["default"], 1.6, places=6)
        with self.assertRaises(ocelli.InputError):
            ocelli.camera.options("telephoto")

    def test_unknown_names_and_options_are_told(self):
        with self.assertRaises(ocelli.InputError) as caught:
            ocelli.ocri.build(self.teapot, "telephoto")
        self.assertIn("ddoc", caught.exception.next)
        with self.assertRaisesRegex(ocelli.InputError, "tiles"):
            ocelli.ocri.build(self.teapot, "ddoc", tiles=3)
        with self.assertRaises(ocelli.InputError):
            ocelli.render(self.teapot, method="magic")
        for camera in ("ddoc", "portal"):
            with self.assertRaisesRegex(ocelli.InputError, "magic"):
                ocelli.ocri.build(self.teapot, camera, construction="magic")
        with self.assertRaises(ocelli.InputError):
            ocelli.render(self.teapot, size=(0, 10))
        with self.assertRaises(ocelli.InputError):
            ocelli.render(7)

    def test_a_view_that_sees_nothing(self):
        away = ocelli.View(eye=(0, 0, 10), target=(0, 0, 20))
        with self.assertRaises(ocelli.InputError):
            ocelli.render(self.teapot, view=away, size=SIZE)

    def test_resampled_from_the_same_eye(self):
        images = ocelli.ocri.build(self.teapot, "di", size=SIZE)
        again = ocelli.resample(images, ocelli.View(), size=SIZE)
        self.assertFalse(again.is_warped)
        held = images[0].held == 1
        # The rays of the image itself: half precision of interpolation at a pixel's own centre.
        numpy.testing.assert_allclose(again.color[held], images[0].color[held], atol=1e-4)


class Views(unittest.TestCase):
    def test_round_trip(self):
        view = ocelli.View(eye=(1, 2, 3), target=(0, 0.5, 0), fov_vertical_degrees=40)
        self.assertEqual(ocelli.View.from_json(view.json()), view)
        self.assertEqual(view.eye, (1, 2, 3))
        self.assertEqual(view.fov_vertical_degrees, 40)

    def test_nonsense_is_refused(self):
        with self.assertRaises(ocelli.InputError):
            ocelli.View(eye=(0, 0, 0), target=(0, 0, 0))
        with self.assertRaises(TypeError):
            ocelli.View(eye=(0, 0))


if __name__ == "__main__":
    unittest.main()
