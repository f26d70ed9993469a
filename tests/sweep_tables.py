"""Compares the tables of two sweeps: equal but for what depends on the machine."""

import csv

# Of the run, not of the answer.
APART = {"seconds", "memory_bytes"}


def read(folder):
    with open(folder / "table.csv", newline="") as file:
        return list(csv.DictReader(file))


def differences(one, other):
    """What differs, in words, and how many cells were compared."""
    if len(one) != len(other):
        return [f"{len(one)} rows and {len(other)}"], 0
    found, cells = [], 0
    for a, b in zip(one, other):
        if list(a) != list(b):
            return [f"row {a['row']}: the columns differ"], cells
        for name in a:
            if name in APART:
                continue
            cells += 1
            if a[name] != b[name]:
                found.append(f"row {a['row']}, {name}: {a[name]} and {b[name]}")
    return found, cells


def compare(one, other):
    """Says whether the tables in two folders are equal; True where they are."""
    found, cells = differences(read(one), read(other))
    for line in found[:10]:
        print("  differs:", line)
    if not found:
        print(f"equal to the last digit: {cells} cells, all but {' and '.join(sorted(APART))}")
    return not found
