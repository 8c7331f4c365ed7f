"""Ocelli: cameras that are not pinholes.

    import ocelli
    statues = ocelli.scene.load("builtin:statues")
    images = ocelli.ocri.build(statues, "ddoc")          # an occlusion camera's reference image
    images.write("statues.exr")
    mesh = ocelli.ocri.mesh(images)                      # its bounded mesh
    rows = ocelli.evaluate(statues, ["di", "ddoc"])      # figures: pandas.DataFrame(rows)
    skull = ocelli.volume("builtin:volume,name=skull")   # or a file, or an array
    ocelli.render(skull).before((1, 1, 1))               # along the rays of any camera
    ocelli.sea.read("museum.sea")[1200]                  # one of thousands of views of a place

Conventions: right-handed, y up; arrays of images have their first row at the top; colours are linear RGB (`ocelli.srgb()`
turns them into bytes that a PNG takes); angles in degrees. A scene is fitted into the unit sphere unless `fit=False`.
Arrays of C++ objects are read-only views of their memory: copy what you want to change.

Whatever takes a scene takes a `Scene`, a `Mesh`, a file name, or "builtin:NAME[,key=value...]". Errors are
`ocelli.InputError` and `ocelli.WorkError`: what, where, next. Long work shows its progress on a terminal or in a notebook,
unless `progress=False`; give a function `progress(stage, fraction)` to show it yourself. Ctrl-C ends it.
"""

from ocelli import camera, devices, effects, ocri, scene, sea, study
from ocelli._analysing import Analysis, analyse, column_maps
from ocelli._drawing import render, resample, srgb
from ocelli._evaluating import evaluate
from ocelli._ocelli import (
    DisplayVolume,
    Mesh,
    Rays,
    ReferenceImage,
    ReferenceImages,
    ResampledView,
    Scene,
    Sea,
    View,
    Volume,
    VolumeImage,
    __version__,
)
from ocelli._slicing import dithers, observe, profiles, slice  # noqa: A004 - as the command is called
from ocelli._table import Table
from ocelli._volumes import isosurface, transfer_presets, volume, volume_info
from ocelli.errors import Error, InputError, WorkError

__all__ = [
    "Analysis",
    "DisplayVolume",
    "Error",
    "InputError",
    "Mesh",
    "Rays",
    "ReferenceImage",
    "ReferenceImages",
    "ResampledView",
    "Scene",
    "Sea",
    "Table",
    "View",
    "Volume",
    "VolumeImage",
    "WorkError",
    "__version__",
    "analyse",
    "camera",
    "column_maps",
    "devices",
    "dithers",
    "effects",
    "evaluate",
    "isosurface",
    "observe",
    "ocri",
    "profiles",
    "render",
    "resample",
    "scene",
    "sea",
    "slice",
    "srgb",
    "study",
    "transfer_presets",
    "volume",
    "volume_info",
]
