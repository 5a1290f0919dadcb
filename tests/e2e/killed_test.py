#!/usr/bin/env python3
"""What a killed program leaves behind goes with the next run: killed_test.py LAPFX PROJECT

Each case kills a render in its middle (SIGKILL), then runs the same command to its end.
"""
import os
import signal
import subprocess
import sys
import tempfile
import time


def parts(folder):
    return [name for name in os.listdir(folder) if name.startswith(".lapfx")]


def start(lapfx, project, folder, output, until):
    return subprocess.Popen(
        [lapfx, "render", os.path.join(project, "samples", "lagb.scene.json"), "--from", "0", "--to", until, "--fps", "10",
         "--size", "64x52", "--amounts", "amounts.csv", "-o", output],
        cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)


def wait_for_part(render, folder, size):
    """Waits until it writes: `size` bytes of a video, files of a sequence."""
    while True:  # ctest ends what hangs
        assert render.poll() is None, f"it ended by itself: {render.stderr.read()}"
        for name in parts(folder):
            path = os.path.join(folder, name)
            if (len(os.listdir(path)) if os.path.isdir(path) else os.path.getsize(path)) >= size:
                return
        time.sleep(0.01)


def finish(render):
    _, said = render.communicate()
    if render.returncode == 77:
        sys.exit(77)
    assert render.returncode == 0, said


def kill_one(lapfx, project, output, size, whole):
    with tempfile.TemporaryDirectory() as folder:
        render = start(lapfx, project, folder, output, "3000")
        wait_for_part(render, folder, size)
        render.send_signal(signal.SIGKILL)
        render.communicate()
        assert len(parts(folder)) == 1, f"{output}: killed, and nothing is left? {os.listdir(folder)}"
        finish(start(lapfx, project, folder, output, "0.2"))
        assert sorted(os.listdir(folder)) == sorted(["amounts.csv"] + whole), f"{output}: {os.listdir(folder)}"


def side_by_side(lapfx, project):
    """A process does not remove the files of another that runs."""
    with tempfile.TemporaryDirectory() as folder:
        slow = start(lapfx, project, folder, "slow.mp4", "2")
        wait_for_part(slow, folder, 0)
        for _ in range(2):
            finish(start(lapfx, project, folder, "quick_%d.png", "0.1"))
        finish(slow)
        assert sorted(os.listdir(folder)) == ["amounts.csv", "quick_0.png", "slow.mp4"], os.listdir(folder)


def main(lapfx, project):
    kill_one(lapfx, project, "out.mp4", 1, ["out.mp4"])
    kill_one(lapfx, project, "out_%d.png", 2, ["out_0.png", "out_1.png"])
    side_by_side(lapfx, project)
    print("what killed renders left is gone, what runs is not")


if __name__ == "__main__":
    main(os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2]))
