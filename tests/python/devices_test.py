"""Devices: volumes on displays that are files, simulated, or nothing at all."""

import os
import pathlib
import signal
import subprocess
import tempfile
import threading
import time
import unittest

import ocelli

PROGRAM = os.environ["OCELLI_PROGRAM"]


class Devices(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.volume = ocelli.slice("builtin:teapot", "perspecta-99", progress=False)

    def test_they_are_those_of_the_program(self):
        told = subprocess.run([PROGRAM, "device", "list"], check=True, capture_output=True, text=True).stdout
        self.assertIn("null", ocelli.devices.kinds())
        for usage, meaning in ocelli.devices.kinds().items():
            self.assertIn(usage, told)
            self.assertTrue(meaning)

    def test_a_file_holds_what_was_shown(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "seen.svol"
            report = ocelli.devices.show(self.volume, f"file:{path}", seconds=1, progress=False)
            self.assertEqual(report["frames_shown"], 1)
            self.assertEqual(ocelli.DisplayVolume.read(path), self.volume)

    def test_a_recording_ends_by_itself(self):
        with tempfile.TemporaryDirectory() as folder:
            one, film = pathlib.Path(folder) / "one.svol", pathlib.Path(folder) / "film.svol"
            self.volume.write(one)
            subprocess.run([PROGRAM, "volume", "join", one, one, one, "--fps", "10", "-o", film, "--quiet"], check=True)
            told = []
            report = ocelli.devices.show(film, "null", seconds=None, progress=lambda *each: told.append(each))
            self.assertGreaterEqual(report["frames_submitted"], 1)
            self.assertTrue(told)

    def test_no_time_shows_nothing_and_is_no_error(self):
        self.assertEqual(ocelli.devices.show(self.volume, "null", seconds=0, progress=False)["frames_shown"], 0)

    def test_the_simulated_display(self):
        report = ocelli.devices.show(self.volume, "sim", seconds=0.5, progress=False)
        self.assertEqual((report["device"], report["profile"]), ("sim", self.volume.profile))
        self.assertGreater(report["refreshes"], 3)

    def test_what_is_wrong(self):
        wrong = {
            "hologram": lambda: ocelli.devices.show(self.volume, "hologram"),
            "slice": lambda: ocelli.devices.show(ocelli.scene.load("builtin:teapot"), "null"),
            "missing.svol": lambda: ocelli.devices.show("missing.svol", "null"),
            "seconds": lambda: ocelli.devices.show(self.volume, "null", seconds=-1),
        }
        for message, call in wrong.items():
            with self.subTest(message), self.assertRaises(ocelli.InputError) as caught:
                call()
            self.assertIn(message, str(caught.exception))
        with self.assertRaises(ocelli.WorkError):
            ocelli.devices.show(self.volume, "file:/nowhere/seen.svol", seconds=0.2)

    def test_ctrl_c_ends_it(self):
        threading.Timer(0.4, os.kill, (os.getpid(), signal.SIGINT)).start()
        start = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            ocelli.devices.show(self.volume, "sim", seconds=None, progress=False)
        self.assertLess(time.monotonic() - start, 30)


if __name__ == "__main__":
    unittest.main()
