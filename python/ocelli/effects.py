"""Effects: what a scene looks like where rays go further than to the first surface.

    picture = ocelli.effects.draw("builtin:mirror", "reflection", by="ddoc")     # (height, width, 3), linear RGB
    found = ocelli.effects.compare("builtin:lamp", "shadow", by=["outlines", "eoc-hv"])
    found.figures["outlines"]                                                    # errors against the traced picture

`kinds()` lists them: reflection, refraction, soft shadows, ambient light, relief, each with what may stand for the scene
where rays go on (`by`), its options, which are keywords here, and what its figures mean. Scenes need objects with roles,
such as mirrors: built-in scenes have them, files have a SCENE.roles.json beside them or as `roles`.
"""

from __future__ import annotations

import json
import os
from collections.abc import Sequence
from typing import Any

from ocelli import _ocelli
from ocelli._arguments import size_of, view_of
from ocelli._progress import Shown
from ocelli._types import Bytes, Floats, Path, Progress, Size, ViewLike
from ocelli.errors import InputError

__all__ = ["Comparison", "compare", "draw", "kinds", "options"]


class Comparison:
    """What `compare()` measured.

    Attributes:
        figures: {way: {figure: value}}, "traced" first; None where a way has no such figure.
        pictures: {way: array (height, width, 3), linear RGB}.
        maps: {way: {name: array (height, width, 3), bytes}}: where a picture is wrong, and what rays took.
        report: all of it as `ocelli shade --json` writes it.
    """

    def __init__(self, report: str, pictures: list[tuple[Floats, dict[str, Bytes]]]) -> None:
        self.report: dict[str, Any] = json.loads(report)
        self.figures: dict[str, dict[str, Any]] = {}
        self.pictures: dict[str, Floats] = {}
        self.maps: dict[str, dict[str, Bytes]] = {}
        for row, (picture, maps) in zip(self.report["by"], pictures, strict=True):
            name = row["name"]
            self.figures[name] = {key: value for key, value in row.items() if key != "name"}
            self.pictures[name] = picture
            self.maps[name] = maps


def kinds() -> dict[str, str]:
    """The effects that there are: {name: what it is}."""
    return {row["name"]: row["meaning"] for row in _ocelli.effects()}


def options(effect: str) -> dict[str, Any]:
    """What an effect takes: "ways", a list for `by`; "options", dicts with name, values, default and meaning; "figures",
    {name: what it means}.

    Raises:
        InputError: for an unknown name.
    """
    for row in _ocelli.effects():
        if row["name"] == effect:
            return row
    raise InputError(f"there is no effect {effect!r}", "effect", f"use one of {', '.join(kinds())}")


def draw(
    scene: Path,
    effect: str = "reflection",
    *,
    by: str = "traced",
    roles: Path = "",
    view: ViewLike = None,
    size: Size = (720, 480),
    image_size: Size | None = None,
    cell: float | None = None,
    environment_height: int = 1024,
    shaded: bool = True,
    progress: Progress = None,
    **options: object,
) -> Floats:
    """Draws an effect.

    Args:
        scene: a file name or "builtin:NAME", whose objects have the roles that the effect needs.
        effect: a name of `kinds()`.
        by: what stands for the scene where rays go on: "traced" is the scene itself; `options(effect)["ways"]` lists them.
        roles: a JSON file that says which objects mirror, refract or cast; "": the one beside the scene, if any.
        view: of the picture, a `View` or a JSON file; None: towards what sends the rays.
        size: of the picture, (width, height), pixels.
        image_size: of reference images, (width, height), pixels; None: what the effect takes.
        cell: side of the cell of viewpoints that they are made for, world units; None: what fits the scene.
        environment_height: rows of environment maps.
        shaded: multiply colours by a fixed light, but for effects that bring their own.
        progress: None, True, False or a function `progress(stage, fraction)`.
        **options: of the effect, by name.

    Returns:
        Array of shape (height, width, 3): linear RGB.

    Raises:
        InputError: for unknown names and options, and scenes without such objects.
    """
    arguments = _arguments(scene, effect, by, roles, view, size, image_size, cell, environment_height, options, shaded)
    with Shown(progress) as callback:
        return _ocelli.draw_effect(*arguments, callback)


def compare(
    scene: Path,
    effect: str = "reflection",
    *,
    by: str | Sequence[str],
    roles: Path = "",
    view: ViewLike = None,
    size: Size = (720, 480),
    image_size: Size | None = None,
    cell: float | None = None,
    environment_height: int = 1024,
    shaded: bool = True,
    runs: int = 1,
    progress: Progress = None,
    **options: object,
) -> Comparison:
    """Draws an effect by several ways, and measures each against the traced picture.

    Args:
        scene: as for `draw()`.
        effect: a name of `kinds()`.
        by: what stands for the scene; several. The traced picture is measured in any case.
        roles: as for `draw()`.
        view: of the picture; None: towards what sends the rays.
        size: of the picture, (width, height), pixels.
        image_size: of reference images, (width, height), pixels; None: what the effect takes.
        cell: side of the cell of viewpoints that they are made for, world units; None: what fits the scene.
        environment_height: rows of environment maps.
        shaded: multiply colours by a fixed light, but for effects that bring their own.
        runs: how often rays are timed; the best counts.
        progress: None, True, False or a function `progress(stage, fraction)`.
        **options: of the effect, by name.

    Returns:
        `Comparison`: `.figures[way]`, `.pictures[way]`, `.maps[way]`.

    Raises:
        InputError: for unknown names and options, and scenes without such objects.
    """
    ways = [by] if isinstance(by, str) else list(by)
    arguments = _arguments(scene, effect, ways, roles, view, size, image_size, cell, environment_height, options, shaded)
    with Shown(progress) as callback:
        return Comparison(*_ocelli.compare_effect(*arguments, runs, callback))


def _arguments(scene, effect, ways, roles, view, size, image_size, cell, environment_height, options, shaded):
    """Those that both functions of the C++ side take, in their order."""
    if not isinstance(scene, (str, os.PathLike)):
        raise InputError(
            f"a {type(scene).__name__} says nothing of its objects' roles", "scene", "give a file name or \"builtin:NAME\""
        )
    width, height = size_of(size)
    texts = {name.replace("_", "-"): str(value) for name, value in options.items()}
    return (
        os.fspath(scene),
        effect,
        ways,
        os.fspath(roles),
        None if view is None else view_of(view),
        width,
        height,
        None if image_size is None else size_of(image_size),
        cell,
        environment_height,
        texts,
        shaded,
    )
