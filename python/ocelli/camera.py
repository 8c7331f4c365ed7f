"""Cameras: by name, and your own.

By name there are two kinds: representations displace the image of a pinhole, or look around by themselves
(`representations()`: "di", "ddoc", "eoc-h", "panorama", ...); constructors make graph and curved ray cameras for a scene
that one walks through (`constructors()`: "portal", "maze", ...). Options are keywords wherever a camera is named, or fields of a dict:

    ocelli.render("builtin:maze", "comprehensive", size=(1920, 1200))
    ocelli.ocri.build("builtin:statues", "cell", cell_side_radii=1.2)
    ocelli.ocri.build("builtin:statues", {"camera": "cell", "cell_side_radii": 1.2})

Your own camera says the ray of each pixel. It is an object with a method that is asked for as many rays as the image has
pixels, or a `Rays` with the arrays themselves:

    class Orthographic:
        def rays(self, width, height):
            x, y = numpy.meshgrid(numpy.linspace(-1.5, 1.5, width), numpy.linspace(1, -1, height))
            return numpy.stack([x, y, numpy.full_like(x, 10)], axis=-1), (0, 0, -1)

    ocelli.render("builtin:statues", Orthographic())
    ocelli.evaluate("builtin:statues", [Orthographic(), "ddoc"])

Both arrays have the shape (height, width, 3), or (3,) where all pixels have the same; the first row is the top one; a
direction of 0 or NaN is no ray. Beside the method, the object may have `name`, `near` and `far` (distances from the
origins), `frame` ("world", or "view": right, up and backward from the eye of the image's view) and `wraps_around`.
`rays()` gives those of the toolkit's own cameras.
"""

from __future__ import annotations

from typing import Any

from ocelli import _ocelli
from ocelli._arguments import camera_of, constructor_of, mesh_of, scene_of, size_of, view_of
from ocelli._ocelli import Rays
from ocelli._progress import Shown
from ocelli._types import CameraLike, Progress, SceneLike, Size, ViewLike

__all__ = ["Rays", "constructors", "options", "rays", "representations"]


def representations() -> dict[str, str]:
    """Cameras whose reference images stand for a scene: {name: what it is}."""
    return dict(_ocelli.representations())


def options(name: str) -> list[dict[str, Any]]:
    """What a representation may be told, by keywords: a list of dicts with name, meaning, unit, default, min and max.

    Raises:
        InputError: for an unknown name.
    """
    return _ocelli.camera_options(name)


def constructors() -> dict[str, str]:
    """Constructors of graph and curved ray cameras: {name: what it is}."""
    return dict(_ocelli.constructors())


def rays(
    camera: CameraLike,
    *,
    scene: SceneLike | None = None,
    view: ViewLike = None,
    size: Size = (720, 480),
    image: int = 0,
    progress: Progress = None,
    **options: object,
) -> Rays:
    """The ray of each pixel of any camera, as ray casting follows it.

    Args:
        camera: as for `ocelli.render()`.
        scene: what it looks at: "di", "gpc", "panorama" and "cylinder" need none, all others do.
        view: a `View` or a JSON file; None: from (0, 0, 10).
        size: (width, height), pixels.
        image: of a camera with several images, such as a union: which one, from 1 on.
        progress: None, True, False or a function `progress(stage, fraction)`.
        **options: of the camera, by name.

    Returns:
        `Rays`: `.origins` and `.directions`, shape (height, width, 3); `.ray(x, y)`, where it bends; `.write(path)`.

    Raises:
        InputError: for what has no rays, for a scene that is missing, and for an image that is not there.
    """
    width, height = size_of(size)
    chosen = camera_of(camera, options, (width, height))
    with Shown(progress) as callback:
        if name := constructor_of(chosen):
            return _ocelli.rays_of_constructed(scene_of(scene, callback), chosen, name, view_of(view), width, height, callback)
        mesh = None if scene is None else mesh_of(scene, callback)
        return _ocelli.rays_of(chosen, mesh, view_of(view), width, height, image, callback)
