#!/usr/bin/env python3
"""A host with an organ shader of its own (samples/host/host.cpp, "own") has its blood and smoke where lapfx has them.

    own_shader_test.py LAPFX LAPFX_HOST ROOT

Each draws one view of the liver lobe with and without blood; where the two pictures of one program differ, there is
blood. The masks of the two programs agree, but for pixels beside the edge of either, which lapfx smooths; and where one
has more of it over the tissue, so has the other. Smoke over what is not organ is the same to the last bit.
"""
import json
import os
import shutil
import statistics
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


def smoke_preset():
    plume, haze = ({"file": "plume_thick.mp4", "role": role} for role in ("plume", "haze"))
    return {**preset(False), "smoke": {"clips": [plume, haze]}}


def scene(root, action="cut", duration=0.2):
    events = [{"action": action, "time": 0, "duration": duration, "position": place}
              for place in ([0, 9, 23], [30, 24, 15])]
    return {"format": "lapfx.scene", "version": 1, "name": "own shader", "seed": 3, "duration": 10,
            "organ": {"file": os.path.join(root, "samples/liver_lobe.glb")}, "events": events,
            "camera": {"eye": [20, 10, 120], "target": [5, 0, 0], "field_of_view": 55, "vignette": 0, "exposure": 1.5}}


def run(command, **more):
    done = subprocess.run(command, stdout=subprocess.PIPE, check=False, **more)
    assert done.returncode == 0, f"{command[0]}: exit code {done.returncode}"
    return done.stdout


def core_pixels(lapfx, folder, name, tool="scene"):
    picture = os.path.join(folder, "core.png")
    run([lapfx, "render", os.path.join(folder, tool + ".json"), "--preset", os.path.join(folder, name + ".json"), "--at",
         SECONDS, "--size", f"{WIDTH}x{HEIGHT}", "--backend", "osmesa", "-o", picture])
    return run(["ffmpeg", "-v", "error", "-i", picture, "-f", "rawvideo", "-pix_fmt", "rgb24", "-"])


def host_pixels(host, folder, name, tool="scene"):
    ppm = run([host, os.path.join(folder, tool + ".json"), os.path.join(folder, name + ".json"), folder, "own", str(WIDTH),
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


def order(values):
    """The rank of each; equal ones share theirs."""
    by_value = sorted(range(len(values)), key=values.__getitem__)
    ranks, begin = [0.0] * len(values), 0
    while begin < len(by_value):
        end = begin
        while end < len(by_value) and values[by_value[end]] == values[by_value[begin]]:
            end += 1
        for index in by_value[begin:end]:
            ranks[index] = (begin + end - 1) / 2
        begin = end
    return ranks


def agreement(first, second):
    """Rank correlation (Spearman's): 1 where both have the same order."""
    ranks = order(first), order(second)
    mean = (len(first) - 1) / 2
    products = [sum((a - mean) * (b - mean) for a, b in zip(ranks[i], ranks[j])) for i, j in ((0, 1), (0, 0), (1, 1))]
    return products[0] / max((products[1] * products[2]) ** 0.5, 1e-9)


def left_of_tissue(bleeding, dry, pixels):
    """How much of the tissue's green remains under blood, which absorbs green most."""
    return [(bleeding[3 * i + 1] + 1) / (dry[3 * i + 1] + 1) for i in pixels]


def off_organ(*pictures):
    """Pixels of the background, which the first one is, as are those around them."""
    empty = {i for i in range(WIDTH * HEIGHT) if all(picture[3 * i:3 * i + 3] == picture[:3] for picture in pictures)}
    around = [dy * WIDTH + dx for dy in (-2, -1, 0, 1, 2) for dx in (-2, -1, 0, 1, 2)]
    return [i for i in empty if all(i + step in empty or not 0 <= i + step < WIDTH * HEIGHT for step in around)]


def main():
    lapfx, host, root = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        shutil.copy(os.path.join(root, "samples/clips/plume_thick.mp4"), folder)
        for name, text in (("scene", scene(root)), ("burn", scene(root, "cauterise", 6)), ("blood", preset(True)),
                           ("dry", preset(False)), ("smoke", smoke_preset())):
            with open(os.path.join(folder, name + ".json"), "w", encoding="utf-8") as file:
                json.dump(text, file)
        pictures = (("blood", "scene"), ("dry", "scene"), ("smoke", "burn"))
        core = {name: core_pixels(lapfx, folder, name, tool) for name, tool in pictures}
        own = {name: host_pixels(host, folder, name, tool) for name, tool in pictures}
    core_mask, own_mask = (mask(picture["blood"], picture["dry"]) for picture in (core, own))
    share = len(core_mask) / (WIDTH * HEIGHT)
    apart = sum(1 for pixel in core_mask ^ own_mask if not beside_edge(core_mask)(pixel)) / max(len(core_mask), 1)
    area = len(own_mask) / max(len(core_mask), 1)
    print(f"blood covers {share:.3f} of lapfx's picture; the host's is {area:.3f} as large, {apart:.5f} of it elsewhere")
    assert share > 0.05, "too little blood to compare"
    assert apart < 0.002, "the host's blood is not where lapfx has it"
    assert abs(area - 1) < 0.04, "the host has more or less blood than lapfx"

    both = sorted(core_mask & own_mask)
    left = [left_of_tissue(picture["blood"], picture["dry"], both) for picture in (core, own)]
    depth, middle = agreement(*left), [statistics.median(one) for one in left]
    print(f"what is left of the tissue under blood has the same order: {depth:.3f}")
    print(f"half of them keep less than {middle[0]:.3f} of its green, {middle[1]:.3f} in the host's picture")
    assert depth > 0.55, "the host's blood is deep where lapfx's is not"

    assert 0.5 < middle[1] / middle[0] < 2, "the host's blood is deeper or shallower"

    assert core["dry"][:3] == own["dry"][:3], "the background is another"
    bare = off_organ(core["dry"], own["dry"])
    smoky = {core["smoke"][3 * i:3 * i + 3] for i in bare}
    wrong = [i for i in bare if core["smoke"][3 * i:3 * i + 3] != own["smoke"][3 * i:3 * i + 3]]
    print(f"smoke beside the organ: {len(smoky)} colours in {len(bare)} pixels; the host's is another in {len(wrong)}")
    assert len(bare) > 10000 and len(smoky) > 50, "too little smoke to compare"
    assert not wrong, "smoke over the host's own picture is not lapfx's"


if __name__ == "__main__":
    main()
