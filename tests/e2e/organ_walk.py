#!/usr/bin/env python3
"""lapfx inspect on meshes of the third-party test data, and what became of their triangles: of each collection and
format the first and every twelfth after it, or with `tests/run --deep` (LAPFX_DEEP=1) every one, which takes some
minutes.

    organ_walk.py LAPFX DATA_FOLDER

Prints, by folder and format: files, triangles read, drawn and left out by reason, vertices mended, and the reasons of
the files that were refused. Fails when a file's triangles do not add up, or one is refused without a line that names
it. Skips (77) where that data is not there.
"""
import collections
import os
import re
import sys

import inspecting

FORMATS = ("glb", "gltf", "obj", "off", "ply", "stl")
IN_THE_FILE = re.compile(r"^  in the file +(\d+) triangles?, (?:none left out|(\d+) left out: (.*))$", re.M)
DRAWN = re.compile(r"^  triangles +(\d+)$", re.M)
MENDED = re.compile(r"^  mended +(\d+) vertices", re.M)


class Sum:
    def __init__(self):
        self.files = self.refused = self.read = self.drawn = self.mended = 0
        self.dropped = collections.Counter()


def meshes(folder):
    """Sorted by collection, which is two folders deep, and format."""
    found = collections.defaultdict(list)
    for path, _, names in os.walk(folder):
        collection = os.path.relpath(path, folder).split(os.sep)[:2]
        for name in names:
            if (kind := name.rsplit(".", 1)[-1].lower()) in FORMATS:
                found[(*collection, kind)].append(os.path.join(path, name))
    step = 1 if os.environ.get("LAPFX_DEEP") else 12
    for _, files in sorted(found.items()):
        yield from sorted(files)[::step]


def reason_of(line, file):
    """A fault without names and numbers, so that like ones are counted together."""
    text = line.removeprefix(f"lapfx: {file}: ")
    text = re.sub(r'"[^"]*"', '"..."', text)
    text = re.sub(r"(/[A-Za-z]\w*)+(/\w+)*", lambda place: re.sub(r"\d+", "N", place.group()), text, count=1)
    return re.sub(r"\d[\d.]*", "N", text)[:110]


def add(total, output):
    """The fault of the counts, or nothing."""
    found, drawn, mended = (pattern.search(output) for pattern in (IN_THE_FILE, DRAWN, MENDED))
    if not found or not drawn:
        return "tells no counts"
    # A reason may have a comma of its own.
    reasons = [part.split(" ", 1) for part in re.split(r", (?=\d)", found[3] or "") if part]
    read, left_out = int(found[1]), int(found[2] or 0)
    total.read += read
    total.drawn += int(drawn[1])
    total.mended += int(mended[1]) if mended else 0
    for count, reason in reasons:
        total.dropped[reason] += int(count)
    by_reason = sum(int(count) for count, _ in reasons)
    if read == int(drawn[1]) + left_out and left_out == by_reason:
        return None
    return f"{read} read, {drawn[1]} drawn, {left_out} left out, {by_reason} of them for a reason"


def main():
    program, folder = sys.argv[1], os.environ.get("LAPFX_TEST_DATA", sys.argv[2])
    if not os.path.isdir(folder):
        print(f"organ_walk: no test data in {folder}, so nothing was inspected")
        return 77
    sums, refusals, faults = collections.defaultdict(Sum), collections.Counter(), []
    for file, code, output, errors in inspecting.inspect_all(program, meshes(folder)):
        total = sums[os.path.relpath(file, folder).split(os.sep)[0], file.rsplit(".", 1)[-1].lower()]
        total.files += 1
        lines = [line for line in errors.splitlines() if line.startswith(f"lapfx: {file}: ")]
        if code == 2 and lines:
            total.refused += 1
            refusals[reason_of(lines[0], file)] += 1
        elif code != 0:
            faults.append(f"{file}: exit {code}: {errors[:200]}")
        elif (fault := add(total, output)) is not None:
            faults.append(f"{file}: {fault}")
    print(f"{'':14}{'files':>7}{'refused':>9}{'read':>10}{'drawn':>10}{'left out':>10}{'sewn':>8}")
    for (place, kind), total in sorted(sums.items()):
        print(f"{place + ' ' + kind:14}{total.files:7}{total.refused:9}{total.read:10}{total.drawn:10}"
              f"{sum(total.dropped.values()):10}{total.mended:8}  "
              + ", ".join(f"{count} {reason}" for reason, count in total.dropped.most_common()))
    print("\nrefused:")
    for reason, count in refusals.most_common():
        print(f"{count:5}  {reason}")
    if not os.environ.get("LAPFX_DEEP"):
        print("\nof each collection and format the first and every twelfth; tests/run --deep inspects all of them")
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
