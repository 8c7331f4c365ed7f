from __future__ import annotations

import csv
import io
import json
import os
from collections.abc import Sequence
from typing import Any

from ocelli import _ocelli
from ocelli._progress import Shown
from ocelli._table import Table
from ocelli._types import Path, Progress

_NUMBERS = {"value": float, "numerator": int, "denominator": int, "published": lambda text: text == "1"}


class Analysis:
    """What `ocelli.analyse()` found, as numbers with all their digits.

    Attributes:
        tables: {id: `Table`}: the tables of the report, in its order. A column is its numbers, None where a cell has none, and
            where cells have intervals followed by columns "... lower" and "... upper"; a column without numbers is its text.
        cells: `Table`, a row for each cell of the tables that count trials, answers and subjects: tables/cells.csv.
        trials: `Table`, a row for each trial that is analysed: tables/trials.csv. Its values are text.
        answers: `Table`, the same of answers to forms: tables/answers.csv.
        exclusions: `Table`, a row for each row that is left out, and why: tables/exclusions.csv.
        report: report.json as a dict: also the text of the report, and the rows that each number comes from.
        warnings: what a reader must not miss, sentences.
        failures: parts of the report that failed: faults of this package, sentences.
        subjects: how many are analysed.
        trial_count: how many trials are analysed.
        simulated: whether subjects are simulated, which says nothing about people; None where nothing says it.
        data_sha256: of what was read, before exclusions.
        plan_sha256: of the plan.
    """

    def __init__(self, found: dict[str, Any]) -> None:
        self.report: dict[str, Any] = json.loads(found["report"])
        self.tables = {each["id"]: _table_of(each) for each in self.report["elements"] if each["type"] == "table"}
        files = {name: text.decode() if isinstance(text, bytes) else text for name, text in found["files"].items()}
        self.cells = _table_of_csv(files["tables/cells.csv"], _NUMBERS)
        self.trials = _table_of_csv(files["tables/trials.csv"])
        self.answers = _table_of_csv(files["tables/answers.csv"])
        self.exclusions = _table_of_csv(files["tables/exclusions.csv"])
        self.warnings: list[str] = found["warnings"]
        self.failures: list[str] = found["failures"]
        self.subjects: int = found["subjects"]
        self.trial_count: int = found["trials"]
        self.simulated: bool | None = found["simulated"]
        self.data_sha256: str = found["data_sha256"]
        self.plan_sha256: str = found["plan_sha256"]

    def __repr__(self) -> str:
        kind = "simulated subjects" if self.simulated else "subjects"
        return f"<ocelli.Analysis of {self.trial_count} trials of {self.subjects} {kind}: {len(self.tables)} tables>"


def analyse(
    sources: Path | Sequence[Path],
    *,
    plan: Path = "",
    protocol: Path = "",
    columns: Path = "",
    only: Sequence[str] = (),
    simulated: str = "unless-people",
    other_protocols: bool = False,
    seed: int | None = None,
    progress: Progress = None,
) -> Analysis:
    """Analyses the trials of a study, as `ocelli analyse` does, and gives its tables instead of a report's folder.

    Nothing is written. The databases do not know who has these numbers: for reports that a withdrawal has to find use
    `ocelli analyse`.

    Args:
        sources: a database, a folder of a CSV export, with `columns` tables of another tool; or several of them.
        plan: the registered plan of the analysis, a file; "": the default one.
        protocol: the study's protocol, which CSV exports do not hold, a file.
        columns: of tables of another tool, which column is what: a name of `column_maps()` or a JSON file.
        only: the tasks that are analysed; empty: all.
        simulated: which rows where there are people and simulated subjects: "unless-people", "only" or "together".
        other_protocols: allow sources of different protocols.
        seed: of what is random; None: the plan's.
        progress: None, True, False or a function `progress(stage, fraction)`.

    Returns:
        `Analysis`: `.tables["find-means"].frame()` is a `pandas.DataFrame`.

    Raises:
        InputError: for sources, plans and tasks that are wrong.
    """
    paths = [sources] if isinstance(sources, (str, os.PathLike)) else list(sources)
    with Shown(progress) as callback:
        return Analysis(
            _ocelli.analyse(
                [os.fspath(path) for path in paths],
                os.fspath(plan),
                os.fspath(protocol),
                os.fspath(columns),
                list(only),
                simulated,
                other_protocols,
                seed,
                callback,
            )
        )


def column_maps() -> list[str]:
    """Names of the maps of the columns of other tools' tables that are built in."""
    return list(_ocelli.column_maps())


def _table_of(element: dict[str, Any]) -> Table:
    """Of a table of report.json."""
    values: dict[str, list[Any]] = {}
    for index, column in enumerate(element["columns"]):
        cells = [row[index] for row in element["rows"]]
        title = ": ".join(part for part in (column.get("group"), column["title"]) if part)
        name = title if title not in values else f"{title} ({index + 1})"
        has_numbers = any("value" in cell for cell in cells)
        intervals = [cell.get("interval") or (None, None) for cell in cells]
        has_intervals = any("interval" in cell for cell in cells)
        if has_numbers or not has_intervals:
            values[name] = [cell.get("value") if has_numbers else cell["text"] for cell in cells]
        if has_intervals:
            values[f"{name} lower"] = [lower for lower, _ in intervals]
            values[f"{name} upper"] = [upper for _, upper in intervals]
    return Table(values, title=element.get("caption", ""))


def _table_of_csv(text: str, numbers: dict[str, Any] | None = None) -> Table:
    """Columns of a CSV file; of those in `numbers`, what they make of a text, and None of nothing."""
    rows = list(csv.reader(io.StringIO(text, newline="")))
    convert = numbers or {}
    columns = {name: [row[index] for row in rows[1:]] for index, name in enumerate(rows[0])}
    for name, number in convert.items():
        columns[name] = [number(each) if each else None for each in columns[name]]
    return Table(columns)
