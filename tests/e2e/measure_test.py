#!/usr/bin/env python3
"""measure_test.py LAPFX REFERENCE: `lapfx measure` as a user runs it: what it writes, and what it says of bad input."""
import csv
import json
import os
import subprocess
import sys
import tempfile

COLUMNS = "time,blood,blood_low,blood_high,smoke,smoke_low,smoke_high,valid,likeness,told".split(",")


def run(lapfx, *arguments):
    done = subprocess.run([lapfx, "measure", *arguments], capture_output=True, text=True, timeout=1700)
    return done.returncode, done.stdout, done.stderr


def ffmpeg(*arguments):
    subprocess.run(["ffmpeg", "-v", "error", "-y", *arguments], check=True)


def check_output(lapfx, reference, folder):
    amounts, plot, whole = (os.path.join(folder, name) for name in ("a.csv", "a.png", "a.json"))
    code, said, told = run(lapfx, reference, "--baseline", "0", "--to", "1", "-o", amounts, "--plot", plot)
    assert code == 0, told
    assert said.startswith("baseline: 0.00 s\nblood: peak ") and "\nsmoke: peak " in said, said
    rows = list(csv.DictReader(open(amounts)))
    assert list(rows[0]) == COLUMNS and len(rows) == 26, (list(rows[0]), len(rows))
    for row in rows:
        for amount in ("blood", "smoke"):
            low, value, high = (float(row[amount + end]) for end in ("_low", "", "_high"))
            assert 0 <= low <= value <= high <= 1, row
    assert open(plot, "rb").read(8) == b"\x89PNG\r\n\x1a\n"
    halves = ["--mask", "0,0,320,0,320,512,0,512", "--mask", "0.5,0,1,0,1,0.5,0.5,0.5"]
    masked = os.path.join(folder, "m.csv")
    code, _, told = run(lapfx, reference, "--baseline", "0", "--to", "0.2", *halves, "-o", masked)
    assert code == 0, told
    share = float(next(csv.DictReader(open(masked)))["valid"]) / float(rows[0]["valid"])
    assert 0.15 < share < 0.35, share
    code, _, told = run(lapfx, reference, "--to", "0.4", "-o", whole)
    assert code == 0, told
    found = json.load(open(whole))
    assert found["format"] == "lapfx.amounts" and found["baseline"]["suggested"] and len(found["frames"]) == 11


def check_notes(lapfx, reference, folder):
    """The shipped reference is clear at its start, of one white balance and without text: nothing else is told."""
    code, _, told = run(lapfx, reference, "-o", os.path.join(folder, "notes.csv"))
    assert code == 0, told
    for words in ("hazy", "white balance", "Burnt-in text"):
        assert words not in told, told


def check_faults(lapfx, reference, folder):
    black, one, text = (os.path.join(folder, name) for name in ("black.mp4", "one.png", "text.mp4"))
    ffmpeg("-f", "lavfi", "-i", "color=black:size=160x128:rate=10:duration=1", black)
    ffmpeg("-f", "lavfi", "-i", "color=red:size=160x128", "-frames:v", "1", one)
    open(text, "w").write("no video")
    out = os.path.join(folder, "out.csv")
    cases = [
        (["missing.mp4", "-o", out], "missing.mp4: "),
        ([text, "-o", out], text + ": "),
        ([black, "-o", out], black + ": has no frame that shows anything: all are black or missing"),
        ([one, "-o", out], one + ": has one frame; measuring compares frames with a clear one of the same view"),
        ([reference, "--baseline", "99", "-o", out],
         reference + ": --baseline: 99.00 s is outside the video (allowed: 0 to "),
        ([reference, "--from", "3", "--to", "2", "-o", out], reference + ": --to: 2.00 s is before from, 3.00 s"),
        ([reference, "--baseline", "nan", "-o", out], "--baseline: "),
        ([reference, "--roi", "1,2,3", "-o", out], '--roi: "1,2,3" is not x,y,width,height'),
        ([reference, "--roi", "0,0,9000,20", "-o", out], '--roi: "0,0,9000,20" is not inside the picture of 640x512'),
        ([reference, "--redness", "0", "-o", out], "--redness: "),
        ([reference, "--rise", "6", "-o", out], "--rise: "),
        ([reference, "--brightness", "0", "-o", out], "--brightness: "),
        ([reference, "--mask", "0,0,1,1", "-o", out], '--mask: "0,0,1,1" is not x,y of 3 to 32 corners'),
        ([reference, "--mask", "0,0,1,1,1,x", "-o", out], '--mask: "0,0,1,1,1,x" is not x,y,x,y,x,y'),
        ([reference, "--mask", "0,0,9000,20,3,3", "-o", out],
         '--mask: "0,0,9000,20,3,3" is not inside the picture of 640x512'),
        ([reference, "-o", reference], '--output: "' + reference + '" ends neither in .csv nor in .json'),
        ([reference, "--roi", "0,0,4,4", "-o", out], "--roi: leaves nothing of the view"),
        ([reference], "--output is required"),
    ]
    for arguments, line in cases:
        code, said, told = run(lapfx, *arguments)
        assert code == 2, f"{arguments}: {code}\n{told}"
        assert said == "" and told.startswith("lapfx: ") and told.count("\n") == 1, f"{arguments}: {told}"
        assert line in told, f"{arguments}: {told}"
        assert not os.path.exists(out), f"{arguments} left a file"
    code, _, told = run(lapfx, reference, "--to", "0.2", "-o", os.path.join(folder, "no", "out.csv"))
    assert code == 1 and told.count("\n") == 1, told


def bench_pairs(lapfx, *arguments):
    done = subprocess.run([lapfx, "bench", "measure", "--pairs", *arguments], capture_output=True, text=True,
                          timeout=1700)
    return done.returncode, done.stdout, done.stderr


def check_pairs(lapfx, reference, folder):
    """Smoke is over the end of the reference: cut into a clear and a smoky video, they rank right."""
    smoky, clear, black = (os.path.join(folder, name) for name in ("smoky", "clear", "black"))
    for place in (smoky, clear, black):
        os.mkdir(place)
    ffmpeg("-ss", "7.4", "-i", reference, "-frames:v", "8", os.path.join(smoky, "a.mp4"))
    ffmpeg("-i", reference, "-frames:v", "6", os.path.join(clear, "a.mp4"))
    figures = os.path.join(folder, "pairs.json")
    code, said, told = bench_pairs(lapfx, smoky, clear, "--json", figures)
    assert code == 0, told
    assert "right" in said and "a.mp4 and a.mp4: 8 and 6 frames; only the first 6 are compared" in said, said
    found = json.load(open(figures))
    assert found["ratios"] == {"smoky_ranked_above_clear": 1.0}, found["ratios"]
    measured = found["results"][0]
    assert measured["frames"] == 2 and measured["frames_not_measurable"] == 0, measured
    ffmpeg("-f", "lavfi", "-i", "color=black:size=640x512:rate=25:duration=0.2", os.path.join(black, "a.mp4"))
    code, said, told = bench_pairs(lapfx, black, clear)
    assert code == 2 and told.count("\n") == 1, (code, told)
    assert os.path.join(black, "a.mp4") + ": has no frame to compare with " in told, told
    code, said, told = bench_pairs(lapfx, os.path.join(folder, "none"), clear)
    assert code == 2 and os.path.join(folder, "none") + ": cannot be read" in told, told


def check_nothing_measurable(lapfx, reference, folder):
    """Tissue for a moment, then a title card: with the tissue as baseline nothing of the card is measurable."""
    card, both = (os.path.join(folder, name) for name in ("card.mp4", "both.mp4"))
    ffmpeg("-f", "lavfi", "-i", "color=white:size=640x512:rate=25:duration=1", "-pix_fmt", "yuv420p", card)
    ffmpeg("-i", reference, "-i", card, "-filter_complex",
           "[0:v]trim=end=1,setpts=PTS-STARTPTS,setsar=1,format=yuv420p[a];[1:v]setsar=1[b];[a][b]concat=n=2:v=1:a=0",
           both)
    out = os.path.join(folder, "card.csv")
    code, said, told = run(lapfx, both, "--baseline", "0.2", "--from", "1.2", "-o", out)
    assert code == 2 and said == "" and told.count("\n") == 1, (code, said, told)
    assert both + ": has no frame that is measurable with the baseline at 0.20 s" in told, told
    assert not os.path.exists(out)
    code, said, told = run(lapfx, both, "--baseline", "0.2", "--from", "0.8", "-o", out[:-4] + ".json")
    assert code == 0 and "blood: not measurable\nsmoke: not measurable\n" in said, (code, said, told)
    assert json.load(open(out[:-4] + ".json"))["smoke"]["peak"] is None


def main(lapfx, reference):
    with tempfile.TemporaryDirectory() as folder:
        check_output(lapfx, reference, folder)
        check_notes(lapfx, reference, folder)
        check_faults(lapfx, reference, folder)
        check_nothing_measurable(lapfx, reference, folder)
        check_pairs(lapfx, reference, folder)


main(*sys.argv[1:])
