"""Compares the tables of two sweeps: equal but for what depends on the machine."""

import csv

# Of the run, not of the answer.
APART = {"seconds", "memory_bytes"}


def read(folder):
    with open(folder / "table.csv", newline="") as file:
        return list(csv.DictReader(file))


def off(a, b):
    """The relative difference of two cells; infinite where they are no numbers and differ."""
    if a == b:
        return 0.0
    try:
        a, b = float(a), float(b)
    except ValueError:
        return float("inf")
    return abs(a - b) / max(abs(a), abs(b))


def compare(one, other, tolerance=0.0):
    """Says whether the tables in two folders are equal, numbers within `tolerance` of each other."""
    one, other = read(one), read(other)
    if [list(row) for row in one] != [list(row) for row in other]:
        print(f"  differs: rows or columns, {len(one)} rows and {len(other)}")
        return False
    cells = [(a["row"], name, a[name], b[name]) for a, b in zip(one, other) for name in a if name not in APART]
    wrong = [cell for cell in cells if not off(*cell[2:]) <= tolerance]
    for row, name, a, b in wrong[:10]:
        print(f"  differs: row {row}, {name}: {a} and {b}")
    if not wrong:
        worst = max(off(a, b) for _, _, a, b in cells)
        said = f"within {worst:.0e}" if worst else "to the last digit"
        print(f"  equal {said}: {len(cells)} cells, all but {' and '.join(sorted(APART))}")
    return not wrong
