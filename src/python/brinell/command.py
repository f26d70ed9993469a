"""The command that the wheel brings."""

from __future__ import annotations

import shutil
import subprocess
import sysconfig
from os import PathLike
from pathlib import Path
from typing import Union

from .results import Run, read


class RunError(RuntimeError):
    """A run that gave no answer. `status` is the exit status of the command: 2 bad input, 3 not converged,
    130 interrupted; the message is what it said."""

    def __init__(self, status: int, message: str) -> None:
        super().__init__(message)
        self.status = status


def executable() -> Path:
    """The program: the one beside this Python, else the one that is found by its name."""
    beside = shutil.which("brinell", path=sysconfig.get_path("scripts"))
    found = beside or shutil.which("brinell")
    if found is None:
        raise FileNotFoundError("no program `brinell` beside this Python and none on the path")
    return Path(found)


def run(case: Union[str, "PathLike[str]"], out: Union[str, "PathLike[str]"], *options: str) -> Run:
    """Runs a case into the folder `out`, with further options of `brinell run`, and reads what it wrote.

    A run that is solved but misses a limit (exit status 1) is read like any other: see `Run.exit_status`.
    """
    line = [str(executable()), "run", str(case), "--out", str(out), *options]
    done = subprocess.run(line, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)
    if done.returncode not in (0, 1):
        raise RunError(done.returncode, done.stderr.strip() or done.stdout.strip())
    return read(out, exit_status=done.returncode)
