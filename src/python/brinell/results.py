"""What a run writes, read."""

from __future__ import annotations

import json
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any, Dict, List, Optional, Union

import numpy as np

if TYPE_CHECKING:
    import pyvista


class ResultError(ValueError):
    """A folder that holds no results, or results that do not have what is asked for."""


@dataclass(frozen=True)
class Units:
    """Names of the units that all figures are in."""

    length: str
    force: str
    stress: str


@dataclass(frozen=True)
class Figure:
    """A certified figure."""

    #: The quantity, such as ``"peak_pressure"``.
    what: str
    #: Body, interface or surface; ``"overall"`` for the scene.
    where: str
    value: float
    #: Absolute, in the unit of `value`; `None` where nothing is known.
    error: Optional[float]
    #: The same over the size of `value`.
    relative_error: Optional[float]
    resolved: bool
    note: Optional[str]


@dataclass(frozen=True)
class Line:
    """A line of contact."""

    interface: str
    #: The axis along which it runs.
    axis: str
    across: float
    #: Places of the rows of nodes along the line, and the force per length at each.
    at: np.ndarray
    load: np.ndarray
    half_width: float
    #: Stand its rows for those at the opposite places, too?
    mirrored: bool


@dataclass(frozen=True)
class Run:
    """A run in its folder."""

    folder: Path
    #: All of `summary.json`; its schema is `docs/schema/summary.schema.json`.
    summary: Dict[str, Any]
    #: Of the command, where it was run from here.
    exit_status: Optional[int] = None

    @property
    def units(self) -> Units:
        return Units(**self.summary["units"])

    @property
    def converged(self) -> bool:
        return bool(self.summary["converged"])

    @property
    def figures(self) -> List[Figure]:
        """Every certified figure."""
        names = ("what", "where", "value", "error", "relative_error", "resolved", "note")
        return [Figure(**{name: one[name] for name in names}) for one in self.summary["certificate"]]

    def figure(self, what: str, where: str = "overall") -> Figure:
        """The certified figure of one quantity at one place."""
        for figure in self.figures:
            if (figure.what, figure.where) == (what, where):
                return figure
        known = sorted({f"{f.what} of {f.where}" for f in self.figures})
        raise ResultError(f"no figure `{what}` of `{where}`; there are: {', '.join(known)}")

    @property
    def lines(self) -> List[Line]:
        """Every line of contact, of all interfaces."""
        found = []
        for interface, figures in self.summary["interfaces"].items():
            for line in figures["lines"]:
                found.append(
                    Line(
                        interface=interface,
                        axis=line["axis"],
                        across=line["across"],
                        at=np.asarray(line["at"], dtype=float),
                        load=np.asarray(line["load"], dtype=float),
                        half_width=line["half_width"],
                        mirrored=line["mirrored"],
                    )
                )
        return found

    @property
    def times(self) -> np.ndarray:
        """The increments that have fields: steps done, so that 1.5 is half of the second step."""
        return np.asarray(sorted({entry.time for entry in self._entries()}))

    def bodies(self, time: Optional[float] = None) -> "pyvista.UnstructuredGrid":
        """Displacement, stress and strain of the bodies, at the end or at one of `times`."""
        return self._grid(0, time)

    def contacts(self, time: Optional[float] = None) -> "pyvista.UnstructuredGrid":
        """Pressure, gap, traction and status on the contact surfaces, at the end or at one of `times`."""
        return self._grid(1, time)

    def _grid(self, part: int, time: Optional[float]) -> "pyvista.UnstructuredGrid":
        try:
            import pyvista
        except ImportError as error:
            raise ImportError("fields are read by pyvista: pip install brinell[fields]") from error
        entries = [entry for entry in self._entries() if entry.part == part]
        if time is not None:
            entries = [entry for entry in entries if abs(entry.time - time) <= 1e-9]
        if not entries:
            raise ResultError(f"{self.folder} has no fields of that kind at that time; times are {self.times}")
        file = max(entries, key=lambda entry: entry.time).file
        grid = pyvista.read(file)
        if not isinstance(grid, pyvista.UnstructuredGrid):
            raise ResultError(f"{file} is no unstructured grid")
        return grid

    def _entries(self) -> List["_Entry"]:
        collections = sorted(self.folder.glob("*.pvd"))
        if len(collections) != 1:
            raise ResultError(f"{self.folder} has {len(collections)} collections of fields, not one")
        root = ElementTree.parse(collections[0]).getroot()
        return [
            _Entry(float(one.attrib["timestep"]), int(one.attrib["part"]), self.folder / one.attrib["file"])
            for one in root.iter("DataSet")
        ]


@dataclass(frozen=True)
class _Entry:
    time: float
    part: int
    file: Path


def read(folder: Union[str, "PathLike[str]"], exit_status: Optional[int] = None) -> Run:
    """Reads the folder of a run; of one with a target, its last level."""
    folder = _last_level(Path(folder))
    path = folder / "summary.json"
    try:
        summary = json.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        parts = sorted(part.parent.name for part in folder.glob("*/summary.json"))
        if parts:
            raise ResultError(f"{folder} holds several runs: read one of its folders {', '.join(parts)}") from None
        raise ResultError(f"{folder} holds no summary.json: `brinell run CASE.toml --out {folder}` writes it") from None
    except json.JSONDecodeError as error:
        raise ResultError(f"{path} is no JSON: {error}") from error
    return Run(folder=folder, summary=summary, exit_status=exit_status)


def _last_level(folder: Path) -> Path:
    """Of a run with a target the folder of its last level, else the folder itself."""
    levels = [level for level in folder.glob("level-*") if level.name[6:].isdigit() and (level / "summary.json").exists()]
    if (folder / "summary.json").exists() or not levels:
        return folder
    return max(levels, key=lambda level: int(level.name[6:]))
