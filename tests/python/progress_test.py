"""Progress, other threads while C++ works, and Ctrl-C."""

import io
import os
import signal
import threading
import time
import unittest

import ocelli
from ocelli import _progress


def long_work(progress):
    ocelli.evaluate("builtin:statues", ["di", "ddoc"], size=(360, 240), interior_views=4, progress=progress)


class Progress(unittest.TestCase):
    def test_a_function_is_told(self):
        told = []
        ocelli.evaluate("builtin:fence", ["di"], size=(72, 48), interior_views=2, runs=1,
                        progress=lambda stage, fraction: told.append((stage, fraction)))
        self.assertTrue(told)
        self.assertTrue(all(0 <= fraction <= 1 for _, fraction in told))
        self.assertIn("di", {stage for stage, _ in told})

    def test_what_the_function_raises_ends_the_work(self):
        class Enough(Exception):
            pass

        def stop(stage, fraction):
            raise Enough

        with self.assertRaises(Enough):
            ocelli.evaluate("builtin:fence", ["di"], size=(72, 48), progress=stop)

    def test_other_threads_run(self):
        done = threading.Event()
        counted = 0

        def work():
            long_work(False)
            done.set()

        thread = threading.Thread(target=work)
        thread.start()
        # Where C++ kept the interpreter, this loop would not come back to its condition before the end.
        while not done.wait(0.001):
            counted += 1
        thread.join()
        self.assertGreater(counted, 10)

    def test_ctrl_c_ends_the_work(self):
        threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()
        with self.assertRaises(KeyboardInterrupt):
            # Without the signal it would take longer than a test may.
            ocelli.evaluate("builtin:statues", ["di"], interior_views=5000, progress=False)
        # Nothing is left in a state that would disturb the next call.
        self.assertGreater(len(ocelli.scene.load("builtin:teapot").mesh), 0)

    def test_a_line_over_itself(self):
        stream = io.StringIO()
        line = _progress.ProgressLine(stream)
        line._next = time.monotonic()
        line("drawing", 0.42)
        line.clear()
        self.assertIn("drawing  42 %", stream.getvalue())
        self.assertTrue(stream.getvalue().endswith("\r"))


if __name__ == "__main__":
    unittest.main()
