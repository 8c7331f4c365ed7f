"""A session from consent to survey, by real input of an X server: `ocelli study run` in full screen, driven by xdotool.

Usage: session_test.py OCELLI PROTOCOL.json mouse|keyboard FOLDER, on a screen of 1280x800 without a window manager.
Leaves the database and a picture of each screen in FOLDER. Exits with 1, and says what is wrong, where something is.
"""

import math
import pathlib
import queue
import shutil
import sqlite3
import subprocess
import sys
import threading
import time

WIDTH, HEIGHT = 1280, 800
PATIENCE = 90  # seconds that a step may take on a busy machine
# Where the screens have their buttons, at this size.
GO_ON = (1150, 754)


def fail(text):
    print("FAILED:", text)
    sys.exit(1)


def xdotool(*arguments):
    subprocess.run(["xdotool", *map(str, arguments)], check=True)


class Session:
    """The program, and what its console says."""

    def __init__(self, ocelli, protocol, folder):
        command = [ocelli, "study", "run", protocol, "--db", folder / "tiny.db", "--subject", "S01", "--force",
                   "--hash-frames", "5", "--screenshots", folder / "screens"]
        self.program = subprocess.Popen([str(part) for part in command], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        stderr=subprocess.STDOUT, text=True)
        self.lines = queue.Queue()
        threading.Thread(target=self.read, daemon=True).start()
        self.said = []

    def read(self):
        for line in self.program.stdout:
            self.lines.put(line.rstrip("\n"))
        self.lines.put(None)

    def wait_for(self, text):
        """Until the console says so; what it said before counts no more."""
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            try:
                line = self.lines.get(timeout=1)
            except queue.Empty:
                continue
            if line is None:
                break
            print(line, flush=True)
            self.said.append(line)
            if text in line:
                return line
        fail(f'the console never said "{text}"')

    def type(self, command):
        self.program.stdin.write(command + "\n")
        self.program.stdin.flush()


def click(x, y):
    xdotool("mousemove", x, y)
    time.sleep(0.15)
    xdotool("mousedown", 1)
    time.sleep(0.15)
    xdotool("mouseup", 1)
    time.sleep(0.1)


def key(name):
    xdotool("keydown", name)
    time.sleep(0.12)
    xdotool("keyup", name)
    time.sleep(0.12)


def object_ahead(meters):
    """Where a sphere on the floor is seen that stands so far ahead: a pinhole of 70 degrees over the whole width."""
    top = max(48, HEIGHT * 3 // 40)  # of the views, below the prompt
    focal = WIDTH / 2 / math.tan(math.radians(35))
    below_eye = 1.6 - 0.13 * 3  # its middle is as high as its radius, 0.13 cells of 3 m
    return WIDTH / 2, top + (HEIGHT - top) / 2 + focal * below_eye / meters


class ByMouse:
    go_on = staticmethod(lambda: click(*GO_ON))

    @staticmethod
    def demographics():
        click(320, 215)  # the second age band
        click(420, 350)  # 3 of 5
        click(*GO_ON)

    @staticmethod
    def survey():
        click(560, 165)
        click(*GO_ON)

    @staticmethod
    def find():
        click(*object_ahead(6))


class ByKeyboard:
    go_on = staticmethod(lambda: key("Return"))

    @staticmethod
    def demographics():
        for name in ("2", "Down", "Right", "Right", "Right", "Return", "Return"):
            key(name)

    @staticmethod
    def survey():
        for name in ("4", "Return", "Return"):
            key(name)

    @staticmethod
    def find():
        """From the middle of the view to the object: Shift and the arrows move the pointer by 600 pixels a second."""
        middle = max(48, HEIGHT * 3 // 40) + (HEIGHT - max(48, HEIGHT * 3 // 40)) / 2
        xdotool("keydown", "shift", "keydown", "Down", "sleep", (object_ahead(6)[1] - middle) / 600, "keyup", "Down",
                "keyup", "shift")
        key("space")


def run(session, subject):
    session.wait_for("consent")
    xdotool("mousemove", 5, 795)
    subject.go_on()
    session.wait_for("form demographics")
    subject.demographics()
    for page in ("page Keys and mouse", "page Find the object", "page A view that bends"):
        session.wait_for(page)
        subject.go_on()
    session.wait_for("before practice")
    session.type("pause a moment, please")
    session.wait_for("(paused)")
    time.sleep(0.3)
    session.type("resume")
    session.wait_for("before practice")
    for name in ("practice", "trial 1 of 2", "trial 2 of 2"):
        if name != "practice":
            session.wait_for(f"before {name}")
        subject.go_on()
        session.wait_for(f": {name}")
        subject.find()
        session.wait_for("feedback")
        subject.go_on()
    session.wait_for("break")
    time.sleep(1.5)
    subject.go_on()
    session.wait_for("form survey")
    session.type("note all went well")
    subject.survey()
    session.wait_for("ended: completed")
    subject.go_on()
    session.wait_for("the session is complete")
    code = session.program.wait(timeout=PATIENCE)
    if code != 0:
        fail(f"exit code {code}")


def check_database(path):
    database = sqlite3.connect(f"file:{path}?mode=ro", uri=True)

    def rows(query):
        return database.execute(query).fetchall()

    print(rows("SELECT name FROM sqlite_master WHERE type = 'table' ORDER BY name"))
    return rows


def main():
    ocelli, protocol, way, folder = sys.argv[1], sys.argv[2], sys.argv[3], pathlib.Path(sys.argv[4])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    session = Session(ocelli, protocol, folder)
    try:
        run(session, ByMouse if way == "mouse" else ByKeyboard)
    finally:
        session.program.kill()
    check_database(folder / "tiny.db")


if __name__ == "__main__":
    main()
