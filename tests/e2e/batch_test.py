#!/usr/bin/env python3
"""batch_test.py LAPFX LIGHT_SAMPLES: `lapfx batch` under GNU parallel, as a user runs it.

Twelve clips, of which one is broken, two are fitted as the references of scenes, and the others are measured; what does
not belong there lies between them. One fit is killed in its middle, and the second run does what it left, alone. Then
the index is opened in a browser. Needs GNU parallel and chromium; what can be tested without is.
"""
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
import xml.etree.ElementTree as xml

import report_test
from report_test import DARK, HTML, LIGHT, SKIPPED, SVG

ODD = 'odd & <b>"it\'s" #1%.mp4'  # a file may be called so
PARAMETER = "smoke.haze.accumulation"
MEASURED = [f"clip_{i}.mp4" for i in range(1, 8)] + [ODD, "week 2/late.mp4"]
SCENES = ["one.scene.json", "two.scene.json"]
BROKEN = "broken.mp4"
ITEMS = sorted([*MEASURED, *SCENES, BROKEN])
FITTED = ["amounts.csv", "curves.csv", "fitted.json", "fitted.scene.json", "report.html", "result.json"]


def run(lapfx, *arguments, cwd=None):
    done = subprocess.run([lapfx, *arguments], capture_output=True, text=True, timeout=1700, cwd=cwd)
    return done.returncode, done.stdout, done.stderr


def make_folder(lapfx, light, folder):
    """videos/ with all that is in it; its clips differ in length and brightness."""
    videos = os.path.join(folder, "videos")
    os.makedirs(os.path.join(videos, "week 2"))
    samples = os.path.join(light, "samples")
    with open(os.path.join(samples, "lagb.scene.json"), encoding="utf-8") as file:
        scene = json.load(file)
    whole = os.path.join(folder, "whole.mp4")
    code, _, told = run(lapfx, "render", os.path.join(samples, "lagb.scene.json"), "--size", "128x104", "--fps", "5", "--to",
                        "2", "--set", f"{PARAMETER}=0.12", "-o", whole)
    assert code == 0, told
    for i, name in enumerate([*MEASURED, "first.mp4", "second.mp4"]):
        subprocess.run(["ffmpeg", "-v", "error", "-i", whole, "-vf", f"eq=brightness={0.01 * i}", "-t", str(2 - 0.2 * (i % 3)),
                        os.path.join(videos, name)], check=True, timeout=600)
    for name, reference in zip(SCENES, ("first.mp4", "second.mp4")):
        own = {**scene, "preset": os.path.join(light, "presets", "gastric_banding.json"), "duration": 2,
               "events": scene["events"][:1], "reference": {"file": reference},
               "organ": {**scene["organ"], "file": os.path.join(samples, scene["organ"]["file"])},
               "tool": {**scene["tool"], "file": os.path.join(samples, scene["tool"]["file"])}}
        with open(os.path.join(videos, name), "w", encoding="utf-8") as file:
            json.dump(own, file)
    with open(os.path.join(videos, "clip_1.mp4"), "rb") as whole_clip, open(os.path.join(videos, BROKEN), "wb") as file:
        file.write(whole_clip.read(1500))
    shutil.copy(os.path.join(videos, "clip_2.mp4"), os.path.join(videos, "copy_of_2.mp4"))
    with open(os.path.join(videos, "notes.txt"), "w", encoding="utf-8") as file:
        file.write("foreign")
    os.symlink("..", os.path.join(videos, "week 2", "loop"))
    os.symlink("nowhere.mp4", os.path.join(videos, "gone.mp4"))


def check_list(lapfx, folder):
    code, said, told = run(lapfx, "batch", "list", "videos", cwd=folder)
    assert code == 0 and said.splitlines() == ITEMS, (code, said, told)
    for expected in ("1 other file is left out: notes.txt", "copy_of_2.mp4: has the content of clip_2.mp4",
                     "first.mp4: is the reference of one.scene.json", "week 2/loop: leads to a folder",
                     "gone.mp4: is a link to nothing"):
        assert expected in told, (expected, told)
    return said


def check_refused(lapfx, folder):
    """Nothing is written."""
    os.mkdir(os.path.join(folder, "empty"))
    one = ["run", "videos", "clip_1.mp4", "--into", "results"]
    cases = [
        (["list", "nowhere"], "no such folder"), (["list", "empty"], "holds neither scenes"),
        (["list", "whole.mp4"], "is not a folder"), (["collect", "nowhere"], "no such folder"),
        (["collect", "empty"], "holds no results"), (["run", "videos", "--into", "results"], "ITEM: is missing"),
        ([*one, "--number", "1"], "one of them"), (["run", "videos", "--number", "99", "--into", "results"], "1 to 12"),
        (["run", "videos", "--number", "0", "--into", "results"], "1 to 12"),
        (["run", "videos", "--number", "-1", "--into", "results"], '"-1" is not a whole number'),
        (["run", "videos", "../whole.mp4", "--into", "results"], "is not a path below"),
        (["run", "videos", "./clip_1.mp4", "--into", "results"], "is not a path below"),
        (["run", "videos", "none.mp4", "--into", "results"], "is no file of"),
        (["run", "videos", "notes.txt", "--into", "results"], "neither a scene"),
        (["run", "videos", "clip_1.mp4", "--into", "videos"], "is the folder of the items"),
        (["run", "videos", "clip_1.mp4", "--into", "whole.mp4"], "is not a folder"),
        ([*one, "--window", "5"], "--window"), ([*one, "--scene", "none.scene.json"], "none.scene.json"),
    ]
    for arguments, expected in cases:
        code, said, told = run(lapfx, "batch", *arguments, cwd=folder)
        assert code == 2 and expected in told and said == "", (arguments, code, said, told)
    assert sorted(os.listdir(folder)) == ["empty", "videos", "whole.mp4"], os.listdir(folder)


def start_parallel(lapfx, folder, items):
    command = ["parallel", "--will-cite", "-j2", "--halt", "never", lapfx, "batch", "run", "videos", "{}", "--into", "results",
               "--parameters", PARAMETER]
    process = subprocess.Popen(command, cwd=folder, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                               text=True, env={**os.environ, "HOME": folder})
    process.stdin.write(items)
    process.stdin.close()
    process.stdin = None
    return process


def finished(process):
    said, told = process.communicate(timeout=1700)
    return process.returncode, sorted(said.splitlines()), told


def kill_in_the_middle(folder, item):
    """Kills who holds the item once it has drawn something, or at least begun."""
    lock = os.path.join(folder, "results", item, "running.lock")
    while True:  # ctest ends what hangs
        try:
            with open(lock, encoding="utf-8") as file:
                holder = re.match(r"process (\d+) on ", file.read())
            if holder:
                break
        except FileNotFoundError:
            pass
        time.sleep(0.01)
    time.sleep(0.5)
    os.kill(int(holder[1]), signal.SIGKILL)


def results(folder):
    found = {}
    for item in ITEMS:
        path = os.path.join(folder, "results", item, "result.json")
        if os.path.exists(path):
            found[item] = os.stat(path).st_mtime_ns
    return found


def check_runs(lapfx, folder, items):
    killed = SCENES[1]
    process = start_parallel(lapfx, folder, items)
    kill_in_the_middle(folder, killed)
    code, said, told = finished(process)
    assert code == 2, (code, said, told)  # two have failed: the broken one and the killed one
    assert BROKEN in told and len(said) == len(ITEMS) - 2, (said, told)
    first = results(folder)
    assert sorted(first) == sorted(set(ITEMS) - {killed}), sorted(first)
    code, said, told = run(lapfx, "batch", "collect", "results", cwd=folder)
    assert code == 0 and said == "12 items, 10 done, 1 failed, 1 unfinished\n" and f"{killed}: is not finished" in told
    code, said, told = finished(start_parallel(lapfx, folder, items))
    assert code == 1 and sum(line.endswith(": done before") for line in said) == 10, (said, told)
    assert f"{BROKEN}: failed before" in said and any(line.startswith(f"{killed}: blood") for line in said), said
    second = results(folder)
    assert {**second, **first} == second and sorted(second) == ITEMS, (first, second)
    code, said, told = finished(start_parallel(lapfx, folder, items))
    assert code == 1 and results(folder) == second, (said, told)
    assert sorted(os.listdir(os.path.join(folder, "results", killed))) == FITTED
    assert os.listdir(os.path.join(folder, "results", BROKEN)) == ["result.json"]


def check_again(lapfx, folder):
    """By its number, anew when asked for or when an option is another, and not while another process does it."""
    number = str(ITEMS.index("clip_1.mp4") + 1)
    one = ["batch", "run", "videos", "--number", number, "--into", "results", "--parameters", PARAMETER]
    before = results(folder)["clip_1.mp4"]
    assert run(lapfx, *one, cwd=folder)[1] == "clip_1.mp4: done before\n"
    for more in (["--again"], ["--window", "0,1"]):
        code, said, told = run(lapfx, *one, *more, cwd=folder)
        after = results(folder)["clip_1.mp4"]
        assert code == 0 and said.startswith("clip_1.mp4: blood ") and after > before, (more, said, told)
        before = after
    with open(os.path.join(folder, "results", "clip_1.mp4", "running.lock"), "w", encoding="utf-8") as lock:
        import fcntl
        fcntl.flock(lock, fcntl.LOCK_EX)
        code, said, told = run(lapfx, *one, "--again", cwd=folder)
        assert code == 0 and said == "clip_1.mp4: is being done by another process\n", (code, said, told)
    assert run(lapfx, *one, cwd=folder)[0] == 0  # all is as it was: the lock that a kill left holds nobody up


def check_files(lapfx, folder):
    """What is written names nothing of this machine, and a fitted scene finds its files."""
    code, said, told = run(lapfx, "batch", "collect", "results", cwd=folder)
    assert code == 0 and said == "12 items, 11 done, 1 failed, 0 unfinished\n" and told == "", (said, told)
    with open(os.path.join(folder, "results", "table.csv"), encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert [row["item"] for row in rows] == ITEMS
    for row in rows:
        assert row["state"] == ("failed" if row["item"] == BROKEN else "done"), row
        assert row["fault"] == (f"{BROKEN}: is not a video that can be decoded" if row["item"] == BROKEN else ""), row
        fitted = row["item"] in SCENES
        assert (row["kind"] == "scene") == fitted and bool(row["report"]) == fitted, row
        assert bool(row["veil_rms_after"]) == fitted and bool(row["veil_peak"]) == (row["item"] != BROKEN), row
        assert bool(row[PARAMETER + "_after"]) == fitted, row
        if fitted:
            assert 0 < float(row["veil_rms_after"]) < 0.2 and row[PARAMETER + "_determined"] in ("yes", "no"), row
            assert os.path.exists(os.path.join(folder, "results", row["report"])), row
    for name in ("result.json", "report.html", "fitted.json"):
        with open(os.path.join(folder, "results", SCENES[0], name), encoding="utf-8") as file:
            assert folder not in file.read(), name
    code, _, told = run(lapfx, "check", os.path.join(folder, "results", SCENES[0], "fitted.scene.json"))
    assert code == 0, told


def check_index(folder):
    page = xml.parse(os.path.join(folder, "results", "index.html")).getroot()
    names = ["".join(title.itertext()) for title in page.iter(HTML + "h2")]
    assert names == ITEMS, names
    links = [link.get("href") for link in page.iter(HTML + "a")]
    assert links == ["./table.csv", *(f"./{scene}/report.html" for scene in SCENES)], links
    ids = [element.get("id") for element in page.iter() if element.get("id")]
    assert len(ids) == len(set(ids)), ids
    assert len(list(page.iter(SVG + "svg"))) == 2 * (len(ITEMS) - 1)
    text = " ".join("".join(page.find(HTML + "body").itertext()).split())
    assert "12 items, 11 done, 1 failed" in text and "is not a video that can be decoded" in text, text
    assert not list(page.iter(HTML + "script"))


# The places of the items once another order is chosen.
ORDERS = """["by-name", "by-state"].map(id => { page.getElementById(id).click();
  return Array.from(page.querySelectorAll(".item"), i => [i.getBoundingClientRect().top, i.querySelector("h2").innerText])
    .sort((a, b) => a[0] - b[0]).map(i => i[1]); })"""


def check_shown(browser, folder):
    index = os.path.join(folder, "results", "index.html")
    assert browser.open(index, "--dump-dom")[1] == []
    for width in (1200, 400):
        found, asked = report_test.read(browser, os.path.dirname(index), width, "index.html", ORDERS)
        assert asked == [] and found["scripts"] == 0 and found["wider"] <= 0, (width, asked, found)
        assert len(found["plots"]) == 22 and all(200 < plot[0] <= width for plot in found["plots"]), found["plots"]
        assert len(found["images"]) == len(MEASURED) + 2 * len(SCENES), found["images"]
        for complete, wide, high, name in found["images"]:
            assert complete and 0 < wide <= 160 and 0 < high <= 160 and name, found["images"]
        assert min(found["curves"]) > 50 and len(found["curves"]) >= 22, found["curves"]
        assert found["more"] == [ITEMS, [BROKEN, *(item for item in ITEMS if item != BROKEN)]], found["more"]
    for size in ((1200, 900), (400, 900)):
        light, dark = browser.corner(index, LIGHT, size), browser.corner(index, DARK, size)
        assert min(light) > 240 and max(dark) < 40, (size, light, dark)


def main(lapfx, light):
    lapfx = os.path.abspath(lapfx)
    if shutil.which("parallel") is None:
        print("skipped: GNU parallel is not installed (.packages names it)")
        return SKIPPED
    with tempfile.TemporaryDirectory() as folder:
        make_folder(lapfx, os.path.abspath(light), folder)
        items = check_list(lapfx, folder)
        check_refused(lapfx, folder)
        check_runs(lapfx, folder, items)
        check_again(lapfx, folder)
        check_files(lapfx, folder)
        check_index(folder)
        program = shutil.which("chromium")
        if program is None:
            print("skipped: chromium is not installed, so the index was not opened in a browser (.packages names it)")
            return SKIPPED
        check_shown(report_test.Browser(program, folder), folder)
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
