#!/usr/bin/env python3
"""The sample host for two eyes (samples/host/stereo.cpp): without a distance between them both see what the host in a
window sees; with one, blood is where either eye would see the wound.

    stereo_test.py LAPFX_HOST LAPFX_HOST_STEREO ROOT

77 where EGL gives no context without a window.
"""
import json
import math
import os
import subprocess
import sys
import tempfile

WIDTH, HEIGHT, SECONDS = 320, 256, "4"
EYE, TARGET, WOUND, FIELD_DEG = (0, 9, 100), (0, 9, 0), (0, 9, 23), 40
SKIP = 77


def scene(root):
    return {"format": "lapfx.scene", "version": 1, "name": "stereo", "seed": 3, "duration": 10,
            "organ": {"file": os.path.join(root, "samples/liver_lobe.glb")},
            "events": [{"action": "cut", "time": 0.2, "duration": 0.2, "position": WOUND}],
            "camera": {"eye": EYE, "target": TARGET, "field_of_view": FIELD_DEG, "vignette": 0}}


def ppm(command, width):
    done = subprocess.run(command, capture_output=True, check=False)
    if done.returncode == SKIP:
        print(f"stereo: {done.stderr.decode().strip()}")
        sys.exit(SKIP)
    assert done.returncode == 0, done.stderr.decode()
    header = f"P6\n{width} {HEIGHT}\n255\n".encode()
    assert done.stdout.startswith(header) and len(done.stdout) == len(header) + 3 * width * HEIGHT
    return done.stdout[len(header):]


def halves(picture):
    row = 2 * 3 * WIDTH
    rows = [picture[begin:begin + row] for begin in range(0, len(picture), row)]
    return [b"".join(one[side * 3 * WIDTH:(side + 1) * 3 * WIDTH] for one in rows) for side in (0, 1)]


def blood_column(bloody, bare):
    """Where blood is on average across the picture, in pixels from its left edge."""
    columns = [i % WIDTH for i in range(WIDTH * HEIGHT)
               if any(abs(bloody[3 * i + c] - bare[3 * i + c]) > 6 for c in range(3))]
    assert len(columns) > 100, f"{len(columns)} pixels of blood"
    return sum(columns) / len(columns) + 0.5


def expected_column(side):
    """Of the wound, seen from `side` mm right of the middle; the frustum meets that of the middle at the target."""
    per_mm = HEIGHT / 2 / math.tan(math.radians(FIELD_DEG) / 2)
    near, far = EYE[2] - WOUND[2], EYE[2] - TARGET[2]
    return WIDTH / 2 - side * per_mm * (1 / near - 1 / far)


def main():
    host, stereo, root = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        def at(name, text):
            path = os.path.join(folder, name + ".json")
            with open(path, "w", encoding="utf-8") as file:
                json.dump(text, file)
            return path

        blood = {"speed": 3, "max_extent": 8, "noise_strength": 0, "gravity_bias": 0, "crease_bias": 0}
        preset = {"format": "lapfx.preset", "version": 1, "name": "blood only"}
        shown = at("scene", scene(root))
        bloody = at("bloody", {**preset, "bleeding": blood})
        bare = at("bare", {**preset, "bleeding": {**blood, "max_extent": 0, "threshold": 10}})

        def seen(preset_file, eyes):
            return halves(ppm([stereo, shown, preset_file, folder, str(WIDTH), str(HEIGHT), SECONDS, str(eyes)], 2 * WIDTH))

        alone = ppm([host, shown, bloody, folder, "lapfx", str(WIDTH), str(HEIGHT), SECONDS], WIDTH)
        left, right = seen(bloody, 0)
        assert left == right, "two eyes at one place see two pictures"
        worst = max(abs(a - b) for a, b in zip(left, alone))
        assert worst <= 1, f"an eye sees another picture than the host in a window: {worst} of 255"
        eyes = 12
        for side, bloody_half, bare_half in zip((-eyes / 2, eyes / 2), seen(bloody, eyes), seen(bare, eyes)):
            found, wanted = blood_column(bloody_half, bare_half), expected_column(side)
            print(f"{side:+.0f} mm: blood at column {found:.1f}, the wound at {wanted:.1f}")
            assert abs(found - wanted) < 2.0
    return 0


if __name__ == "__main__":
    sys.exit(main())
