"""Runs the Python display of docs/wire_protocol.md, as it stands there, on streams of the encoder, whole and damaged,
and compares with what the firmware acknowledges and reports.

Usage: wire_python_test.py WIRE_STREAM_WRITER SOURCE_FOLDER. Where the package `zstandard` is missing, the zstd library
takes its place.
"""

import pathlib
import re
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "cli"))
from svol_python_test import expect, provide_zstandard  # noqa: E402


def documented_display(source):
    text = (source / "docs/wire_protocol.md").read_text(encoding="utf-8")
    names = {}
    exec(re.search(r"```python\n(.*?)```", text, re.DOTALL).group(1), names)
    expect(names["crc32c"](b"123456789") == 0xE3069283, "the checksum of the page")
    return names["Display"]


def main():
    writer, source = sys.argv[1], pathlib.Path(sys.argv[2])
    provide_zstandard()
    display_class = documented_display(source)
    lines = subprocess.run([writer, "20"], check=True, capture_output=True, text=True).stdout.splitlines()
    streams = []
    for line in lines:
        kind, *rest = line.split()
        if kind == "display":
            streams.append((list(map(int, rest)), []))
        elif kind == "bytes":
            data = bytes.fromhex(rest[0])
            streams[-1] = (*streams[-1], data)
        elif kind == "arrived":
            streams[-1][1].append(("ARRIVED", int(rest[0]), [bytes.fromhex(slice) for slice in rest[1:]]))
        else:
            streams[-1][1].append(("ERROR", int(rest[0]), int(rest[1])))
    arrived = errors = 0
    for number, (numbers, expected, data) in enumerate(streams):
        display = display_class(*numbers)
        events = []
        step = 1 + 97 * number
        for at in range(0, len(data), step):
            events += display.take(data[at:at + step])
        expect(len(events) == len(expected), f"stream {number}: {len(events)} events instead of {len(expected)}")
        for got, wanted in zip(events, expected):
            expect(got == wanted, f"stream {number}: {got[:2]} instead of {wanted[:2]}")
        arrived += sum(event[0] == "ARRIVED" for event in events)
        errors += sum(event[0] == "ERROR" for event in events)
    expect(arrived > 400 and errors > 50, f"{arrived} frames, {errors} errors")


if __name__ == "__main__":
    main()
