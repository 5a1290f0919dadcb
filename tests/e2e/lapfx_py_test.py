#!/usr/bin/env python3
"""lapfx.py as it was installed: its structs are those of the header, its pictures the host's, and what is wrong raises.

    lapfx_py_test.py STRUCTS SCENE PRESET CLIPS

STRUCTS has a line for each struct: its name in lapfx.py, its size, the bytes of its initialiser. Python finds lapfx.py
by PYTHONPATH.
"""
import ctypes
import gc
import logging
import os
import sys
import threading
import time

import numpy

import lapfx


def fails(kind, text, body, *arguments, **more):
    """That the call raises `kind`, and nothing more special, with `text` in its message."""
    try:
        body(*arguments, **more)
    except lapfx.Error as error:
        assert type(error) is kind and text in str(error), f"{type(error).__name__}: {error}; expected {kind.__name__}: {text}"
        return
    raise AssertionError(f"did not fail; expected {kind.__name__}: {text}")


def check_structs(lines):
    for name, size, *data in map(str.split, lines):
        kind = getattr(lapfx, name)
        assert ctypes.sizeof(kind) == int(size), f"{name}: {ctypes.sizeof(kind)} bytes; {size} in lapfx.h"
        assert not data or bytes(kind()).hex() == data[0], f"{name}: other defaults than in lapfx.h"
    fails(lapfx.BadInput, "action: stab is not one of cauterise, cut,", lapfx.Contact, action="stab")
    fails(lapfx.BadInput, "position: 2 numbers; expected 3", lapfx.Contact, position=(1, 2))
    fails(lapfx.BadInput, "view: 1 numbers; expected 16", lapfx.View.of, [[1]], numpy.eye(4))
    moved = numpy.eye(4)
    moved[2, 3] = -50
    assert lapfx.View.of(moved, numpy.eye(4), haze=0).view[14] == -50, "column by column"
    assert lapfx.Contact(action="tear").action == 3 and "action=3" in repr(lapfx.Contact(action="tear"))


def check_pictures(scene, preset, clips):
    several = lapfx.render(scene, preset, times=[5.5, 0], size=(160, 128), clip_folders=[clips], backend="osmesa")
    assert several.shape == (2, 128, 160, 3) and several.dtype == numpy.uint8
    with lapfx.Player(scene, preset, size=(160, 128), clip_folders=[clips], backend="osmesa") as player:
        again = player.picture(0)
        assert again.shape == (128, 160, 4) and (again[..., :3] == several[1]).all() and (again[..., 3] == 255).all()
        assert (player.picture(5.5)[..., :3] == several[0]).all(), "another picture when time goes on"
        amounts, before = player.effects.amounts(), player.preset["bleeding.speed"]
        assert amounts.wounds == len([w for w in player.effects.wounds() if w.start <= 5.5]) > 0 and amounts.blood_area > 100
        player.preset["bleeding.speed"] = before / 2
        player.effects.set_preset(player.preset)
        slower = player.picture(5.5)
        assert player.preset["bleeding.speed"] == before / 2
        assert 0 < player.effects.amounts().blood_area < amounts.blood_area and (slower[..., :3] != several[0]).any()
        fails(lapfx.BadInput, "bleeding.sped: no such parameter; nearest is bleeding.speed", player.preset.__setitem__,
              "bleeding.sped", 3)
        assert player.effects.memory().total > 1e6
        into = numpy.zeros((128, 160, 4), numpy.uint8)
        player.frame.read(player.scene.response(), out=into)
        assert (into == slower).all()
        fails(lapfx.BadInput, "bytes: 4; a picture of 160x128 pixels has 81920", player.frame.read,
              out=numpy.zeros(4, numpy.uint8))
    fails(lapfx.Misuse, "effects is no lapfx_effects that lives", player.effects.seek, 0.0)
    effects = lapfx.Player(scene, preset, size=(16, 16), clip_folders=[clips], backend="osmesa").effects
    gc.collect()
    assert effects.amounts().wounds >= 0, "a player that is collected leaves what the caller holds"
    ignored = []
    sys.unraisablehook = ignored.append
    fails(lapfx.BadInput, "none.json", lapfx.Player, "none.json")
    gc.collect()
    sys.unraisablehook = sys.__unraisablehook__
    assert not ignored, ignored


def square(count=41, side=60.0):
    """A flat square, facing +z."""
    line = numpy.linspace(-side / 2, side / 2, count)
    x, y = numpy.meshgrid(line, line)
    positions = numpy.stack([x, y, numpy.zeros_like(x)], -1).reshape(-1, 3)
    corner = (numpy.arange(count - 1)[:, None] * count + numpy.arange(count - 1)).reshape(-1, 1)
    return positions, numpy.concatenate([corner + [0, 1, count + 1], corner + [0, count + 1, count]])


def check_arrays(preset):
    positions, triangles = square()
    organ = lapfx.Organ.of(positions, triangles)
    assert (organ.positions == positions.astype(numpy.float32)).all() and (organ.triangles == triangles).all()
    assert numpy.allclose(organ.normals, [0, 0, 1]) and organ.uvs.shape == (1681, 2) and (organ.colors == 1).all()
    fails(lapfx.BadInput, "positions: an array of the shape (3,); expected (vertices, 3)", lapfx.Organ.of, [1, 2, 3], triangles)
    fails(lapfx.BadInput, "normals: an array of the shape (2, 3); expected (1681, 3)", lapfx.Organ.of, positions, triangles,
          normals=positions[:2])
    with lapfx.Context("osmesa") as context, lapfx.Effects(context, organ, preset, clip_folders=[]) as effects:
        hit = effects.pick((1, 2, 50), (0, 0, -1))
        assert list(hit.position) == [1, 2, 0] and hit.distance == 50 and effects.pick((1, 2, 50), (0, 0, 1)) is None
        effects.set_contacts([lapfx.Contact(action="cut", position=(0, 0, 0), to=(5, 0, 0))])
        effects.seek(3)
        assert effects.amounts().bleeding_wounds > 0 and len(effects.contacts()) == 1
        fails(lapfx.BadInput, "contacts[1].action: 7 is not one of 0 to 6", effects.set_contacts,
              [lapfx.Contact(), lapfx.Contact(action=7)])
        assert len(effects.contacts()) == 1, "of a list with a fault nothing is taken"
        effects.set_shape(positions + [0, 0, 10])
        assert effects.pick((1, 2, 50), (0, 0, -1)).distance == 40
        fails(lapfx.BadInput, "vertex_count: 2; the organ has 1681 vertices", effects.set_shape, positions[:2])
        fails(lapfx.BadInput, "time: nan is no finite number", effects.seek, float("nan"))
        check_threads(effects)
        other = lapfx.Organ.of(positions * 0.5 + [0, 0, 7], triangles)
        fails(lapfx.Misuse, "call lapfx_organ_prepare before", effects.set_organ, other)
        other.prepare(preset)
        assert not effects.organ_coming()
        effects.set_organ(other, [lapfx.Contact(action="cut", position=(0, 0, 7), to=(1, 0, 7))])
        assert effects.organ_coming() and effects.pick((1, 2, 50), (0, 0, -1)).distance == 40
        end = time.monotonic() + 60
        while effects.organ_coming() and time.monotonic() < end:
            effects.seek(5)
        assert effects.pick((1, 2, 50), (0, 0, -1)).distance == 43 and [one.time for one in effects.contacts()] == [0]


def check_threads(effects):
    told = []

    def other():
        try:
            effects.push_sample(lapfx.Sample(time=4, touching=1, action=1))
            effects.push_sample(lapfx.Sample(time=4.05, touching=1, action=1))
            effects.seek(1.0)
        except lapfx.Error as error:
            told.append(error)

    thread = threading.Thread(target=other)
    thread.start()
    thread.join()
    assert len(told) == 1 and isinstance(told[0], lapfx.Misuse) and "another thread" in str(told[0]), told
    effects.seek(5)
    assert len(effects.contacts()) == 2, effects.contacts()


def check_files(scene, preset):
    fails(lapfx.BadInput, "none.glb", lapfx.Organ, "none.glb")
    fails(lapfx.BadInput, "none.json", lapfx.Preset, "none.json")
    fails(lapfx.BadInput, "is not one of automatic, egl, osmesa", lapfx.Context, "vulkan")
    text = lapfx.Preset(preset).json()
    assert lapfx.Preset.parse(text).json() == text
    fails(lapfx.BadInput, "speed", lapfx.Preset.parse, text.replace('"speed": ', '"speed": -', 1))
    opened = lapfx.Scene(scene)
    info = opened.info()
    assert os.path.exists(info.organ_file) and os.path.exists(info.preset) and info.event_count == len(opened.events())
    assert sorted(event.time for event in opened.events()) == [event.time for event in opened.events()]
    opened.close()
    opened.close()
    fails(lapfx.Misuse, "scene is no lapfx_scene that lives", opened.info)


def check_warnings():
    """What is repaired goes to Python's log: a triangle that is there twice."""
    told = []
    handler = logging.Handler()
    handler.emit = lambda record: told.append(record.getMessage())
    logging.getLogger("lapfx").addHandler(handler)
    with open("twice.obj", "w", encoding="utf-8") as file:
        file.write("v 0 0 0\nv 9 0 0\nv 0 9 0\nf 1 2 3\nf 1 2 3\n")
    lapfx.Organ("twice.obj")
    os.remove("twice.obj")
    logging.getLogger("lapfx").removeHandler(handler)
    assert any(line.startswith("lapfx_organ_load: ") for line in told), told


def main(structs, scene, preset, clips):
    assert lapfx.version() == "0.1.0"
    with open(structs, encoding="utf-8") as file:
        check_structs(file.read().splitlines())
    check_files(scene, preset)
    check_warnings()
    check_pictures(scene, preset, clips)
    plain = lapfx.Preset(preset)
    with lapfx.Player(scene, plain, size=(8, 8), clip_folders=[clips], backend="osmesa"):
        pass  # a preset outlives what was made of it
    check_arrays(lapfx.Preset.parse('{"format": "lapfx.preset", "version": 1, "name": "plain"}'))


if __name__ == "__main__":
    main(*sys.argv[1:])
