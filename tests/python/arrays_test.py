"""Arrays are the memory of C++ objects: same addresses, alive as long as they are looked at, and read-only."""

import gc
import unittest

import numpy

import ocelli

POSITIONS = numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], dtype=numpy.float32)
TRIANGLES = numpy.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]], dtype=numpy.uint32)


def address(array):
    return array.__array_interface__["data"][0]


class ArrayTest(unittest.TestCase):
    def assert_same_memory(self, one, other):
        """Both are alive here: two copies would have two addresses."""
        self.assertEqual(address(one), address(other))


class MeshArrays(ArrayTest):
    def test_what_goes_in_comes_out(self):
        colors = numpy.linspace(0, 1, 12, dtype=numpy.float32).reshape(4, 3)
        mesh = ocelli.Mesh(POSITIONS, TRIANGLES, colors)
        numpy.testing.assert_array_equal(mesh.positions, POSITIONS)
        numpy.testing.assert_array_equal(mesh.triangles, TRIANGLES)
        numpy.testing.assert_array_equal(mesh.colors, colors)
        self.assertEqual(mesh.positions.dtype, numpy.float32)
        self.assertEqual(mesh.triangles.dtype, numpy.uint32)
        self.assertEqual(len(mesh), 4)

    def test_views_are_not_copies(self):
        mesh = ocelli.Mesh(POSITIONS, TRIANGLES)
        self.assert_same_memory(mesh.positions, mesh.positions)
        scene = ocelli.Scene(mesh)
        self.assert_same_memory(scene.mesh.positions, scene.mesh.positions)

    def test_views_keep_their_object(self):
        positions = ocelli.Mesh(POSITIONS, TRIANGLES).positions
        gc.collect()
        numpy.testing.assert_array_equal(positions, POSITIONS)
        mesh = ocelli.Scene(ocelli.Mesh(POSITIONS, TRIANGLES)).mesh
        gc.collect()
        numpy.testing.assert_array_equal(mesh.positions, POSITIONS)

    def test_views_are_read_only(self):
        mesh = ocelli.Mesh(POSITIONS, TRIANGLES)
        with self.assertRaises(ValueError):
            mesh.triangles[0, 0] = 99

    def test_other_types_and_layouts_are_converted(self):
        mesh = ocelli.Mesh(POSITIONS.astype(float).tolist(), numpy.asfortranarray(TRIANGLES.astype(numpy.int64)))
        numpy.testing.assert_array_equal(mesh.positions, POSITIONS)
        numpy.testing.assert_array_equal(mesh.triangles, TRIANGLES)

    def test_a_mesh_without_colors_has_none(self):
        self.assertIsNone(ocelli.Mesh(POSITIONS, TRIANGLES).colors)

    def test_broken_meshes_are_refused(self):
        with self.assertRaisesRegex(ocelli.InputError, "triangles"):
            ocelli.Mesh(POSITIONS, TRIANGLES[:, :2])
        with self.assertRaises(ocelli.InputError):
            ocelli.Mesh(POSITIONS, TRIANGLES + 4)
        with self.assertRaises(ocelli.InputError):
            ocelli.Mesh(POSITIONS * numpy.nan, TRIANGLES)
        with self.assertRaises(ocelli.InputError):
            ocelli.Mesh(POSITIONS, TRIANGLES, POSITIONS[:2])


class ImageArrays(ArrayTest):
    @classmethod
    def setUpClass(cls):
        cls.images = ocelli.ocri.build("builtin:teapot", "ddoc", size=(90, 60), progress=False)

    def test_shapes(self):
        image = self.images[0]
        self.assertEqual(image.color.shape, (60, 90, 3))
        self.assertEqual(image.t.shape, (60, 90))
        self.assertEqual(image.displacement.shape, (60, 90, 2))
        self.assertEqual(int(image.held.sum()), image.sample_count)

    def test_views_are_not_copies(self):
        self.assert_same_memory(self.images[0].color, self.images[-1].color)
        first = ocelli.ocri.build("builtin:teapot", "ddoc", size=(30, 20), progress=False)[0]
        gc.collect()
        self.assertGreater(first.color.max(), 0)

    def test_points_lie_where_samples_are(self):
        image = ocelli.render("builtin:teapot", size=(90, 60), progress=False)
        points = image.points()
        self.assertTrue((numpy.isfinite(points[..., 0]) == (image.held == 1)).all())
        held = points[image.held == 1]
        # A fitted scene; 1e-3: what a float32 z at distance 10 rounds to, a hundred times over.
        self.assertLess(numpy.linalg.norm(held, axis=1).max(), 1 + 1e-3)
        # t is the distance along the view direction, and the eye is at z = 10; the same bound.
        numpy.testing.assert_allclose(10 - held[:, 2], image.t[image.held == 1], atol=1e-3)

    def test_there_is_no_image_beyond_the_last(self):
        with self.assertRaises(IndexError):
            self.images[1]
        self.assertEqual(len(list(self.images)), 1)

    def test_srgb(self):
        # IEC 61966-2-1: linear 0.5 is 187.5 of 255.
        linear = numpy.array([[[0, 0.5, 1]]], dtype=numpy.float32)
        numpy.testing.assert_array_equal(ocelli.srgb(linear), [[[0, 188, 255]]])
        with self.assertRaises(ocelli.InputError):
            ocelli.srgb(linear[0])


if __name__ == "__main__":
    unittest.main()
