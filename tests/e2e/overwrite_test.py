#!/usr/bin/env python3
"""overwrite_test.py LAPFX SAMPLES: no command replaces a file that it reads, or writes two results into one."""
import hashlib
import os
import shutil
import subprocess
import sys
import tempfile

MESH = """mtllib organ.mtl
usemtl skin
v -20 -20 0
v 20 -20 0
v 20 20 0
v -20 20 0
vt 0 0
vt 1 0
vt 1 1
vt 0 1
f 1/1 2/2 3/3
f 1/1 3/3 4/4
"""
SCENE = """{"format": "lapfx.scene", "version": 1, "organ": {"file": "organ.obj"}, "preset": "preset.json",
 "duration": 1, "camera": {"eye": [0, 0, 80], "target": [0, 0, 0]}, "reference": {"file": "reference.mp4"}}"""
PRESET = """{"format": "lapfx.preset", "version": 1, "smoke": {"clips": [{"file": "clip.mp4", "role": "haze"}]}}"""


def run(lapfx, folder, *arguments):
    done = subprocess.run([lapfx, *arguments], capture_output=True, text=True, timeout=600, cwd=folder)
    return done.returncode, done.stdout, done.stderr


def ffmpeg(*arguments):
    subprocess.run(["ffmpeg", "-v", "error", "-y", *arguments], check=True)


def make_inputs(folder, samples):
    def put(name, text):
        with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
            file.write(text)

    put("organ.obj", MESH), put("organ.mtl", "newmtl skin\nmap_Kd skin.png\n")
    put("m.scene.json", SCENE), put("preset.json", PRESET)
    at = lambda name: os.path.join(folder, name)
    moving = "testsrc2=size=160x128:rate=10:duration=0.6"
    ffmpeg("-f", "lavfi", "-i", "color=0xb06050:size=64x64", "-frames:v", "1", at("skin.png"))
    ffmpeg("-f", "lavfi", "-i", moving, "-pix_fmt", "yuv420p", at("reference.mp4"))
    ffmpeg("-f", "lavfi", "-i", moving, "-start_number", "0", at("f_%04d.png"))
    shutil.copyfile(os.path.join(samples, "clips", "haze_rolling.mp4"), at("clip.mp4"))
    shutil.copyfile(at("reference.mp4"), at("video.csv"))
    os.symlink(folder, at("same"))
    os.link(at("reference.mp4"), at("hard.mp4"))


def sums(folder):
    found = {}
    for name in sorted(os.listdir(folder)):
        path = os.path.join(folder, name)
        if os.path.isfile(path):
            found[name] = hashlib.sha256(open(path, "rb").read()).hexdigest()
    return found


def check_reads(lapfx, folder):
    """Each of these names as its output something that it reads."""
    render = ["render", "m.scene.json", "--to", "0.2", "--fps", "10", "--size", "32x32"]
    still = ["m.scene.json", "--at", "0", "--size", "32x32"]
    frames = ["--amounts", "x.csv", "-o", "x_%04d.png"]
    before = sums(folder)
    cases = [
        [*render, "-o", "reference.mp4"], [*render, "-o", "same/reference.mp4"], [*render, "-o", "hard.mp4"],
        [*render, "-o", "clip.mp4"], [*render, "-o", os.path.join(folder, "clip.mp4")],
        ["render", *still, "-o", "skin.png"],
        *([*render, "--amounts", name, "-o", "x_%04d.png"]
          for name in ("m.scene.json", "organ.obj", "organ.mtl", "preset.json", "reference.mp4", "skin.png")),
        ["sheet", *still, "-o", "skin.png"],
        ["picture", "skin.png", "-o", "skin.png"], ["picture", "f_0001.png", "-o", "./f_0001.png"],
        ["measure", "f_%04d.png", "--plot", "f_0002.png", "-o", "a.csv"],
        ["measure", "video.csv", "-o", "video.csv"],
        ["measure", "reference.mp4", "-o", "a.csv", "--overlay", "reference.mp4"],
        ["measure", "reference.mp4", "-o", "a.csv", "--overlay", "hard.mp4"],
        ["compare", "m.scene.json", "reference.mp4", "--json", "preset.json"],
        ["fit", "m.scene.json", "--reference", "reference.mp4", "-o", "preset.json"],
        ["fit", "m.scene.json", "--reference", "reference.mp4", "-o", "new.json", "--csv", "video.csv", "--report",
         "r.html", "--fitted-scene", "m.scene.json"],
        ["edit", "m.scene.json", "--size", "900x700", "--screenshot", "skin.png"],
        *(["edit", "m.scene.json", "--dump-on-close", name]  # refused before there is a window
          for name in ("m.scene.json", "same/organ.obj", "preset.json")),
        [*render, "--beside", "f_%04d.png", "-o", "f_%04d.png"], [*render, "--beside", "hard.mp4", "-o", "hard.mp4"],
    ]
    for case in cases:
        code, said, told = run(lapfx, folder, *case)
        assert code == 2 and said == "", (case, code, said, told)
        assert "is a file that is read here" in told, (case, told)
        left = sums(folder)
        assert left == before, (case, [name for name in left if left[name] != before.get(name)])
    code, _, told = run(lapfx, folder, *render, *frames)
    assert code == 0 and sorted(set(sums(folder)) - set(before)) == ["x.csv", "x_0000.png", "x_0001.png"], told
    code, _, told = run(lapfx, folder, *render, *frames)
    assert code == 0, "results of a run before are replaced: " + told


def check_frames_of_a_sequence(lapfx, folder):
    """The reference is a sequence whose images a rendered sequence would replace one by one."""
    with open(os.path.join(folder, "q.scene.json"), "w", encoding="utf-8") as file:
        file.write(SCENE.replace("reference.mp4", "f_%04d.png"))
    before = sums(folder)
    for name in ("f_%04d.png", "f_000%d.png"):
        code, said, told = run(lapfx, folder, "render", "q.scene.json", "--to", "0.3", "--fps", "10", "--size",
                               "32x32", "-o", name)
        assert code == 2 and "is read here" in told and said == "", (name, code, told)
    assert sums(folder) == before


def check_two_of_one_name(lapfx, folder):
    os.mkdir(os.path.join(folder, "d"))
    render = ["render", "m.scene.json", "--to", "0.2", "--fps", "10", "--size", "32x32"]
    for case, line in (
            ([*render, "--layers", "d", "--amounts", "d/amounts.csv", "-o", "x.mp4"], "--layers: "),
            ([*render, "--layers", "d", "-o", "d/view_%04d.png"], "--layers: "),
            ([*render, "--amounts", "y_0001.png", "-o", "y_%04d.png"], "--amounts: "),
            (["measure", "reference.mp4", "-o", "a.json", "--json", "./a.json"], "--json: ")):
        code, said, told = run(lapfx, folder, *case)
        assert code == 2 and said == "" and told.startswith("lapfx: " + line), (case, code, told)
        assert told.count("\n") == 1 and "is the file of " in told and told.endswith(", too\n"), (case, told)
    assert not os.listdir(os.path.join(folder, "d"))
    assert not [name for name in os.listdir(folder) if name.startswith(("y_", "a."))]


def check_empty(lapfx, folder):
    """An unset variable of a shell is no wish to do without a result."""
    before = sums(folder)
    for case, line in (
            (["render", "m.scene.json", "--at", "0", "--size", "32x32", "-o", ""], "-o: "),
            (["render", "m.scene.json", "--at", "0", "-o", "e.png", "--amounts", ""], "--amounts: "),
            (["measure", "reference.mp4", "-o", "e.csv", "--json", ""], "--json: "),
            (["measure", "reference.mp4", "-o", "e.csv", "--plot="], "--plot: "),
            (["measure", "reference.mp4", "--baseline=", "-o", "e.csv"], "--baseline: "),
            (["fit", "m.scene.json", "--reference", "reference.mp4", "-o", "e.json", "--csv", ""], "--csv: "),
            (["compare", "m.scene.json", "reference.mp4", "--json", ""], "--json: "),
            (["inspect", ""], ""), (["", "x"], "")):
        code, said, told = run(lapfx, folder, *case)
        assert code == 2 and said == "", (case, code, said, told)
        assert told == "lapfx: " + line + '"" is empty; a value is needed here\n', (case, told)
    assert sums(folder) == before
    code, _, told = run(lapfx, folder, "render", "m.scene.json", "--at", "0", "--size", "32x32", "--set",
                        "name=a=", "-o", "e.png")
    assert "is empty" not in told, told


def main():
    lapfx, samples = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
    with tempfile.TemporaryDirectory() as folder:
        make_inputs(folder, samples)
        check_reads(lapfx, folder)
        check_frames_of_a_sequence(lapfx, folder)
        check_two_of_one_name(lapfx, folder)
        check_empty(lapfx, folder)
    print("overwrite: all right")


if __name__ == "__main__":
    main()
