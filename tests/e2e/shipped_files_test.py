#!/usr/bin/env python3
"""Where lapfx finds the presets and samples that come with it: beside the program, or where LAPFX_DATA says.

    shipped_files_test.py LAPFX SOURCE_DIR
"""
import os
import shutil
import subprocess
import sys
import tempfile


def run(program, *words, data=None):
    environment = {name: value for name, value in os.environ.items() if name != "LAPFX_DATA"}
    if data is not None:
        environment["LAPFX_DATA"] = data
    return subprocess.run([program, *words], env=environment, capture_output=True, encoding="utf-8", check=False)


def fails(done, *said):
    """With bad input, in one line on stderr that has these words."""
    lines = done.stderr.splitlines()
    assert done.returncode == 2 and not done.stdout and len(lines) == 1, done
    assert all(words in lines[0] for words in said), lines


def works(program, preset, data=None):
    """The preset, which names a clip that comes with lapfx, is fine, and help lists the presets that do."""
    checked, listed = run(program, "check", preset, data=data), run(program, "help", "preset", data=data)
    assert checked.returncode == 0, checked
    assert listed.returncode == 0 and "presets/slow_ooze.json" in listed.stdout, listed


def main(lapfx, source):
    with tempfile.TemporaryDirectory(prefix="lapfx files ") as folder:
        preset = os.path.join(folder, "own.json")
        shutil.copy(os.path.join(source, "presets", "slow_ooze.json"), preset)
        works(lapfx, preset)  # they lie in the build folder

        bare = shutil.copy(lapfx, os.path.join(folder, "lapfx"))
        fails(run(bare, "help", "preset"), "share/lapfx", "LAPFX_DATA")
        fails(run(bare, "check", preset), "wisps_thin.mp4", os.path.join(folder, "share/lapfx/samples/clips"))
        works(bare, preset, data=source)
        for wrong in (os.path.join(folder, "nowhere"), preset):
            fails(run(bare, "help", "preset", data=wrong), wrong, "LAPFX_DATA")
            fails(run(lapfx, "check", preset, data=wrong), wrong, "LAPFX_DATA")  # no other place is taken instead

        # As it is installed.
        for name in ("bin", "share"):
            os.makedirs(os.path.join(folder, "as", name))
        os.symlink(source, os.path.join(folder, "as", "share", "lapfx"))
        works(shutil.copy(lapfx, os.path.join(folder, "as", "bin", "lapfx")), preset)


if __name__ == "__main__":
    main(*map(os.path.realpath, sys.argv[1:]))
