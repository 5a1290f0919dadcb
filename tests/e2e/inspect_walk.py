#!/usr/bin/env python3
"""lapfx inspect on files of the third-party test data but meshes, which organ_walk.py inspects: no crash, no hang; exit
0, or exit 2 and at least one line that begins with "lapfx: " and names the file. It looks at one file in four, or with
`tests/run --deep` (LAPFX_DEEP=1) at every one. Skips (77) where that data is not there.

    inspect_walk.py LAPFX DATA_FOLDER
"""
import os
import sys

import inspecting
import organ_walk


def others(folder):
    files = sorted(os.path.join(path, name) for path, _, names in os.walk(folder) for name in names
                   if name.rsplit(".", 1)[-1].lower() not in organ_walk.FORMATS)
    return files if os.environ.get("LAPFX_DEEP") else files[::4]


def main():
    program, folder = sys.argv[1], os.environ.get("LAPFX_TEST_DATA", sys.argv[2])
    if not os.path.isdir(folder):
        print(f"inspect_walk: no test data in {folder}, so nothing was inspected")
        return 77
    failed = count = 0
    for file, code, _, errors in inspecting.inspect_all(program, others(folder)):
        count += 1
        if code != 0 and not (code == 2 and f"lapfx: {file}: " in errors):
            failed += 1
            print(f"exit {code}: {file}: {errors[-500:]}")
    print(f"inspect_walk: {count} files"
          + ("" if os.environ.get("LAPFX_DEEP") else ", one in four; tests/run --deep inspects all of them"))
    return 1 if failed or not count else 0


if __name__ == "__main__":
    sys.exit(main())
