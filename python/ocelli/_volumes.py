from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from typing import Any

import numpy

from ocelli import _ocelli
from ocelli._arguments import mesh_of
from ocelli._ocelli import Mesh, Volume, VolumeSeries
from ocelli._progress import Shown
from ocelli._types import Progress, SceneLike, VolumeSource
from ocelli.errors import InputError

_AS_VOXELS = {"bool": numpy.uint8, "float16": numpy.float32}


def volume(
    source: VolumeSource,
    *,
    spacing: Sequence[float] | None = None,
    origin: Sequence[float] | None = None,
    orientation: Sequence[Sequence[float]] | None = None,
    unit: str = "",
    anatomical: bool = False,
    scale: float = 1,
    offset: float = 0,
    modality: str = "",
    value_unit: str = "",
    transfer: str | os.PathLike[str] | Mapping[str, Any] | None = None,
    shaded: bool | None = None,
    clips: Sequence[Sequence[float]] = (),
    fit: bool = True,
    series: str = "",
    seconds: float | None = None,
    surfaces: SceneLike | None = None,
    surfaces_frame: str = "volume",
    progress: Progress = None,
) -> Volume:
    """A volume of scalars: of a file, of an array, made, or another look at one that is there.

    An array is not copied where it is dense, of a type that voxels can have (integers of 8, 16 and 32 bits, float32,
    float64) and in the byte order of the machine: `volume(array).array` is the same memory. What you write to it later is
    seen by what is drawn later; do not write while something is drawn. Files are mapped: what is not looked at is not read.

    Args:
        source: a file or a folder of DICOM files; "builtin:volume,name=NAME"; an array `[k, j, i]`, of which i lies densest
            (give `array.T` of one that is indexed `[i, j, k]`); or a `Volume`, whose voxels are taken.
        spacing: of an array: the edges of a voxel along i, j and k; None: 1, 1, 1.
        origin: of an array: where the middle of voxel (0, 0, 0) is, (x, y, z); None: 0, 0, 0.
        orientation: of an array: (3, 3), whose columns are where i, j and k run to, of length 1; None: along x, y and z.
        unit: of an array: that of `spacing` and `origin`, such as "mm".
        anatomical: of an array: whether the world is a patient, x to the left, y to the back, z to the head (LPS).
        scale: of an array: what a voxel means is this times what it holds,
        offset: plus this.
        modality: of an array: how it was taken: "CT", "MR"; the preset of colours is chosen by it.
        value_unit: of an array: that of its values, such as "HU".
        transfer: the transfer function: a name of `transfer_presets()`, a JSON file, or what such a file holds as a dict;
            None: what fits the volume.
        shaded: lit by the gradient of the field; None: as the transfer function says. Of surfaces: None is True.
        clips: half spaces of the scene that are shown, each (x, y, z, distance): where the normal (x, y, z) times the point
            is `distance` or more.
        fit: its box into the unit sphere.
        series: of a folder of DICOM files with several: its UID or its number.
        seconds: of a time series: its moment; None: the first one.
        surfaces: a scene of triangles that stands in the volume, opaque.
        surfaces_frame: "volume": it has the coordinates of the volume's file; "scene": those of the scene, as meshes of
            `isosurface()`.
        progress: None, True, False or a function `progress(stage, fraction)`.

    Returns:
        `Volume`: `.array`, `.spacing`, `.unit`, ...; for `ocelli.render()`, `ocelli.ocri.build()`, `ocelli.slice()`,
        `ocelli.evaluate()`, `ocelli.isosurface()` and `ocelli.volume_info()`.

    Raises:
        InputError: for files, arrays and transfer functions that are wrong.
    """
    of_array = {
        "spacing": spacing is not None,
        "origin": origin is not None,
        "orientation": orientation is not None,
        "unit": bool(unit),
        "anatomical": anatomical,
        "scale": scale != 1,
        "offset": offset != 0,
        "modality": bool(modality),
        "value_unit": bool(value_unit),
    }
    is_array = not isinstance(source, (str, os.PathLike, Volume))
    given = [name for name, is_given in of_array.items() if is_given]
    if given and not is_array:
        raise InputError("only an array takes this: files and volumes say it themselves", given[0], "leave it out")
    if series and not isinstance(source, (str, os.PathLike)):
        raise InputError("only a folder of DICOM files has series", "series", "leave it out")
    with Shown(progress) as callback:
        if is_array:
            rows = _world_from_index(spacing, origin, orientation)
            voxels = _series_of_array(source, rows, unit, anatomical, scale, offset, modality, value_unit)
        elif isinstance(source, Volume):
            voxels = source.series
        else:
            voxels = _ocelli.load_volume_series(os.fspath(source), series, callback)
        name, text = _transfer_of(transfer)
        made = _ocelli.volume_at(voxels, seconds, fit, name, text, shaded, [tuple(map(float, each)) for each in clips], callback)
        if surfaces is None:
            return made
        return _ocelli.volume_with_surfaces(made, _surfaces_of(surfaces, callback), surfaces_frame, shaded is not False)


def volume_info(volume: Volume, *, progress: Progress = None) -> dict[str, Any]:
    """What a volume is, in figures: those of `ocelli scene info --json`, with the range and the percentiles of its values.

    Args:
        volume: a `Volume`, of which all voxels are read.
        progress: None, True, False or a function `progress(stage, fraction)`.

    Returns:
        A dict: docs/volumes.md says what its fields mean.
    """
    with Shown(progress) as callback:
        return json.loads(_ocelli.volume_info(volume, callback))


def isosurface(
    volume: Volume, value: float, *, shaded: bool = True, max_triangles: int | None = None, progress: Progress = None
) -> Mesh:
    """The surface where a volume has one value.

    Args:
        volume: a `Volume`; its clips do not count.
        value: what voxels mean there.
        shaded: lit by a fixed light, with the gradient of the field as the normal.
        max_triangles: more are an error; None: as many as a scene may have.
        progress: None, True, False or a function `progress(stage, fraction)`.

    Returns:
        `Mesh`, closed, in the coordinates of the scene: it lies in the volume. Its colour is that of the transfer function.

    Raises:
        InputError: where no voxel is above the value, or all are, and where the package was built without OpenVDB.
    """
    with Shown(progress) as callback:
        return _ocelli.isosurface(volume, value, shaded, max_triangles, callback)


def transfer_presets() -> dict[str, dict[str, Any]]:
    """Transfer functions by name: {name: what its JSON file would hold, and "summary"}.

    A dict like one of these, with or without the summary, is what `ocelli.volume(transfer=...)` takes.
    """
    return {name: {"summary": summary, **json.loads(text)} for name, summary, text in _ocelli.transfer_presets()}


def _series_of_array(array, rows, *facts) -> VolumeSeries:
    """Of what becomes an array; only what voxels cannot be is converted, and only what is not dense is copied."""
    voxels = numpy.asarray(array)
    if voxels.dtype.kind not in "buif":
        raise InputError(f"voxels cannot be of the type {voxels.dtype}", "array", "give an array of numbers")
    kind = numpy.dtype(_AS_VOXELS.get(voxels.dtype.name, voxels.dtype)).newbyteorder("=")
    return _ocelli.volume_series_of_array(numpy.require(voxels, kind, ["C", "A"]), rows, *facts)


def _world_from_index(spacing, origin, orientation):
    """Rows of the affine matrix, (3, 4)."""
    parts = {
        "spacing": ((3,), spacing, numpy.ones(3)),
        "origin": ((3,), origin, numpy.zeros(3)),
        "orientation": ((3, 3), orientation, numpy.eye(3)),
    }
    found = {}
    for name, (shape, given, default) in parts.items():
        try:
            found[name] = default if given is None else numpy.asarray(given, dtype=float)
        except (TypeError, ValueError) as error:
            raise InputError(f"no numbers: {error}", name, f"give numbers of shape {shape}") from None
        if found[name].shape != shape:
            raise InputError(f"the shape {found[name].shape} is not {shape}", name, f"give numbers of shape {shape}")
    return numpy.column_stack([found["orientation"] * found["spacing"], found["origin"]]).tolist()


def _transfer_of(transfer) -> tuple[str, str]:
    """(name or file, JSON): one of them is empty."""
    if transfer is None:
        return "", ""
    if isinstance(transfer, (str, os.PathLike)):
        return os.fspath(transfer), ""
    try:
        return "", json.dumps({name: value for name, value in transfer.items() if name != "summary"})
    except (AttributeError, TypeError) as error:
        raise InputError(f"no transfer function: {error}", "transfer", "give a preset's name, a JSON file, or a dict") from None


def _surfaces_of(surfaces, callback) -> Mesh:
    """The mesh, in its own coordinates and without light: both come with the volume."""
    if isinstance(surfaces, (str, os.PathLike)):
        from ocelli.scene import load

        return load(surfaces, fit=False, shaded=False, progress=callback).mesh
    return mesh_of(surfaces, callback)
