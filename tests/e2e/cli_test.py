#!/usr/bin/env python3
"""The command line from outside: exit codes, messages, and what is left on the disk. cli_test.py LAPFX [NAME]

Exit 0 done; 1 failed while running; 2 wrong usage or bad input. Data on stdout, messages on stderr, a line per fault:
`lapfx: FILE: PLACE: REASON`. Nothing is left half written, however a command ends. Each case runs in an empty folder
that holds the files of FILES; with NAME only the cases whose name contains it are run.
"""
import json
import os
import re
import signal
import struct
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from typing import Callable, Optional, Tuple

LIMIT_S = 1200  # for one command, also under a sanitizer on a busy machine
SHEET = ("sheet", "scene.json", "--backend", "osmesa", "--size", "64x48")
RENDER = ("render", "scene.json", "--backend", "osmesa", "--size", "64x48")

SCENE = {
    "format": "lapfx.scene", "version": 1, "name": "cli test", "duration": 60,
    "organ": {"file": "organ.obj"},
    "events": [{"action": "cut", "time": 0.1, "duration": 0.2, "position": [0, 0, 0]}],
}
# A square of 100 mm in the plane z = 0, facing the camera's default place.
ORGAN = """v -50 -50 0\nv 50 -50 0\nv 50 50 0\nv -50 50 0
vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1
f 1/1/1 2/2/1 3/3/1\nf 1/1/1 3/3/1 4/4/1\n"""
# 96 by 24 pixels, all alike: a BMP, whose bytes are ASCII.
WIDE = struct.pack("<2sIIIIiiHHIIIIII", b"BM", 6966, 0, 54, 40, 96, 24, 1, 24, 0, 6912, 0, 0, 0, 0).decode("ascii")
WIDE += "\x01" * 6912


def document(kind, **values):
    return json.dumps({"format": f"lapfx.{kind}", "version": 1, **values})


FILES = {
    "scene.json": json.dumps(SCENE),
    "organ.obj": ORGAN,
    "hostile \x1b[31m.obj": "o liver\x1b]0;title\x07\nusemtl skin\u202egnp\n" + ORGAN,
    "good.json": document("preset", bleeding={"speed": 2.0}),
    "low.json": document("preset", bleeding={"speed": -3}),
    "typo.json": document("preset", bleeding={"sped": 2.0}),
    "cut off.json": '{"format": "lapfx.preset", "vers',
    "words.json": "not JSON at all",
    "empty.json": "",
    "future.json": json.dumps({"format": "lapfx.preset", "version": 999}),
    "no organ.scene.json": json.dumps({**SCENE, "organ": {"file": "nowhere.obj"}}),
    "nothing there.scene.json": json.dumps({**SCENE, "organ": {"file": "nowhere.obj"}, "tool": {"file": "nowhere.stl"}}),
    "no clips.json": document("preset", smoke={"clips": [{"file": "nowhere.mp4"}, {"file": "words.txt"}]}),
    "bad organ.scene.json": json.dumps({**SCENE, "organ": {"file": "words.json"}}),
    "words.glb": "not a mesh at all",
    "words.txt": "not a picture at all",
    "wide.bmp": WIDE,
    "kept.png": "was here before",
    "folder/": None,
}


@dataclass
class Case:
    name: str
    arguments: Tuple[str, ...]
    code: int
    file: Optional[str] = None  # the one line on stderr is about this file
    says: str = ""  # a regular expression that is found on stderr
    prints: Optional[str] = ""  # a regular expression that all of stdout matches
    leaves: Tuple[str, ...] = ()  # new files, nothing else is new
    then: Optional[Callable[[str], None]] = None  # looks at what is left, raises AssertionError


def is_png(folder, name, size):
    with open(os.path.join(folder, name), "rb") as file:
        data = file.read()
    assert data.startswith(b"\x89PNG\r\n\x1a\n") and data.endswith(b"IEND\xaeB`\x82"), f"{name} is not a whole PNG"
    assert struct.unpack(">II", data[16:24]) == size, f"{name} is {struct.unpack('>II', data[16:24])}, not {size}"


def is_video(folder, name, size, frames):
    done = subprocess.run(
        ["ffprobe", "-v", "error", "-count_frames", "-select_streams", "v:0", "-show_entries",
         "stream=width,height,nb_read_frames", "-of", "csv=p=0", os.path.join(folder, name)],
        capture_output=True, encoding="utf-8", check=False)
    found = done.stdout.strip()
    assert found == f"{size[0]},{size[1]},{frames}", f"{name}: expected {size} and {frames} frames, ffprobe: {found}"


def holds_layers(folder):
    """The square is seen from the front and a cut bleeds in it: amounts.csv says what the pictures show."""
    with open(os.path.join(folder, "truth", "amounts.csv"), encoding="utf-8") as file:
        lines = file.read().splitlines()
    assert lines[0] == "time,blood,blood_low,blood_high,veil,veil_low,veil_high,flags", lines[0]
    assert [line.split(",")[0] for line in lines[1:]] == ["2.0000", "2.5000"], lines
    for line in lines[1:]:
        _, blood, low, high, veil, *_ = line.split(",")
        assert blood == low == high and 0.0 < float(blood) < 0.5 and 0.0 <= float(veil) < 0.5, line
    for name in ("view", "blood", "veil"):
        for number in (0, 1):
            is_png(folder, f"truth/{name}_{number:04d}.png", (64, 48))


USAGE = [
    Case("usage: no such verb", ("paint",), 2, says=r'^lapfx: "paint" is neither a command nor a file \('),
    Case("usage: nearest verb", ("rendr", "scene.json", "-o", "out.png"), 2, says="nearest is render"),
    Case("usage: a file alone is edited", ("scene.json", "--size", "640x480", "--backend", "osmesa", "--screenshot",
         "out.png"), 0, leaves=("out.png",), then=lambda folder: is_png(folder, "out.png", (640, 480))),
    Case("usage: options alone are of edit", ("--size", "640x480", "--theme", "pink"), 2, says="pink"),
    Case("usage: a missing file alone", ("nowhere.json",), 2, "nowhere.json"),
    Case("usage: help by its name", ("help", "render"), 0, prints=r"(?s).*--size.*--fps.*"),
    Case("usage: no such option", ("--paint",), 2, says="--paint"),
    Case("usage: help", ("--help",), 0, prints=r"(?s).*render.*"),
    Case("usage: version", ("--version",), 0, prints=r".*\d+\.\d+\.\d+\n"),
    Case("usage: help of render", ("render", "--help"), 0, prints=r"(?s).*--size.*--fps.*"),
    Case("usage: help of check", ("check", "--help"), 0, prints=r"(?s).*FILE.*"),
    Case("usage: help of inspect", ("inspect", "--help"), 0, prints=r"(?s).*FILE.*"),
    Case("usage: help of edit", ("edit", "--help"), 0, prints=r"(?s).+"),
    Case("usage: help of gallery", ("gallery", "--help"), 0, prints=r"(?s).*--screenshot.*--dump.*"),
    Case("usage: gallery without such a page", ("gallery", "--page", "Attic", "--dump", "out.txt"), 2,
         says="Attic.*is not one of Overview, Basic"),
    Case("usage: gallery without such a theme", ("gallery", "--theme", "pink", "--dump", "out.txt"), 2, says="pink"),
    Case("usage: gallery without such a widget", ("gallery", "--focus", "Attic", "--dump", "out.txt"), 2, says="Attic"),
    Case("usage: gallery at no scale", ("gallery", "--scale", "nan", "--dump", "out.txt"), 2, says="--scale"),
    Case("usage: gallery no picture's name", ("gallery", "--screenshot", "out.gif"), 2, says="out.gif"),
    Case("usage: gallery into no folder", ("gallery", "--dump", "nowhere/out.txt"), 1, "nowhere/out.txt"),
    Case("usage: gallery as a tree", ("gallery", "--dump", "out.json"), 0, leaves=("out.json",),
         then=lambda folder: json.load(open(os.path.join(folder, "out.json"), encoding="utf-8"))["children"]),
    Case("render: gallery", ("gallery", "--screenshot", "out.png", "--size", "64x48", "--backend", "osmesa"), 0,
         leaves=("out.png",), then=lambda folder: is_png(folder, "out.png", (64, 48))),
]

INPUT = [
    Case("check: nothing", ("check",), 2),
    Case("check: good", ("check", "good.json", "scene.json"), 0, prints=r"(?s)good\.json.*scene\.json.*"),
    Case("check: missing", ("check", "missing.json"), 2, "missing.json"),
    Case("check: folder", ("check", "folder"), 2, "folder"),
    Case("check: empty", ("check", "empty.json"), 2, "empty.json"),
    Case("check: words", ("check", "words.json"), 2, "words.json"),
    Case("check: cut off", ("check", "cut off.json"), 2, "cut off.json"),
    Case("check: newer than we are", ("check", "future.json"), 2, "future.json", says="999"),
    Case("check: below the minimum", ("check", "low.json"), 2, "low.json",
         says=r"^lapfx: low\.json: /bleeding/speed: -3\b.*\b0 mm/s"),
    Case("check: unknown key, nearest one named", ("check", "typo.json"), 2, "typo.json",
         says=r"/bleeding/sped: .*\bspeed\b"),
    Case("check: an organ that is not there", ("check", "no organ.scene.json"), 2, "no organ.scene.json",
         says=r'/organ/file: "nowhere\.obj": no such file'),
    Case("check: every file is looked at", ("check", "low.json", "good.json", "typo.json"), 2,
         says=r"(?s)^lapfx: note: good\.json: .*\nlapfx: low\.json: .*\nlapfx: typo\.json: ", prints=r"(?s)good\.json.*"),
    Case("inspect: nothing", ("inspect",), 2),
    Case("inspect: missing", ("inspect", "missing.glb"), 2, "missing.glb"),
    Case("inspect: folder", ("inspect", "folder"), 2, "folder"),
    Case("inspect: not a mesh", ("inspect", "words.glb"), 2, "words.glb"),
    Case("render: larger than a frame can be", ("render", "scene.json", "--size", "16384x16384", "--at", "0", "-o",
         "out.png"), 2, says="at most as many as 8192x8192"),
    Case("inspect: names that drive a terminal", ("inspect", "hostile \x1b[31m.obj"), 0,
         prints=r"(?s)hostile \\x1b\[31m\.obj: mesh\n[ -~\n]*liver\\x1b\]0;title\\x07: 2 [ -~\n]*skin\\u202egnp is not[ -~\n]*"),
    Case("inspect: good", ("inspect", "organ.obj"), 0, prints=r"(?s).*\b2\b.*"),
]

RENDERING = [
    Case("render: no scene", ("render", "-o", "out.png"), 2),
    Case("render: no output", RENDER + ("--at", "1"), 2, says="--output"),
    Case("render: missing scene", ("render", "missing.json", "-o", "out.png"), 2, "missing.json"),
    Case("render: folder for a scene", ("render", "folder", "-o", "out.png"), 2, "folder"),
    Case("render: preset for a scene", ("render", "good.json", "-o", "out.png"), 2, "good.json"),
    Case("render: missing preset", RENDER + ("--preset", "missing.json", "-o", "out.png"), 2, "missing.json"),
    Case("render: folder for a preset", RENDER + ("--preset", "folder", "-o", "out.png"), 2, "folder"),
    Case("render: cut off preset", RENDER + ("--preset", "cut off.json", "-o", "out.png"), 2, "cut off.json"),
    Case("render: preset out of range", RENDER + ("--preset", "low.json", "-o", "out.png"), 2, "low.json",
         says=r"/bleeding/speed: -3\b"),
    Case("render: scene without its organ", ("render", "no organ.scene.json", "-o", "out.png"), 2, says="nowhere.obj"),
    Case("render: every file that is missing, and every bad clip", ("render", "nothing there.scene.json", "--preset", "no clips.json", "-o",
         "out.png"), 2, says=r'(?s)^lapfx: nothing there\.scene\.json: /organ/file: "nowhere\.obj": no such file\n'
         r'lapfx: nothing there\.scene\.json: /tool/file: "nowhere\.stl": no such file\n'
         r'lapfx: no clips\.json: /smoke/clips/0/file: nowhere\.mp4: no such clip; [^\n]*\n'
         r'lapfx: no clips\.json: /smoke/clips/1/file: words\.txt: is not a video[^\n]*\n$'),
    Case("render: organ is no mesh", ("render", "bad organ.scene.json", "-o", "out.png"), 2, says="words.json"),
    Case("render: set an unknown key", RENDER + ("--set", "paint=1", "-o", "out.png"), 2, says="paint"),
    Case("render: set without a value", RENDER + ("--set", "bleeding.speed", "-o", "out.png"), 2, says="bleeding.speed"),
    Case("render: no such backend", ("render", "scene.json", "--backend", "paper", "-o", "out.png"), 2, says="paper"),
    Case("render: no such overlay", RENDER + ("--overlay", "bones", "-o", "out.png"), 2, says="bones"),
    Case("render: size in words", ("render", "scene.json", "--size", "large", "-o", "out.png"), 2, says="large"),
    Case("render: size of nothing", ("render", "scene.json", "--size", "0x48", "-o", "out.png"), 2, says="0x48"),
    Case("render: no frames a second", RENDER + ("--fps", "0", "-o", "out.mp4"), 2, says=r"fps"),
    Case("render: backwards", RENDER + ("--from", "2", "--to", "1", "-o", "out.mp4"), 2),
    Case("render: a moment and a stretch", RENDER + ("--at", "1", "--to", "2", "-o", "out.png"), 2),
    Case("render: unknown kind of output", RENDER + ("--at", "1", "-o", "out.paint"), 2, says=r"out\.paint"),
    Case("render: bad input spares an older output",
         ("render", "missing.json", "-o", "kept.png"), 2, "missing.json"),
    Case("render: folder of the output is a file", RENDER + ("--at", "1", "-o", "organ.obj/out.png"), 1,
         says=r"organ\.obj/out\.png"),
    Case("render: video into what is a file", RENDER + ("--to", "0.2", "-o", "organ.obj/out.mp4"), 1,
         says=r"organ\.obj/out\.mp4"),
    Case("render: an image", RENDER + ("--at", "0.5", "-o", "out.png"), 0, leaves=("out.png",),
         then=lambda folder: is_png(folder, "out.png", (64, 48))),
    Case("render: a preset and a value", RENDER + ("--preset", "good.json", "--set", "bleeding.speed=4", "--at", "0.5",
         "-o", "out.png"), 0, leaves=("out.png",), then=lambda folder: is_png(folder, "out.png", (64, 48))),
    Case("render: an overlay of an organ without colours", RENDER + ("--overlay", "vessels", "--at", "0.5", "-o",
         "out.png"), 0, leaves=("out.png",), then=lambda folder: is_png(folder, "out.png", (64, 48))),
    Case("render: layers", RENDER + ("--fps", "2", "--from", "2", "--to", "3", "--layers", "truth", "-o", "out.mp4"), 0,
         leaves=("out.mp4", "truth/amounts.csv") + tuple(f"truth/{name}_000{number}.png" for name in
                                                         ("view", "blood", "veil") for number in (0, 1)),
         then=holds_layers),
    Case("render: layers into what is a file", RENDER + ("--at", "1", "--layers", "organ.obj", "-o", "out.png"), 1,
         "organ.obj"),
    Case("render: layers into no folder", RENDER + ("--at", "1", "--layers", "nowhere/truth", "-o", "out.png"), 1,
         "nowhere/truth"),
    Case("render: a video", RENDER + ("--fps", "10", "--from", "1", "--to", "2", "-o", "out.mp4"), 0,
         leaves=("out.mp4",), then=lambda folder: is_video(folder, "out.mp4", (64, 48), 10)),
    Case("render: a lossless video", RENDER + ("--fps", "10", "--to", "0.3", "--codec", "ffv1", "-o", "out.mkv"), 0,
         leaves=("out.mkv",), then=lambda folder: is_video(folder, "out.mkv", (64, 48), 3)),
    Case("render: a small video", RENDER + ("--fps", "10", "--to", "0.3", "--codec", "h265", "--quality", "small", "-o",
         "out.mp4"), 0, leaves=("out.mp4",), then=lambda folder: is_video(folder, "out.mp4", (64, 48), 3)),
    Case("render: a codec that does not go into the file", RENDER + ("--codec", "ffv1", "-o", "out.mp4"), 2,
         says=r'--codec: "ffv1" does not go into \.mp4; name the file \.mkv or \.avi'),
    Case("render: no such codec", RENDER + ("--codec", "divx", "-o", "out.mp4"), 2,
         says=r'--codec: "divx" is not one of h264, h265, ffv1'),
    Case("render: no such quality", RENDER + ("--quality", "fine", "-o", "out.mp4"), 2,
         says=r'--quality: "fine" is not one of small, good, best'),
    Case("render: a codec of a picture", RENDER + ("--at", "1", "--codec", "h264", "-o", "out.png"), 2,
         says=r'--codec: is of a video; "out\.png" is none'),
    Case("render: quality of a sequence", RENDER + ("--to", "1", "--quality", "best", "-o", "out_%04d.png"), 2,
         says=r'--quality: is of a video; "out_%04d\.png" is none'),
    Case("render: quality of what is lossless", RENDER + ("--codec", "ffv1", "--quality", "best", "-o", "out.mkv"), 2,
         says=r'--quality: "ffv1" is lossless and has none'),
    Case("render: numbered images", RENDER + ("--fps", "10", "--to", "0.3", "-o", "out_%04d.png"), 0,
         leaves=("out_0000.png", "out_0001.png", "out_0002.png"),
         then=lambda folder: is_png(folder, "out_0002.png", (64, 48))),
]

PICTURES = [
    Case("picture: help", ("picture", "--help"), 0, prints=r"(?s).*FILE.*--size.*"),
    Case("picture: no file", ("picture", "-o", "out.png"), 2, says="FILE"),
    Case("picture: no output", ("picture", "organ.obj"), 2, says="--output"),
    Case("picture: missing", ("picture", "missing.mp4", "-o", "out.png"), 2, "missing.mp4"),
    Case("picture: a text", ("picture", "words.txt", "-o", "out.png"), 2, "words.txt", says="is a text"),
    Case("picture: a broken mesh", ("picture", "words.glb", "-o", "out.png"), 2, "words.glb"),
    Case("picture: a preset out of range", ("picture", "low.json", "-o", "out.png"), 2, "low.json",
         says=r"/bleeding/speed: -3\b"),
    Case("picture: a video of it", ("picture", "organ.obj", "-o", "out.mp4"), 2, says=r"out\.mp4"),
    Case("picture: size of nothing", ("picture", "organ.obj", "--size", "0x48", "-o", "out.png"), 2, says="0x48"),
    Case("picture: an organ", ("picture", "organ.obj", "--backend", "osmesa", "--size", "64x48", "-o", "out.png"), 0,
         leaves=("out.png",), then=lambda folder: is_png(folder, "out.png", (64, 48))),
    Case("picture: a scene", ("picture", "scene.json", "--backend", "osmesa", "--size", "64x48", "-o", "out.png"), 0,
         leaves=("out.png",), then=lambda folder: is_png(folder, "out.png", (64, 48))),
    Case("picture: an image keeps its shape", ("picture", "wide.bmp", "--size", "64x48", "-o", "out.png"), 0,
         leaves=("out.png",), then=lambda folder: is_png(folder, "out.png", (64, 16))),
]

# A cell is 64 by 48, a line of text 16, a gap 4 high and wide: editor/commands/sheet.cpp, Layout.
SHEETS = [
    Case("sheet: help", ("sheet", "--help"), 0, prints=r"(?s).*--preset.*--at.*"),
    Case("sheet: no scene", ("sheet", "--at", "1", "-o", "out.png"), 2),
    Case("sheet: no times", SHEET + ("-o", "out.png"), 2, says="--at"),
    Case("sheet: no output", SHEET + ("--at", "1"), 2, says="--output"),
    Case("sheet: missing scene", ("sheet", "missing.json", "--at", "1", "-o", "out.png"), 2, "missing.json"),
    Case("sheet: missing preset", SHEET + ("--preset", "good.json", "--preset", "missing.json", "--at", "1", "-o",
         "out.png"), 2, "missing.json"),
    Case("sheet: preset out of range", SHEET + ("--preset", "low.json", "--at", "1", "-o", "out.png"), 2, "low.json",
         says=r"/bleeding/speed: -3\b"),
    Case("sheet: set an unknown key", SHEET + ("--set", "paint=1", "--at", "1", "-o", "out.png"), 2, says="paint"),
    Case("sheet: time in words", SHEET + ("--at", "1,soon", "-o", "out.png"), 2, says="soon"),
    Case("sheet: no time at all", SHEET + ("--at", "nan", "-o", "out.png"), 2, says="nan"),
    Case("sheet: before the start", SHEET + ("--at", "1,-1", "-o", "out.png"), 2, says="-1"),
    Case("sheet: size of nothing", ("sheet", "scene.json", "--size", "64x0", "--at", "1", "-o", "out.png"), 2,
         says="64x0"),
    Case("sheet: larger than a picture can be", ("sheet", "scene.json", "--size", "9000x100", "--at", "1,2", "-o",
         "out.png"), 2, says="16384"),
    Case("sheet: a video", SHEET + ("--at", "1", "-o", "out.mp4"), 2, says=r"out\.mp4"),
    Case("sheet: folder of the output is missing", SHEET + ("--at", "1", "-o", "nowhere/out.png"), 1,
         says=r"nowhere/out\.png"),
    Case("sheet: two presets, three times", SHEET + ("--preset", "good.json", "--preset", "good.json", "--at", "0.5,1,2",
         "--set", "bleeding.gloss=0.5", "-o", "out.png"), 0, leaves=("out.png",),
         then=lambda folder: is_png(folder, "out.png", (4 + 3 * 68, 16 + 2 * 68))),
    Case("sheet: the scene's own preset", SHEET + ("--at", "0.5", "-o", "out.png"), 0, leaves=("out.png",),
         then=lambda folder: is_png(folder, "out.png", (4 + 68, 16 + 68))),
]


def fill(folder):
    for name, text in FILES.items():
        path = os.path.join(folder, name)
        if text is None:
            os.mkdir(path)
        else:
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)


def contents(folder):
    """{path: bytes} of all files in a folder."""
    found = {}
    for at, _, names in os.walk(folder):
        for name in names:
            try:
                with open(os.path.join(at, name), "rb") as file:
                    found[os.path.relpath(os.path.join(at, name), folder)] = file.read()
            except FileNotFoundError:  # a file that was being written has just got its name
                continue
    return found


def faults_of(case, folder, done, before):
    """Differences from what the case says."""
    if done.returncode != case.code:
        yield f"exit code {done.returncode}, expected {case.code}"
    if case.prints is not None and not re.fullmatch(case.prints, done.stdout):
        yield f"stdout does not match {case.prints!r}"
    lines = done.stderr.splitlines()
    if case.code != 0:
        if not lines:
            yield "no message on stderr"
        for line in lines:
            if not line.startswith("lapfx: ") or not line.isprintable():
                yield f"not a message of lapfx: {line!r}"
    if case.file is not None and not (len(lines) == 1 and lines[0].startswith(f"lapfx: {case.file}: ")):
        yield f"stderr is not the one line 'lapfx: {case.file}: ...'"
    if not re.search(case.says, done.stderr):
        yield f"stderr does not say {case.says!r}"
    after = contents(folder)
    if sorted(set(after) - set(before)) != sorted(case.leaves):
        yield f"left {sorted(set(after) - set(before))}, expected {sorted(case.leaves)}"
    yield from (f"changed {name}" for name in before if after.get(name) != before[name])
    if case.then and done.returncode == 0:
        try:
            case.then(folder)
        except (AssertionError, OSError) as fault:
            yield str(fault)


def run_case(lapfx, case, folder):
    before = contents(folder)
    try:
        done = subprocess.run([lapfx, *case.arguments], cwd=folder, capture_output=True, encoding="utf-8", timeout=LIMIT_S,
                              stdin=subprocess.DEVNULL, check=False)
    except subprocess.TimeoutExpired:
        yield f"not done after {LIMIT_S} s"
        return
    faults = list(faults_of(case, folder, done, before))
    if faults:
        yield from faults
        yield f"stdout: {done.stdout[:2000]!r}"
        yield f"stderr: {done.stderr[:2000]!r}"


def run_interrupted(lapfx, output, number, folder):
    """A render that would take minutes is interrupted while it runs: it ends soon and leaves nothing half done."""
    before = contents(folder)
    with subprocess.Popen([lapfx, "render", "scene.json", "--backend", "osmesa", "--size", "640x480", "--fps", "60",
                           "-o", output], cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, encoding="utf-8") as render:
        # Under way: its files appear, wherever they are being written.
        while render.poll() is None and contents(folder).keys() == before.keys():
            time.sleep(0.02)
        if render.poll() is not None:
            yield f"ended before it was interrupted: {render.returncode}, {render.communicate()}"
            return
        render.send_signal(number)
        try:
            _, messages = render.communicate(timeout=LIMIT_S)
        except subprocess.TimeoutExpired:
            render.kill()
            yield f"still running {LIMIT_S} s after it was interrupted"
            return
    if render.returncode not in (1, 128 + number, -number):
        yield f"exit code {render.returncode} after an interrupt: {messages[-500:]!r}"
    for name in sorted(contents(folder).keys() - before.keys()):
        try:  # finished images of a sequence may stay
            assert "%" in output and re.fullmatch(r"out_\d{4}\.png", name), f"left {name}"
            is_png(folder, name, (640, 480))
        except AssertionError as fault:
            yield str(fault)


def main():
    if len(sys.argv) not in (2, 3):
        print(__doc__)
        return 2
    lapfx = os.path.abspath(sys.argv[1])
    tests = [(case.name, lambda folder, case=case: run_case(lapfx, case, folder))
             for case in USAGE + INPUT + RENDERING + PICTURES + SHEETS]
    for output in ("out.mp4", "out_%04d.png"):
        for number in (signal.SIGINT, signal.SIGTERM):
            tests.append((f"render: {number.name} while it writes {output}",
                          lambda folder, o=output, n=number: run_interrupted(lapfx, o, n, folder)))
    tests = [test for test in tests if len(sys.argv) < 3 or sys.argv[2] in test[0]]
    failed = 0
    for name, test in tests:
        with tempfile.TemporaryDirectory(prefix="lapfx cli ") as folder:
            fill(folder)
            faults = list(test(folder))
        failed += bool(faults)
        if faults:
            print(f"FAILED {name}")
            print("".join(f"    {fault}\n" for fault in faults), end="")
    print(f"{len(tests) - failed} of {len(tests)} cases passed")
    return 1 if failed or not tests else 0


if __name__ == "__main__":
    sys.exit(main())
