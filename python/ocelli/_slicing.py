from __future__ import annotations

import os

from ocelli import _ocelli
from ocelli._arguments import mesh_of, size_of
from ocelli._ocelli import DisplayVolume
from ocelli._progress import Shown
from ocelli._types import Floats, Path, Progress, SceneLike, Size


def profiles() -> list[str]:
    """Names of the displays that are known by name."""
    return list(_ocelli.profiles())


def slice(  # noqa: A001 - as the command is called
    scene: SceneLike, profile: Path = "perspecta", *, exact: bool = False, progress: Progress = None
) -> DisplayVolume:
    """Slices a scene for a swept-screen display.

    Args:
        scene: a `Scene`, a `Mesh`, a file name or "builtin:NAME", in the display's unit sphere.
        profile: a name of `profiles()` or a JSON file.
        exact: light every voxel that the surface touches: slow.
        progress: None, True, False or a function, for the loading of a scene.

    Returns:
        `DisplayVolume`: `.levels(i)` is slice i, shape (height, width, 3), bytes; `.write(path)` makes an .svol file.
    """
    with Shown(progress) as callback:
        return _ocelli.slice(mesh_of(scene, callback), os.fspath(profile), exact)


def observe(
    volume: DisplayVolume,
    *,
    eye: tuple[float, float, float] | None = None,
    size: Size = (768, 768),
    fov_vertical_degrees: float = 0,
    exposure_seconds: float = 0,
    gain: float = 0,
) -> Floats:
    """What an eye sees of a volume on its display.

    Args:
        volume: a `DisplayVolume`.
        eye: (x, y, z), display radii; None: the display's viewing distance, in front.
        size: (width, height), pixels.
        fov_vertical_degrees: 0: just holds the display.
        exposure_seconds: 0: one refresh.
        gain: of the light; 0: so that the brightest parts are just below white.

    Returns:
        Array of shape (height, width, 3): linear RGB.
    """
    width, height = size_of(size)
    return _ocelli.observe(volume, eye, width, height, fov_vertical_degrees, exposure_seconds, gain)
