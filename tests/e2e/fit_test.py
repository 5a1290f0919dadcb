#!/usr/bin/env python3
"""fit_test.py LAPFX SCENE: `lapfx fit` as a user runs it: a hidden preset is found again, and bad input is told."""
import csv
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

COLUMNS = ("time,blood,blood_low,blood_high,blood_before,blood_after,"
           "veil,veil_low,veil_high,veil_before,veil_after").split(",")
# Few frames, and low: a fit draws as many pictures of that shape, 256 px wide, for each curve.
VIDEO = ("--size", "128x64", "--fps", "1.25")
VIDEO_OF_COLORS = ("--size", "128x104", "--fps", "2.5")  # in which there is enough blood to tell its colour
ACCUMULATION = 0.09  # 1/s, hidden; the scene's preset has another


def run(lapfx, *arguments):
    done = subprocess.run([lapfx, *arguments], capture_output=True, text=True, timeout=1700)
    return done.returncode, done.stdout, done.stderr


def render_hidden(lapfx, scene, folder):
    video = os.path.join(folder, "hidden.mp4")
    code, _, told = run(lapfx, "render", scene, *VIDEO, "--to", "6", "--set",
                        f"smoke.haze.accumulation={ACCUMULATION}", "-o", video)
    assert code == 0, told
    return video


def check_found(lapfx, scene, video, folder):
    fitted, curves = os.path.join(folder, "fitted.json"), os.path.join(folder, "curves.csv")
    code, said, told = run(lapfx, "fit", scene, "--reference", video, "--offset", "0", "--window", "0,4.4",
                           "--parameters", "smoke.haze.accumulation,bleeding.pulse_rate", "-o", fitted, "--csv", curves)
    assert code == 0, told
    found = json.load(open(fitted))["smoke"]["haze"]["accumulation"]
    assert abs(found / ACCUMULATION - 1) < 0.15, (found, said)
    assert "bleeding.pulse_rate: 0, kept: not determined" in said, said
    code, _, told = run(lapfx, "check", fitted)
    assert code == 0, told
    rows = list(csv.DictReader(open(curves)))
    assert list(rows[0]) == COLUMNS and len(rows) == 6, (list(rows[0]), len(rows))
    misfit = {name: sum((float(row["veil_" + name]) - float(row["veil"])) ** 2 for row in rows if row["veil"])
              for name in ("before", "after")}
    assert misfit["after"] < misfit["before"] / 9, misfit


def check_scene(lapfx, scene, video, folder):
    """The scene's tools begin when the reference smokes, and the scene that is written names preset and reference."""
    fitted, written = os.path.join(folder, "s.json"), os.path.join(folder, "fitted.scene.json")
    report = os.path.join(folder, "s.html")
    code, said, told = run(lapfx, "fit", scene, "--reference", video, "--offset", "0.5", "--window", "0,5",
                           "--parameters", "smoke.haze.accumulation", "-o", fitted, "--fitted-scene", written,
                           "--report", report)
    assert code == 0, told
    page = re.sub("<[^>]*>", " ", open(report).read())
    for name, file in (("Preset after", fitted), ("Scene after", written)):
        assert re.search(name + r"\s+" + re.escape(os.path.basename(file)), page), name
    assert "smoke: from " in said and "events have to move" not in said, said
    found, given = json.load(open(written)), json.load(open(scene))
    assert found["preset"] == "s.json" and found["reference"]["file"] == "hidden.mp4", found
    assert found["reference"]["offset"] == 0.5
    first = min(event["time"] for event in found["events"] if event["power"] > 0)
    begins = min(event["time"] for event in given["events"]) - 0.5
    assert abs(first - begins) < 0.6, (first, said)
    for event in given["events"]:  # what the reference does not reach stays
        if event["time"] > 5.5:
            assert event in found["events"], (event, found["events"])
    start = json.load(open(os.path.join(os.path.dirname(scene), given["preset"])))
    end = json.load(open(fitted))
    assert end["bleeding"] == start["bleeding"], "only the accumulation was free"
    end["smoke"]["haze"]["accumulation"] = start["smoke"]["haze"]["accumulation"]
    assert end == start
    code, _, told = run(lapfx, "check", written)
    assert code == 0, told
    code, _, told = run(lapfx, "render", written, "--at", "2", "--size", "64x52", "-o", os.path.join(folder, "p.png"))
    assert code == 0, told


def write_bleeding(scene, folder):
    """The scene's preset with so much blood and haze that their colours are told."""
    preset = json.load(open(os.path.join(os.path.dirname(scene), json.load(open(scene))["preset"])))
    preset["bleeding"]["speed"], preset["bleeding"]["max_extent"] = 12, 30
    preset["smoke"]["haze"]["accumulation"] = 0.06
    path = os.path.join(folder, "bleeding.json")
    json.dump(preset, open(path, "w"))
    return path


def render_colors(lapfx, scene, preset, folder):
    """Another blood and another haze."""
    video = os.path.join(folder, "colors.mp4")
    code, _, told = run(lapfx, "render", scene, "--preset", preset, *VIDEO_OF_COLORS, "--to", "6",
                        "--set", "bleeding.color_thin=#c04020", "--set", "bleeding.color_deep=#802010",
                        "--set", "smoke.haze.color=#606a90", "--set", "smoke.plume.color=#8090c0", "-o", video)
    assert code == 0, told
    return video


def compared(lapfx, scene, preset, video, folder):
    path = os.path.join(folder, "compared.json")
    code, _, told = run(lapfx, "compare", scene, video, "--preset", preset, "--offset", "0", "--window", "0,6",
                        "--json", path)
    assert code == 0, told
    return json.load(open(path))["figures"]


def check_colors(lapfx, scene, folder):
    start = write_bleeding(scene, folder)
    video = render_colors(lapfx, scene, start, folder)
    fitted, report = os.path.join(folder, "colors.json"), os.path.join(folder, "colors.html")
    code, said, told = run(lapfx, "fit", scene, "--reference", video, "--preset", start, "--offset", "0", "--window",
                           "0,6", "--parameters", "smoke.haze.accumulation", "--colors", "-o", fitted, "--report", report)
    assert code == 0, told
    assert "camera.exposure and organ.color: stay, the scene is written with --fitted-scene only" in said, said
    before = compared(lapfx, scene, start, video, folder)
    after = compared(lapfx, scene, fitted, video, folder)
    for name in ("blood_delta_e", "smoke_delta_e"):
        assert after[name] < 3 < before[name], (name, before, after, said)
    assert "<h2>Colours</h2>" in open(report).read()


def check_ended(lapfx, scene, video, folder):
    """Out of time it gives the best so far, and a fit that is stopped leaves nothing."""
    short = os.path.join(folder, "short.json")
    code, said, told = run(lapfx, "fit", scene, "--reference", video, "--budget", "0.01", "-o", short)
    assert code == 1 and "--budget" in told and not os.path.exists(short), (code, said, told)
    stopped = os.path.join(folder, "stopped.json")
    fit = subprocess.Popen([lapfx, "fit", scene, "--reference", video, "-o", stopped], stderr=subprocess.PIPE, text=True)
    time.sleep(2)
    fit.send_signal(signal.SIGINT)
    _, told = fit.communicate(timeout=60)
    assert fit.returncode == 1 and "interrupted" in told, (fit.returncode, told)
    assert not [name for name in os.listdir(folder) if "stopped" in name], os.listdir(folder)


def check_clips(lapfx, scene, video, folder):
    """A preset with clips of its own stays where they are."""
    own, other = os.path.join(folder, "own"), os.path.join(folder, "other")
    os.mkdir(own), os.mkdir(other)
    shipped = os.path.join(os.path.dirname(scene), json.load(open(scene))["preset"])
    preset = json.load(open(shipped))
    clip = os.path.join(own, "mine.mp4")
    shutil.copy(video, clip)
    preset["smoke"]["clips"] = [{"file": "mine.mp4"}]
    json.dump(preset, open(os.path.join(own, "p.json"), "w"))
    code, said, told = run(lapfx, "fit", scene, "--reference", video, "--preset", os.path.join(own, "p.json"), "-o",
                           os.path.join(other, "f.json"))
    assert code == 2 and "mine.mp4" in told and "--output" in told, (code, said, told)


def check_refused(lapfx, scene, video, folder):
    fitted = os.path.join(folder, "none.json")
    whole = ["fit", scene, "--reference", video, "-o", fitted]
    cases = [
        (["--parameters", "bleeding.sped"], "--parameters: bleeding.sped"),
        (["--parameters", "bleeding.color_thin"], "is no number"),
        (["--parameters", ","], "nothing is free"),
        (["--parameters", "bleeding.speed=8..2"], "not below the upper"),
        (["--parameters", "events.0.time"], "is written with --fitted-scene only"),
        (["--window", "5,3"], "--window"),
        (["--window", "0,1000"], "--window"),
        (["--window", "now"], "--window"),
        (["--offset", "50"], "has no time in common"),
        (["--offset", "5.99"], "fewer than two measured moments"),
        (["--offset", "nan"], "--offset"),
        (["--budget", "0"], "--budget"),
        (["--seed", "x"], "--seed"),
        (["--fitted-scene", os.path.join(folder, "scene.json")], "does not end in .scene.json"),
        (["--fitted-scene", scene], "is a file that is read here"),
        (["--csv", video], "does not end in .csv"),
        (["--csv", os.path.join(folder, "none.json")], "does not end in .csv"),
        (["--report", os.path.join(folder, "none.json")], "does not end in .html"),
    ]
    for extra, expected in cases:
        code, said, told = run(lapfx, *whole, *extra)
        assert code == 2 and expected in told and said == "", (extra, code, said, told)
    code, said, told = run(lapfx, *whole[:-1], scene)
    assert code == 2 and "is a file that is read here" in told, (code, said, told)
    for changed, expected in ((2, "no.scene.json"), (4, "no.mp4"), (6, "fitted.txt")):
        arguments = [*whole]
        arguments[changed - 1] = os.path.join(folder, expected)
        code, _, told = run(lapfx, *arguments)
        assert code == 2 and expected in told, (arguments, code, told)
    assert not os.path.exists(fitted)
    code, _, told = run(lapfx, *whole[:-1], os.path.join(folder, "none", "fitted.json"))
    assert code == 1 and "none" in told, (code, told)


def main(lapfx, scene):
    with tempfile.TemporaryDirectory() as folder:
        video = render_hidden(lapfx, scene, folder)
        check_refused(lapfx, scene, video, folder)
        check_clips(lapfx, scene, video, folder)
        check_ended(lapfx, scene, video, folder)
        check_found(lapfx, scene, video, folder)
        check_scene(lapfx, scene, video, folder)
        check_colors(lapfx, scene, folder)


if __name__ == "__main__":
    main(*sys.argv[1:])
