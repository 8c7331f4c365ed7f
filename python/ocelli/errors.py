"""What goes wrong: two kinds of errors, which say what, where, and what to try next.

`InputError` (also a `ValueError`): an argument or a file is wrong. `WorkError` (also an `OSError`): the work itself
failed, for example because the disk is full.
"""


class Error(Exception):
    """What both kinds have in common.

    Attributes:
        what: what went wrong, one line.
        where: the file, field or argument; "" where `what` says it.
        next: what to try.
        details: lines below `what`; mostly "".
    """

    def __init__(self, what: str, where: str = "", next: str = "", details: str = "", text: str | None = None):  # noqa: A002 - the name that users read
        self.what = what
        self.where = where
        self.next = next
        self.details = details
        super().__init__(text if text is not None else _sentence(what, where, next, details))


def _sentence(what: str, where: str, next: str, details: str) -> str:  # noqa: A002 - as above
    """As the C++ side says it."""
    lines = [f"{where}: {what}" if where else what, *(f"    {line}" for line in details.splitlines())]
    return "\n".join([*lines, f"  try: {next}"] if next else lines)


class InputError(Error, ValueError):
    """An argument or an input file is wrong."""


class WorkError(Error, OSError):
    """The work itself failed: a full disk, an output that cannot be written."""

    def __str__(self) -> str:
        return str(self.args[0]) if self.args else ""
