"""Cameras by name.

Two kinds: representations displace the image of a pinhole, or look around by themselves (`representations()`: "di", "ddoc",
"eoc-h", "panorama", ...); constructors make graph and curved ray cameras for a scene that one walks through
(`constructors()`: "portal", "maze", ...). Options are keywords wherever a camera is named, or fields of a dict:

    ocelli.render("builtin:maze", "comprehensive", size=(1920, 1200))
    ocelli.ocri.build("builtin:statues", "cell", cell_side_radii=1.2)
    ocelli.ocri.build("builtin:statues", {"camera": "cell", "cell_side_radii": 1.2})
"""

from ocelli import _ocelli


def representations():
    """Cameras whose reference images stand for a scene: {name: what it is}."""
    return dict(_ocelli.representations())


def options(name):
    """What a representation may be told, by keywords: a list of dicts with name, meaning, unit, default, min and max.

    Raises:
        InputError: for an unknown name.
    """
    return _ocelli.camera_options(name)


def constructors():
    """Constructors of graph and curved ray cameras: {name: what it is}."""
    return dict(_ocelli.constructors())
