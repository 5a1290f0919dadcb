#!/usr/bin/env python3
"""compare_test.py LAPFX SCENE: `lapfx compare` as a simulator's team runs it: limits that hold and that do not, what is
written, and bad input."""
import json
import os
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib

ACCUMULATION = 0.09  # 1/s; the scene's preset has another
WINDOW = ("--offset", "0", "--window", "0,5")
# A scene and its own render differ by the coding of the video and by which of its frames are surveyed.
ALIKE = {"veil_rms": 0.02, "blood_rms": 0.01, "veil_peak_ratio": 1.2, "tissue_delta_e": 3}


def run(lapfx, *arguments):
    done = subprocess.run([lapfx, *arguments], capture_output=True, text=True, timeout=1700)
    return done.returncode, done.stdout, done.stderr


def at_most(limits):
    return [word for name, limit in limits.items() for word in ("--at-most", f"{name}={limit}")]


def render(lapfx, scene, folder, name, fps, *more):
    video = os.path.join(folder, name)
    code, _, told = run(lapfx, "render", scene, "--size", "128x104", "--fps", fps, "--to", "5.6", *more, "-o", video)
    assert code == 0, told
    return video


def write_black(folder, count):
    """Numbered black PNGs of 64 by 48."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    picture = (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 64, 48, 8, 2, 0, 0, 0)) +
               chunk(b"IDAT", zlib.compress((b"\0" + b"\0" * 3 * 64) * 48)) + chunk(b"IEND", b""))
    for i in range(count):
        with open(os.path.join(folder, f"black_{i:02d}.png"), "wb") as file:
            file.write(picture)
    return os.path.join(folder, "black_%02d.png")


def changed_scene(scene, folder, name, change):
    """A copy of the scene elsewhere."""
    with open(scene, encoding="utf-8") as file:
        values = json.load(file)
    home = os.path.dirname(os.path.abspath(scene))
    for part in ("organ", "tool"):
        values[part]["file"] = os.path.join(home, values[part]["file"])
    values["preset"] = os.path.join(home, values["preset"])
    change(values)
    path = os.path.join(folder, name)
    with open(path, "w", encoding="utf-8") as file:
        json.dump(values, file)
    return path


def printed(said):
    """The line of words, and {name: value or None}."""
    words, *lines = said.splitlines()
    found = {}
    for line in lines:
        name, value = line.split(": ", 1)
        assert re.fullmatch(r"not measurable|-?[\d.e+-]+( s| Delta E 2000)?", value), line
        found[name] = None if value == "not measurable" else float(value.split()[0])
    return words, found


def check_alike(lapfx, scene, video, folder):
    """A rendered scene is that scene, and a file says so."""
    path = os.path.join(folder, "alike.json")
    code, said, told = run(lapfx, "compare", scene, video, *WINDOW, *at_most(ALIKE), "--json", path)
    assert code == 0, (code, said, told)
    words, figures = printed(said)
    assert words == "blood and veil match within the error of measuring", words
    with open(path, encoding="utf-8") as file:
        written = json.load(file)
    assert list(written) == ["format", "version", "scene", "reference", "offset", "window", "words", "figures",
                             "at_most"], written
    assert written["window"] == [0.0, 5.0], written
    assert (written["format"], written["version"], written["offset"]) == ("lapfx.comparison", 1, 0), written
    assert (written["scene"], written["reference"], written["words"]) == (scene, video, words), written
    assert list(written["figures"]) == list(figures), (written["figures"], figures)
    for name, value in written["figures"].items():
        assert (value is None) == (figures[name] is None), name
        assert value is None or abs(value - figures[name]) <= 0.006 * abs(value), (name, value, figures[name])
    assert {name: entry["limit"] for name, entry in written["at_most"].items()} == ALIKE, written["at_most"]
    for name, entry in written["at_most"].items():
        assert entry["holds"] is True and entry["value"] == written["figures"][name], (name, entry)
    assert None not in (figures["smoke_delta_e"], figures["tissue_delta_e"]), figures


def check_farther(lapfx, scene, video, folder):
    """Another accumulation is named, figure by figure; with the right one, by --set or by --preset, it holds."""
    path = os.path.join(folder, "farther.json")
    limits = {"veil_rms": 0.02, "tissue_delta_e": 3, "veil_peak_ratio": 1.2, "blood_late": 1}
    code, said, told = run(lapfx, "compare", scene, video, *WINDOW, *at_most(limits), "--json", path)
    lines = [line for line in told.splitlines() if "allowed" in line or "not known" in line]
    assert code == 1 and len(lines) == 3, (code, told)
    assert re.fullmatch(r"lapfx: veil_rms is 0\.\d+, above the 0\.02 that is allowed", lines[0]), lines
    assert re.fullmatch(r"lapfx: veil_peak_ratio is 0\.\d+, which counts as [\d.]+, above the 1\.2 that is allowed",
                        lines[1]), lines
    assert lines[2] == "lapfx: blood_late is not known, so that it cannot be shown to be at most 1", lines
    words, figures = printed(said)
    assert "veil" in words and "too thin" in words and figures["veil_bias"] < -0.02, (words, figures)
    with open(path, encoding="utf-8") as file:
        written = json.load(file)["at_most"]
    assert {name: entry["holds"] for name, entry in written.items()} == {
        "veil_rms": False, "tissue_delta_e": True, "veil_peak_ratio": False, "blood_late": False}, written
    assert written["blood_late"]["value"] is None, written
    right = os.path.join(folder, "right.json")
    with open(os.path.join(os.path.dirname(scene), "..", "presets", "gastric_banding.json"), encoding="utf-8") as file:
        preset = json.load(file)
    preset["smoke"]["haze"]["accumulation"] = ACCUMULATION
    with open(right, "w", encoding="utf-8") as file:
        json.dump(preset, file)
    for chosen in (("--set", f"smoke.haze.accumulation={ACCUMULATION}"), ("--preset", right)):
        code, said, told = run(lapfx, "compare", scene, video, *WINDOW, *chosen, *at_most(ALIKE), "--json", path)
        assert code == 0, (chosen, said, told)
        with open(path, encoding="utf-8") as file:
            written = json.load(file)
        key, value = ("set", [chosen[1]]) if chosen[0] == "--set" else ("preset", chosen[1])
        assert written[key] == value and ("set" in written) != ("preset" in written), (chosen, written)


def check_videos(lapfx, video, other, folder):
    path = os.path.join(folder, "itself.json")
    code, said, told = run(lapfx, "compare", other, other, "--json", path, *at_most({"veil_rms": 0, "veil_late": 0}))
    assert code == 0, (said, told)
    with open(path, encoding="utf-8") as file:
        written = json.load(file)
    assert written["video"] == other and "scene" not in written and written["offset"] == 0, written
    for name, value in written["figures"].items():
        if name in ("blood_error", "veil_error"):  # measuring alone has these errors
            assert value is None or 0 < value < 0.5, (name, value)
        else:
            assert value in (None, 1 if name.endswith("_ratio") else 0), (name, value)
    assert written["figures"]["veil_rms"] == 0 and written["figures"]["tissue_delta_e"] == 0, written
    code, said, told = run(lapfx, "compare", video, other, "--at-most", "veil_rms=0.02")
    assert code == 1 and "lapfx: veil_rms is 0." in told, (code, told)
    assert printed(said)[1]["veil_bias"] < -0.02, said
    code, said, told = run(lapfx, "compare", other, video)
    assert code == 0 and printed(said)[1]["veil_bias"] > 0.02, (code, said, told)
    # What comes a second later in the reference is early.
    code, said, told = run(lapfx, "compare", other, other, "--offset", "-1", "--window", "1,5.6")
    late = printed(said)[1]["veil_late"]
    assert code == 0 and late is not None and -1.5 < late < -0.3, (code, said, told)
    # The haze is not as dense in the middle as elsewhere.
    of_view = {}
    for view in ("0.5,0.5,1", "0.5,0.5,0.2"):
        code, said, told = run(lapfx, "compare", video, other, "--view", view)
        assert code == 0, (code, said, told)
        of_view[view] = printed(said)[1]["veil_rms"]
    assert abs(of_view["0.5,0.5,1"] - of_view["0.5,0.5,0.2"]) > 0.005, of_view


def check_refused(lapfx, scene, video, other, folder):
    def away(values):
        values["camera"].update(eye=[0, 0, 1000], target=[0, 0, 2000])
    def dark(values):
        values["light"]["intensity"] = 0
    of_scene, of_videos = ["compare", scene, other], ["compare", video, other]
    home = os.path.dirname(scene)
    black = write_black(folder, 12)
    hidden = changed_scene(scene, folder, "away.scene.json", away)
    unlit = changed_scene(scene, folder, "dark.scene.json", dark)
    late = changed_scene(scene, folder, "late.scene.json", lambda values: values.update(reference={
        "file": video, "measure": {"strokes": [{"time": 99, "points": [{"x": 0.5, "y": 0.5}]}]}}))
    own = changed_scene(scene, folder, "own.scene.json", lambda values: values.update(preset="own.json"))
    shutil.copy(os.path.join(home, "..", "presets", "gastric_banding.json"), os.path.join(folder, "own.json"))
    named_json = os.path.join(folder, "video.json")
    shutil.copy(video, named_json)
    kept = {name: os.path.getmtime(os.path.join(folder, name)) for name in ("own.scene.json", "own.json", "video.json")}
    cases = [
        ([*of_videos, "--at-most", "veil_rsm=1"], '"veil_rsm" is not a figure; nearest is veil_rms'),
        ([*of_videos, "--at-most", "veil_rms"], "is not NAME=VALUE"),
        ([*of_videos, "--at-most", "veil_rms=much"], 'veil_rms: "much" is not a number'),
        ([*of_videos, "--at-most", "veil_rms=nan"], 'veil_rms: "nan" is not a number'),
        ([*of_videos, "--at-most", "veil_rms=-1"], "veil_rms: -1 is below the minimum 0"),
        ([*of_videos, *at_most({"veil_rms": 1}), *at_most({"veil_rms": 2})], "veil_rms is given twice"),
        ([*of_videos, "--set", "bleeding.speed=3"], "--set: is of a scene"),
        ([*of_videos, "--preset", scene], "--preset: is of a scene"),
        ([*of_videos, "--offset", "50"], "has no time in common"),
        ([*of_scene, "--offset", "-50"], "has no time in common"),
        ([*of_videos, "--offset", "nan"], "--offset"),
        ([*of_videos, "--window", "3,1"], "--window"),
        ([*of_scene, "--window", "0,1000"], "--window"),
        ([*of_videos, "--baseline", "99"], "--baseline: 99.00 s is outside the video"),
        ([*of_videos, "--view", "0.5,0.5"], '--view: "0.5,0.5" is not x,y,r'),
        ([*of_scene, "--view", "0.5,0.5,9"], '--view: the radius of "0.5,0.5,9" is outside 0.1 to 2 heights'),
        ([*of_scene, "--set", "bleeding.sped=3"], "nearest is bleeding.speed"),
        ([*of_scene, "--preset", os.path.join(folder, "none.json")], "none.json"),
        ([*of_videos, "--json", os.path.join(folder, "out.txt")], "does not end in .json"),
        (["compare", own, other, "--json", own], "--json"),
        (["compare", own, other, "--json", os.path.join(folder, "own.json")], "is a file that is read here"),
        (["compare", own, other, "--preset", os.path.join(folder, "own.json"), "--json",
          os.path.join(folder, ".", "own.json")], "is a file that is read here"),
        (["compare", video, named_json, "--json", named_json], "is a file that is read here"),
        (["compare", named_json, video, "--json", named_json], "is a file that is read here"),
        (["compare", os.path.join(home, "lagb.glb"), other], "neither a scene nor a video"),
        (["compare", os.path.join(folder, "black_00.png"), other], "neither a scene nor a video"),
        (["compare", os.path.join(folder, "own.json"), other], '"lapfx.preset" is not "lapfx.scene"'),
        (["compare", os.path.join(folder, "none.mp4"), other], "no such file"),
        (["compare", scene, os.path.join(folder, "none.mp4")], "no such file"),
        (["compare", scene, scene], "is not a video"),
        (["compare", folder, other], "is a folder"),
        (["compare", scene, black, "--window", "0,0.4"], "has no frame that shows anything"),
        (["compare", black, video], "has no frame that shows anything"),
        (["compare", hidden, video, "--window", "0,1"], "away.scene.json: the organ is not in view"),
        (["compare", unlit, video, "--window", "0,1"], "dark.scene.json: "),
        (["compare", late, video, "--window", "0,1"],
         "late.scene.json: /reference/measure/strokes/0/time: 99.00 s is outside the video (allowed: 0 to "),
        (["compare", scene], "REFERENCE is required"),
    ]
    for arguments, expected in cases:
        code, said, told = run(lapfx, *arguments)
        assert code == 2 and expected in told and said == "", (arguments, code, said, told)
    assert kept == {name: os.path.getmtime(os.path.join(folder, name)) for name in kept}
    code, _, told = run(lapfx, *of_videos, "--json", os.path.join(folder, "none", "out.json"))
    assert code == 1 and "none" in told, (code, told)


def check_bleeding_plate(lapfx, scene, video, folder):
    """A plate that bleeds by itself: by the scene's strokes its blood counts in the preview as it does in the video."""
    def stroke(marks, *points):
        return {"time": 5.21, "marks": marks, "radius": 0.03, "points": [{"x": x, "y": y} for x, y in points]}

    def plated(strokes, aspect):
        return changed_scene(scene, folder, "plate.scene.json", lambda values: values.update(
            events=[], plate={"use": True, "frame": "chosen", "time": 5.21},
            reference={"file": video, "aspect": aspect, "measure": {"baseline": 0.1, "strokes": strokes}}))
    strokes = [stroke("blood", (0.5, 0.55), (0.55, 0.55)), stroke("other", (0.2, 0.3), (0.3, 0.25)),
               stroke("other", (0.7, 0.7), (0.75, 0.4))]
    ratios = []
    for painted, aspect in (([], 0), (strokes, 0), (strokes, 2.0)):  # stored 1.23:1, shown 2:1
        code, said, told = run(lapfx, "compare", plated(painted, aspect), video, "--offset", "0", "--window", "4.8,5.6")
        assert code == 0, told
        ratios.append(float(printed(said)[1]["blood_peak_ratio"]))
    assert ratios[0] < 0.2 and 0.6 < ratios[1] < 1.1 and 0.6 < ratios[2] < 1.1, ratios
    assert "the strokes of " + os.path.join(folder, "plate.scene.json") in told, told


def check_beside(lapfx, scene, video, folder):
    """`lapfx render --beside`: the page of both pictures says what `lapfx compare` says."""
    scene = changed_scene(scene, folder, "short.scene.json", lambda values: values.update(duration=2))
    code, said, told = run(lapfx, "compare", scene, video)
    assert code == 0, told
    words = printed(said)[0]
    page = os.path.join(folder, "both.png")
    code, said, told = run(lapfx, "render", scene, "--at", "1.6", "--size", "128x102", "--beside", video, "-o", page)
    assert code == 0 and said == "" and f"lapfx: {video}: {words}" in told.splitlines(), (code, said, told)
    with open(page, "rb") as file:
        width, height = struct.unpack(">II", file.read(24)[16:])
    # The video is 128 x 104; text is at least three quarters of its usual size.
    assert (width, height % 2) == (128 + 4 + 126, 0) and 102 + 150 < height < 102 + 300, (width, height)
    # Of a video that shows nothing there is no curve, and the page says so.
    black = write_black(folder, 12)
    code, _, told = run(lapfx, "render", scene, "--at", "1.6", "--size", "128x102", "--beside", black, "-o", page)
    assert code == 0 and "The reference is not measured: " in told, (code, told)
    code, _, told = run(lapfx, "render", scene, "--at", "1.6", "--size", "128x102", "--beside",
                        os.path.join(folder, "none.mp4"), "-o", page)
    assert code == 2 and "none.mp4: no such file" in told, (code, told)
    both = os.path.join(folder, "both.mp4")
    code, _, told = run(lapfx, "render", scene, "--from", "1.2", "--to", "1.8", "--fps", "5", "--size", "128x102",
                        "--beside", video, "-o", both)
    assert code == 0, told
    code, said, told = run(lapfx, "inspect", both)
    assert code == 0 and f"{width}x{height}" in said, (said, told)
    kept = os.path.getmtime(both)
    code, _, told = run(lapfx, "render", scene, "--to", "1", "--fps", "5", "--size", "128x102", "--beside", both, "-o",
                        both)
    assert code == 2 and "is a file that is read here" in told and kept == os.path.getmtime(both), (code, told)


def main(lapfx, scene):
    with tempfile.TemporaryDirectory() as folder:
        video = render(lapfx, scene, folder, "shown.mp4", "2.5")  # as many pictures are drawn
        other = render(lapfx, scene, folder, "other.mp4", "3", "--set", f"smoke.haze.accumulation={ACCUMULATION}")
        check_refused(lapfx, scene, video, other, folder)
        check_videos(lapfx, video, other, folder)
        check_alike(lapfx, scene, video, folder)
        check_farther(lapfx, scene, other, folder)
        check_bleeding_plate(lapfx, scene, video, folder)
        check_beside(lapfx, scene, video, folder)


if __name__ == "__main__":
    main(*sys.argv[1:])
