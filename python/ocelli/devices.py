"""Displays that volumes are shown on: hardware, simulated ones, and files.

    ocelli.devices.kinds()                                            # {"null": ..., "sim": ..., "file:PATH.svol": ...}
    volume = ocelli.slice("builtin:teapot", "perspecta-99")
    report = ocelli.devices.show(volume, "file:seen.svol", seconds=2)
    report["frames_shown"]
"""

from __future__ import annotations

import json
import os
from typing import Any

from ocelli import _ocelli
from ocelli._ocelli import DisplayVolume
from ocelli._progress import Shown
from ocelli._types import Path, Progress
from ocelli.errors import InputError

__all__ = ["kinds", "show"]


def kinds() -> dict[str, str]:
    """The devices that there are, as `show()` takes them: {"file:PATH.svol": what it is}."""
    return {usage: meaning for _, usage, meaning in _ocelli.device_kinds()}


def show(
    volume: DisplayVolume | Path,
    device: str,
    *,
    seconds: float | None = 5,
    loop: bool = False,
    tear: bool = False,
    coarse: bool = False,
    progress: Progress = None,
) -> dict[str, Any]:
    """Shows a volume, or a recording, on a display, in time with it.

    Ctrl-C ends it: the device is closed, and `KeyboardInterrupt` is raised.

    Args:
        volume: a `DisplayVolume`, or a file of volumes (.svol), which plays in its own time.
        device: "NAME" or "NAME:REST"; `kinds()` lists them. It has the display that the volume was sliced for.
        seconds: for how long, from the start on, waiting for the display included; None: until a recording ends, or Ctrl-C.
        loop: play a recording again and again.
        tear: show a frame that is late in the middle of a turn, instead of waiting for the next one.
        coarse: show what is there of a frame that is late.
        progress: None, True, False or a function `progress(stage, fraction)`.

    Returns:
        A dict: what `ocelli present --json` tells: refreshes, misses, frames shown, latencies.

    Raises:
        InputError: for unknown devices, and a volume of another display.
        WorkError: where the device cannot be opened, and where no frame was ever shown.
    """
    if not isinstance(volume, (DisplayVolume, str, os.PathLike)):
        raise InputError(f"a {type(volume).__name__} is not for displays", "volume", "slice it: ocelli.slice(scene, profile)")
    with Shown(progress) as callback:
        return json.loads(_ocelli.present(volume, device, seconds, loop, tear, coarse, callback))
