"""What arguments may be, for type checkers and editors."""

import os
from collections.abc import Callable, Mapping
from typing import Any, Protocol, Union

import numpy
from numpy.typing import ArrayLike, NDArray

from ocelli import _ocelli

Path = Union[str, "os.PathLike[str]"]
SceneLike = Union[_ocelli.Scene, _ocelli.Mesh, Path]
ViewLike = Union[_ocelli.View, Path, None]
EvaluatedLike = Union[SceneLike, _ocelli.Volume]
VolumeSource = Union[_ocelli.Volume, ArrayLike, Path]
Size = tuple[int, int]
Progress = Union[bool, Callable[[str, float], object], None]
Floats = NDArray[numpy.float32]
Bytes = NDArray[numpy.uint8]


class OwnCamera(Protocol):
    """A camera of your own: see `ocelli.camera`."""

    def rays(self, width: int, height: int) -> tuple[ArrayLike, ArrayLike] | _ocelli.Rays: ...


CameraLike = Union[str, Mapping[str, Any], "os.PathLike[str]", _ocelli.Rays, OwnCamera]
