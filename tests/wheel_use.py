"""Uses what the wheel brings: `tests/wheel` calls it with a case of problem H and a folder for its results."""

import sys
from pathlib import Path

import numpy as np

import brinell

case, out = sys.argv[1:]
assert str(brinell.executable()).startswith(sys.prefix), brinell.executable()

run = brinell.run(case, out)
assert run.converged and run.exit_status == 0
assert run.units == brinell.Units(length="in", force="kip", stress="ksi")

# Hertz: 167.17 ksi under 8.125 kip/in, within the bar that the run claims.
peak = run.figure("peak_pressure", "cylinder-block")
assert peak.error is not None and peak.resolved
assert abs(peak.value - 167.17) <= peak.error, peak
assert np.isclose(peak.relative_error, peak.error / peak.value)

# The force of the line is the load: 8.125 kip/in.
(line,) = run.lines
assert line.axis == "z" and np.allclose(line.load, 8.125, rtol=5e-3), line.load

# The fields are those of the summary, and say their units.
bodies, contacts = run.bodies(), run.contacts()
assert np.isclose(contacts["contact_pressure"].max(), run.summary["interfaces"]["cylinder-block"]["max_pressure"])
assert np.isclose(bodies["mises_nodal"].max(), max(b["mises_max"]["nodal"] for b in run.summary["bodies"].values()))
assert "stress: ksi" in list(bodies.field_data["units"]), bodies.field_data["units"]
assert run.times.tolist() == sorted(run.times) and run.bodies(run.times[0]).n_points == bodies.n_points

# Read again, and what goes wrong says so.
assert brinell.read(out).figures == run.figures
for wrong, error in [
    (lambda: brinell.read(Path(out) / "nowhere"), brinell.ResultError),
    (lambda: run.figure("peak_pressure", "nowhere"), brinell.ResultError),
    (lambda: brinell.run("no-such-case.toml", out), brinell.RunError),
]:
    try:
        wrong()
    except error as told:
        print("as it should be:", str(told).splitlines()[0])
    else:
        raise AssertionError(f"{error} was to come")
print(f"p max {peak.value:.2f} ± {peak.error:.2f} {run.units.stress}")
