"""The page that walks through a sea of images, opened as a file in Chromium: what it shows beside the room that its
images are of, and what mouse and keys do.

Usage: page_test.py SEA_PAGE_SAMPLE. Exits with 77 without a Chromium.
"""

import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "remote_page"))
from chromium import Browser, find_chromium  # noqa: E402

SAMPLE = ""
SIZE = (800, 600)
LOWER, UPPER = (-3, 0, -2), (3, 3, 2)  # sample_room.h
IMAGES = os.environ.get("OCELLI_TEST_IMAGES")  # a folder that keeps what the page shows at the end of each test


def room_color(eye, yaw, pitch):
    """What one sees of the room, 0 to 255."""
    y, p = math.radians(yaw), math.radians(pitch)
    ray = (math.sin(y) * math.cos(p), math.sin(p), -math.cos(y) * math.cos(p))
    t = min(((UPPER[k] if ray[k] > 0 else LOWER[k]) - eye[k]) / ray[k] for k in range(3) if abs(ray[k]) > 1e-12)
    return [255 * (eye[k] + t * ray[k] - LOWER[k]) / (UPPER[k] - LOWER[k]) for k in range(3)]


class SeaPageTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        subprocess.run([SAMPLE, cls.folder.name], check=True)
        cls.browser = Browser(*SIZE)

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()
        cls.folder.cleanup()

    def setUp(self):
        self.expects_missing = False
        self.open()

    def tearDown(self):
        if IMAGES is not None:
            self.browser.screenshot(pathlib.Path(IMAGES) / f"{self.id().split('.')[-1]}.png")
        troubles = [each for each in self.browser.logs if each[0] in ("exception", "error")]
        if self.expects_missing:
            troubles = [each for each in troubles if "ERR_FILE_NOT_FOUND" not in each[1]]
        self.browser.logs.clear()
        self.assertEqual(troubles, [])

    def open(self, place=None):
        self.browser.open("about:blank")
        anchor = "" if place is None else f"#place={place}"
        self.browser.open(f"file://{self.folder.name}/index.html{anchor}")
        self.browser.wait("document.readyState === 'complete' && window.ocelliSea?.page !== undefined")
        self.settle()

    def settle(self):
        self.browser.wait("ocelliSea.page.isWhole && ocelliSea.page.step === null && ocelliSea.page.frame === undefined", 30)

    def value(self, expression):
        return self.browser.evaluate(expression)

    def look(self, yaw, pitch):
        self.value(f"Object.assign(ocelliSea.page.view, {{yaw: {yaw}, pitch: {pitch}}}); ocelliSea.page.redraw()")
        self.settle()

    def middle(self):
        """The colour in the middle of the picture."""
        return self.value("""(() => {
          const {gl, canvas} = ocelliSea.page;
          ocelliSea.page.draw();
          const pixel = new Uint8Array(4);
          gl.readPixels(canvas.width / 2, canvas.height / 2, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
          return [...pixel];
        })()""")

    def expect_room(self, eye, tolerance):
        for yaw, pitch in ((0, 0), (33, 0), (90, 10), (151, -20), (200, 35), (275, -60), (340, 70)):
            self.look(yaw, pitch)
            seen, truth = self.middle(), room_color(eye, yaw, pitch)
            for k in range(3):
                self.assertAlmostEqual(seen[k], truth[k], delta=tolerance, msg=f"{yaw}, {pitch}: {seen}, {truth}")

    def place(self, index):
        return self.value(f"ocelliSea.page.data.places[{index}].eye")

    def here(self):
        return self.value("ocelliSea.page.blend[0].index")

    def test_shows_what_is_seen_from_a_place(self):
        for index in (0, 7, 19):
            self.open(index)
            self.assertEqual(self.value("ocelliSea.page.blend"), [{"index": index, "weight": 1}])
            # JPEG, and pixels of 0.7 degrees: half of one at a grazing wall is up to 3 levels.
            self.expect_room(self.place(index), 7)

    def test_blends_three_places_between_them(self):
        for point in ((-0.62, -0.4), (0.13, 0.05), (0.9, 0.6)):
            self.value(f"ocelliSea.page.moveTo([{point[0]}, {point[1]}])")
            self.settle()
            blend = self.value("ocelliSea.page.blend")
            self.assertEqual(len(blend), 3)
            self.assertAlmostEqual(sum(each["weight"] for each in blend), 1)
            eye = self.value("ocelliSea.page.view.eye")
            for k, wanted in ((0, point[0]), (2, point[1])):
                mean = sum(each["weight"] * self.place(each["index"])[k] for each in blend)
                self.assertAlmostEqual(mean, wanted)
                self.assertAlmostEqual(eye[k], wanted)
            for each in blend:  # the corners of the cell that holds the point
                self.assertLess(math.dist(point, self.place(each["index"])[::2]), 0.5 * math.sqrt(2) + 1e-9)
            self.expect_room(eye, 9)

    def test_picture_of_other_places_is_another(self):
        self.open(0)
        self.look(90, 0)
        first = self.middle()
        truth = room_color(self.place(4), 90, 30)
        self.assertGreater(max(abs(a - b) for a, b in zip(first, truth)), 20, "a test of colours that could not fail")

    def test_keys_walk_to_the_next_place(self):
        self.open(7)
        for key, there in (("w", 2), ("s", 7), ("d", 8), ("ArrowLeft", 7), ("a", 6), ("ArrowDown", 11), ("ArrowUp", 6), ("ArrowRight", 7)):
            self.browser.key(key)
            self.settle()
            self.assertEqual(self.here(), there, key)
        self.value("ocelliSea.page.view.yaw = 90")
        self.browser.key("w")
        self.settle()
        self.assertEqual(self.here(), 8)
        self.browser.key("W", shift=True)  # to the wall, and no further
        self.settle()
        self.assertEqual(self.here(), 9)
        self.browser.key("w")
        self.settle()
        self.assertEqual(self.here(), 9)
        self.browser.key("n")
        self.settle()
        self.assertEqual(self.here(), 10)
        self.browser.key("0")
        self.settle()
        self.assertEqual(self.here(), 0)
        self.assertEqual(self.value("ocelliSea.page.view.yaw"), 0)

    def test_mouse_turns_and_zooms(self):
        before = self.value("ocelliSea.page.view")
        self.browser.drag((400, 300), (300, 340))
        after = self.value("ocelliSea.page.view")
        degrees = before["fov"] / SIZE[1]
        self.assertAlmostEqual(after["yaw"], before["yaw"] + 100 * degrees, places=3)
        self.assertAlmostEqual(after["pitch"], before["pitch"] + 40 * degrees, places=3)
        self.browser.wheel(400, 300, -200)
        self.browser.wait(f"ocelliSea.page.view.fov < {before['fov']} - 5")
        self.browser.key("q")
        self.assertAlmostEqual(self.value("ocelliSea.page.view.yaw"), after["yaw"] - 5, places=3)

    def map_point(self, index):
        return self.value(f"""(() => {{
          const box = document.getElementById('map').getBoundingClientRect();
          const [x, y] = ocelliSea.page.map.pixelOf(ocelliSea.page.plan.points[{index}]);
          return [box.x + x, box.y + y];
        }})()""")

    def test_map_takes_one_to_places_and_between(self):
        x, y = self.map_point(13)
        self.browser.click(x + 3, y - 3)
        self.settle()
        self.assertEqual(self.here(), 13)
        self.assertIn("Place 13 of 20", self.value("document.getElementById('status').textContent"))
        x, y = self.map_point(6)
        self.browser.drag((x, y), (x + 14, y + 12))
        self.settle()
        self.assertEqual(self.value("ocelliSea.page.blend.length"), 3)
        self.assertIn("Between places", self.value("document.getElementById('status').textContent"))

    def test_help_and_map_open_and_close_by_keys(self):
        self.browser.key("h")
        self.assertTrue(self.value("document.getElementById('help').open"))
        self.browser.key("w")  # does nothing below
        self.assertEqual(self.here(), 0)
        self.browser.key("Escape")
        self.browser.wait("!document.getElementById('help').open")
        self.browser.key("m")
        self.assertTrue(self.value("document.getElementById('plan').hidden"))
        self.assertEqual(self.value("document.title"), "A room & its <images>")

    def test_missing_and_damaged_images_are_said(self):
        folder = pathlib.Path(self.folder.name) / "images"
        kept = {name: (folder / name).read_bytes() for name in ("00015.js", "00017.js", "00019.js")}
        try:
            self.expects_missing = True
            (folder / "00015.js").unlink()
            (folder / "00017.js").write_text('ocelliSea.take(17, "data:image/jpeg;base64,AAAA");')
            (folder / "00019.js").write_text("// nothing")
            for index, said in ((15, "images/00015.js"), (17, "place 17 is damaged"), (19, "00019.js holds no image")):
                self.open(0)
                self.value(f"ocelliSea.page.goTo({index})")
                self.browser.wait(f"document.getElementById('state').textContent.includes('{said}')")
                self.assertFalse(self.value("document.getElementById('state').hidden"))
        finally:
            for name, data in kept.items():
                (folder / name).write_bytes(data)

    def test_holds_a_bounded_number_of_images(self):
        for index in range(20):
            self.value(f"ocelliSea.page.goTo({index})")
            self.settle()
        self.assertLessEqual(self.value("ocelliSea.page.images.held.size"), 24)
        self.assertEqual(self.value("ocelliSea.page.images.missing.size"), 0)

    def test_shows_the_picture_again_after_its_context_was_lost(self):
        self.look(33, 0)
        before = self.middle()
        self.value("""window.lost = ocelliSea.page.gl.getExtension('WEBGL_lose_context'); window.lost.loseContext()""")
        self.browser.wait("ocelliSea.page.gl.isContextLost()")
        self.value("window.lost.restoreContext()")
        self.browser.wait("!ocelliSea.page.gl.isContextLost() && ocelliSea.page.images.held.size > 0")
        self.settle()
        self.assertEqual(self.middle(), before)


if __name__ == "__main__":
    if find_chromium() is None:
        print("skipped: there is no chromium")
        sys.exit(77)
    SAMPLE = sys.argv.pop(1)
    unittest.main(verbosity=2)
