"""Hosts that are built of what was installed alone (install_test.py): in C++ and in C, found by CMake and by
pkg-config, and in Python. All draw what the host of the build folder draws.
"""
import os
import re
import shlex
import subprocess
import sys

# Two hosts: one finds lapfx by CMake, draws, and has its own loader of OpenGL; the other one finds it by pkg-config.
IN_CPP = """cmake_minimum_required(VERSION 3.25)
project(host LANGUAGES C CXX)
find_package(lapfx 0.1 REQUIRED COMPONENTS effects)
find_package(glfw3 REQUIRED)
add_custom_command(OUTPUT glad/src/gl.c
    COMMAND glad --quiet --reproducible --api gl:core=4.5 --extensions= --out-path glad c)
add_executable(simulator "{source}/samples/host/host.cpp" ${{CMAKE_CURRENT_BINARY_DIR}}/glad/src/gl.c)
target_include_directories(simulator PRIVATE ${{CMAKE_CURRENT_BINARY_DIR}}/glad/include)
target_link_libraries(simulator PRIVATE lapfx::effects glfw)
add_executable(stereo "{source}/samples/host/stereo.cpp")
target_link_libraries(stereo PRIVATE lapfx::effects EGL)
"""
# It knows no C++ and looks for nothing but lapfx.
IN_C = """cmake_minimum_required(VERSION 3.25)
project(host LANGUAGES C)
find_package(lapfx 0.1 REQUIRED COMPONENTS c)
if(NOT EXISTS "${{lapfx_DATA_DIR}}/presets/slow_ooze.json")
    message(FATAL_ERROR "lapfx_DATA_DIR is ${{lapfx_DATA_DIR}}")
endif()
if(TARGET glm::glm)
    message(FATAL_ERROR "a host in C needs no GLM")
endif()
add_executable(simulator "{source}/samples/host/host.c")
set_target_properties(simulator PROPERTIES C_STANDARD 99 C_STANDARD_REQUIRED ON C_EXTENSIONS OFF)
target_compile_options(simulator PRIVATE -Wall -Wextra -Wpedantic -Werror)
target_link_libraries(simulator PRIVATE lapfx::c)
"""
STRICT_C = ("cc", "-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Werror")

# What lapfx.py has to say again: the size of each struct, and the bytes of its initialiser.
STRUCTS_IN_C = r"""
#include <lapfx.h>
#include <stdio.h>

static void show(const char* name, const void* data, size_t size) {
    printf("%s %zu ", name, size);
    for (size_t i = 0; data != NULL && i < size; ++i) printf("%02x", ((const unsigned char*)data)[i]);
    printf("\n");
}

int main(void) {
    static const lapfx_contact contact = LAPFX_CONTACT;
    static const lapfx_sample sample = LAPFX_SAMPLE;
    static const lapfx_view view = LAPFX_VIEW;
    static const lapfx_response response = LAPFX_RESPONSE;
    static const lapfx_organ_options organ_options = LAPFX_ORGAN_OPTIONS;
    static const lapfx_mesh mesh = LAPFX_MESH;
    show("Contact", &contact, sizeof contact);
    show("Sample", &sample, sizeof sample);
    show("View", &view, sizeof view);
    show("Response", &response, sizeof response);
    show("_OrganOptions", &organ_options, sizeof organ_options);
    show("_Mesh", &mesh, sizeof mesh);
    show("_EffectsOptions", NULL, sizeof(lapfx_effects_options));
    show("_OrganData", NULL, sizeof(lapfx_organ_data));
    show("Amounts", NULL, sizeof(lapfx_amounts));
    show("Wound", NULL, sizeof(lapfx_wound));
    show("Hit", NULL, sizeof(lapfx_hit));
    show("MemoryUse", NULL, sizeof(lapfx_memory_use));
    show("SceneInfo", NULL, sizeof(lapfx_scene_info));
    return 0;
}
"""
TIMES = ("0", "2", "5.5")


def run(*command, text=True, fails=False, **more):
    done = subprocess.run(command, capture_output=True, check=False, **more)
    told = (done.stdout + done.stderr).decode(errors="replace")
    assert (done.returncode != 0) == fails, " ".join(command) + "\n" + told
    return told if fails else done.stdout.decode() if text else done.stdout


def put(path, text):
    """Only what changes, or it would be built again."""
    if os.path.exists(path) and open(path, encoding="utf-8").read() == text:
        return
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def configured(prefix, project, text, fails=False):
    """What CMake says to a project that finds lapfx in `prefix`, or the folder that it builds in."""
    put(os.path.join(project, "CMakeLists.txt"), text)
    built = os.path.join(project, "build")
    told = run("cmake", "-S", project, "-B", built, "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={prefix}", fails=fails)
    return told if fails else built


def check_drawing_host(source, prefix, folder, build, scene, preset, clips):
    built = configured(prefix, os.path.join(folder, "host"), IN_CPP.format(source=source))
    run("cmake", "--build", built)
    draw = (os.path.join(built, "simulator"), scene, preset, clips)
    pictures = [run(*draw, shader, "160", "128", "4", text=False) for shader in ("lapfx", "own")]
    assert all(len(set(picture[15:])) > 40 for picture in pictures) and pictures[0] != pictures[1], "nothing is drawn"
    in_tree = run(os.path.join(build, "lapfx_host"), *draw[1:], "lapfx", "160", "128", "4", text=False)
    assert pictures[0] == in_tree, "the installed core draws another picture than the one in the build folder"

    eyes = subprocess.run([sys.executable, os.path.join(source, "tests", "e2e", "stereo_test.py"), draw[0],
                           os.path.join(built, "stereo"), source], check=False)
    assert eyes.returncode in (0, 77), "the stereo host"

    wrong = IN_CPP.format(source=source).replace("COMPONENTS effects", "COMPONENTS effects sound")
    told = configured(prefix, os.path.join(folder, "other"), wrong, fails=True)
    assert "lapfx has no component \"sound\"; it has: c, effects" in " ".join(told.split()), told


def packaged(libraries, package):
    """The flags of pkg-config for what was installed, and the environment in which programs find it."""
    environment = {**os.environ, "PKG_CONFIG_PATH": os.path.join(libraries, "pkgconfig"), "LD_LIBRARY_PATH": libraries}
    assert run("pkg-config", "--modversion", package, env=environment).strip() == "0.1.0"
    (data,) = shlex.split(run("pkg-config", "--variable=datadir", package, env=environment))
    assert os.path.exists(os.path.join(data, "samples", "host", "host.cpp")), f"{data}: no host is there"
    return shlex.split(run("pkg-config", "--cflags", "--libs", package, env=environment)), environment


def check_scoring_host(source, libraries, folder, build, scene, preset):
    flags, environment = packaged(libraries, "lapfx")
    scores = os.path.join(folder, "scores")
    run("c++", "-std=c++20", os.path.join(source, "samples", "host", "scores.cpp"), *flags, "-o", scores)
    table = run(scores, scene, preset, env=environment)
    assert table == run(os.path.join(build, "lapfx_scores"), scene, preset), "other amounts than in the build folder"


def pictures_of(host, wanted, size, **more):
    """The host's pictures are those of the build folder's, byte for byte."""
    for time, picture in wanted.items():
        found = run(*host, *size, time, text=False, **more)
        assert found == picture, f"{host[0]} draws another picture at {time} s: {len(found)} bytes, {len(picture)} expected"


def with_numpy():
    """A Python that has numpy: Debian's belongs to /usr/bin/python3."""
    for python in (sys.executable, "/usr/bin/python3"):
        if subprocess.run([python, "-c", "import numpy"], capture_output=True, check=False).returncode == 0:
            return python
    raise AssertionError("numpy is missing: python3-numpy is in .packages")


def check_other_languages(source, prefix, libraries, folder, build, scene, preset, clips):
    """C by CMake and by pkg-config, Python, and what lapfx.py says again of the header."""
    shown, size = (scene, preset, clips), ("160", "128")
    wanted = {time: run(os.path.join(build, "lapfx_host"), *shown, "lapfx", *size, time, text=False) for time in TIMES}
    assert len(set(wanted.values())) == len(TIMES), "the pictures of different times are the same"

    built = configured(prefix, os.path.join(folder, "host in C"), IN_C.format(source=source))
    run("cmake", "--build", built)
    pictures_of((os.path.join(built, "simulator"), *shown), wanted, size)
    flags, environment = packaged(libraries, "lapfx-c")
    program = os.path.join(folder, "host_in_c")
    run(*STRICT_C, os.path.join(source, "samples", "host", "host.c"), *flags, "-o", program)
    pictures_of((program, *shown), wanted, size, env=environment)
    header = os.path.join(prefix, "include", "lapfx.h")
    for alone in (STRICT_C, ("c++", "-std=c++11", *STRICT_C[2:])):
        run(*alone, "-fsyntax-only", "-include", header, "-x", "c++" if alone[0] == "c++" else "c", os.devnull)

    python, module = with_numpy(), os.path.join(prefix, "lib", "python3", "dist-packages")
    environment = {name: value for name, value in os.environ.items() if name != "LAPFX_LIBRARY"}
    environment.update(PYTHONPATH=module, PYTHONDONTWRITEBYTECODE="1")
    pictures_of((python, os.path.join(source, "samples", "host", "host.py"), *shown), wanted, size, env=environment)

    structs = os.path.join(folder, "structs")
    put(structs + ".c", STRUCTS_IN_C)
    run(*STRICT_C, structs + ".c", *flags, "-o", structs)
    put(structs + ".txt", run(structs, env={**environment, "LD_LIBRARY_PATH": libraries}))
    run(python, os.path.join(source, "tests", "e2e", "lapfx_py_test.py"), structs + ".txt", *shown, env=environment)
