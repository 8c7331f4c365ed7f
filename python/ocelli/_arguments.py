"""What many functions take: scenes, sizes, and cameras."""

import json
import os

import numpy

from ocelli import _ocelli
from ocelli.errors import InputError


def scene_of(scene, progress=None):
    """A `Scene` from what users give for one."""
    if isinstance(scene, _ocelli.Scene):
        return scene
    if isinstance(scene, _ocelli.Mesh):
        return _ocelli.Scene(scene)
    if isinstance(scene, (str, os.PathLike)):
        from ocelli.scene import load

        if _ocelli.is_volume_source(os.fspath(scene)):
            raise InputError(
                "this is a volume, not a scene of triangles",
                os.fspath(scene),
                "give ocelli.volume(...) of it, or ocelli.scene.load(..., iso=VALUE) for a surface",
            )
        return load(scene, progress=progress)
    if isinstance(scene, _ocelli.Volume):
        raise InputError("a volume has no triangles", "scene", "give the surface at a value: ocelli.isosurface(volume, value)")
    raise InputError(f"a {type(scene).__name__} is no scene", "scene", "give a Scene, a Mesh, a file name or \"builtin:NAME\"")


def mesh_of(scene, progress=None):
    """The `Mesh` of it: of a mesh itself, nothing is copied."""
    return scene if isinstance(scene, _ocelli.Mesh) else scene_of(scene, progress).mesh


def size_of(size):
    try:
        width, height = size
        return int(width), int(height)
    except (TypeError, ValueError):
        raise InputError(f"{size!r} is no size", "size", "give (width, height), pixels") from None


def view_of(view):
    if view is None:
        return _ocelli.View()
    if isinstance(view, (str, os.PathLike)):
        return _ocelli.View.read(view)
    return view


def camera_of(camera, options, size):
    """What the C++ side takes for a camera: the JSON of its options, or `Rays`.

    Args:
        camera: a name with keywords, a dict, a file, `Rays`, or an object with a method `rays(width, height)`.
        options: the keywords.
        size: (width, height) of the image, which such an object is asked for.
    """
    rays = _rays_of(camera, size)
    if rays is None:
        return _camera_options(camera, options)
    if options:
        raise InputError(f"rays have no options: {', '.join(options)}", "camera", "leave them out")
    return rays


def _rays_of(camera, size):
    """The `Rays` of a camera that consists of them; None for all others."""
    if isinstance(camera, _ocelli.Rays):
        return camera
    if isinstance(camera, (str, os.PathLike)):
        return _ocelli.Rays.read(camera) if os.fspath(camera).endswith(".exr") else None
    if isinstance(camera, type):
        raise InputError(f"{camera.__name__} is a class", "camera", f"give an object of it: {camera.__name__}(...)")
    return _asked_rays(camera, size) if callable(getattr(camera, "rays", None)) else None


def _asked_rays(camera, size):
    """Of an object with a method `rays(width, height)`, which gives (origins, directions) or `Rays`."""
    where = f"{type(camera).__name__}.rays()"
    width, height = size
    answer = camera.rays(width, height)
    if isinstance(answer, _ocelli.Rays):
        return answer
    shape = (height, width, 3)
    try:
        origins, directions = (numpy.broadcast_to(numpy.asarray(each, numpy.float32), shape) for each in answer)
    except (TypeError, ValueError) as error:
        raise InputError(
            f"no arrays of origins and directions: {error}", where, f"return (origins, directions), each of shape {shape} or (3,)"
        ) from None
    notes = {key: getattr(camera, key) for key in ("near", "far", "frame", "wraps_around", "view") if hasattr(camera, key)}
    return _ocelli.Rays(origins, directions, name=getattr(camera, "name", type(camera).__name__), **notes)


def _camera_options(camera, options):
    """The JSON of a camera: of a name with keywords, a dict, or a file."""
    if isinstance(camera, dict):
        fields = {**camera, **options}
    elif not isinstance(camera, (str, os.PathLike)):
        raise InputError(
            f"a {type(camera).__name__} is no camera",
            "camera",
            "give a name, a dict, a file, Rays, or an object with a method rays(width, height)",
        )
    elif os.fspath(camera).endswith(".json"):
        with open(camera, encoding="utf-8") as file:
            return file.read() if not options else json.dumps({**json.load(file), **options})
    else:
        fields = {"camera": camera, **options}
    try:
        return json.dumps(fields)
    except TypeError as error:
        raise InputError(str(error), f"options of {fields.get('camera')}", "give numbers, texts, lists and dicts") from None


def constructor_of(camera):
    """The name of a graph or curved ray camera's constructor, of what `camera_of()` gave; None for other cameras."""
    if not isinstance(camera, str):
        return None
    try:
        fields = json.loads(camera)
    except ValueError:
        return None  # the reader of options says what is wrong
    name = fields.get("camera") if isinstance(fields, dict) else None
    return name if name in dict(_ocelli.constructors()) else None
