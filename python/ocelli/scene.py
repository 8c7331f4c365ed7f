"""Scenes: files, what the toolkit makes itself, and your own meshes.

    bunny = ocelli.scene.load("bunny.ply")
    room = ocelli.scene.load("builtin:room,mesh=bunny.ply")
    mine = ocelli.Mesh(positions, triangles, colors)
"""

from __future__ import annotations

import os

from ocelli import _ocelli
from ocelli._ocelli import Scene
from ocelli._progress import Shown
from ocelli._types import Path, Progress

__all__ = ["builtins", "load"]


def load(
    source: Path,
    *,
    fit: bool = True,
    shaded: bool = True,
    textures: bool = True,
    seconds: float | None = None,
    iso: float | None = None,
    labels: Path | None = None,
    texture_triangles: int = 1_000_000,
    progress: Progress = None,
) -> Scene:
    """Loads a scene as one mesh with a colour at each vertex.

    Args:
        source: a file name, or "builtin:NAME[,key=value...]": `builtins()` lists the names.
        fit: scale and move it into the unit sphere; otherwise it keeps its own coordinates.
        shaded: multiply colours by a fixed light, so that shapes show.
        textures: bake the textures of a file to the colours of its vertices.
        seconds: of a scene that moves, the moment that is taken; None: as it is at rest.
        iso: of a volume, the value whose surface is taken.
        labels: a table in CSV of texts in the scene (docs/files.md, "Labels"): x, y, z, text, and perhaps size, color.
        texture_triangles: how many triangles textures may add, up to 20 million; those that need more are blurred.
        progress: None, True, False or a function `progress(stage, fraction)`.

    Returns:
        `Scene`: `.mesh`, and `.object_of_triangle`, shape (triangles,).

    Raises:
        InputError: for a file or a name that is wrong.
    """
    with Shown(progress) as callback:
        return _ocelli.load_scene(
            os.fspath(source),
            fit,
            shaded,
            textures,
            seconds,
            iso,
            "" if labels is None else os.fspath(labels),
            texture_triangles,
            callback,
        )


def builtins() -> dict[str, str]:
    """The scenes that the toolkit makes: {name: what it is}."""
    return dict(_ocelli.builtin_scenes())
