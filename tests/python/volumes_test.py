"""Volumes: arrays without copies, pictures, surfaces and reference images, the same as those of the program."""

import gc
import json
import os
import pathlib
import signal
import subprocess
import tempfile
import threading
import unittest
import warnings

import numpy

import ocelli

PROGRAM = os.environ["OCELLI_PROGRAM"]
SIZE = (72, 48)
SKULL = "builtin:volume,name=skull,size=64"
GREY = {
    "values": "absolute",
    "opacity_length": 1,
    "points": [{"value": 0, "color": "#ffffff", "opacity": 0}, {"value": 1, "color": "#ffffff", "opacity": 0.5}],
}


def run(*arguments):
    subprocess.run([PROGRAM, *map(str, arguments), "--quiet"], check=True)


def address(array):
    return array.__array_interface__["data"][0]


def ball(size=24, dtype=numpy.float32):
    """1 in the middle, 0 at a distance of 1: the faces of the box."""
    k, j, i = numpy.meshgrid(*[numpy.linspace(-1, 1, size)] * 3, indexing="ij")
    return numpy.maximum(0, 1 - numpy.sqrt(i * i + j * j + k * k)).astype(dtype)


class Arrays(unittest.TestCase):
    def test_what_is_dense_is_not_copied(self):
        for dtype in ("uint8", "int8", "uint16", "int16", "uint32", "int32", "float32", "float64"):
            with self.subTest(dtype):
                voxels = numpy.arange(2 * 3 * 4).reshape(2, 3, 4).astype(dtype)
                volume = ocelli.volume(voxels)
                self.assertEqual(address(volume.array), address(voxels))
                self.assertEqual(volume.array.dtype, voxels.dtype)
                self.assertEqual(volume.shape, (2, 3, 4))
                numpy.testing.assert_array_equal(volume.array, voxels)

    def test_an_array_that_is_indexed_the_other_way_is_not_copied_either(self):
        voxels = numpy.asfortranarray(numpy.arange(24, dtype=numpy.int16).reshape(4, 3, 2))  # [i, j, k]
        volume = ocelli.volume(voxels.T)
        self.assertEqual(address(volume.array), address(voxels))

    def test_what_is_not_dense_or_of_another_type_is_converted(self):
        voxels = numpy.arange(48, dtype=numpy.float32).reshape(2, 4, 6)
        for other in (voxels[:, :, ::2], voxels.astype(">f4"), voxels > 20, voxels.astype(numpy.float16), voxels.tolist()):
            volume = ocelli.volume(other)
            numpy.testing.assert_array_equal(volume.array, numpy.asarray(other))

    def test_the_array_lives_as_long_as_its_volume_and_its_views(self):
        volume = ocelli.volume(ball())
        gc.collect()
        numpy.testing.assert_array_equal(volume.array, ball())
        view = ocelli.volume(ball(8)).array
        again = ocelli.volume(ocelli.volume(ball(8)), transfer=GREY)
        gc.collect()
        numpy.testing.assert_array_equal(view, ball(8))
        numpy.testing.assert_array_equal(again.array, ball(8))

    def test_views_cannot_be_written_to(self):
        with self.assertRaises(ValueError):
            ocelli.volume(ball(8)).array[0, 0, 0] = 2

    def test_what_is_written_later_is_drawn_later(self):
        voxels = ball()
        volume = ocelli.volume(voxels, transfer=GREY)
        before = ocelli.render(volume, size=SIZE).color.max()
        voxels *= 0.1
        self.assertLess(ocelli.render(volume, size=SIZE).color.max(), 0.8 * before)

    def test_where_voxels_stand(self):
        turned = [[0, -1, 0], [1, 0, 0], [0, 0, 1]]  # i runs along y, j along -x
        volume = ocelli.volume(ball(), spacing=(1, 2, 3), origin=(10, 20, 30), orientation=turned, unit="mm", fit=False)
        self.assertEqual((volume.spacing, volume.unit), ((1, 2, 3), "mm"))
        at = volume.world_from_index @ (1, 2, 3, 1)  # voxel (1, 2, 3)
        numpy.testing.assert_allclose(at, (10 - 4, 20 + 1, 30 + 9, 1))
        numpy.testing.assert_allclose(volume.scene_from_index, volume.world_from_index)
        info = ocelli.volume_info(volume)
        self.assertEqual((info["size"], info["unit"], info["axes"]), ([24, 24, 24], "mm", ["+y", "-x", "+z"]))

    def test_a_patient_stands_upright(self):
        volume = ocelli.volume(ball(), anatomical=True, fit=False)
        head = volume.scene_from_index @ (0, 0, 5, 0)
        numpy.testing.assert_allclose(head, (0, 5, 0, 0), atol=1e-12)

    def test_values_have_a_scale(self):
        voxels = numpy.zeros((4, 4, 4), dtype=numpy.int16)
        voxels[1:3, 1:3, 1:3] = 100
        info = ocelli.volume_info(ocelli.volume(voxels, scale=2, offset=-1000, modality="CT", value_unit="HU"))
        self.assertEqual((info["least"], info["greatest"]), (-1000, -800))
        self.assertEqual((info["modality"], info["value_unit"], info["type"]), ("CT", "HU", "int16"))

    def test_what_is_no_volume(self):
        wrong = {
            "shape": lambda: ocelli.volume(ball()[0]),
            "int64": lambda: ocelli.volume(numpy.zeros((2, 2, 2), dtype=numpy.int64)),
            "numbers": lambda: ocelli.volume(numpy.array([[["a"]]])),
            "spacing": lambda: ocelli.volume(ball(), spacing=(0, 1, 1)),
            "orientation": lambda: ocelli.volume(ball(), orientation=numpy.ones((2, 2))),
            "voxels": lambda: ocelli.volume(numpy.zeros((0, 2, 2), dtype=numpy.uint8)),
            "NaN": lambda: ocelli.volume(ball() * numpy.nan),
            "array": lambda: ocelli.volume(SKULL, spacing=(1, 1, 1)),
            "series": lambda: ocelli.volume(ball(), series="1"),
            "no time": lambda: ocelli.volume(ball(), seconds=1),
            "half space": lambda: ocelli.volume(ball(), clips=[(0, 0, 0, 1)]),
            "scale": lambda: ocelli.volume(ball(), scale=0),
            "ct-bone": lambda: ocelli.volume(ball(), transfer="x-ray"),
            "points": lambda: ocelli.volume(ball(), transfer={"values": "absolute"}),
        }
        for message, make in wrong.items():
            with self.subTest(message):
                with self.assertRaises(ocelli.InputError) as caught:
                    make()
                self.assertIn(message, str(caught.exception))
                self.assertTrue(caught.exception.next)

    def test_one_value_is_warned_of(self):
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            ocelli.volume(numpy.ones((3, 3, 3), dtype=numpy.float32))
        self.assertTrue(any("all voxels have the value" in str(each.message) for each in told))


class Pictures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.ball = ocelli.volume(ball(32), transfer=GREY)

    def test_light_that_is_lost(self):
        # A slab of one value: of a ray along z, exp(log(1 - 0.5) * length) of the light behind is left.
        slab = ocelli.volume(numpy.ones((8, 8, 8), dtype=numpy.float32), transfer=GREY, fit=False)
        along = ocelli.View(eye=(3.5, 3.5, 100), target=(3.5, 3.5, 0), fov_vertical_degrees=2)
        image = ocelli.render(slab, view=along, size=(9, 9))
        # 1e-3: where rays end early, VolumeRenderOptions::endTransmittance; 8 units of length 1 leave 0.4 %.
        self.assertAlmostEqual(float(image.color[4, 4, 3]), 1 - 0.5**8, delta=1e-3)
        self.assertAlmostEqual(float(image.before((0, 0, 0))[4, 4, 0]), 1 - 0.5**8, delta=1e-3)
        # Half of the light is lost after a length of 1: there `t` is, behind the face at z = 7.5.
        self.assertAlmostEqual(float(image.t[4, 4]), 100 - 6.5, delta=0.02)
        numpy.testing.assert_allclose(image.points()[4, 4], (3.5, 3.5, 6.5), atol=0.05)

    def test_views_are_the_pictures_memory(self):
        image = ocelli.render(self.ball, size=SIZE)
        self.assertEqual(image.color.shape, (48, 72, 4))
        self.assertEqual(address(image.color), address(image.color))
        self.assertEqual(address(image.t) - address(image.color), 16)
        self.assertFalse(image.samples.flags.writeable)
        nowhere = image.color[..., 3] == 0
        self.assertTrue(numpy.isinf(image.t[nowhere]).all())
        numpy.testing.assert_array_equal(image.before((0.5, 0.25, 1))[nowhere], [(0.5, 0.25, 1)] * nowhere.sum())
        kept = ocelli.render(self.ball, size=SIZE).color
        gc.collect()
        numpy.testing.assert_array_equal(kept, image.color)

    def test_the_program_draws_the_same(self):
        skull = ocelli.volume(SKULL, clips=[(0, 0, 1, 0)], shaded=False, progress=False)
        with tempfile.TemporaryDirectory() as folder:
            ours, theirs = pathlib.Path(folder) / "ours.png", pathlib.Path(folder) / "theirs.png"
            for camera in ("di", "ddoc"):
                look = ("--clip", "z>0", "--shading", "none", "--step", "0.5", "--background", "#ffffff")
                run("render", SKULL, "--camera", camera, *look, "--size", "72x48", "-o", theirs)
                ocelli.render(skull, camera, size=SIZE, step=0.5).write(ours, (1, 1, 1))
                self.assertEqual(ours.read_bytes(), theirs.read_bytes(), camera)

    def test_cameras_of_all_kinds(self):
        class Parallel:
            def rays(self, width, height):
                x, y = numpy.meshgrid(numpy.linspace(-1, 1, width), numpy.linspace(1, -1, height))
                return numpy.stack([x, y, numpy.full_like(x, 10)], axis=-1), (0, 0, -1)

        for camera in ("panorama", "eoc-h", Parallel(), {"camera": "gpc"}):
            image = ocelli.render(self.ball, camera, size=SIZE)
            self.assertGreater(float(image.color[..., 3].max()), 0.01)
        with self.assertRaisesRegex(ocelli.InputError, "union"):
            ocelli.render(self.ball, "eoc-hv", size=SIZE)
        with self.assertRaisesRegex(ocelli.InputError, "telephoto"):
            ocelli.render(self.ball, "telephoto", size=SIZE)

    def test_surfaces_end_rays(self):
        inside = ocelli.isosurface(self.ball, 0.5)
        shown = ocelli.volume(self.ball, transfer=GREY, surfaces=inside, surfaces_frame="scene")
        image = ocelli.render(shown, size=SIZE)
        self.assertTrue(numpy.isfinite(image.surface_t[24, 36]))
        self.assertEqual(float(image.color[24, 36, 3]), 1)
        self.assertTrue(numpy.isinf(ocelli.render(self.ball, size=SIZE).surface_t).all())

    def test_options_that_do_not_fit(self):
        wrong = {
            "step": lambda: ocelli.render(self.ball, step=0),
            "opacity": lambda: ocelli.render(self.ball, opacity=1),
            "triangles": lambda: ocelli.render("builtin:teapot", step=1),
            "hybrid": lambda: ocelli.render(self.ball, method="hybrid"),
            "ocelli.volume": lambda: ocelli.render(SKULL),
            "outside": lambda: ocelli.render(self.ball, view=ocelli.View(eye=(0, 0, 10), target=(0, 0, 20)), size=SIZE),
            ".exr": lambda: ocelli.render(self.ball, size=SIZE).write("picture.jpg"),
            "isosurface": lambda: ocelli.camera.rays("ddoc", scene=self.ball),
        }
        for message, call in wrong.items():
            with self.subTest(message), self.assertRaises(ocelli.InputError) as caught:
                call()
            self.assertIn(message, str(caught.exception))

    def test_presets_are_transfer_functions(self):
        presets = ocelli.transfer_presets()
        self.assertIn("ct-bone", presets)
        ct = ocelli.volume(SKULL, transfer="ct-bone", progress=False)
        by_dict = ocelli.volume(ct, transfer=presets["ct-bone"])
        self.assertEqual(json.loads(ct.transfer), json.loads(by_dict.transfer))
        with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
            file.write(ct.transfer)
            file.flush()
            by_file = ocelli.volume(ct, transfer=file.name)
        numpy.testing.assert_array_equal(ocelli.render(by_file, size=SIZE).color, ocelli.render(by_dict, size=SIZE).color)


class Surfaces(unittest.TestCase):
    def test_a_ball(self):
        # Of the field 1 - |p|, the surface at 0.5 is a sphere of the radius 0.5 of the box's half edge, 15.5 voxels.
        mesh = ocelli.isosurface(ocelli.volume(ball(32), fit=False), 0.5)
        radii = numpy.linalg.norm(mesh.positions - 15.5, axis=1)
        numpy.testing.assert_allclose(radii, 0.5 * 15.5, atol=0.1)  # how far trilinear cells are from a sphere
        edges = numpy.sort(mesh.triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
        self.assertTrue((numpy.unique(edges, axis=0, return_counts=True)[1] % 2 == 0).all())
        with self.assertRaisesRegex(ocelli.InputError, "array"):
            ocelli.isosurface(ocelli.volume(ball()), 7)

    def test_it_is_that_of_the_scene(self):
        skull = ocelli.volume(SKULL, progress=False)
        ours = ocelli.isosurface(skull, 300)
        theirs = ocelli.scene.load(SKULL, iso=300, progress=False).mesh
        numpy.testing.assert_array_equal(ours.positions, theirs.positions)
        numpy.testing.assert_array_equal(ours.colors, theirs.colors)


class ReferenceImagesOfVolumes(unittest.TestCase):
    def test_the_program_builds_the_same(self):
        skull = ocelli.volume(SKULL, progress=False)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "skull.exr"
            options = ("--camera", "ldi-3", "--opacity", "0.7", "--size", "72x48")
            run("ocri", "build", SKULL, *options, "-o", path)
            theirs = ocelli.ocri.read(path)
        ours = ocelli.ocri.build(skull, "ldi-3", opacity=0.7, size=SIZE)
        self.assertEqual(len(ours), len(theirs))
        self.assertGreater(len(ours), 1)
        for mine, their in zip(ours, theirs, strict=True):
            numpy.testing.assert_array_equal(mine.color, their.color)
            numpy.testing.assert_array_equal(mine.t, their.t)

    def test_evaluated(self):
        shown = ocelli.volume(ball(16), transfer={**GREY, "opacity_length": 0.1})
        [row] = ocelli.evaluate(shown, "di", size=SIZE, interior_views=1, runs=1, compare_images=False)
        self.assertEqual(row["name"], "di")
        self.assertGreater(row["samples"], 100)

    def test_what_cannot_be_built(self):
        shown = ocelli.volume(ball(), transfer=GREY)
        with self.assertRaisesRegex(ocelli.InputError, "rays"):
            ocelli.ocri.build(shown, "di", construction="raster")
        with self.assertRaisesRegex(ocelli.InputError, "triangles"):
            ocelli.ocri.build("builtin:teapot", "di", opacity=0.5)
        with self.assertRaisesRegex(ocelli.InputError, "curved ray"):
            ocelli.ocri.build(shown, "portal")


class Slices(unittest.TestCase):
    def test_the_program_slices_the_same(self):
        skull = ocelli.volume(SKULL, transfer="ct-bone", progress=False)
        ways = {
            (): {},
            ("--seen-opacity", "0.5", "--viewer", "2,0,5"): {"seen_opacity": 0.5, "viewers": [(2, 0, 5)]},
            ("--mask", "300:2000", "--dither", "blue-noise"): {"mask": (300, 2000), "dither": "blue-noise"},
            ("--cutaway", "0", "--gradient-light", "0.2"): {"cutaway": 0, "gradient_light": 0.2},
            ("--light-gain", "2"): {"light_gain": 2},
            ("--iso", "300", "--undithered"): {"iso": 300, "undithered": True},
        }
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "skull.svol"
            for flags, keywords in ways.items():
                with self.subTest(flags):
                    shown = (SKULL, "--transfer", "ct-bone", "--profile", "test")
                    run("slice", *shown, *flags, "-o", path)
                    ours = ocelli.slice(skull, "test", **keywords)
                    self.assertGreater(ours.lit_voxels, 10)
                    self.assertEqual(ours, ocelli.DisplayVolume.read(path))

    def test_a_mask_of_voxels(self):
        voxels = ball()
        half = numpy.zeros(voxels.shape, dtype=numpy.uint8)
        half[:, :, :12] = 1
        solid = {"values": "absolute", "opacity_length": 1, "points": [{"value": 0.2, "color": "#ffffff", "opacity": 0.9}]}
        shown = ocelli.volume(voxels, transfer=solid, spacing=(2, 2, 2))
        whole = ocelli.slice(shown, "test").lit_voxels
        masked = ocelli.slice(shown, "test", mask=ocelli.volume(half, spacing=(2, 2, 2), transfer=solid)).lit_voxels
        self.assertAlmostEqual(masked / whole, 0.5, delta=0.05)  # the half, but for voxels that its face cuts

    def test_meshes_have_the_same_options(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "teapot.svol"
            run("slice", "builtin:teapot", "--profile", "test", "--dither", "none", "--antialias", "-o", path)
            ours = ocelli.slice("builtin:teapot", "test", dither="none", antialias=True, progress=False)
            self.assertEqual(ours, ocelli.DisplayVolume.read(path))

    def test_options_that_do_not_fit(self):
        shown = ocelli.volume(ball(), transfer=GREY)
        wrong = {
            "exact": lambda: ocelli.slice(shown, exact=True),
            "iso": lambda: ocelli.slice("builtin:teapot", iso=1, progress=False),
            "viewers": lambda: ocelli.slice(shown, viewers=[(0, 0, 10)]),
            "seen_opacity": lambda: ocelli.slice(shown, seen_opacity=2),
            "blue-noise": lambda: ocelli.slice(shown, dither="red-noise"),
            "no surface": lambda: ocelli.slice(shown, iso=17),
            "one value": lambda: ocelli.slice(shown, iso=0.5, mask=(0, 1)),
        }
        for message, call in wrong.items():
            with self.subTest(message), self.assertRaises(ocelli.InputError) as caught:
                call()
            self.assertIn(message, str(caught.exception))
        self.assertIn("ordered", ocelli.dithers())


def write_nrrd(path, voxels):
    header = "NRRD0004\ntype: int16\ndimension: 3\nsizes: 6 5 4\nspacings: 1 2 3\nencoding: raw\nendian: little\n\n"
    path.write_bytes(header.encode() + voxels.tobytes())


class Files(unittest.TestCase):
    def test_a_series_has_moments(self):
        voxels = numpy.arange(4 * 5 * 6, dtype="<i2").reshape(4, 5, 6)
        with tempfile.TemporaryDirectory() as folder:
            for time in range(3):
                write_nrrd(pathlib.Path(folder) / f"t{time}.nrrd", voxels * (time + 1))
            with self.assertWarnsRegex(UserWarning, "times"):
                first = ocelli.volume(folder)
                later = ocelli.volume(first, seconds=2)
        self.assertEqual((first.series.times, len(first.series)), ([0, 1, 2], 3))
        numpy.testing.assert_array_equal(first.array, voxels)
        numpy.testing.assert_array_equal(later.array, voxels * 3)
        self.assertEqual(first.transfer, later.transfer)  # that of the first one for all: nothing flickers
        with self.assertRaisesRegex(ocelli.InputError, "no time"):
            ocelli.volume(first, seconds=7)

    def test_a_file_is_mapped(self):
        voxels = numpy.arange(4 * 5 * 6, dtype="<i2").reshape(4, 5, 6)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "small.nrrd"
            write_nrrd(path, voxels)
            volume = ocelli.volume(path, transfer={**GREY, "opacity_length": 0.5})
        numpy.testing.assert_array_equal(volume.array, voxels)
        self.assertEqual(volume.spacing, (1, 2, 3))
        self.assertTrue(ocelli.volume_info(volume)["mapped"])
        with self.assertRaises(ocelli.InputError):
            ocelli.volume("/nowhere/volume.nrrd")

    def test_info_is_that_of_the_program(self):
        told = subprocess.run([PROGRAM, "scene", "info", SKULL, "--json"], check=True, capture_output=True)
        ours = ocelli.volume_info(ocelli.volume(SKULL, progress=False), progress=False)
        self.assertEqual(ours, json.loads(told.stdout))


class Work(unittest.TestCase):
    def test_progress_and_its_end(self):
        class Enough(Exception):
            pass

        def stop(stage, fraction):
            raise Enough

        told = []
        shown = ocelli.volume(SKULL, progress=lambda *each: told.append(each))
        self.assertTrue(told)
        for work in (
            lambda: ocelli.render(shown, size=SIZE, progress=stop),
            lambda: ocelli.isosurface(shown, 300, progress=stop),
            lambda: ocelli.ocri.build(shown, "ddoc", size=SIZE, progress=stop),
            lambda: ocelli.slice(shown, "test", progress=stop),
        ):
            with self.assertRaises(Enough):
                work()

    def test_other_threads_run_and_ctrl_c_ends_it(self):
        shown = ocelli.volume(SKULL, progress=False)
        counted = []
        ended = threading.Event()

        def count():
            while not ended.wait(0.001):
                counted.append(1)

        counter = threading.Thread(target=count)
        counter.start()
        threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT)).start()
        try:
            with self.assertRaises(KeyboardInterrupt):
                # Without the signal it would take minutes.
                ocelli.render(shown, size=(3000, 3000), step=1 / 64, progress=False)
        finally:
            ended.set()
            counter.join()
        self.assertGreater(len(counted), 10)


if __name__ == "__main__":
    unittest.main()
