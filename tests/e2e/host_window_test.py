#!/usr/bin/env python3
"""The sample host in its window: its thread pushes the tool at 1 kHz in real time while its loop draws; what has
happened at the end is what the same events do at once. A preset that is written anew meanwhile is taken.

    host_window_test.py LAPFX_HOST LAPFX ROOT

77 where Xvfb or OpenGL is missing.
"""
import csv
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import threading

import real_window

DURATION, TUNED = 4.0, 20.0  # s; of the second, as a slow machine has to see two presets meanwhile
PRESET = {"format": "lapfx.preset", "version": 1, "name": "blood only"}
FPS = 5


def scene(root, duration):
    return {"format": "lapfx.scene", "version": 1, "name": "live", "seed": 3, "duration": duration,
            "organ": {"file": os.path.join(root, "samples/liver_lobe.glb")},
            "events": [{"action": "cut", "time": 0.5, "duration": 0.6, "position": [0, 9, 23], "to": [2, 9, 23]}],
            "camera": {"eye": [20, 10, 120], "target": [5, 0, 0], "field_of_view": 55}}


def scene_of(root, folder, name, duration):
    """The file of a scene."""
    path = os.path.join(folder, name + ".json")
    with open(path, "w", encoding="utf-8") as file:
        json.dump(scene(root, duration), file)
    return path


def area_at_once(lapfx, root, folder, duration):
    """That of lapfx render at the end, mm2: of a scene that is a frame longer, because a frame begins its time."""
    longer = scene_of(root, folder, "longer", duration + 1 / FPS)
    table = os.path.join(folder, "amounts.csv")
    subprocess.run([lapfx, "render", longer, "--preset", os.path.join(folder, "preset.json"),
                    "--amounts", table, "--size", "32x32", "--fps", str(FPS), "-o", os.path.join(folder, "f_%04d.png")], check=True)
    with open(table, encoding="utf-8") as file:
        last = list(csv.DictReader(file))[-1]
    assert float(last["time_s"]) == duration, last
    return float(last["blood_area_mm2"])


def on(display):
    return {**{name: value for name, value in os.environ.items() if name != "WAYLAND_DISPLAY"}, "DISPLAY": display.name}


def live(host, folder, shader, display):
    done = subprocess.run([host, os.path.join(folder, "scene.json"), os.path.join(folder, "preset.json"), folder, shader, "160",
                           "128"], env=on(display), capture_output=True, encoding="utf-8", timeout=real_window.LIMIT_S, check=False)
    if done.returncode == real_window.SKIP:
        raise real_window.Skip(done.stderr.strip())
    assert done.returncode == 0, (done.returncode, done.stderr)
    found = re.fullmatch(r"(\d+) samples, (\d+) lost, (\d+) frames, (\d+) wounds, ([0-9.]+) mm2 of blood\n", done.stdout)
    assert found, done.stdout
    return [float(number) for number in found.groups()]


def line_with(host, text):
    """Waits for a line of the host's on stderr."""
    for line in host.stderr:
        if text in line:
            return line
    raise AssertionError(f"the host has ended, and not told: {text}")


def tuned(host, root, folder, display):
    """The area at the end, mm2, when the preset is written anew meanwhile: broken first, then as it is to be."""
    path = os.path.join(folder, "tuned.json")

    def write(preset):
        with open(path + ".new", "w", encoding="utf-8") as file:
            json.dump(preset, file)
        os.replace(path + ".new", path)

    write({**PRESET, "bleeding": {"speed": 0.5}})
    command = [host, scene_of(root, folder, "tuned.scene", TUNED), path, folder, "lapfx", "160", "128"]
    with subprocess.Popen(command, env=on(display), stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8") as running:
        limit = threading.Timer(real_window.LIMIT_S, running.kill)
        limit.start()
        try:
            line_with(running, "may be written anew")
            write({**PRESET, "bleeding": {"speed": -1}})
            told = line_with(running, path)
            assert "/bleeding/speed: -1 is below the minimum 0 mm/s" in told, told
            write({**PRESET, "name": "second"})
            line_with(running, 'now with "second"')
            out, _ = running.communicate()
        finally:
            limit.cancel()
            running.kill()
    return float(re.search(r"([0-9.]+) mm2 of blood", out)[1])


def main():
    host, lapfx, root = sys.argv[1:]
    if shutil.which("Xvfb") is None:
        print("host_window: no Xvfb here")
        return real_window.SKIP
    with tempfile.TemporaryDirectory() as folder:
        scene_of(root, folder, "scene", DURATION)
        with open(os.path.join(folder, "preset.json"), "w", encoding="utf-8") as file:
            json.dump(PRESET, file)
        blood = area_at_once(lapfx, root, folder, DURATION)
        assert blood > 100, "too little blood to compare"
        display = None
        try:
            display = real_window.Display(folder)
            for shader in ("lapfx", "own"):
                samples, lost, frames, wounds, area = live(host, folder, shader, display)
                print(f"{shader}: {samples:.0f} samples, {frames:.0f} frames, {area} mm2; at once {blood:.1f} mm2")
                assert samples == 1000 * DURATION + 1 and lost == 0 and frames >= 1
                assert wounds == 1 and abs(area / blood - 1) < 0.02, "what came through the queue bleeds otherwise"
            area, wanted = tuned(host, root, folder, display), area_at_once(lapfx, root, folder, TUNED)
            print(f"written anew: {area} mm2; at once {wanted:.1f} mm2")
            assert abs(area / wanted - 1) < 0.02, "the second preset bleeds otherwise"
        except real_window.Skip as skip:
            print(f"host_window: {skip}")
            return real_window.SKIP
        finally:
            if display is not None:
                display.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
