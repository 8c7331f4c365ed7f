"""Runs the Python reader of docs/svol.md, as it stands there, on files of the program, and compares with NRRD exports.

Usage: svol_python_test.py OCELLI SOURCE_FOLDER. Where the package `zstandard` is missing, the zstd library takes its place.
"""

import ctypes
import gzip
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import types


def provide_zstandard():
    try:
        import zstandard  # noqa: F401
    except ImportError:
        library = ctypes.CDLL("libzstd.so.1")
        library.ZSTD_decompress.restype = ctypes.c_size_t

        def decompress(packed, max_output_size):
            content = ctypes.create_string_buffer(max_output_size)
            size = library.ZSTD_decompress(content, ctypes.c_size_t(max_output_size), packed,
                                           ctypes.c_size_t(len(packed)))
            assert size <= max_output_size, "zstd refused a payload"
            return content.raw[:size]

        sys.modules["zstandard"] = types.ModuleType("zstandard")
        sys.modules["zstandard"].decompress = decompress


def documented_reader(source):
    text = (source / "docs/svol.md").read_text(encoding="utf-8")
    names = {}
    exec(re.search(r"```python\n(.*?)```", text, re.DOTALL).group(1), names)
    return names["Svol"]


def expect(condition, what):
    if not condition:
        sys.exit(f"failed: {what}")


def compare_with_exports(program, reader, folder):
    profile = {"name": "three-bits", "radius_metres": 0.1, "slices_per_half_turn": 7, "width": 29, "height": 23,
               "rotations_per_minute": 600, "color_bits_per_channel": 3}
    (folder / "profile.json").write_text(json.dumps(profile))

    def run(*arguments):
        subprocess.run([program, *arguments, "--quiet"], cwd=folder, check=True)

    for name, scene in (("a", "builtin:teapot,segments=4"), ("b", "builtin:box"), ("c", "builtin:teapot,segments=4")):
        run("slice", scene, "--profile", "profile.json", "-o", name + ".svol")
    run("volume", "join", "a.svol", "b.svol", "c.svol", "--fps", "10", "-o", "film.svol")
    file = reader(folder / "film.svol")
    expect(file.profile["name"] == "three-bits" and file.metadata["scene"].startswith("builtin:"), "the texts")
    lit = 0
    count = 0
    for time, planes in file.frames():
        expect(time == 100000 * count, f"the time of frame {count}")
        run("volume", "export", "film.svol", "--frame", str(count), "-o", "frame.nrrd")
        exported = gzip.decompress((folder / "frame.nrrd").read_bytes().split(b"\n\n", 1)[1])
        at = 0
        for i in range(7):
            for y in range(23):
                for x in range(29):
                    levels = file.levels(planes, i, x, y)
                    lit += any(levels)
                    # As display_sim/frames/volume.h scales levels to bytes.
                    expect(tuple(exported[at:at + 3]) == tuple((255 * level + 3) // 7 for level in levels),
                           f"frame {count}, slice {i}, column {x}, row {y}")
                    at += 3
        count += 1
    expect(count == 3 and file.finished and lit > 100, "three frames with something lit")


def read_corpus(reader, corpus):
    for path in corpus.glob("*.svol"):
        if not path.name.startswith("bad_"):
            file = reader(path)
            for _ in file.frames():
                pass
            expect(file.finished == path.name.startswith("good_"), path.name)


def main():
    program, source = sys.argv[1], pathlib.Path(sys.argv[2])
    provide_zstandard()
    reader = documented_reader(source)
    with tempfile.TemporaryDirectory() as folder:
        compare_with_exports(program, reader, pathlib.Path(folder))
    read_corpus(reader, source / "tests/display_sim_frames/corpus")


if __name__ == "__main__":
    main()
