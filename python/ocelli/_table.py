"""Tables as users get them: columns of values, which pandas takes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ocelli.errors import WorkError

if TYPE_CHECKING:
    import pandas


class Table(dict[str, list[Any]]):
    """{column: values}, which `pandas.DataFrame()` takes; None where there is no value.

    Attributes:
        meanings: {column: (unit, what it means)}; the unit is "" where there is none.
        title: what it shows; "" where its name says it.
    """

    def __init__(self, values: dict[str, list[Any]], meanings: dict[str, tuple[str, str]] | None = None, title: str = "") -> None:
        super().__init__(values)
        self.meanings = meanings or {}
        self.title = title

    def frame(self) -> pandas.DataFrame:
        """The same as a `pandas.DataFrame`; it alone needs pandas.

        Raises:
            WorkError: where pandas is not installed.
        """
        try:
            import pandas
        except ImportError as error:
            next_step = "install pandas, or take the columns as they are"
            raise WorkError(f"there is no pandas: {error}", "Table.frame()", next_step) from None
        return pandas.DataFrame(self)
