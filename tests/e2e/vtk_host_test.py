#!/usr/bin/env python3
"""A host in VTK (samples/host/vtk.cpp), built of what was installed alone: its blood, metal clips and smoke are where
lapfx's own host with a shader of its own (samples/host/host.cpp, "own") has them, and no call of the core changes VTK's
OpenGL state. On a display of its own (Xvfb).

    vtk_host_test.py BUILD SOURCE FOLDER

FOLDER is kept: what is built there once is not built again. 77 where VTK, Xvfb or OpenGL 4.5 is missing.
"""
import json
import os
import re
import shutil
import statistics
import subprocess
import sys
import tempfile

import install_test
import installed_hosts
import real_window
from installed_hosts import run

# The head of vtk.cpp has the same.
PROJECT = """cmake_minimum_required(VERSION 3.25)
project(host LANGUAGES C CXX)
find_package(lapfx 0.1 REQUIRED COMPONENTS effects)
find_package(VTK 9 QUIET COMPONENTS InteractionStyle RenderingOpenGL2 RenderingUI glew)
if(NOT VTK_FOUND)
    message(FATAL_ERROR "there is no VTK 9 here")
endif()
find_package(OpenGL REQUIRED COMPONENTS GLX)
find_package(X11 REQUIRED)
function(host_in_vtk program source)
    add_executable(${{program}} "${{source}}")
    target_compile_options(${{program}} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Werror)
    target_link_libraries(${{program}} PRIVATE lapfx::effects ${{VTK_LIBRARIES}} OpenGL::GLX X11::X11)
    vtk_module_autoinit(TARGETS ${{program}} MODULES ${{VTK_LIBRARIES}})
endfunction()
host_in_vtk(simulator "{source}/samples/host/vtk.cpp")
"""
# The same host, watched.
WATCHED = """host_in_vtk(watched "{source}/tests/e2e/watched_vtk_host.cpp")
target_include_directories(watched PRIVATE "{source}/tests")
"""
WIDTH, HEIGHT, TIME = 480, 384, "5.5"
CLIP = {"action": "clip", "time": 1, "duration": 0.3, "position": [-33.7, -8.08, -36.09]}  # where nothing bleeds yet
CALLS = ("Effects", "bind_bleeding", "draw_metal_clips", "draw_smoke", "seek", "set_contacts", "set_curves", "~Effects")


def built_host(source, prefix, folder):
    project = os.path.join(folder, "vtk")
    installed_hosts.put(os.path.join(project, "CMakeLists.txt"), (PROJECT + WATCHED).format(source=source))
    built = os.path.join(project, "build")
    told = subprocess.run(("cmake", "-S", project, "-B", built, "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={prefix}"),
                          capture_output=True, encoding="utf-8", check=False)
    if "there is no VTK 9 here" in told.stderr:
        raise real_window.Skip("VTK 9 is not installed (.packages names it)")
    assert told.returncode == 0, told.stderr
    run("cmake", "--build", built)
    libraries = run("ldd", os.path.join(built, "simulator"))
    assert "liblapfx" in libraries and "Qt" not in libraries, libraries
    return os.path.join(built, "simulator"), os.path.join(built, "watched")


def pixels_of(ppm):
    """(red, green, blue) of each pixel, rows from the top."""
    header = f"P6\n{WIDTH} {HEIGHT}\n255\n".encode()
    assert ppm.startswith(header) and len(ppm) == len(header) + 3 * WIDTH * HEIGHT, "not the PPM that was asked for"
    data = ppm[len(header):]
    return list(zip(data[0::3], data[1::3], data[2::3]))


def light(code):
    return code / 255 / 12.92 if code <= 10 else ((code / 255 + 0.055) / 1.055) ** 2.4


def blood(picture, seen):
    return {i for i in seen if picture[i][0] > 40 and picture[i][1] < 0.5 * picture[i][0]}


def changed(first, second, seen):
    return {i for i in seen if max(abs(a - b) for a, b in zip(first[i], second[i])) > 12}


def overlap(first, second):
    """Of both, as a share of all that is in either."""
    return len(first & second) / max(len(first | second), 1)


def check_pictures(vtk, own):
    """Both: pictures by name. VTK's organ has another light and material, so that what has come on it is compared."""
    seen = {i for i, pixel in enumerate(own["before"]) if max(pixel) > 60}  # inside the endoscope's round view
    assert len(seen) > 0.5 * WIDTH * HEIGHT
    assert not blood(vtk["before"], seen) and not blood(own["before"], seen), "blood before anything has happened"
    red = blood(vtk["during"], seen), blood(own["during"], seen)
    same = overlap(*red)
    print(f"blood: {len(red[0])} pixels in VTK, {len(red[1])} in lapfx's own host, {same:.3f} of all in both")
    assert len(red[1]) > 0.01 * WIDTH * HEIGHT, "too little blood to compare"
    assert same > 0.93, "VTK's blood is not where lapfx has it"

    metal = changed(vtk["clipped"], vtk["during"], seen), changed(own["clipped"], own["during"], seen)
    # lapfx's own host has more of them, because it smooths their edges.
    inside = len(metal[0] & metal[1]) / max(len(metal[0]), 1)
    print(f"metal clips: {len(metal[0])} and {len(metal[1])} pixels, {inside:.3f} of VTK's in both")
    assert len(metal[0]) > 20 and len(metal[0]) > 0.4 * len(metal[1]), "there are no clips in VTK's picture"
    assert inside > 0.9, "VTK's clips are not where lapfx has them"

    bare = sorted(seen - red[0] - red[1])
    left = [[light(of["during"][i][2]) / light(of["before"][i][2]) for i in bare] for of in (vtk, own)]
    alike, mean = statistics.correlation(*left), [statistics.fmean(one) for one in left]
    print(f"smoke: of the tissue's blue light {mean[0]:.4f} is left in VTK, {mean[1]:.4f} in lapfx's own host; both "
          f"pictures of it correlate by {alike:.4f}")
    assert max(left[1]) > 1.1 and mean[1] < 0.98, "too little smoke to compare"
    assert alike > 0.96 and abs(mean[0] - mean[1]) < 0.01, "VTK's smoke is not lapfx's"


def check_state(told):
    """The watched host has told its calls, and would have ended with 3 after one that changes something."""
    calls = dict(re.findall(r"^(\S+) (\d+)$", told, re.MULTILINE))
    print(f"calls that left OpenGL's state alone: {calls}")
    assert tuple(sorted(calls)) == CALLS and all(int(count) >= 1 for count in calls.values()), told


def check_exit_codes(host, shown, display):
    """One line and a code for what the user can mend."""
    old = {**display, "MESA_GL_VERSION_OVERRIDE": "3.3"}
    nowhere = {name: value for name, value in display.items() if name != "DISPLAY"}
    for arguments, environment, code, text in ((shown, nowhere, 77, "no X display"), (shown, old, 77, "4.5"),
                                               (shown[:3], display, 2, "usage: "),
                                               (("missing.scene.json", *shown[1:]), display, 2, "missing.scene.json")):
        done = subprocess.run((host, *arguments), env=environment, capture_output=True, encoding="utf-8", check=False)
        lines = [line for line in done.stderr.splitlines() if line.startswith("lapfx_host_vtk: ")]
        assert done.returncode == code and len(lines) == 1 and text in lines[0], (code, done.returncode, done.stderr)


def main(build, source, folder):
    if shutil.which("Xvfb") is None:
        raise real_window.Skip("Xvfb is not installed (.packages names it)")
    os.makedirs(folder, exist_ok=True)
    prefix = install_test.installed(build, folder)
    host, watched = built_host(source, prefix, folder)
    data = os.path.join(prefix, "share", "lapfx")
    scene = os.path.join(data, "samples", "lagb.scene.json")
    shown = (os.path.join(data, "presets", "gastric_banding.json"), os.path.join(data, "samples", "clips"))
    size = (str(WIDTH), str(HEIGHT))
    with tempfile.TemporaryDirectory() as temporary:
        with open(scene, encoding="utf-8") as file:
            clipped = json.load(file)
        clipped["organ"]["file"] = os.path.join(data, "samples", clipped["organ"]["file"])
        clipped["events"].append(CLIP)
        del clipped["preset"], clipped["tool"]
        with_clip = os.path.join(temporary, "clipped.scene.json")
        installed_hosts.put(with_clip, json.dumps(clipped))
        wanted = {"before": (scene, "0"), "during": (scene, TIME), "clipped": (with_clip, TIME)}
        own = {name: pixels_of(run(os.path.join(build, "lapfx_host"), of, *shown, "own", *size, time, text=False))
               for name, (of, time) in wanted.items()}
        display = real_window.Display(temporary)
        try:
            environment = {**os.environ, "DISPLAY": display.name}
            pictures = {}
            for name, (of, time) in wanted.items():
                done = subprocess.run((host, of, *shown, *size, time), env=environment, capture_output=True, check=False)
                if done.returncode == real_window.SKIP:
                    raise real_window.Skip(done.stderr.decode(errors="replace").strip())
                assert done.returncode == 0 and b"lapfx" not in done.stderr and b"ERR|" not in done.stderr, done
                pictures[name] = done.stdout
            done = subprocess.run((watched, with_clip, *shown, *size, TIME), env=environment, capture_output=True, check=False)
            assert done.returncode == 0, (done.returncode, done.stderr)
            assert done.stdout == pictures["clipped"], "the watched host draws another picture"
            check_exit_codes(host, (with_clip, *shown, "32", "26", TIME), environment)
        finally:
            display.close()
    check_pictures({name: pixels_of(ppm) for name, ppm in pictures.items()}, own)
    check_state(done.stderr.decode())


if __name__ == "__main__":
    try:
        main(*[os.path.realpath(word) for word in sys.argv[1:]])
    except real_window.Skip as skip:
        print(f"vtk_host: skipped: {skip}")
        sys.exit(real_window.SKIP)
