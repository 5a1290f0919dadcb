#!/usr/bin/env python3
"""A host in Python, call by call: writes one frame of a scene as a PPM, without a window. The same bytes as host.c.

    host.py SCENE PRESET CLIPS WIDTH HEIGHT SECONDS > frame.ppm
"""
import sys

import lapfx


def draw(scene, effects, frame, width, height, time):
    view = scene.view(width, height)
    effects.seek(time)
    frame.begin(width, height)
    effects.draw_organ(view)
    frame.begin_smoke()
    effects.draw_smoke(view, frame.depth())
    return frame.read(scene.response())


def main(scene_file, preset_file, clips, width, height, seconds):
    width, height, time = int(width), int(height), float(seconds)
    scene = lapfx.Scene(scene_file)
    info, events = scene.info(), scene.events()
    with lapfx.Context("osmesa") as context, lapfx.Frame(context) as frame, lapfx.Effects(
            context, scene.load_organ(), lapfx.Preset(preset_file), seed=info.seed, gravity=info.gravity,
            clip_folders=[clips], wait_for_clips=True) as effects:
        effects.set_curves(scene)
        for count, event in enumerate(events, 1):
            if event.time <= time:  # what the hand has done, as it went on
                effects.set_contacts(events[:count])
                effects.seek(event.time)
        picture = draw(scene, effects, frame, width, height, time)
    sys.stdout.buffer.write(b"P6\n%d %d\n255\n" % (width, height) + picture[..., :3].tobytes())


if __name__ == "__main__":
    if len(sys.argv) != 7:
        sys.exit("usage: host.py SCENE PRESET CLIPS WIDTH HEIGHT SECONDS")
    try:
        main(*sys.argv[1:])
    except lapfx.Error as error:
        sys.exit(f"host.py: {error}")
