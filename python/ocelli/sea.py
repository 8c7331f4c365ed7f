"""Seas of images: thousands of views of a place in one file, any of which is had at once.

    sea = ocelli.sea.build("builtin:office", "office.sea", count=200, size=(512, 512))
    sea = ocelli.sea.read("office.sea")
    sea[17]                                  # (height, width, 3), bytes of sRGB
    sea.view(sea.positions[:2].mean(axis=0)) # from between images

docs/sea_of_images.md says what a sea is made from and how it is stored.
"""

from __future__ import annotations

import csv
import json
import os
import tempfile
from collections.abc import Sequence
from pathlib import Path as File
from typing import Any

import numpy
from numpy.typing import ArrayLike

from ocelli import _ocelli
from ocelli._arguments import size_of
from ocelli._ocelli import Sea
from ocelli._progress import Shown
from ocelli._types import Path, Progress, Size
from ocelli.errors import InputError

__all__ = ["build", "read", "settings"]


def read(path: Path) -> Sea:
    """Opens a sea: `len(sea)`, `sea[i]`, `sea.view()`, `sea.positions`, `sea.names`, `sea.verify()`.

    Args:
        path: a file `.sea`. It is mapped: what is not looked at is not read.

    Raises:
        InputError: for what is no sea, or is damaged where it says what it holds.
    """
    return Sea(path)


def settings(sea: Sea) -> dict[str, Any]:
    """How a sea was built: what its file says of itself.

    Args:
        sea: what `read()` or `build()` gave.
    """
    return dict(json.loads(sea.settings_json()))


def build(
    source: Path,
    path: Path,
    *,
    positions: ArrayLike | Path | None = None,
    spacing: float | None = None,
    grid: Sequence[float] | None = None,
    eye_height: float = 1.6,
    first: int = 0,
    count: int = 0,
    size: Size = (1024, 1024),
    samples: int = 2,
    shaded: bool = True,
    proxy: Path = "",
    proxy_triangles: int = 20000,
    start_over: bool = False,
    progress: Progress = None,
    **settings: object,
) -> Sea:
    """Makes a sea of a folder of images with poses, or of a scene that is rendered. A build that was stopped goes on.

    Args:
        source: a folder with COLMAP's text files or with `positions.csv`; or a scene: a file name or "builtin:NAME".
        path: the file `.sea` that is written.
        positions: of a scene: where panoramas are taken, (images, 3), or a table in CSV; None: along its walk.
        spacing: of a scene: how far images along its walk are apart; None: as it says itself.
        grid: of a scene: (x0, z0, x1, z1, spacing) of a level grid in place of the walk.
        eye_height: of such a grid.
        first: images before it are left out.
        count: at most so many images; 0: all.
        size: of panoramas, (width, height), pixels.
        samples: a side of each of their pixels.
        shaded: multiply colours of a scene by a fixed light, so that shapes show.
        proxy: what the place is shaped like: a mesh file, "scene", "box" or "none"; "": what fits the source.
        proxy_triangles: the most triangles that a scene is simplified to.
        start_over: remove what a build that was stopped has left.
        progress: None, True, False or a function `progress(stage, fraction)`.
        **settings: of the file, as `settings()` shows them: way, i_spacing, i_codec, p_codec, i_quality, p_quality, ...

    Returns:
        The sea, open.

    Raises:
        InputError: for sources and settings that are none.
    """
    with tempfile.TemporaryDirectory() as folder, Shown(progress) as callback:
        _ocelli.build_sea(
            os.fspath(source),
            path,
            size_of(size),
            samples,
            _table_of(positions, File(folder)),
            spacing,
            "" if grid is None else ",".join(repr(float(value)) for value in grid),
            eye_height,
            first,
            count,
            os.fspath(proxy),
            proxy_triangles,
            shaded,
            json.dumps(settings),
            start_over,
            callback,
        )
    return Sea(path)


def _table_of(positions, folder):
    """The path of a table of places; one in `folder` for an array."""
    if positions is None:
        return ""
    if isinstance(positions, (str, os.PathLike)):
        return os.fspath(positions)
    rows = numpy.asarray(positions, dtype=float)
    if rows.ndim != 2 or rows.shape[1] != 3:
        raise InputError(f"an array of shape {rows.shape} has no places", "positions", "give (images, 3)")
    path = folder / "positions.csv"
    with path.open("w", newline="", encoding="utf-8") as file:
        table = csv.writer(file)
        table.writerow("xyz")
        table.writerows([repr(value) for value in row] for row in rows.tolist())
    return os.fspath(path)
