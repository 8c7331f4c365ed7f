"""Reference images: what a camera samples of a scene, and the bounded mesh that is made of it.

    images = ocelli.ocri.build("builtin:statues", "ddoc", size=(720, 480))
    images[0].color          # (height, width, 3), linear RGB
    images[0].points()       # (height, width, 3), world coordinates; NaN where there is no sample
    mesh = ocelli.ocri.mesh(images)

Of a volume (`ocelli.volume()`) a sample is where the opacity of what a ray has passed first reaches `opacity`.
"""

from __future__ import annotations

import os

from ocelli import _ocelli
from ocelli._arguments import camera_of, constructor_of, mesh_of, scene_of, size_of, view_of
from ocelli._ocelli import Mesh, ReferenceImages, Volume
from ocelli._progress import Shown
from ocelli._types import CameraLike, EvaluatedLike, Path, Progress, Size, ViewLike
from ocelli.errors import InputError

__all__ = ["build", "mesh", "read", "write"]


def build(
    scene: EvaluatedLike,
    camera: CameraLike = "ddoc",
    *,
    view: ViewLike = None,
    size: Size = (720, 480),
    construction: str = "auto",
    opacity: float | None = None,
    progress: Progress = None,
    **options: object,
) -> ReferenceImages:
    """Builds the reference images of a scene: one, or those of a union.

    Args:
        scene: a `Scene`, a `Mesh`, a file name or "builtin:NAME"; or a `Volume`, for all cameras but those of constructors.
        camera: a name of `ocelli.camera.representations()` or `constructors()`, a dict with its options, a JSON file, or
            rays of your own (see `ocelli.camera`).
        view: a `View` or a JSON file; None: from (0, 0, 10), just holding the unit sphere.
        size: (width, height) of the reference view, pixels.
        construction: "auto", "raster" or "rays", the one way for volumes.
        opacity: of a volume: at which a ray hits it, from 0.001 to 0.999; None: 0.5.
        progress: None, True, False or a function `progress(stage, fraction)`.
        **options: of the camera, by name: `ocelli.camera.options(name)` lists those of representations.

    Returns:
        `ReferenceImages`: a sequence of `ReferenceImage`, with `.write(path)` (OpenEXR) and `.mesh()`.

    Raises:
        InputError: for unknown names and options, and views that see nothing or lie inside an object.
    """
    width, height = size_of(size)
    chosen = camera_of(camera, options, (width, height))
    if isinstance(scene, Volume):
        return _of_volume(scene, chosen, view_of(view), (width, height), construction, opacity, progress)
    if opacity is not None:
        raise InputError("this scene has triangles: the option is for volumes alone", "opacity", "leave it out")
    with Shown(progress) as callback:
        if constructor_of(chosen):
            return _ocelli.construct_images(scene_of(scene, callback), chosen, view_of(view), width, height, construction)
        mesh = mesh_of(scene, callback)
        return _ocelli.build_images(mesh, chosen, view_of(view), width, height, construction, callback)


def _of_volume(volume, chosen, view, size, construction, opacity, progress) -> ReferenceImages:
    if construction not in ("auto", "rays"):
        raise InputError("reference images of volumes are constructed by rays", "construction", "use auto or rays")
    if constructor_of(chosen):
        raise InputError(
            "graph and curved ray cameras build no reference images of volumes",
            "camera",
            "draw the volume along their rays with ocelli.render(), or take the surface at a value: ocelli.isosurface()",
        )
    with Shown(progress) as callback:
        return _ocelli.build_volume_images(volume, chosen, view, *size, opacity, callback)


def mesh(images: ReferenceImages) -> Mesh:
    """The bounded mesh of reference images: a `Mesh` in world coordinates."""
    return images.mesh()


def read(path: Path) -> ReferenceImages:
    """`ReferenceImages` of a file that `images.write()` or `ocelli ocri build` wrote.

    Raises:
        InputError: for a file that is missing, broken, or holds something else.
    """
    return _ocelli.read_reference_images(os.fspath(path))


def write(path: Path, images: ReferenceImages) -> None:
    """Writes reference images to an OpenEXR file."""
    images.write(os.fspath(path))
