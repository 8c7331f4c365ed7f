from __future__ import annotations

from typing import overload

from numpy.typing import ArrayLike

from ocelli import _ocelli
from ocelli._arguments import camera_of, constructor_of, mesh_of, scene_of, size_of, view_of
from ocelli._ocelli import ReferenceImage, ReferenceImages, ResampledView, Volume, VolumeImage
from ocelli._progress import Shown
from ocelli._types import Bytes, CameraLike, Progress, SceneLike, Size, ViewLike
from ocelli.errors import InputError


@overload
def render(
    scene: SceneLike,
    camera: CameraLike = "di",
    *,
    view: ViewLike = None,
    size: Size = (720, 480),
    method: str | None = None,
    progress: Progress = None,
    **options: object,
) -> ReferenceImage: ...
@overload
def render(
    scene: Volume,
    camera: CameraLike = "di",
    *,
    view: ViewLike = None,
    size: Size = (720, 480),
    method: str | None = None,
    step: float | None = None,
    opacity: float | None = None,
    progress: Progress = None,
    **options: object,
) -> VolumeImage: ...
def render(
    scene: SceneLike | Volume,
    camera: CameraLike = "di",
    *,
    view: ViewLike = None,
    size: Size = (720, 480),
    method: str | None = None,
    step: float | None = None,
    opacity: float | None = None,
    progress: Progress = None,
    **options: object,
) -> ReferenceImage | VolumeImage:
    """Draws a scene or a volume with any camera.

    Args:
        scene: a `Scene`, a `Mesh`, a file name or "builtin:NAME"; or a `Volume`.
        camera: a name ("di" is the pinhole), a dict with options, a file, or your own; see `ocelli.camera`.
        view: a `View` or a JSON file; None: from (0, 0, 10), just holding the unit sphere.
        size: (width, height), pixels.
        method: of a scene: "raster" (None), or "raycast", the slow reference for it; "points" and "hybrid" for cameras that
            displace a pinhole. Volumes are always drawn along rays.
        step: of a volume: the distance of samples along rays, in voxels; None: 0.25.
        opacity: of a volume: `.t` is where the opacity of what a ray has passed reaches this; None: 0.5.
        progress: None, True, False or a function `progress(stage, fraction)`.
        **options: of the camera, by name.

    Returns:
        `ReferenceImage`: `.color` (height, width, 3), linear RGB; `.t`, along the rays; `.held`, 1 where something is seen.
        Of a volume, `VolumeImage`: `.color` (height, width, 4), linear RGB times opacity, and opacity; `.before(background)`.

    Raises:
        InputError: for unknown names and options, and views that see nothing.
    """
    width, height = size_of(size)
    if isinstance(scene, Volume):
        return _render_volume(scene, camera, options, view_of(view), (width, height), method, step, opacity, progress)
    given = [name for name, value in (("step", step), ("opacity", opacity)) if value is not None]
    if given:
        raise InputError("this scene has triangles: the option is for volumes alone", given[0], "leave it out")
    drawn_by = "raster" if method is None else method
    chosen = camera_of(camera, options, (width, height))
    with Shown(progress) as callback:
        if constructor_of(chosen):
            if drawn_by not in ("raster", "raycast"):
                raise InputError(f"graph and curved ray cameras are not drawn by {drawn_by}", "method", "use raster or raycast")
            construction = "rays" if drawn_by == "raycast" else "raster"
            images = _ocelli.construct_images(scene_of(scene, callback), chosen, view_of(view), width, height, construction)
        else:
            mesh = mesh_of(scene, callback)
            images = _ocelli.draw_images(mesh, chosen, view_of(view), width, height, drawn_by, callback)
    if len(images) > 1:
        raise InputError(f"{images[0].camera} is a union of {len(images)} images", "camera", "build it with ocelli.ocri.build()")
    return images[0]


def _render_volume(volume, camera, options, view, size, method, step, opacity, progress) -> VolumeImage:
    if method not in (None, "raycast"):
        raise InputError(f"a volume is not drawn by {method}", "method", "use raycast, the default")
    chosen = camera_of(camera, options, size)
    with Shown(progress) as callback:
        return _ocelli.draw_volume(volume, chosen, constructor_of(chosen) or "", view, *size, step, opacity, callback)


def resample(images: ReferenceImages, view: ViewLike, *, size: Size = (720, 480)) -> ResampledView:
    """What a pinhole would see, of what reference images hold.

    Args:
        images: `ReferenceImages`.
        view: a `View` or a JSON file.
        size: (width, height), pixels.

    Returns:
        `ResampledView`: `.color` (height, width, 3), linear RGB; `.hole` (height, width), 1 where nothing is known.
    """
    width, height = size_of(size)
    return _ocelli.resample(images, view_of(view), width, height)


def srgb(linear: ArrayLike) -> Bytes:
    """Linear RGB, shape (height, width, 3), as bytes of sRGB: what PNG files and matplotlib take."""
    return _ocelli.srgb_from_linear(linear)
