"""Three cameras that the toolkit has no model of, as ray maps for `--camera RAYS.exr` (docs/ray_maps.md).

    python3 write_ray_maps.py FOLDER
    ocelli render builtin:town    --camera FOLDER/push_broom.exr -o push_broom.png
    ocelli render builtin:statues --camera FOLDER/around.exr     -o around.png
    ocelli render builtin:town    --camera FOLDER/fisheye.exr --view docs/cameras/examples/street_view.json -o fisheye.png

It needs Python alone. With NumPy, pass float32 arrays of shape (height, width, 3): anything that iterates like that does.
"""

import json
import math
import pathlib
import struct
import sys


def attribute(name, kind, value):
    return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(value)) + value


def write_ray_map(path, origins, directions, **description):
    """Writes an OpenEXR file, uncompressed: rows of pixels, each an origin and a direction of three numbers.

    A direction may have any length; (0, 0, 0) is a pixel without a ray. `description` says what docs/ray_maps.md lists:
    name, frame, near, far, wraps_around, view.
    """
    height, width = len(origins), len(origins[0])
    rows = {}
    for layer, values in (("direction", directions), ("origin", origins)):
        for axis in range(3):
            rows[f"{layer}.{'xyz'[axis]}"] = [[float(pixel[axis]) for pixel in row] for row in values]
    names = sorted(rows)  # as OpenEXR stores them
    floats = 2
    channels = b"".join(name.encode() + b"\0" + struct.pack("<iB3xii", floats, 0, 1, 1) for name in names) + b"\0"
    window = struct.pack("<4i", 0, 0, width - 1, height - 1)
    text = json.dumps({"type": "rays", "format": 1, **description}).encode()
    header = (struct.pack("<ii", 20000630, 2)
              + attribute("channels", "chlist", channels)
              + attribute("compression", "compression", b"\0")
              + attribute("dataWindow", "box2i", window)
              + attribute("displayWindow", "box2i", window)
              + attribute("lineOrder", "lineOrder", b"\0")
              + attribute("ocelli", "string", text)
              + attribute("pixelAspectRatio", "float", struct.pack("<f", 1))
              + attribute("screenWindowCenter", "v2f", struct.pack("<ff", 0, 0))
              + attribute("screenWindowWidth", "float", struct.pack("<f", 1))
              + b"\0")
    line_bytes = 4 * width * len(names)
    first_line = len(header) + 8 * height
    with open(path, "wb") as file:
        file.write(header)
        for y in range(height):
            file.write(struct.pack("<Q", first_line + y * (8 + line_bytes)))
        for y in range(height):
            file.write(struct.pack("<ii", y, line_bytes))
            for name in names:
                file.write(struct.pack(f"<{width}f", *rows[name][y]))


def rays_of(width, height, ray):
    """`ray(u, v)` gives origin and direction; u and v run from 0 to 1 over the image, to the right and down."""
    pixels = [[ray((x + 0.5) / width, (y + 0.5) / height) for x in range(width)] for y in range(height)]
    return [[origin for origin, _ in row] for row in pixels], [[direction for _, direction in row] for row in pixels]


def push_broom(u, v):
    """Flies over the scene from left to right and looks down along a line across its way, 40 degrees forward."""
    tilt, across = math.radians(40), math.radians(46) * (v - 0.5)
    return ((2 * u - 1) * 0.86 - 0.87, 0.9, 0), (math.cos(across) * math.sin(tilt), -math.cos(across) * math.cos(tilt), math.sin(across))


def around(u, v):
    """Looks at the axis of the scene from all sides at once: a column is a side, a row is a height."""
    angle = 2 * math.pi * (u - 0.5)
    return (3 * math.sin(angle), 1 - 2 * v, 3 * math.cos(angle)), (-math.sin(angle), 0, -math.cos(angle))


def fisheye(u, v):
    """An equidistant lens of 180 degrees, as a calibration gives one: in its own frame, right, up and backward."""
    x, y = 2 * u - 1, 1 - 2 * v
    radius = math.hypot(x, y)
    if radius > 1:
        return (0, 0, 0), (0, 0, 0)
    angle = radius * math.pi / 2
    sine = math.sin(angle) / radius if radius > 0 else 0
    return (0, 0, 0), (x * sine, y * sine, -math.cos(angle))


def main(folder):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    write_ray_map(folder / "push_broom.exr", *rays_of(720, 360, push_broom), name="push-broom", far=10)
    write_ray_map(folder / "around.exr", *rays_of(720, 280, around), name="around", far=10, wraps_around=True)
    write_ray_map(folder / "fisheye.exr", *rays_of(360, 360, fisheye), name="fisheye", frame="view", far=10)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: write_ray_maps.py FOLDER")
    main(sys.argv[1])
