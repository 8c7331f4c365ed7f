"""Cameras as arrays: a user's own, and the rays of those of the toolkit."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import numpy

import ocelli

PROGRAM = os.environ["OCELLI_PROGRAM"]
SIZE = (72, 48)


def pinhole_rays(view, width, height):
    """The rays of a pinhole, by its own arithmetic: the eye, and directions through the centres of the pixels."""
    eye, target, up = (numpy.array(each) for each in (view.eye, view.target, view.up))
    back = (eye - target) / numpy.linalg.norm(eye - target)
    right = numpy.cross(up, back)
    right /= numpy.linalg.norm(right)
    above = numpy.cross(back, right)
    half = numpy.tan(numpy.radians(view.fov_vertical_degrees) / 2)
    y = half * (1 - 2 * (numpy.arange(height) + 0.5) / height)
    x = half * width / height * (2 * (numpy.arange(width) + 0.5) / width - 1)
    directions = -back + x[None, :, None] * right + y[:, None, None] * above
    return eye, directions


class Pinhole:
    name = "by hand"

    def __init__(self, view):
        self.view = view

    def rays(self, width, height):
        return pinhole_rays(self.view, width, height)


class Answers:
    """Gives the same answer whatever it is asked."""

    def __init__(self, answer, **notes):
        self.answer = answer
        vars(self).update(notes)

    def rays(self, width, height):
        return self.answer


class OwnCameras(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.teapot = ocelli.scene.load("builtin:teapot")
        cls.view = ocelli.View(eye=(3, 2, 9))

    def test_a_pinhole_by_hand_is_the_pinhole(self):
        theirs = ocelli.render(self.teapot, Pinhole(self.view), view=self.view, size=SIZE)
        ours = ocelli.render(self.teapot, "di", view=self.view, size=SIZE, method="raycast")
        self.assertEqual(theirs.camera, "by hand")
        # Directions are rounded to floats: on outlines a ray may go either way.
        self.assertLess((theirs.held != ours.held).mean(), 0.005)
        both = (theirs.held == 1) & (ours.held == 1)
        self.assertGreater(both.sum(), 400)
        worst = numpy.abs(theirs.points() - ours.points())[both].max(axis=-1)
        self.assertLess(numpy.median(worst), 1e-5)
        self.assertLess(numpy.quantile(worst, 0.99), 1e-3)

    def test_it_is_built_and_evaluated_like_ours(self):
        images = ocelli.ocri.build(self.teapot, Pinhole(ocelli.View()), size=SIZE)
        self.assertGreater(len(ocelli.ocri.mesh(images)), 100)
        rows = ocelli.evaluate(
            self.teapot, [Pinhole(ocelli.View()), "di", "ddoc"], size=SIZE, interior_views=2, compare_images=False, runs=1
        )
        own, di, ddoc = rows
        self.assertEqual([own["name"], di["name"], ddoc["name"]], ["by hand", "di", "ddoc"])
        missing = [each["missing_strict"]["edges"] for each in (own, di)]
        # The same samples miss the same, but for single pixels on outlines.
        self.assertAlmostEqual(missing[0], missing[1], delta=0.15 * missing[1])

    def test_arrays_alone_are_a_camera(self):
        origins, directions = pinhole_rays(self.view, *SIZE)
        rays = ocelli.Rays(numpy.broadcast_to(origins, directions.shape), directions, name="arrays")
        image = ocelli.render(self.teapot, rays, view=self.view, size=SIZE)
        again = ocelli.render(self.teapot, Pinhole(self.view), view=self.view, size=SIZE)
        numpy.testing.assert_array_equal(image.color, again.color)

    def test_pixels_without_a_ray_see_nothing(self):
        origins, directions = pinhole_rays(self.view, *SIZE)
        directions[:, :36] = 0
        directions[:10] = numpy.nan
        rays = ocelli.Rays(numpy.broadcast_to(origins, directions.shape), directions)
        self.assertEqual(rays.ray_count, 36 * 38)
        held = ocelli.render(self.teapot, rays, view=self.view, size=SIZE).held
        self.assertEqual(held[:, :36].sum() + held[:10].sum(), 0)
        self.assertGreater(held.sum(), 100)

    def test_a_lens_moves_with_the_view(self):
        local = ocelli.View(eye=(0, 0, 0), target=(0, 0, -1), fov_vertical_degrees=self.view.fov_vertical_degrees)
        lens = Answers(pinhole_rays(local, *SIZE), frame="view", name="lens")
        moved = ocelli.render(self.teapot, lens, view=self.view, size=SIZE)
        world = ocelli.render(self.teapot, Pinhole(self.view), view=self.view, size=SIZE)
        self.assertGreater(moved.held.sum(), 400)
        self.assertLess((moved.held != world.held).mean(), 0.005)

    def test_near_and_far_end_the_rays(self):
        whole = Answers(pinhole_rays(self.view, *SIZE))
        self.assertGreater(ocelli.render(self.teapot, whole, view=self.view, size=SIZE).held.sum(), 400)
        for notes in ({"far": 5.0}, {"near": 20.0}):
            with self.subTest(notes), self.assertRaises(ocelli.InputError):
                ocelli.render(self.teapot, Answers(whole.answer, **notes), view=self.view, size=SIZE)

    def test_errors_say_what_to_give(self):
        origins, directions = pinhole_rays(self.view, *SIZE)
        wrong = {
            "is a class": Pinhole,
            "no arrays of origins and directions": Answers(None),
            "could not be broadcast": Answers((origins, directions[:-1])),
            "not enough values": Answers((directions,)),
            "no pixel of the ray map has a ray": Answers((origins, numpy.zeros_like(directions))),
            "there is no frame": Answers((origins, directions), frame="elsewhere"),
            "is no camera": 7,
        }
        for message, camera in wrong.items():
            with self.subTest(message):
                with self.assertRaises(ocelli.InputError) as raised:
                    ocelli.render(self.teapot, camera, view=self.view, size=SIZE)
                self.assertIn(message, str(raised.exception))
        with self.assertRaises(ocelli.InputError) as raised:
            ocelli.render(self.teapot, Pinhole(self.view), size=SIZE, cell_side_radii=2)
        self.assertIn("cell_side_radii", raised.exception.what)
        with self.assertRaises(ocelli.InputError):
            ocelli.Rays(origins, directions)  # two shapes
        with self.assertRaises(ocelli.InputError):
            ocelli.Rays(directions[..., :2], directions[..., :2])

    def test_errors_of_the_camera_itself_arrive(self):
        class Fails:
            def rays(self, width, height):
                raise ZeroDivisionError("mine")

        with self.assertRaises(ZeroDivisionError):
            ocelli.render(self.teapot, Fails(), size=SIZE)


class OurRays(unittest.TestCase):
    def test_rays_of_a_pinhole(self):
        view = ocelli.View(eye=(1, 2, 9))
        rays = ocelli.camera.rays("di", view=view, size=SIZE)
        self.assertEqual((rays.width, rays.height, rays.ray_count, rays.max_segments), (*SIZE, 72 * 48, 1))
        _, directions = pinhole_rays(view, *SIZE)
        directions /= numpy.linalg.norm(directions, axis=-1, keepdims=True)
        self.assertLess(numpy.abs(rays.directions - directions).max(), 1e-5)
        # Rays begin at the near plane, on the line from the eye.
        beside = numpy.cross(rays.origins - numpy.array(view.eye), directions)
        self.assertLess(numpy.abs(beside).max(), 1e-5)

    def test_bent_rays_come_point_by_point(self):
        rays = ocelli.camera.rays("comprehensive", scene="builtin:maze", size=SIZE)
        self.assertGreater(rays.max_segments, 1)
        lengths = {len(rays.ray(x, y)[1]) for x in range(0, 72, 6) for y in range(0, 48, 6)}
        self.assertGreater(max(lengths), 2)
        for x, y in ((10, 20), (36, 24), (70, 40)):
            points, t = rays.ray(x, y)
            self.assertEqual(points.shape, (len(t), 3))
            self.assertTrue((numpy.diff(t) > 0).all())
            if len(t):
                numpy.testing.assert_array_equal(points[0], rays.origins[y, x])
        with self.assertRaises(IndexError):
            rays.ray(72, 0)

    def test_arrays_of_a_ray_are_views_and_outlive_it(self):
        rays = ocelli.camera.rays("di", size=SIZE)
        first, second = rays.ray(3, 4)[0], rays.ray(3, 4)[0]
        self.assertEqual(first.ctypes.data, second.ctypes.data)
        self.assertFalse(first.flags.writeable)
        copy = first.copy()
        del rays, second
        numpy.testing.assert_array_equal(first, copy)

    def test_the_scene_is_asked_for_where_it_is_needed(self):
        with self.assertRaises(ocelli.InputError) as raised:
            ocelli.camera.rays("ddoc", size=SIZE)
        self.assertEqual(raised.exception.where, "scene")
        with self.assertRaises(ocelli.InputError):
            ocelli.camera.rays("eoc-hv", scene="builtin:teapot", size=SIZE)  # which image of it?
        self.assertEqual(ocelli.camera.rays("eoc-hv", scene="builtin:teapot", size=SIZE, image=1).height, 48)

    def test_files_go_to_the_program_and_back(self):
        with tempfile.TemporaryDirectory() as folder:
            ours, theirs, picture = (pathlib.Path(folder) / name for name in ("ours.exr", "theirs.exr", "a.png"))
            rays = ocelli.camera.rays("ddoc", scene="builtin:teapot", size=SIZE)
            rays.write(ours)
            subprocess.run(
                [PROGRAM, "camera", "rays", "ddoc", "--scene", "builtin:teapot", "--size", "72x48", "-o", theirs, "--quiet"],
                check=True,
            )
            self.assertEqual(ours.read_bytes(), theirs.read_bytes())
            back = ocelli.Rays.read(theirs)
            self.assertEqual(back.name, "ddoc")
            numpy.testing.assert_allclose(back.origins, rays.origins, atol=1e-5)
            image = ocelli.render("builtin:teapot", str(theirs), size=SIZE)
            subprocess.run(
                [PROGRAM, "render", "builtin:teapot", "--camera", ours, "--size", "72x48", "-o", picture, "--quiet"], check=True
            )
            drawn = pathlib.Path(folder) / "drawn.png"
            image.write_png(drawn)
            self.assertEqual(drawn.read_bytes(), picture.read_bytes())
            (pathlib.Path(folder) / "none.exr").write_text("no rays")
            with self.assertRaises(ocelli.InputError):
                ocelli.Rays.read(pathlib.Path(folder) / "none.exr")

    def test_notes_are_kept(self):
        view = ocelli.View(eye=(1, 2, 9))
        rays = ocelli.Rays(numpy.zeros((2, 3, 3)), numpy.ones((2, 3, 3)), name="x", frame="view", wraps_around=True, view=view)
        self.assertEqual((rays.name, rays.frame, rays.wraps_around, rays.view), ("x", "view", True, view))
        self.assertEqual(json.loads(rays.view.json()), json.loads(view.json()))


if __name__ == "__main__":
    unittest.main()
