#!/usr/bin/env python3
"""Writes the tables of analysis/dataset/column_maps/examples/: the same simulated trials as PsychoPy, jsPsych and UXF write theirs.

Usage: make_trial_tables.py FOLDER. The trials are drawn here, and nobody's: eight subjects see eight cases in both conditions once,
searches with the graph camera take 0.7 of the time, and are cut off after 12 s. Times are whole milliseconds, so that the
tables agree.
"""

import csv
import math
import pathlib
import random
import sys

LIMIT_MS = 12000
CASES = ["atrium", "bridge", "corner", "door", "escalator", "fountain", "gallery", "hall"]


def trials_of(subject):
    """(condition, case, right key, key or None, right, milliseconds) in the order in which they were done."""
    draw = random.Random(2010 + subject)
    slowness = draw.gauss(0, 0.25)
    order = [(condition, case) for case in range(len(CASES)) for condition in ("pinhole", "graph")]
    draw.shuffle(order)
    for condition, case in order:
        log_seconds = math.log(6) + slowness + 0.08 * case + (math.log(0.7) if condition == "graph" else 0) + draw.gauss(0, 0.4)
        milliseconds = round(1000 * math.exp(log_seconds))
        right_key = "left" if case % 2 == 0 else "right"
        right = draw.random() < (0.9 if condition == "graph" else 0.8)
        key = right_key if right else {"left": "right", "right": "left"}[right_key]
        if milliseconds >= LIMIT_MS:
            yield condition, CASES[case], right_key, None, False, LIMIT_MS
        else:
            yield condition, CASES[case], right_key, key, right, milliseconds


def write_psychopy(path, subjects):
    """UTF-8 with a byte order mark; each line ends in a separator, so the last column has no name."""
    names = ["condition", "case", "corrAns", "trials.thisRepN", "trials.thisTrialN", "trials.thisN", "trials.thisIndex",
             "instr_key.keys", "instr_key.rt", "key_resp.keys", "key_resp.corr", "key_resp.rt", "participant", "session", "date",
             "expName", "psychopyVersion", "frameRate", ""]
    with open(path, "w", encoding="utf-8-sig", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(names)
        for subject in subjects:
            who = [f"P{subject:02}", "001", f"2026-03-{subject:02}_10h15.{subject:02}.000", "search", "2024.1.4", "60.02", ""]
            table.writerow(["", "", "", "", "", "", "", "space", "3.5", "", "", "", *who])
            for number, (condition, case, right_key, key, right, milliseconds) in enumerate(trials_of(subject)):
                table.writerow([condition, case, right_key, 0, number, number, number, "", "", key or "None", int(right),
                                milliseconds / 1000 if key else "", *who])


def write_jspsych(path, subjects):
    """All fields in quotes; what is null is the text null; CR LF."""
    names = ["rt", "stimulus", "response", "trial_type", "trial_index", "time_elapsed", "internal_node_id", "subject", "task",
             "condition", "case", "correct"]
    with open(path, "w", encoding="utf-8", newline="") as file:
        table = csv.writer(file, quoting=csv.QUOTE_ALL, lineterminator="\r\n")
        table.writerow(names)
        for subject in subjects:
            who = f"P{subject:02}"
            elapsed = 3500
            table.writerow([3500, "<p>Find the door, and press the arrow of its side.</p>", " ", "html-keyboard-response", 0,
                            elapsed, "0.0-0.0", who, "", "", "", ""])
            for number, (condition, case, _, key, right, milliseconds) in enumerate(trials_of(subject)):
                elapsed += 500
                table.writerow(["null", '<div style="font-size:60px;">+</div>', "null", "html-keyboard-response", 2 * number + 1,
                                elapsed, f"0.0-1.0-{number}.0", who, "fixation", "", "", ""])
                elapsed += milliseconds
                table.writerow([milliseconds if key else "null", f"img/{case}-{condition}.png", f"arrow{key}" if key else "null",
                                "image-keyboard-response", 2 * number + 2, elapsed, f"0.0-1.0-{number}.1", who, "response",
                                condition, case, "true" if right else "false"])


def write_uxf(path, subjects):
    """Seconds since the program began, with up to six decimals."""
    def seconds(milliseconds):
        return f"{milliseconds / 1000:.6f}".rstrip("0").rstrip(".")
    with open(path, "w", encoding="utf-8", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["experiment", "ppid", "session_num", "trial_num", "block_num", "trial_num_in_block", "start_time", "end_time",
                        "condition", "case", "answer", "correct"])
        for subject in subjects:
            clock = 20417
            for number, (condition, case, _, key, right, milliseconds) in enumerate(trials_of(subject), 1):
                table.writerow(["search", f"P{subject:02}", 1, number, 1, number, seconds(clock), seconds(clock + milliseconds),
                                condition, case, key or "null", right])
                clock += milliseconds + 1013


def main(folder):
    folder = pathlib.Path(folder)
    subjects = range(1, 9)
    write_psychopy(folder / "psychopy.csv", subjects)
    write_jspsych(folder / "jspsych.csv", subjects)
    write_uxf(folder / "uxf.csv", subjects)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
