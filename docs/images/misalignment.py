"""Writes the table of the gallery: what plates out of parallel do to a roller.

    cargo run --release -- sweep cases/sweep-misalignment.toml
    python3 docs/images/misalignment.py results/sweep-misalignment
"""

import json
import math
import pathlib
import re
import sys

LOAD, LENGTH, RADIUS = 400.0, 400.0, 60.0  # kN, mm
MODULUS = 210.0 / (2.0 * (1.0 - 0.3**2))  # GPa, of two alike
EVEN = LOAD / LENGTH
HERTZ = math.sqrt(EVEN * MODULUS / (math.pi * RADIUS))
INTERFACE = "upper_plate-roller"


def figure(summary, what, over, digits):
    """Value over `over` with its bar, or the value in brackets where it is not resolved."""
    claims = summary["certificate"]
    claim = next(c for c in claims if c["what"] == what and c["where"] == INTERFACE)
    value = claim["value"] / over
    if not claim["resolved"]:
        return f"({value:.{digits}f}), not resolved"
    return f"{value:.{digits}f} ± {claim['error'] / abs(over):.{digits}f}"


def moment(summary):
    """The force of the contact times its distance from the middle of the roller: zero where a mirror plane says so."""
    if not any(c["what"] == "eccentricity" for c in summary["certificate"]):
        return "0"
    force = summary["interfaces"][INTERFACE]["normal_force"]
    return figure(summary, "eccentricity", -1000.0 / force, 1)


print("| end | tilt, mrad | moment, kN m | loaded length, mm | largest line load over even | p_max over even Hertz |")
print("|---|---|---|---|---|---|")
for path in sorted(pathlib.Path(sys.argv[1], "rows").glob("*/summary.json")):
    summary = json.loads(path.read_text())
    end, tilt = re.search(r"\d+-(\w[\w.]*?)-tilt([\d.]+)mrad", path.parent.name).groups()
    cells = [
        re.sub(r"crown([\d.]+)mm", r"crown \1 mm", end),
        tilt,
        moment(summary),
        figure(summary, "contact_length", 1.0, 0),
        figure(summary, "line_load", EVEN, 2),
        figure(summary, "peak_pressure", HERTZ, 2),
    ]
    print("| " + " | ".join(cells) + " |")
