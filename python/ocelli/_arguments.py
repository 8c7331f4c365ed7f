"""What many functions take: scenes, sizes, and the options of cameras."""

import json
import os

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

        return load(scene, progress=progress)
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


def camera_options(camera, options):
    """The JSON of a camera: of a name with keywords, a dict, or a file."""
    if isinstance(camera, dict):
        fields = {**camera, **options}
    elif isinstance(camera, os.PathLike) or camera.endswith(".json"):
        with open(camera, encoding="utf-8") as file:
            return file.read() if not options else json.dumps({**json.load(file), **options})
    else:
        fields = {"camera": camera, **options}
    try:
        return json.dumps(fields)
    except TypeError as error:
        raise InputError(str(error), f"options of {fields.get('camera')}", "give numbers, texts, lists and dicts") from None


def is_constructor(options):
    """Whether JSON options name a graph or curved ray camera's constructor."""
    try:
        fields = json.loads(options)
    except ValueError:
        return False  # the reader of options says what is wrong
    return isinstance(fields, dict) and fields.get("camera") in dict(_ocelli.constructors())
