#!/usr/bin/env python3
"""What a killed program leaves behind goes with the next run: killed_test.py LAPFX

Each case kills a render in its middle (SIGKILL), then runs the same command to its end. The scene is a square: how
long a render takes does not matter, for the one that is to run beside others is held meanwhile.
"""
import os
import signal
import subprocess
import sys
import tempfile
import time

import cli_test


def parts(folder):
    return [name for name in os.listdir(folder) if name.startswith(".lapfx")]


def start(lapfx, scene, folder, output, until):
    return subprocess.Popen(
        [lapfx, "render", os.path.join(scene, "scene.json"), "--from", "0", "--to", until, "--fps", "10", "--size", "64x52",
         "--backend", "osmesa", "--amounts", "amounts.csv", "-o", output],
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


def kill_one(lapfx, scene, output, size, whole):
    with tempfile.TemporaryDirectory() as folder:
        render = start(lapfx, scene, folder, output, "3000")
        wait_for_part(render, folder, size)
        render.send_signal(signal.SIGKILL)
        render.communicate()
        assert len(parts(folder)) == 1, f"{output}: killed, and nothing is left? {os.listdir(folder)}"
        finish(start(lapfx, scene, folder, output, "0.2"))
        assert sorted(os.listdir(folder)) == sorted(["amounts.csv"] + whole), f"{output}: {os.listdir(folder)}"


def side_by_side(lapfx, scene):
    """A process does not remove the files of another that runs."""
    with tempfile.TemporaryDirectory() as folder:
        slow = start(lapfx, scene, folder, "slow.mp4", "2")
        wait_for_part(slow, folder, 0)
        slow.send_signal(signal.SIGSTOP)  # it runs until the others have ended
        for _ in range(2):
            finish(start(lapfx, scene, folder, "quick_%d.png", "0.1"))
        slow.send_signal(signal.SIGCONT)
        finish(slow)
        assert sorted(os.listdir(folder)) == ["amounts.csv", "quick_0.png", "slow.mp4"], os.listdir(folder)


def main(lapfx):
    with tempfile.TemporaryDirectory() as scene:
        cli_test.fill(scene)
        kill_one(lapfx, scene, "out.mp4", 1, ["out.mp4"])
        kill_one(lapfx, scene, "out_%d.png", 2, ["out_0.png", "out_1.png"])
        side_by_side(lapfx, scene)
    print("what killed renders left is gone, what runs is not")


if __name__ == "__main__":
    main(os.path.abspath(sys.argv[1]))
