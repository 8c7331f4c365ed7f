from __future__ import annotations

from numpy.typing import ArrayLike

from ocelli import _ocelli
from ocelli._arguments import camera_of, constructor_of, mesh_of, scene_of, size_of, view_of
from ocelli._ocelli import ReferenceImage, ReferenceImages, ResampledView
from ocelli._progress import Shown
from ocelli._types import Bytes, CameraLike, Progress, SceneLike, Size, ViewLike
from ocelli.errors import InputError


def render(
    scene: SceneLike,
    camera: CameraLike = "di",
    *,
    view: ViewLike = None,
    size: Size = (720, 480),
    method: str = "raster",
    progress: Progress = None,
    **options: object,
) -> ReferenceImage:
    """Draws a scene with any camera.

    Args:
        scene: a `Scene`, a `Mesh`, a file name or "builtin:NAME".
        camera: a name ("di" is the pinhole), a dict with options, a file, or your own; see `ocelli.camera`.
        view: a `View` or a JSON file; None: from (0, 0, 10), just holding the unit sphere.
        size: (width, height), pixels.
        method: "raster", or "raycast", the slow reference for it; "points" and "hybrid" for cameras that displace a pinhole.
        progress: None, True, False or a function `progress(stage, fraction)`.
        **options: of the camera, by name.

    Returns:
        `ReferenceImage`: `.color` (height, width, 3), linear RGB; `.t`, along the rays; `.held`, 1 where something is seen.

    Raises:
        InputError: for unknown names and options, and views that see nothing.
    """
    width, height = size_of(size)
    chosen = camera_of(camera, options, (width, height))
    with Shown(progress) as callback:
        if constructor_of(chosen):
            if method not in ("raster", "raycast"):
                raise InputError(f"graph and curved ray cameras are not drawn by {method}", "method", "use raster or raycast")
            construction = "rays" if method == "raycast" else "raster"
            images = _ocelli.construct_images(scene_of(scene, callback), chosen, view_of(view), width, height, construction)
        else:
            mesh = mesh_of(scene, callback)
            images = _ocelli.draw_images(mesh, chosen, view_of(view), width, height, method, callback)
    if len(images) > 1:
        raise InputError(f"{images[0].camera} is a union of {len(images)} images", "camera", "build it with ocelli.ocri.build()")
    return images[0]


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
