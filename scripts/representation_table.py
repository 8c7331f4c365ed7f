"""Prints the tables of docs/choosing.md from the files that measure_representations.sh leaves: SCENE-CELL.json.

Usage: representation_table.py FOLDER
"""

import json
import pathlib
import sys

SCENES = ["bunny", "dragon", "armadillo", "buddhas", "teapot", "doors", "boxes", "fence-4", "fence-1"]


def read(folder, cell):
    """{scene: {representation: figures}} of one cell."""
    scenes = {}
    for scene in SCENES:
        path = folder / f"{scene}-{cell}.json"
        if path.exists():
            rows = json.loads(path.read_text())["representations"]
            scenes[scene] = {row["name"]: row for row in rows}
    return scenes


def names(scenes):
    found = []
    for rows in scenes.values():
        found += [name for name in rows if name not in found]
    return found


def table(head, lines):
    print("| " + " | ".join(head) + " |")
    print("| --- |" + " ---: |" * (len(head) - 1))
    for line in lines:
        print("| " + " | ".join(line) + " |")
    print()


def percent(value):
    return f"{100 * value:.1f}" if value < 0.0995 else f"{100 * value:.0f}"


def mean(values):
    values = [value for value in values if value is not None]
    return sum(values) / len(values) if values else None


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    for cell in ("8in", "4in"):
        scenes = read(folder, cell)
        if not scenes:
            continue
        for field, measure in (("strict", "strictly"), ("thick", "thickly")):
            print(f"Cell of {cell}: samples {measure} missing over its edges, % of those that the depth image lacks.\n")
            table(
                ["representation", *scenes],
                [
                    [f"`{name}`"]
                    + [percent(rows[name]["ratio_to_di"][field]) if name in rows else "" for rows in scenes.values()]
                    for name in names(scenes)
                ],
            )
        print(f"Cell of {cell}: samples, relative to the depth image.\n")
        table(
            ["representation", *scenes],
            [
                [f"`{name}`"]
                + [
                    f"{rows[name]['samples'] / rows['di']['samples']:.2f}" if name in rows else ""
                    for rows in scenes.values()
                ]
                for name in names(scenes)
            ],
        )
        print(f"Cell of {cell}: means over the scenes.\n")
        lines = []
        for name in names(scenes):
            rows = [scene[name] for scene in scenes.values() if name in scene]
            build = mean([row["build_ms"] + row["mesh_ms"] for row in rows])
            lines.append(
                [
                    f"`{name}`",
                    f"{100 * mean([row['missing_strict']['edges'] for row in rows]):.2f} %",
                    f"{100 * mean([row['missing_strict']['interior'] for row in rows]):.2f} %",
                    f"{100 * mean([row['missing_strict']['reference'] for row in rows]):.3f} %",
                    f"{100 * mean([row['false_skins']['edges'] for row in rows]):.2f} %",
                    f"{mean([row['flip']['edges'] for row in rows]):.4f}",
                    f"{mean([row['triangles'] for row in rows]) / 1000:.0f}",
                    f"{mean([row['bytes']['raw'] for row in rows]) / 1e6:.1f}",
                    f"{mean([row['bytes']['zstd'] for row in rows]) / 1e6:.2f}",
                    f"{build:.0f}",
                ]
            )
        table(
            [
                "representation",
                "missing, edges",
                "inside",
                "at the reference",
                "false skins",
                "FLIP",
                "triangles, K",
                "MB",
                "MB, zstd",
                "made in, ms",
            ],
            lines,
        )


main()
