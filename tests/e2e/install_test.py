#!/usr/bin/env python3
"""What `cmake --install` puts where: it is moved to another folder, and everything is used from there alone.

    install_test.py BUILD SOURCE FOLDER [--renew]

FOLDER is kept: what is built there once is not built again. --renew writes exported_names.txt again.
"""
import os
import re
import shlex
import shutil
import subprocess
import sys

NAMES = os.path.join(os.path.dirname(os.path.realpath(__file__)), "exported_names.txt")
HEAD = "# What liblapfx.so exports: the functions of its headers (effects/include/lapfx). Renewed by install_test.py --renew.\n"

# Two hosts: one finds lapfx by CMake, draws, and has its own loader of OpenGL; the other one finds it by pkg-config.
CMAKE = """cmake_minimum_required(VERSION 3.25)
project(host LANGUAGES C CXX)
find_package(lapfx 0.1 REQUIRED COMPONENTS effects)
find_package(glfw3 REQUIRED)
add_custom_command(OUTPUT glad/src/gl.c
    COMMAND glad --quiet --reproducible --api gl:core=4.5 --extensions= --out-path glad c)
add_executable(simulator "{source}/samples/host/host.cpp" ${{CMAKE_CURRENT_BINARY_DIR}}/glad/src/gl.c)
target_include_directories(simulator PRIVATE ${{CMAKE_CURRENT_BINARY_DIR}}/glad/include)
target_link_libraries(simulator PRIVATE lapfx::effects glfw)
"""


def run(*command, text=True, fails=False, **more):
    done = subprocess.run(command, capture_output=True, check=False, **more)
    told = (done.stdout + done.stderr).decode(errors="replace")
    assert (done.returncode != 0) == fails, " ".join(command) + "\n" + told
    return told if fails else done.stdout.decode() if text else done.stdout


def put(path, text):
    """Only what changes, or it would be built again."""
    if os.path.exists(path) and open(path, encoding="utf-8").read() == text:
        return
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def installed(build, folder):
    """Installs, and moves what was installed."""
    at_first, prefix = os.path.join(folder, "first"), os.path.join(folder, "moved here")
    for old in (at_first, prefix):
        shutil.rmtree(old, ignore_errors=True)
    run("cmake", "--install", build, "--prefix", at_first)
    os.rename(at_first, prefix)
    return prefix


def files_below(folder):
    return [os.path.join(where, name) for where, _, names in os.walk(folder) for name in names]


def check_names_no_folder(prefix, *folders):
    """No installed file names a folder of this machine."""
    for path in files_below(prefix):
        if os.path.islink(path):
            assert not os.path.isabs(os.readlink(path)), f"{path} leads to {os.readlink(path)}"
            continue
        with open(path, "rb") as file:
            data = file.read()
        for folder in folders:
            at = data.find(os.fsencode(folder) + b"/")
            assert at < 0, f"{path} names {folder}: {data[max(at - 40, 0):at + 80]}"


def exported(library):
    lines = run("nm", "-DC", "--defined-only", library).splitlines()
    return sorted({line.split(" ", 2)[2] for line in lines})  # a constructor is there twice


def check_library(prefix, renew):
    library = next(path for path in files_below(prefix) if os.path.basename(path) == "liblapfx.so")
    dynamic = run("readelf", "-d", library)
    assert re.search(r"SONAME.*\[liblapfx\.so\.0\]", dynamic), dynamic
    assert not re.search(r"RPATH|RUNPATH|Qt|highgui|OSMesa", dynamic), dynamic
    names = exported(library)
    if renew:
        with open(NAMES, "w", encoding="utf-8") as file:
            file.write(HEAD + "".join(name + "\n" for name in names))
    listed = [line for line in open(NAMES, encoding="utf-8").read().splitlines() if not line.startswith("#")]
    more, less = sorted(set(names) - set(listed)), sorted(set(listed) - set(names))
    assert not more and not less, f"exported and not in exported_names.txt: {more}; there and not exported: {less}"
    assert all("lapfx::" in name for name in names), names
    return os.path.dirname(library)


def check_program(prefix, build):
    """The program finds its presets and samples, and draws what the one of the build folder draws."""
    data = os.path.join(prefix, "share", "lapfx")
    program, scene = os.path.join(prefix, "bin", "lapfx"), os.path.join(data, "samples", "lagb.scene.json")
    environment = {name: value for name, value in os.environ.items() if name != "LAPFX_DATA"}
    assert "presets/slow_ooze.json" in run(program, "help", "preset", env=environment)
    pictures = []
    for one in (program, os.path.join(build, "lapfx")):
        picture = os.path.join(prefix, "picture.png")
        run(one, "render", scene, "--at", "4", "--size", "160x128", "--backend", "osmesa", "-o", picture, env=environment)
        with open(picture, "rb") as file:
            pictures.append(file.read())
        os.remove(picture)
    assert pictures[0] == pictures[1], "the installed program draws another picture"
    return scene, os.path.join(data, "presets", "gastric_banding.json"), os.path.join(data, "samples", "clips")


def check_drawing_host(source, prefix, folder, build, scene, preset, clips):
    project, built = os.path.join(folder, "host"), os.path.join(folder, "host", "build")
    os.makedirs(project, exist_ok=True)
    put(os.path.join(project, "CMakeLists.txt"), CMAKE.format(source=source))
    configure = ("cmake", "-S", project, "-B", built, "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={prefix}")
    run(*configure)
    run("cmake", "--build", built)
    draw = (os.path.join(built, "simulator"), scene, preset, clips)
    pictures = [run(*draw, shader, "160", "128", "4", text=False) for shader in ("lapfx", "own")]
    assert all(len(set(picture[15:])) > 40 for picture in pictures) and pictures[0] != pictures[1], "nothing is drawn"
    in_tree = run(os.path.join(build, "lapfx_host"), *draw[1:], "lapfx", "160", "128", "4", text=False)
    assert pictures[0] == in_tree, "the installed core draws another picture than the one in the build folder"

    other = os.path.join(folder, "other")
    os.makedirs(other, exist_ok=True)
    put(os.path.join(other, "CMakeLists.txt"), CMAKE.format(source=source).replace("COMPONENTS effects", "COMPONENTS effects sound"))
    told = run("cmake", "-S", other, "-B", os.path.join(other, "build"), "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={prefix}", fails=True)
    assert "lapfx has no component \"sound\"; it has: effects" in " ".join(told.split()), told


def check_scoring_host(source, libraries, folder, build, scene, preset):
    environment = {**os.environ, "PKG_CONFIG_PATH": os.path.join(libraries, "pkgconfig"), "LD_LIBRARY_PATH": libraries}
    flags = shlex.split(run("pkg-config", "--cflags", "--libs", "lapfx", env=environment))
    scores = os.path.join(folder, "scores")
    run("c++", "-std=c++20", os.path.join(source, "samples", "host", "scores.cpp"), *flags, "-o", scores)
    table = run(scores, scene, preset, env=environment)
    assert table == run(os.path.join(build, "lapfx_scores"), scene, preset), "other amounts than in the build folder"
    assert run("pkg-config", "--modversion", "lapfx", env=environment).strip() == "0.1.0"


def main(build, source, folder, *more):
    os.makedirs(folder, exist_ok=True)
    prefix = installed(build, folder)
    check_names_no_folder(prefix, source, build, folder)
    libraries = check_library(prefix, "--renew" in more)
    scene, preset, clips = check_program(prefix, build)
    check_drawing_host(source, prefix, folder, build, scene, preset, clips)
    check_scoring_host(source, libraries, folder, build, scene, preset)


if __name__ == "__main__":
    main(*[os.path.realpath(word) if not word.startswith("--") else word for word in sys.argv[1:]])
