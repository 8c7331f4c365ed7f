"""Studies: what their databases hold, as tables.

    tables = ocelli.study.tables("study.db")
    trials = tables["trials"].frame()                    # a pandas.DataFrame
    trials[trials.counts == 1].groupby("view").correct.mean()
    tables["trials"].meanings["response_s"]     # ("s", "from the first image on to the answer ...")

Columns are those of `ocelli study export`. Rows of simulated subjects have `simulated` 1: they say nothing about people.
"""

from __future__ import annotations

from ocelli import _ocelli
from ocelli._progress import Shown
from ocelli._table import Table
from ocelli._types import Path, Progress

__all__ = ["Table", "tables"]


def tables(
    database: Path,
    *,
    frames: bool = False,
    inputs: bool = False,
    gaze: bool = False,
    notes: bool = False,
    progress: Progress = None,
) -> dict[str, Table]:
    """Reads the tables of a study: trials, subjects, runs, answers, events.

    All are of the same moment, also while a session goes on. Nothing is written to the database, which does not know who
    has its data: for files that a withdrawal has to find use `ocelli study export`.

    Args:
        database: the file.
        frames: also each frame of each trial: where one stood, and when.
        inputs: also each key, click and move of the mouse.
        gaze: also where subjects looked.
        notes: also what experimenters typed, which may name people.
        progress: None, True, False or a function `progress(stage, fraction)`.

    Returns:
        {name: `Table`}.

    Raises:
        InputError: for a file that is missing, damaged, or no study's.
    """
    with Shown(progress) as callback:
        read = _ocelli.study_tables(database, frames, inputs, gaze, notes, callback)
    return {name: Table(values, meanings) for name, values, meanings in read}
