"""Progress of long work: a line on a terminal or below a notebook's cell."""

import sys
import time

_FIRST_SECONDS = 0.5  # shorter work shows nothing
_STEP_SECONDS = 0.1


class ProgressLine:
    """Writes "stage  42 %" over itself."""

    def __init__(self, stream):
        self._stream = stream
        self._start = time.monotonic()
        self._next = self._start + _FIRST_SECONDS
        self._width = 0

    def __call__(self, stage, fraction):
        now = time.monotonic()
        if now < self._next:
            return
        self._next = now + _STEP_SECONDS
        text = f"{stage} {100 * fraction:3.0f} %"
        self._stream.write("\r" + text.ljust(self._width))
        self._stream.flush()
        self._width = len(text)

    def clear(self):
        if self._width:
            self._stream.write("\r" + " " * self._width + "\r")
            self._stream.flush()


def _in_notebook():
    return "ipykernel" in sys.modules


class Shown:
    """`with Shown(progress) as callback:` where `progress` is None (show it where someone looks), True, False or a function."""

    def __init__(self, progress):
        looked_at = _in_notebook() or (sys.stderr is not None and sys.stderr.isatty())
        if callable(progress):
            self._callback = progress
        elif progress or (progress is None and looked_at):
            self._callback = ProgressLine(sys.stderr)
        else:
            self._callback = None

    def __enter__(self):
        return self._callback

    def __exit__(self, *_):
        if isinstance(self._callback, ProgressLine):
            self._callback.clear()
