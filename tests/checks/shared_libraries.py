#!/usr/bin/env python3
"""Checks what our programs load: shared_libraries.py PROGRAM...

Every PROGRAM is there, finds all its libraries, and neither loads nor names Qt (OpenCV's highgui would bring it in).
"""
import os
import re
import subprocess
import sys

QT = re.compile(r"libQt|libopencv_highgui", re.IGNORECASE)


def faults_of(program):
    if not os.access(program, os.X_OK):
        return [f"{program}: not built"]
    done = subprocess.run(["ldd", program], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        return [f"{program}: ldd: {done.stderr.strip()}"]
    return [f"{program}: {line.strip()}" for line in done.stdout.splitlines() if QT.search(line) or "not found" in line]


def main():
    programs = sys.argv[1:]
    if not programs:
        print("usage: shared_libraries.py PROGRAM...")
        return 2
    faults = [fault for program in programs for fault in faults_of(program)]
    print("\n".join(faults or [f"{program}: no Qt" for program in programs]))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
