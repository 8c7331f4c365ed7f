from __future__ import annotations

import os
from collections.abc import Sequence

from ocelli import _ocelli
from ocelli._arguments import mesh_of, size_of
from ocelli._ocelli import DisplayVolume, Volume
from ocelli._progress import Shown
from ocelli._types import Floats, Path, Progress, SceneLike, Size
from ocelli.errors import InputError


def profiles() -> list[str]:
    """Names of the displays that are known by name."""
    return list(_ocelli.profiles())


def dithers() -> list[str]:
    """Names of the ways in which colours become the levels of a display."""
    return list(_ocelli.dithers())


def slice(  # noqa: A001 - as the command is called
    scene: SceneLike | Volume,
    profile: Path = "perspecta",
    *,
    exact: bool = False,
    dither: str = "ordered",
    undithered: bool = False,
    antialias: bool = False,
    even_light: float = 0,
    iso: float | None = None,
    mask: Volume | tuple[float, float] | None = None,
    light_gain: float = 1,
    gradient_light: float = 0,
    cutaway: float | None = None,
    seen_opacity: float | None = None,
    viewers: Sequence[tuple[float, float, float]] = (),
    progress: Progress = None,
) -> DisplayVolume:
    """Slices a scene or a volume for a swept-screen display.

    Args:
        scene: a `Scene`, a `Mesh`, a file name or "builtin:NAME", in the display's unit sphere; or a `Volume`.
        profile: a name of `profiles()` or a JSON file.
        exact: of a scene: light every voxel that the surface touches: slow.
        dither: how colours become the levels of the display, a name of `dithers()`.
        undithered: light a channel wherever it has any light at all.
        antialias: of a scene: light both slices between which a surface lies, in proportion to how near it is.
        even_light: of a scene: surfaces within this radius of the axis, 0 to 1, get the same light for their area.
        iso: of a volume: show the surface at this value alone.
        mask: of a volume: show values from (least, greatest) alone, or what a second `Volume` in the same coordinates marks
            by values of 0.5 or more.
        light_gain: of a volume: multiply its extinction by this: more light of what is thin.
        gradient_light: of a volume: full light where its values change by this share of their range over a voxel; 0:
            light everywhere.
        cutaway: of a volume: leave out what lies farther than this from the centre towards a viewer, display radii.
        seen_opacity: of a volume: leave out what a viewer would not see behind this opacity of what lies before it.
        viewers: the eyes for `cutaway` and `seen_opacity`, display radii; empty: (0, 0, 10).
        progress: None, True, False or a function `progress(stage, fraction)`.

    Returns:
        `DisplayVolume`: `.levels(i)` is slice i, shape (height, width, 3), bytes; `.write(path)` makes an .svol file.

    Raises:
        InputError: for unknown names, values out of range, and options of volumes with a scene or the other way round.
    """
    of_scene = {"exact": exact, "antialias": antialias, "even_light": even_light != 0}
    of_volume = {
        "iso": iso is not None,
        "mask": mask is not None,
        "light_gain": light_gain != 1,
        "gradient_light": gradient_light != 0,
        "cutaway": cutaway is not None,
        "seen_opacity": seen_opacity is not None,
        "viewers": len(viewers) > 0,
    }
    is_volume = isinstance(scene, Volume)
    for name, given in (of_scene if is_volume else of_volume).items():
        if given:
            kind = "volume, whose voxels are averages in any case" if is_volume else "scene of triangles"
            raise InputError(f"this is a {kind}", name, "leave it out")
    if isinstance(scene, Volume):
        if viewers and cutaway is None and seen_opacity is None:
            raise InputError("a viewer changes nothing by itself", "viewers", "add seen_opacity=0.5 or cutaway=0")
        marking = mask if isinstance(mask, Volume) else None
        values = None if mask is None or marking is not None else tuple(mask)
        if iso is not None and values is not None:
            raise InputError("a surface has one value alone", "mask", "leave it out, or give a volume as the mask")
        with Shown(progress) as callback:
            return _ocelli.slice_volume(
                scene, os.fspath(profile), dither, undithered, iso, values, marking, light_gain, gradient_light, cutaway,
                seen_opacity, list(viewers), callback,
            )  # fmt: skip
    with Shown(progress) as callback:
        mesh = mesh_of(scene, callback)
        return _ocelli.slice(mesh, os.fspath(profile), exact, dither, undithered, antialias, even_light)


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
