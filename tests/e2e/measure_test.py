#!/usr/bin/env python3
"""measure_test.py LAPFX REFERENCE LIGHT_REFERENCE: `lapfx measure` as a user runs it: what it writes, and what it says
of bad input. LIGHT_REFERENCE is the same video with fewer pixels."""
import csv
import json
import os
import signal
import subprocess
import sys
import tempfile
import time

SPOT = [0.35 * red + 0.65 * yellow for red, yellow in zip((0x78, 6, 8), (240, 228, 66))]  # blood as it is drawn
COLUMNS = ("time,blood,blood_low,blood_high,veil,veil_low,veil_high,flags,"
           "light,light_low,light_high,gain,gain_low,gain_high").split(",")


def run(lapfx, *arguments):
    done = subprocess.run([lapfx, "measure", *arguments], capture_output=True, text=True, timeout=1700)
    return done.returncode, done.stdout, done.stderr


def ffmpeg(*arguments):
    subprocess.run(["ffmpeg", "-v", "error", "-y", *arguments], check=True)


def check_output(lapfx, reference, folder):
    amounts, plot, whole = (os.path.join(folder, name) for name in ("a.csv", "a.png", "a.json"))
    code, said, told = run(lapfx, reference, "--baseline", "0", "--to", "1", "-o", amounts, "--plot", plot)
    assert code == 0, told
    assert said.startswith("baseline: 0.00 s\nblood: peak ") and "\nveil: peak " in said, said
    rows = list(csv.DictReader(open(amounts)))
    assert list(rows[0]) == COLUMNS and len(rows) == 26, (list(rows[0]), len(rows))
    for row in rows:
        for amount in ("blood", "veil"):
            low, value, high = (float(row[amount + end]) for end in ("_low", "", "_high"))
            assert 0 <= low <= value <= high <= 1, row
        assert 0 <= float(row["light_low"]) <= float(row["light"]) <= float(row["light_high"]) <= 1, row
        assert 0 < float(row["gain_low"]) <= 1 <= float(row["gain_high"]), row  # its camera does not change
    assert open(plot, "rb").read(8) == b"\x89PNG\r\n\x1a\n"
    halves = ["--mask", "0,0,320,0,320,512,0,512", "--mask", "0.5,0,1,0,1,0.5,0.5,0.5"]
    masked = os.path.join(folder, "m.json")
    code, _, told = run(lapfx, reference, "--baseline", "0", "--to", "0.2", *halves, "-o", masked)
    assert code == 0, told
    code, _, told = run(lapfx, reference, "--to", "0.4", "-o", whole)
    assert code == 0, told
    found = json.load(open(whole))
    assert found["format"] == "lapfx.amounts" and found["baseline"]["suggested"] and len(found["frames"]) == 11
    share = json.load(open(masked))["frames"][0]["valid"] / found["frames"][0]["valid"]
    assert 0.15 < share < 0.35, share
    polygons = os.path.join(folder, "masks.json")
    with open(polygons, "w", encoding="utf-8") as file:
        file.write("[[[0,0],[320,0],[320,512],[0,512]], [[320,0],[640,0],[640,256],[320,256]]]")
    beside = os.path.join(folder, "beside.json")
    code, _, told = run(lapfx, reference, "--baseline", "0", "--to", "0.2", "--mask", polygons, "-o",
                        os.path.join(folder, "beside.csv"), "--json", beside)
    assert code == 0, told
    assert open(beside, "rb").read() == open(masked, "rb").read(), "a file of polygons is not what they are"
    code, _, told = run(lapfx, reference, "--baseline", "0", "--to", "0.1", "--view", "320,256,100", "-o", whole)
    assert code == 0, told
    disc = json.load(open(whole))["frames"][0]["valid"] * 640 * 512 / (3.14159 * 100 * 100)
    assert 0.75 < disc < 1.02, disc  # what is an instrument there is left out
    first = found["frames"][0]
    assert first["flags"] == "" and first["veil"]["low"] <= first["veil"]["value"] <= first["veil"]["high"], first


def pixels_of(video, frame, width, height):
    """RGB of one frame; a pixel is at 3 * (y * width + x)."""
    raw = subprocess.run(["ffmpeg", "-v", "error", "-i", video, "-vf", f"select=eq(n\\,{frame})", "-frames:v", "1",
                          "-f", "rawvideo", "-pix_fmt", "rgb24", "-"], check=True, capture_output=True).stdout
    assert len(raw) == 3 * width * height, (video, len(raw))
    return raw


def mean_at(pixels, width, x, y, side=8):
    """Mean colour of a square."""
    at = [3 * ((y + j) * width + x + i) for j in range(side) for i in range(side)]
    return [sum(pixels[i + c] for i in at) / len(at) for c in range(3)]


def strokes_over(folder, name, *strokes, **more):
    """A file of strokes, each (time, what it marks, points), 4 px thick at each side."""
    path = os.path.join(folder, name)
    with open(path, "w", encoding="utf-8") as file:
        json.dump({"format": "lapfx.blood_strokes", "version": 1, **more,
                   "strokes": [{"time": time, "marks": marks, "radius": 4, "points": points}
                               for time, marks, points in strokes]}, file)
    return path


def check_strokes(lapfx, reference, folder):
    """A square of blood that the baseline holds already, and all else of the frame: strokes tell it."""
    spot = os.path.join(folder, "there.avi")
    ffmpeg("-i", reference, "-vf", "select=eq(n\\,0),loop=9:1,setpts=N/10/TB,format=bgr0,"
           "drawbox=x=280:y=220:w=80:h=80:color=0x780608:t=fill", "-r", "10", "-frames:v", "10", "-c:v", "ffv1",
           "-pix_fmt", "bgr0", spot)
    blood = (0.5, "blood", [[300, 240], [340, 280]])
    others = [(0.5, "other", points) for points in ([[200, 160], [240, 340]], [[400, 200], [420, 330]],
                                                    [[250, 380], [400, 390]])]
    path = strokes_over(folder, "strokes.json", blood, *others)
    csv_file, json_file, overlay = (os.path.join(folder, "by." + end) for end in ("csv", "json", "mp4"))
    code, _, told = run(lapfx, spot, "--baseline", "0", "--blood", path, "-o", csv_file, "--json", json_file,
                        "--overlay", overlay)
    assert code == 0, told
    assert "Blood is all in view that looks as the strokes of " + path + " say; no frame without blood is known" in told
    found = json.load(open(json_file))
    by_strokes = found["blood_by_strokes"]
    assert by_strokes.pop("found_again") > 0.9, by_strokes
    assert by_strokes == {"file": path, "absolute": True, "without_blood": None, "threshold": 0.9}, by_strokes
    frame = found["frames"][-1]
    share = 80 * 80 / (640 * 512) / frame["valid"]
    value = frame["blood"]["value"]
    assert 0.5 * share < value < 1.1 * share and frame["blood"]["low"] < share < frame["blood"]["high"], (frame, share)
    assert abs(frame["blood"]["low"] - (value / 2 - 0.005)) < 1e-9, frame
    assert abs(frame["blood"]["high"] - (2 * value + 0.005)) < 1e-9, frame
    row = list(csv.DictReader(open(csv_file)))[-1]
    assert abs(float(row["blood"]) - value) < 1e-5 and row["flags"] == "", row
    there = mean_at(pixels_of(overlay, 8, 640, 512), 640, 316, 256)
    assert all(abs(a - b) < 12 for a, b in zip(there, SPOT)), (there, SPOT)
    code, _, told = run(lapfx, spot, "--baseline", "0", "-o", json_file)
    assert code == 0 and "strokes" not in told, told
    plain = json.load(open(json_file))
    assert plain["frames"][-1]["blood"]["value"] < 0.005 and "blood_by_strokes" not in plain, plain["frames"][-1]
    out = os.path.join(folder, "none.csv")
    cases = [
        (strokes_over(folder, "a.json", *others), ": /strokes: no stroke marks blood"),
        (strokes_over(folder, "b.json", blood, (5, "other", [[9, 9]])),
         ": /strokes/1/time: 5.00 s is outside the video (allowed: 0 to 1.00 s)"),
        (strokes_over(folder, "c.json", (0.5, "blood", [[700, 2]])),
         ": /strokes/0/points/0: [700,2] is not inside the picture of 640x512"),
        (strokes_over(folder, "d.json", blood, without_blood=0.5), ": /without_blood: stroke 0 marks blood there"),
        (os.path.join(folder, "nowhere.json"), "nowhere.json")]
    for file, line in cases:
        code, said, told = run(lapfx, spot, "--baseline", "0", "--blood", file, "-o", out)
        assert code == 2 and said == "" and told.count("\n") == 1, (code, told)
        assert told.startswith("lapfx: " + file) and line in told and not os.path.exists(out), (line, told)
    code, _, told = run(lapfx, spot, "--blood", path, "--json", path, "-o", out)
    assert code == 2 and told.count("\n") == 1 and "is a file that is read here" in told, told


def stream_of(video):
    done = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-select_streams", "v:0", "-show_entries",
                           "stream=nb_read_frames,r_frame_rate,width,height", "-of", "json", video],
                          check=True, capture_output=True, text=True)
    return json.loads(done.stdout)["streams"][0]


def check_overlay(lapfx, reference, folder):
    """A still clear view, then a red spot in it: the spot becomes yellow, the rest stays, what is left out is dark."""
    spot, overlay, out = (os.path.join(folder, name) for name in ("spot.mkv", "over.mp4", "over.csv"))
    # 511 rows: the overlay, H.264, has even sides.
    ffmpeg("-i", reference, "-vf", "select=eq(n\\,0),loop=29:1,setpts=N/10/TB,format=bgr0,crop=640:511:0:0,"
           "drawbox=x=300:y=240:w=60:h=60:color=0x780608:t=fill:enable='gte(t,1)'", "-r", "10", "-frames:v", "30",
           "-c:v", "ffv1", "-pix_fmt", "bgr0", spot)
    code, _, told = run(lapfx, spot, "--baseline", "0", "--mask", "0,0,0.4,0,0.4,0.4,0,0.4", "-o", out,
                        "--overlay", overlay)
    assert code == 0, told
    assert stream_of(overlay) == {"width": 640, "height": 512, "r_frame_rate": "10/1", "nb_read_frames": "30"}, \
        stream_of(overlay)
    before, after = pixels_of(spot, 20, 640, 511), pixels_of(overlay, 20, 640, 512)
    there = mean_at(after, 640, 326, 266)
    assert all(abs(a - b) < 12 for a, b in zip(there, SPOT)), (there, SPOT)
    for x, y in ((420, 200), (330, 340)):
        was, now = mean_at(before, 640, x, y), mean_at(after, 640, x, y)
        assert all(abs(a - b) < 8 for a, b in zip(was, now)), (x, y, was, now)
    left_out = mean_at(after, 640, 200, 160, 40), mean_at(before, 640, 200, 160, 40)
    # Seven of ten pixels have 0.45 of their light; the lines of the hatch half of that and half of 150.
    assert all(abs(a - (0.7 * 0.45 + 0.3 * 0.225) * b - 0.3 * 75) < 8 for a, b in zip(*left_out)), left_out
    os.remove(out)
    nowhere = os.path.join(folder, "nowhere", "over.mp4")
    code, said, told = run(lapfx, spot, "-o", out, "--overlay", nowhere)
    assert code == 1 and said == "" and told.count("\n") == 1 and nowhere in told, (code, said, told)
    for name, line in (("over.txt", "is not the name of a video"), (spot, "is a file that is read here")):
        code, said, told = run(lapfx, spot, "-o", out, "--overlay", name)
        assert code == 2 and told.count("\n") == 1 and "--overlay: " in told and line in told, (code, told)
    code, _, told = run(lapfx, spot, "--roi", "0,0,4,4", "-o", out, "--overlay", overlay + ".mp4")
    assert code == 2 and not os.path.exists(overlay + ".mp4"), (code, told)
    assert not os.path.exists(out)

    left = os.path.join(folder, "interrupted")
    os.mkdir(left)
    measuring = subprocess.Popen([lapfx, "measure", reference, "--baseline", "0", "-o", os.path.join(left, "a.csv"),
                                  "--overlay", os.path.join(left, "a.mp4")], stderr=subprocess.PIPE, text=True)
    while measuring.poll() is None and not os.listdir(left):
        time.sleep(0.01)
    measuring.send_signal(signal.SIGINT)
    told = measuring.communicate(timeout=600)[1]
    assert measuring.returncode == 1 and ": measuring: interrupted after " in told, (measuring.returncode, told)
    assert told.count("\n") == 1 and not os.listdir(left), (told, os.listdir(left))


def check_notes(lapfx, light_reference, folder):
    """The shipped reference is clear at its start, of one white balance and without text: nothing else is told."""
    code, _, told = run(lapfx, light_reference, "-o", os.path.join(folder, "notes.csv"))
    assert code == 0, told
    for words in ("hazy", "white balance", "Burnt-in text"):
        assert words not in told, told


def check_faults(lapfx, reference, folder):
    black, one, text = (os.path.join(folder, name) for name in ("black.mp4", "one.png", "text.mp4"))
    ffmpeg("-f", "lavfi", "-i", "color=black:size=160x128:rate=10:duration=1", black)
    ffmpeg("-f", "lavfi", "-i", "color=red:size=160x128", "-frames:v", "1", one)
    open(text, "w").write("no video")
    polygons = os.path.join(folder, "kept.json")
    open(polygons, "w").write("[]")
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
        ([reference, "--redness", "nan", "-o", out], '--redness: "nan" is not a number'),
        ([reference, "--rise", "6", "-o", out], "--rise: "),
        ([reference, "--brightness", "0", "-o", out], "--brightness: "),
        ([reference, "--view", "1,2", "-o", out], '--view: "1,2" is not x,y,r'),
        ([reference, "--mask", "nowhere.json", "-o", out], "nowhere.json"),
        ([reference, "--json", "out.csv", "-o", out], '--json: "out.csv" does not end in .json'),
        ([reference, "--mask", polygons, "--json", polygons, "-o", out], '" is a file that is read here'),
        ([reference, "--mask", "0,0,1,1", "-o", out], '--mask: "0,0,1,1" is not x,y of 3 to 32 corners'),
        ([reference, "--mask", "0,0,1,1,1,x", "-o", out], '--mask: "0,0,1,1,1,x" is not x,y,x,y,x,y'),
        ([reference, "--mask", "0,0,9000,20,3,3", "-o", out],
         '--mask: "0,0,9000,20,3,3" is not inside the picture of 640x512'),
        ([reference, "-o", reference], '--output: "' + reference + '" ends neither in .csv nor in .json'),
        ([reference, "--roi", "0,0,4,4", "-o", out], "--roi: leaves nothing of the view"),
        ([reference, "--mask", "0,0,1,0,1,1,0,1", "-o", out], "--mask: leaves nothing of the view"),
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
    assert code == 0, told
    assert said.startswith("baseline: 0.20 s\nshot 0.80 s to 0.96 s: baseline 0.20 s\nshot 1.00 s to "), said
    assert ": no baseline: no tissue is in view\nblood: not measurable\nveil: not measurable\n" in said, said
    found = json.load(open(out[:-4] + ".json"))
    assert found["veil"]["peak"] is None and found["frames"][-1]["veil"] is None, found["frames"][-1]
    assert "bag" in found["frames"][-1]["flags"].split(" "), found["frames"][-1]
    assert [shot["without"] for shot in found["shots"]] == [None, "bag"], found["shots"]
    code, said, told = run(lapfx, both, "--baseline", "0.2", "--from", "0.8", "-o", out)
    assert code == 0, told
    rows = list(csv.DictReader(open(out)))
    assert rows[0]["veil"] and not rows[0]["flags"], rows[0]
    assert [rows[-1][column] for column in COLUMNS[1:] if column != "flags"] == [""] * 12, rows[-1]
    assert "bag" in rows[-1]["flags"].split(" "), rows[-1]


def duration_of(video):
    done = subprocess.run(["ffprobe", "-v", "error", "-show_entries", "format=duration", "-of", "csv=p=0", video],
                          check=True, capture_output=True, text=True)
    return float(done.stdout)


def check_varying_rate(lapfx, reference, folder):
    """Every third frame of the first second, then every one: the spot comes at its time, in CSV and overlay."""
    varying, overlay, out = (os.path.join(folder, name) for name in ("varying.mkv", "varying.mp4", "varying.csv"))
    ffmpeg("-i", reference, "-vf", "select=eq(n\\,0),loop=74:1,setpts=N/25/TB,format=bgr0,"
           "drawbox=x=300:y=240:w=60:h=60:color=0x780608:t=fill:enable='gte(t,2)',"
           "select='gte(t,1)+not(mod(n,3))'", "-fps_mode", "vfr", "-c:v", "ffv1", "-pix_fmt", "bgr0", varying)
    code, _, told = run(lapfx, varying, "--baseline", "0", "-o", out, "--overlay", overlay)
    assert code == 0, told
    rows = list(csv.DictReader(open(out)))
    assert len(rows) == 59 and abs(float(rows[1]["time"]) - 0.12) < 0.002, (len(rows), rows[1])
    first = next(float(row["time"]) for row in rows if row["blood"] and float(row["blood"]) > 0.005)
    assert abs(first - 2.0) < 0.05, first
    assert abs(duration_of(overlay) - duration_of(varying)) < 0.1, (duration_of(overlay), duration_of(varying))
    rate = eval(stream_of(overlay)["r_frame_rate"])  # a fraction: "59/3"
    before = mean_at(pixels_of(varying, 0, 640, 512), 640, 326, 266)
    for time, wanted in ((1.85, before), (2.15, SPOT)):
        there = mean_at(pixels_of(overlay, round(time * rate), 640, 512), 640, 326, 266)
        assert all(abs(a - b) < 12 for a, b in zip(there, wanted)), (time, there, wanted)


def check_strange_files(lapfx, reference, folder):
    """What a user may come with: a file that was cut short, pixels that are not square, a white balance that drifts."""
    short, squeezed, drifting, out = (os.path.join(folder, name) for name in
                                      ("short.ts", "squeezed.mp4", "drifting.mp4", "strange.csv"))
    whole = os.path.join(folder, "whole.ts")
    ffmpeg("-i", reference, "-t", "2", "-c:v", "mpeg2video", "-q:v", "3", "-an", whole)
    data = open(whole, "rb").read()
    open(short, "wb").write(data[:len(data) * 2 // 3])
    code, _, told = run(lapfx, short, "--baseline", "0", "-o", out)
    assert code == 0, told
    rows = list(csv.DictReader(open(out)))
    assert 20 < len(rows) < 50 and rows[0]["veil"], len(rows)
    for row in rows:  # what cannot be decoded any more has no amounts, and says so
        assert ("missing" in row["flags"].split(" ")) <= (row["veil"] == row["blood"] == ""), row
    ffmpeg("-i", reference, "-t", "0.6", "-vf", "scale=320:512,setsar=2", squeezed)
    code, _, told = run(lapfx, squeezed, "--baseline", "0", "-o", out)
    assert code == 0 and all(row["veil"] for row in csv.DictReader(open(out))), told
    ffmpeg("-i", reference, "-vf", "select=eq(n\\,0),loop=49:1,setpts=N/25/TB,scale=256:205,format=rgb24,"
           "geq=r='r(X,Y)':g='g(X,Y)':b='b(X,Y)*(1+0.1*T)'", "-t", "2", "-r", "25", "-c:v", "libx264", "-qp", "8",
           "-pix_fmt", "yuv444p", drifting)
    code, _, told = run(lapfx, drifting, "--baseline", "0", "-o", out)
    assert code == 0 and "the white balance differs from that of the baseline" in told, told
    rows = list(csv.DictReader(open(out)))
    assert "tinted" not in rows[0]["flags"] and "tinted" in rows[-1]["flags"], (rows[0], rows[-1])


def check_all_hazy(lapfx, reference, folder):
    """Thick smoke over a still view, which becomes thicker: when is told, how much is not."""
    hazy, out, plot = (os.path.join(folder, name) for name in ("hazy.mp4", "hazy.json", "hazy.png"))
    # Into grey by 0.75, from 2 s to 3 s by 0.95.
    mix = "(0.75+0.2*clip(T-2,0,1))"
    ffmpeg("-i", reference, "-vf", "select=eq(n\\,0),loop=99:1,setpts=N/25/TB,scale=160:128,format=rgb24," +
           "geq=" + ":".join(f"{c}='{c}(X,Y)*(1-{mix})+165*{mix}'" for c in "rgb"), "-t", "4", "-r", "25",
           "-c:v", "libx264", "-qp", "8", "-pix_fmt", "yuv444p", hazy)
    code, said, told = run(lapfx, hazy, "-o", out, "--plot", plot)
    assert code == 0, told
    assert said.startswith("baseline: none\nblood: not measurable\nveil: course only, no level, onset 2"), said
    found = json.load(open(out))
    assert found["course_only"] and found["baseline"] is None and found["veil"]["peak"] is None, found["veil"]
    assert found["frames"][10]["veil"] is None and found["frames"][10]["flags"] == "no_baseline", found["frames"][10]
    assert found["frames"][10]["course"] < 0.2 < 0.8 < found["frames"][-1]["course"], found["frames"][-1]
    assert "every frame is hazy" in told, told


def main(lapfx, reference, light_reference):
    with tempfile.TemporaryDirectory() as folder:
        check_output(lapfx, reference, folder)
        check_overlay(lapfx, reference, folder)
        check_strokes(lapfx, reference, folder)
        check_notes(lapfx, light_reference, folder)
        check_faults(lapfx, reference, folder)
        check_nothing_measurable(lapfx, reference, folder)
        check_varying_rate(lapfx, reference, folder)
        check_strange_files(lapfx, reference, folder)
        check_all_hazy(lapfx, reference, folder)
        check_pairs(lapfx, reference, folder)


main(*sys.argv[1:])
