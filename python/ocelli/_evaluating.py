from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Any

from ocelli import _ocelli
from ocelli._arguments import camera_of, mesh_of, size_of, view_of
from ocelli._ocelli import Volume
from ocelli._progress import Shown
from ocelli._types import CameraLike, EvaluatedLike, Progress, Size, ViewLike
from ocelli.errors import InputError


def evaluate(
    scene: EvaluatedLike,
    cameras: CameraLike | Sequence[CameraLike] = ("di", "ddoc"),
    *,
    view: ViewLike = None,
    size: Size = (720, 480),
    cell_side: float = 1.6,
    cell_shape: str = "cube",
    interior_views: int = 12,
    edge_views: int = 1,
    seed: int = 1,
    compare_images: bool = True,
    runs: int = 3,
    opacity: float | None = None,
    progress: Progress = None,
) -> list[dict[str, Any]]:
    """Measures representations against the scene, over the viewpoints of a cell.

    Args:
        scene: a `Scene`, a `Mesh`, a file name or "builtin:NAME"; or a `Volume`, as rays hit it first.
        cameras: names, dicts with options, files, or your own (see `ocelli.camera`); a list, or one of them.
        view: the reference view; None: from (0, 0, 10).
        size: (width, height), pixels.
        cell_side: of the cell, display radii; 1.6 are 8 inches at the reference display.
        cell_shape: "cube", "sphere" or "segment".
        interior_views: viewpoints inside the cell.
        edge_views: viewpoints between the corners of each edge of a cube.
        seed: of the viewpoints inside the cell.
        compare_images: measure PSNR, SSIM and FLIP too, which takes most of the time.
        runs: how often each representation is made; the best times count.
        opacity: of a volume: at which a ray hits it; None: 0.5.
        progress: None, True, False or a function `progress(stage, fraction)`.

    Returns:
        A list of dicts, one for each camera: docs/metrics.md lists the fields. `pandas.json_normalize(rows)` makes a table.

    Raises:
        InputError: for unknown cameras, and where a viewpoint lies inside an object.
    """
    width, height = size_of(size)
    several = cameras if isinstance(cameras, (list, tuple)) else [cameras]
    chosen = [camera_of(camera, {}, (width, height)) for camera in several]
    if opacity is not None and not isinstance(scene, Volume):
        raise InputError("this scene has triangles: the option is for volumes alone", "opacity", "leave it out")
    with Shown(progress) as callback:
        text = _ocelli.evaluate(
            scene if isinstance(scene, Volume) else mesh_of(scene, callback),
            scene if isinstance(scene, str) else repr(scene),
            chosen,
            view_of(view),
            width,
            height,
            cell_side,
            cell_shape,
            interior_views,
            edge_views,
            seed,
            compare_images,
            runs,
            opacity,
            callback,
        )
    return json.loads(text)["representations"]
