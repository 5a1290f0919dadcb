#!/usr/bin/env python3
"""A host with an organ shader of its own (samples/host/host.cpp, "own") has its blood where lapfx has it.

    own_shader_test.py LAPFX LAPFX_HOST ROOT

Each draws one view of the liver lobe with and without blood; where the two pictures of one program differ, there is
blood. The masks of the two programs agree, but for pixels beside the edge of either, which lapfx smooths.
"""
import json
import os
import subprocess
import sys
import tempfile

WIDTH, HEIGHT, SECONDS = 320, 256, "5"
TOLD = 6  # code values; beyond what another rounding makes


def preset(bleeds):
    extent = 14 if bleeds else 0
    return {"format": "lapfx.preset", "version": 1, "name": "blood only",
            "bleeding": {"speed": 4, "max_extent": extent, "noise_strength": 3 if bleeds else 0, "threshold": 0.3,
                         "gravity_bias": 0.5, "rivulets": 1}}


def scene(root):
    cut = [{"action": "cut", "time": 0, "duration": 0.2, "position": place} for place in ([0, 9, 23], [30, 24, 15])]
    return {"format": "lapfx.scene", "version": 1, "name": "own shader", "seed": 3, "duration": 10,
            "organ": {"file": os.path.join(root, "samples/liver_lobe.glb")}, "events": cut,
            "camera": {"eye": [20, 10, 120], "target": [5, 0, 0], "field_of_view": 55, "vignette": 0, "exposure": 1.5}}


def run(command, **more):
    done = subprocess.run(command, stdout=subprocess.PIPE, check=False, **more)
    assert done.returncode == 0, f"{command[0]}: exit code {done.returncode}"
    return done.stdout


def core_pixels(lapfx, folder, name):
    picture = os.path.join(folder, name + ".png")
    run([lapfx, "render", os.path.join(folder, "scene.json"), "--preset", os.path.join(folder, name + ".json"), "--at",
         SECONDS, "--size", f"{WIDTH}x{HEIGHT}", "--backend", "osmesa", "-o", picture])
    return run(["ffmpeg", "-v", "error", "-i", picture, "-f", "rawvideo", "-pix_fmt", "rgb24", "-"])


def host_pixels(host, folder, name):
    ppm = run([host, os.path.join(folder, "scene.json"), os.path.join(folder, name + ".json"), folder, "own", str(WIDTH),
               str(HEIGHT), SECONDS])
    header = f"P6\n{WIDTH} {HEIGHT}\n255\n".encode()
    assert ppm.startswith(header) and len(ppm) == len(header) + 3 * WIDTH * HEIGHT, "not the PPM that was asked for"
    return ppm[len(header):]


def mask(bleeding, dry):
    assert len(bleeding) == len(dry) == 3 * WIDTH * HEIGHT
    return {i // 3 for i in range(len(dry)) if abs(bleeding[i] - dry[i]) > TOLD}


def beside_edge(pixels):
    """Whether a pixel has neighbours inside and outside of a mask."""
    around = [dy * WIDTH + dx for dy in (-1, 0, 1) for dx in (-1, 0, 1)]
    return lambda pixel: len({pixel + step in pixels for step in around}) > 1


def main():
    lapfx, host, root = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        for name, text in (("scene", scene(root)), ("blood", preset(True)), ("dry", preset(False))):
            with open(os.path.join(folder, name + ".json"), "w", encoding="utf-8") as file:
                json.dump(text, file)
        core = mask(core_pixels(lapfx, folder, "blood"), core_pixels(lapfx, folder, "dry"))
        own = mask(host_pixels(host, folder, "blood"), host_pixels(host, folder, "dry"))
    share = len(core) / (WIDTH * HEIGHT)
    apart = sum(1 for pixel in core ^ own if not beside_edge(core)(pixel)) / max(len(core), 1)
    area = len(own) / max(len(core), 1)
    print(f"blood covers {share:.3f} of lapfx's picture; the host's is {area:.3f} as large, {apart:.5f} of it elsewhere")
    assert share > 0.05, "too little blood to compare"
    assert apart < 0.002, "the host's blood is not where lapfx has it"
    assert abs(area - 1) < 0.04, "the host has more or less blood than lapfx"


if __name__ == "__main__":
    main()
