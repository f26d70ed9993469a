"""Runs Brinell and reads what a run writes.

    import brinell

    run = brinell.run("case.toml", "out")
    peak = run.figure("peak_pressure", "upper_plate-upper_roller")
    print(peak.value, peak.error, run.units.stress)

Figures are in the units of the case, which `Run.units` names. Errors are absolute, in the unit of their
figure, unless their name says `relative`. Fields need pyvista (`pip install brinell[fields]`).
"""

from .results import Figure, Line, ResultError, Run, Units, read
from .command import RunError, executable, run

__all__ = ["Figure", "Line", "ResultError", "Run", "RunError", "Units", "executable", "read", "run"]
