"""A session from consent to survey, by real input of an X server: `ocelli study run` in full screen, driven by xdotool.

Usage: session_test.py OCELLI PROTOCOL.json mouse|keyboard FOLDER [WIDTHxHEIGHT], on a screen of that size without a window
manager; 1280x800, which the mouse needs, by default. Leaves the database and a picture of each screen in FOLDER. Exits
with 1, and says what is wrong, where something is.
"""

import csv
import json
import math
import os
import pathlib
import pty
import queue
import shutil
import sqlite3
import subprocess
import sys
import threading
import time
import urllib.request

# A response box on a serial line: what is written to the first end comes out of the device of the second.
BOX, BOX_DEVICE = pty.openpty()
WIDTH, HEIGHT = map(int, sys.argv[5].split("x")) if len(sys.argv) > 5 else (1280, 800)
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
        self.screens = folder / "screens"
        command = [ocelli, "study", "run", protocol, "--db", folder / "tiny.db", "--subject", "S01", "--force",
                   "--hash-frames", "5", "--screenshots", self.screens, "--markers", f"file:{folder / 'S01-markers.csv'}",
                   "--gaze", f"file:{folder / 'gaze.csv'}", "--live", "0",
                   "--responses", f"serial:{os.ttyname(BOX_DEVICE)},115200"]
        self.program = subprocess.Popen([str(part) for part in command], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        stderr=subprocess.STDOUT, text=True)
        self.lines = queue.Queue()
        self.page = None  # the address of the page for the experimenter
        self.statuses = []  # of that page, one a second
        threading.Thread(target=self.read, daemon=True).start()
        threading.Thread(target=self.watch, daemon=True).start()
        threading.Thread(target=self.look, args=(folder / "gaze.csv",), daemon=True).start()

    def look(self, path):
        """An eye tracker: 100 samples a second along a circle, each tenth of which saw nothing."""
        with open(path, "a", buffering=1) as file:
            for i in range(10**6):
                angle = i / 50
                x, y = 0.5 + 0.3 * math.cos(angle), 0.5 + 0.3 * math.sin(angle)
                file.write(f"{i / 100},{x * WIDTH:.2f},{y * HEIGHT:.2f},{int(i % 10 != 0)},3.5\n")
                time.sleep(0.01)

    def watch(self):
        while self.program.poll() is None:
            try:
                if self.page:
                    with urllib.request.urlopen(self.page + "status.json", timeout=5) as answer:
                        self.statuses.append(json.load(answer))
            except OSError:
                pass  # the program has ended meanwhile
            time.sleep(1)

    def read(self):
        for line in self.program.stdout:
            if line.startswith("page "):
                self.page = line.split()[-1]
            self.lines.put(line.rstrip("\n"))
        self.lines.put(None)

    def says(self, text, seconds):
        """Whether the console says so within that time; what it said before counts no more."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            try:
                line = self.lines.get(timeout=0.2)
            except queue.Empty:
                continue
            if line is None:
                fail(f'the program ended before it said "{text}"')
            print(line, flush=True)
            if text in line:
                return True
        return False

    def wait_for(self, text):
        if not self.says(text, PATIENCE):
            fail(f'the console never said "{text}"')

    def wait_for_page(self, state):
        """Until the page has told that state, which it is asked for once a second."""
        end = time.monotonic() + PATIENCE
        while not any(each["state"] == state for each in list(self.statuses)):
            if time.monotonic() > end:
                fail(f'the page never told the state "{state}"')
            time.sleep(0.1)

    def do_until(self, action, text):
        """Again and again: before the choices are shown, answers count for nothing."""
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            action()
            if self.says(text, 1.5):
                return
        fail(f'whatever was done, the console never said "{text}"')

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
        click(332, 319)  # the second age band
        click(418, 453)  # 3 of 5
        click(*GO_ON)

    @staticmethod
    def survey():
        click(631, 345)
        click(*GO_ON)

    @staticmethod
    def find():
        click(*object_ahead(6))

    @staticmethod
    def count():
        click(640, 430)

    @staticmethod
    def match():
        click(640, 430)


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

    @staticmethod
    def count():
        """On the response box: a byte, which bounces."""
        os.write(BOX, b"4")
        os.write(BOX, b"4")

    @staticmethod
    def match():
        key("2")


def calibrate(session, subject):
    """Takes the frame for as large as the card, and five times half a second for what the disc takes to vanish."""
    session.wait_for("timing")
    time.sleep(1)
    subject.go_on()
    for _ in range(5):
        key("space")
        time.sleep(0.5)
        key("space")
    session.wait_for("warning   the distance from the eye is ")


def run(session, subject):
    calibrate(session, subject)
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
    session.wait_for_page("paused")
    session.type("resume")
    session.wait_for("before practice")
    for name in ("practice", "trial 1 of 6", "trial 2 of 6"):
        if name != "practice":
            session.wait_for(f"before {name}")
        subject.go_on()
        session.wait_for(f": {name}")
        subject.find()
        session.wait_for("feedback")
        subject.go_on()
        if name != "practice":
            session.wait_for("break")
            time.sleep(1.5)
            subject.go_on()
    for page in ("page Count the objects", "page All in one image"):
        session.wait_for(page)
        subject.go_on()
    session.wait_for("before trial 3 of 6")
    for after in ("before trial 4 of 6", "break"):
        subject.go_on()
        time.sleep(2.5)  # the scene is shown for two seconds
        session.do_until(subject.count, after)
    time.sleep(1.5)
    subject.go_on()
    session.wait_for("page Tell paths apart")
    subject.go_on()
    session.wait_for("before trial 5 of 6")
    for after in ("before trial 6 of 6", "form extra after"):
        subject.go_on()
        session.do_until(subject.match, after)
    # Typed, also by who has the mouse in the hand: a mark that begins in the middle, a number, a text. What was done once
    # too often to the last trial may have gone elsewhere in the form.
    time.sleep(1)
    for name in ("Up", "Up", "Up", "Right", "Right", "Return", "4", "2", "Return", "o", "k", "Return", "Return"):
        key(name)
    session.wait_for("form survey")
    session.type("note all went well")
    subject.survey()
    session.wait_for("ended: completed")
    subject.go_on()
    session.wait_for("the session is complete")
    code = session.program.wait(timeout=PATIENCE)
    if code != 0:
        fail(f"exit code {code}")


def check(what, got, expected):
    if got != expected:
        fail(f"{what}: {got} instead of {expected}")


def check_database(path, way):
    database = sqlite3.connect(path)

    def rows(query):
        return database.execute(query).fetchall()

    check("integrity", rows("PRAGMA integrity_check"), [("ok",)])
    check("runs", rows("SELECT subject_id, session_number, ending, forced, simulated FROM run"),
          [("S01", 1, "completed", 1, 0)])
    check("consent", rows("SELECT agreed FROM consent"), [(1,)])
    environment = json.loads(rows("SELECT environment_json FROM run")[0][0])
    check("stated gamma", environment["stated_gamma"], 2.2)
    calibration = environment["calibration"]
    # The frame begins at 0.8 of what the protocol states: 1280 pixels are 518 mm.
    check("size", abs(calibration["pixels_per_millimeter"] - 0.8 * 1280 / 518) < 0.01, True)
    check("distance", 40 / math.tan(math.radians(13.5)) < calibration["distance_millimeters"] < 400, True)
    check("deviations", rows("SELECT count(*) FROM event WHERE what = 'screen_deviates'"), [(2,)])
    check("answers", rows("SELECT form, field, answer FROM answer ORDER BY answer_id"),
          [("demographics", "age_band", "30-44"), ("demographics", "experience", "3"),
           ("extra after", "effort", "60"), ("extra after", "age", "42"), ("extra after", "remarks", "ok"),
           ("survey", "find_easier", "4")])
    trials = rows("SELECT practice, task, view, ending, timing_verdict FROM trial ORDER BY trial_id")
    check("trials", trials,
          [(practice, task, view, "completed", "unstable_refresh")
           for practice, task, view in [(1, "find", "ppc"), (0, "find", "ppc"), (0, "find", "gc"), (0, "count", "ppc"),
                                        (0, "count", "gc"), (0, "path", "ppc"), (0, "path", "gc")]])
    check("found objects", rows("SELECT correct, censored FROM trial WHERE task = 'find'"), [(1, 0)] * 3)
    check("answers to the others", rows("SELECT answer <> '', censored FROM trial WHERE task <> 'find'"), [(1, 0)] * 4)
    # Two seconds by the clock, but for a frame, however long that one was, and for what is lost in ticks.
    for rule, shown, frames, longest in rows("SELECT exposure_rule, exposure_shown_s, exposure_frames, "
                                             "longest_interval_ns FROM trial WHERE task = 'count'"):
        check("rule of the exposure", rule, "clock")
        check("exposure", abs(shown - 2) <= longest / 1e9 + 1 / 60 + 1 / 240, True)
        check("frames of the exposure", 0 < frames <= 121, True)
    # Times count from the start of the run, which lasted some minutes at most.
    for table, column in (("event", "at_ns"), ("frame", "shown_ns"), ("input", "came_ns")):
        first, last = rows(f"SELECT min({column}), max({column}) FROM {table}")[0]
        check(f"times of {table}", 0 <= first <= last < 900 * 10**9, True)
    check("events", rows("SELECT detail FROM event WHERE what IN ('pause', 'note') ORDER BY event_id"),
          [("a moment, please",), ("all went well",)])
    kinds = {kind for (kind,) in rows("SELECT DISTINCT kind FROM input")}
    check("clicks", "pointer_button" in kinds, way == "mouse")
    # Each trial has a frame of each number, shown one after the other, and every fifth has a hash.
    for trial, frames in rows("SELECT trial_id, frames FROM trial"):
        shown = rows(f"SELECT frame, shown_ns, pixel_hash IS NOT NULL FROM frame WHERE trial_id = {trial} "
                     "ORDER BY frame")
        check("numbers of frames", [number for number, _, _ in shown], list(range(frames)))
        check("order of times", all(a[1] < b[1] for a, b in zip(shown, shown[1:])), True)
        check("hashes", [hashed for _, _, hashed in shown], [int(i % 5 == 0) for i in range(frames)])


def check_markers(folder):
    """The file tells of each trial at the moment that the database has for its first frame."""
    with open(folder / "S01-markers.csv", newline="") as file:
        markers = list(csv.DictReader(file))
    database = sqlite3.connect(folder / "tiny.db")
    check("starts", [(int(each["trial_number"]), int(each["nanoseconds"])) for each in markers
                     if each["name"].startswith(("trial_start", "practice_start"))],
          database.execute("SELECT trial_number, started_ns FROM trial ORDER BY trial_number").fetchall())
    check("ends", len([each for each in markers if each["name"] == "trial_end"]), 7)
    check("first and last", (markers[0]["name"], markers[-1]["name"]), ("session_start", "session_end"))
    told = database.execute("SELECT detail FROM event WHERE what = 'markers'").fetchall()
    check("told", [detail.split(": ")[-1] for (detail,) in told], [f"{len(markers)} sent, 0 lost"])


def check_gaze(folder):
    """Each trial has samples of its own time, in order, as they were sent."""
    database = sqlite3.connect(folder / "tiny.db")
    trials = database.execute("SELECT trial_id, started_ns, ended_ns FROM trial").fetchall()
    for trial, started, ended in trials:
        samples = database.execute("SELECT came_ns, device_time, valid, x_px, pupil FROM gaze WHERE trial_id = ? "
                                   "ORDER BY gaze_index", (trial,)).fetchall()
        check("samples of a trial", len(samples) > (ended - started) / 1e9 * 20, True)  # a slow machine sends fewer
        check("times", all(started <= each[0] <= ended for each in samples), True)
        check("order", all(a[1] < b[1] for a, b in zip(samples, samples[1:])), True)
        for _, device_time, valid, x, pupil in samples:
            i = round(device_time * 100)
            check("valid", valid, int(i % 10 != 0))
            check("pupil", pupil, 3.5)
            if valid:
                check("place", abs(x - (0.5 + 0.3 * math.cos(i / 50)) * WIDTH) < 0.01, True)
    detail = database.execute("SELECT detail FROM event WHERE what = 'gaze' ORDER BY event_id DESC LIMIT 1").fetchone()[0]
    check("end of gaze", "0 malformed lines, 0 lost" in detail, True)


def check_responses(folder, way):
    """The box had its presses where it was used; they are inputs of the trials like those of a keyboard."""
    database = sqlite3.connect(folder / "tiny.db")
    details = [detail for (detail,) in database.execute("SELECT detail FROM event WHERE what = 'responses'")]
    box = [detail for detail in details if detail.startswith("serial:")]
    check("box", [box[0].endswith("debounced 10 ms"), len(box)], [True, 2])
    presses = int(box[1].split(": ")[-1].split()[0])
    check("presses of the box", presses >= 4 if way == "keyboard" else presses == 0, True)
    if way == "keyboard":
        check("bounces of the box", int(box[1].split()[-2]) >= 2, True)
        check("answers by the box", database.execute("SELECT count(DISTINCT trial_id) FROM input JOIN trial USING "
                                                     "(trial_id) WHERE task = 'count' AND what = '4'").fetchone(), (2,))


def check_page(statuses):
    """The page told of the session, and neither who the subject is nor which condition a trial had."""
    begun = [each for each in statuses if each["state"] != "not begun"]
    check("statuses", len(begun) > 10, True)
    done = [each["trials_done"] for each in begun]
    check("progress", done == sorted(done) and done[-1] >= 5 and begun[-1]["trials"] == 6, True)
    check("states", {"running", "paused"} <= {each["state"] for each in begun}, True)
    check("answers", any(each["last_trials"] for each in begun), True)
    check("devices", {device["name"].split()[0] for device in begun[-1]["devices"]},
          {"keyboard", "markers", "gaze", f"serial:{os.ttyname(BOX_DEVICE)},"})
    text = json.dumps(begun)
    check("blind", [word for word in ("S01", "ppc", '"gc"', ", gc", "all went well") if word in text], [])


def main():
    ocelli, protocol, way, folder = sys.argv[1], sys.argv[2], sys.argv[3], pathlib.Path(sys.argv[4])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    (folder / "gaze.csv").touch()
    session = Session(ocelli, protocol, folder)
    try:
        run(session, ByMouse if way == "mouse" else ByKeyboard)
    finally:
        session.program.kill()
    check_database(folder / "tiny.db", way)
    check_markers(folder)
    check_gaze(folder)
    check_responses(folder, way)
    check_page(session.statuses)
    print("a session by", way, "is complete")


if __name__ == "__main__":
    main()
