#!/usr/bin/env python3
"""A host of its own, in an empty folder, with the two lines of CMake that README tells: a program and a plug-in.

    host_project_test.py PROJECT FOLDER

The folder is kept: what is built there once is not built again.
"""
import ctypes
import os
import re
import shutil
import subprocess
import sys

# Neither a standard of C++ nor a build type nor -fPIC: the target brings what it needs.
CMAKE = """cmake_minimum_required(VERSION 3.25)
project(host LANGUAGES C CXX)
add_subdirectory("{project}" lapfx)
add_executable(simulator simulator.cpp)
target_link_libraries(simulator PRIVATE lapfx::effects)
add_library(plugin SHARED plugin.cpp)
target_link_libraries(plugin PRIVATE lapfx::effects)
"""

SIMULATOR = r"""#include <iostream>
#include "lapfx/effects.h"

int main(int, char** arguments) {
    try {
        auto context = lapfx::Context::create(lapfx::Backend::automatic);
        lapfx::Organ organ = lapfx::load_organ(arguments[1]);
        lapfx::Effects effects(organ, lapfx::load_preset(arguments[2]), {.clip_folders = {arguments[3]}});
        effects.seek(1.0);
        std::cout << organ.triangle_count() << " triangles, " << effects.wounds().size() << " wounds\n";
    } catch (const lapfx::Error& error) {
        std::cerr << error.what() << '\n';
        return error.failure() == lapfx::Failure::no_gl ? 77 : 1;
    }
}
"""

PLUGIN = r"""#include "lapfx/effects.h"

extern "C" int triangles(const char* file) {
    try {
        return static_cast<int>(lapfx::load_organ(file).triangle_count());
    } catch (const lapfx::Error&) {
        return -1;
    }
}
"""


def put(path, text):
    """Only what changes, or it would be built again."""
    if os.path.exists(path) and open(path, encoding="utf-8").read() == text:
        return
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def run(*command):
    done = subprocess.run(command, capture_output=True, encoding="utf-8", check=False)
    assert done.returncode == 0, " ".join(command) + "\n" + done.stdout + done.stderr
    return done.stdout


def main(project, folder):
    os.makedirs(folder, exist_ok=True)
    build = os.path.join(folder, "build")
    put(os.path.join(folder, "CMakeLists.txt"), CMAKE.format(project=project))
    put(os.path.join(folder, "simulator.cpp"), SIMULATOR)
    put(os.path.join(folder, "plugin.cpp"), PLUGIN)
    cache = os.path.join(build, "CMakeCache.txt")
    if os.path.exists(cache) and f"CMAKE_CACHEFILE_DIR:INTERNAL={build}\n" not in open(cache, encoding="utf-8").read():
        shutil.rmtree(build)  # it came along when the tree was moved
    # Debug: it compiles fastest, and it is the host's own choice.
    run("cmake", "-S", folder, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Debug")
    known = open(cache, encoding="utf-8").read()
    for what in ("LAPFX_TESTS:BOOL=ON", "LAPFX_EDITOR:BOOL=ON", "glfw3_DIR", "CLI11_DIR", "GTest_DIR", "imgui"):
        assert what not in known, f"a host has no use for {what}"
    assert re.search(r"CMAKE_BUILD_TYPE:STRING=Debug\n", known), "the build type is the host's"
    run("cmake", "--build", build)
    targets = run("cmake", "--build", build, "--target", "help")
    for target in ("lapfx_editor", "lapfx_ui", "lapfx_unit_tests", "lapfx_host"):
        assert not re.search(rf"\b{target}\b", targets), f"{target} is of no use to a host"

    organ = os.path.join(project, "samples", "hook_cautery.glb")
    triangles = ctypes.CDLL(os.path.join(build, "libplugin.so")).triangles(organ.encode())
    assert triangles > 100, f"the plug-in reads {triangles} triangles"
    done = subprocess.run(
        [os.path.join(build, "simulator"), organ, os.path.join(project, "presets", "gastric_banding.json"),
         os.path.join(project, "samples", "clips")], capture_output=True, encoding="utf-8", check=False)
    if done.returncode != 77:
        assert done.stdout == f"{triangles} triangles, 0 wounds\n", (done.stdout, done.stderr)
    print(f"a host links the core: {triangles} triangles read by its plug-in")


if __name__ == "__main__":
    main(os.path.realpath(sys.argv[1]), os.path.realpath(sys.argv[2]))
