"""Effects: the same pictures and figures as those of `ocelli shade`."""

import json
import os
import pathlib
import signal
import subprocess
import tempfile
import unittest

import numpy

import ocelli

PROGRAM = os.environ["OCELLI_PROGRAM"]
SIZE = (72, 48)
SCENES = {
    "reflection": "builtin:mirror",
    "refraction": "builtin:lens",
    "shadow": "builtin:lamp",
    "relief": "builtin:parking",
    "ambient": "builtin:statues",
}
WAYS = {"reflection": "ddoc", "refraction": "di", "shadow": "outlines", "relief": "height-field", "ambient": "horizon"}


def run(*arguments):
    subprocess.run([PROGRAM, *map(str, arguments), "--quiet"], check=True, stdout=subprocess.DEVNULL)


class Effects(unittest.TestCase):
    def test_the_program_draws_the_same(self):
        self.assertEqual(set(ocelli.effects.kinds()), set(SCENES))
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "theirs.png"
            for effect, scene in SCENES.items():
                with self.subTest(effect):
                    sizes = ("--size", "72x48", "--image-size", "90x60")
                    run("shade", scene, "--effect", effect, "--by", WAYS[effect], *sizes, "-o", path)
                    ours = ocelli.effects.draw(scene, effect, by=WAYS[effect], size=SIZE, image_size=(90, 60), progress=False)
                    self.assertEqual(ours.shape, (48, 72, 3))
                    import matplotlib.image

                    theirs = (matplotlib.image.imread(path)[..., :3] * 255).round().astype(numpy.uint8)
                    numpy.testing.assert_array_equal(ocelli.srgb(ours), theirs)

    def test_figures_are_those_of_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "mirror.json"
            run("shade", "builtin:mirror", "--by", "di,ddoc", "--size", "72x48", "--image-size", "180x120", "--json", path)
            theirs = json.loads(path.read_text(encoding="utf-8"))
        found = ocelli.effects.compare("builtin:mirror", by=["di", "ddoc"], size=SIZE, image_size=(180, 120), progress=False)
        self.assertEqual(list(found.figures), ["traced", "di", "ddoc"])
        self.assertEqual(found.pictures["di"].shape, (48, 72, 3))
        self.assertEqual(found.maps["di"]["errors"].dtype, numpy.uint8)
        meanings = ocelli.effects.options("reflection")["figures"]
        for row in theirs["by"]:
            for figure, value in row.items():
                if figure != "name" and not figure.endswith("_ms") and "seconds" not in figure:
                    self.assertIn(figure, meanings)
                    self.assertEqual(found.figures[row["name"]][figure], value, figure)

    def test_options_are_keywords(self):
        [option] = [each for each in ocelli.effects.options("ambient")["options"] if each["name"] == "radius"]
        self.assertTrue(option["meaning"])
        near = ocelli.effects.draw("builtin:statues", "ambient", by="horizon", radius=0.1, size=SIZE, progress=False)
        far = ocelli.effects.draw("builtin:statues", "ambient", by="horizon", radius=1.0, size=SIZE, progress=False)
        self.assertGreater(near.sum(), far.sum())

    def test_what_is_wrong(self):
        wrong = {
            "glow": lambda: ocelli.effects.draw("builtin:mirror", "glow"),
            "telephoto": lambda: ocelli.effects.draw("builtin:mirror", by="telephoto"),
            "radius": lambda: ocelli.effects.draw("builtin:mirror", radius=1),
            "roles": lambda: ocelli.effects.draw(ocelli.scene.load("builtin:teapot"), "reflection"),
            "runs": lambda: ocelli.effects.compare("builtin:mirror", by="di", runs=0),
            "cell": lambda: ocelli.effects.draw("builtin:mirror", cell=-1),
            "environment_height": lambda: ocelli.effects.draw("builtin:mirror", environment_height=0),
        }
        for message, call in wrong.items():
            with self.subTest(message), self.assertRaises(ocelli.InputError) as caught:
                call()
            self.assertIn(message, str(caught.exception))
            self.assertTrue(caught.exception.next)
        with self.assertRaises(ocelli.InputError):
            ocelli.effects.options("glow")

    def test_what_progress_raises_ends_it(self):
        class Enough(Exception):
            pass

        def stop(stage, fraction):
            raise Enough

        with self.assertRaises(Enough):
            ocelli.effects.draw("builtin:mirror", by="ddoc", size=SIZE, progress=stop)

    def test_ctrl_c_ends_it(self):
        with self.assertRaises(KeyboardInterrupt):
            ocelli.effects.draw("builtin:mirror", by="ddoc", size=SIZE, progress=lambda *_: signal.raise_signal(signal.SIGINT))


if __name__ == "__main__":
    unittest.main()
