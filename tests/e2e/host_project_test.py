#!/usr/bin/env python3
"""Hosts of their own, in an empty folder, with the two lines of CMake that README tells: the sample host's one file as
a program, a plug-in, and the sample host that scores, without OpenGL. The core is configured and built with nothing but
what it links, and a host sees nothing but what it needs.

    host_project_test.py PROJECT FOLDER LAPFX

The host's own files are compiled as the host's CMake says, and linked by its own commands; the core's libraries, which
those commands name, are the ones that lapfx beside LAPFX was built of, so that the core is compiled once. With
`tests/run --deep` (LAPFX_DEEP=1), and where those have a sanitizer, the host builds the core, too. The folder is kept:
what is built there once is not built again.
"""
import csv
import ctypes
import json
import os
import re
import shlex
import shutil
import struct
import subprocess
import sys

# Neither a standard of C++ nor a build type nor -fPIC: the target brings what it needs. The window is the host's own.
CMAKE = """cmake_minimum_required(VERSION 3.25)
project(host LANGUAGES C CXX)
add_subdirectory("{project}" lapfx)
find_package(glfw3 REQUIRED)
add_executable(simulator "{project}/samples/host/host.cpp")
target_link_libraries(simulator PRIVATE lapfx::effects lapfx_glad glfw)
add_library(plugin SHARED plugin.cpp)
# It packs with Draco itself, and so loads libdraco before what the core links.
target_link_libraries(plugin PRIVATE draco::draco lapfx::effects)
add_executable(scores "{project}/samples/host/scores.cpp")
target_link_libraries(scores PRIVATE lapfx::simulation)
"""

# After every public header: what only lapfx's own programs need is not there.
PLUGIN = r"""
#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>

#if __has_include("lapfx/authoring/preview.h") || __has_include("lapfx/authoring/file.h")
#error "what is for lapfx's own programs is on a host's include path"
#endif

namespace lapfx {
template <typename T>
concept Opens = requires(const T& object) { object.state(); };
template <typename... A>
concept ParsesWords = requires(const A&... a) { parse_backend(a...); };
template <typename... A>
concept WritesFiles = requires(const A&... a) { write_file(a...); };
template <typename... A>
concept SavesPresets = requires(const A&... a) { save_preset(a...); };
template <typename T>
concept KnowsScenes = requires(const T& object) { object.made_for(0); } || requires(const T& object) { object.tool_files(); };
static_assert(!Opens<PreparedOrgan> && !Opens<ClipCache> && !KnowsScenes<PreparedOrgan>);
static_assert(!ParsesWords<std::string>);
static_assert(!WritesFiles<std::filesystem::path, std::string_view>);
static_assert(!SavesPresets<Preset, std::filesystem::path>);
static_assert(static_cast<int>(Failure::no_gl) != 77, "exit codes are the program's");
class Preview {};
class VideoReader {};
class KeyingReader {};
class Beside {};
struct OrganReport {};
struct TissueReport {};
}  // namespace lapfx

extern "C" int triangles(const char* file) {
    try {
        return static_cast<int>(lapfx::load_organ(file).triangle_count());
    } catch (const lapfx::Error&) {
        return -1;
    }
}

/// A square of two triangles, 0.1 m wide: how many of `room` bytes it takes.
extern "C" int pack(char* out, int room) {
    constexpr float corners[4][3] = {{0, 0, 0}, {0.1f, 0, 0}, {0.1f, 0.1f, 0}, {0, 0.1f, 0}};
    draco::TriangleSoupMeshBuilder builder;
    builder.Start(2);
    const int position = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
    for (unsigned i = 0; i < 2; ++i)
        builder.SetAttributeValuesForFace(position, draco::FaceIndex(i), corners[0], corners[i + 1], corners[i + 2]);
    draco::EncoderBuffer buffer;
    const auto mesh = builder.Finalize();
    if (!draco::Encoder().EncodeMeshToBuffer(*mesh, &buffer).ok() || buffer.size() > static_cast<std::size_t>(room))
        return -1;
    std::copy_n(buffer.data(), buffer.size(), out);
    return static_cast<int>(buffer.size());
}
"""

# All that lapfx's CMake files look for: what the core links, and what builds it.
NEEDED = {"Threads", "glm", "nlohmann_json", "OpenMesh", "draco", "PNG", "JPEG", "PkgConfig", "tinygltf", "egl", "libavformat",
          "libavcodec", "libavutil", "libswscale", "libutf8proc", "opencv2/core.hpp", "opencv_core", "opencv_imgproc", "glad",
          "ccache"}
DRAWING = {"egl", "glad"}
# What a program that scores is neither made of nor linked to. (Debian's libopencv_core loads libGLX for itself.)
OPENGL = re.compile(r"glad|shaders|lapfx_effects|lib(?:EGL|GL|GLESv2|OpenGL|OSMesa|gbm)\.so")
WORDS = {"REQUIRED", "QUIET", "IMPORTED_TARGET", "GLOBAL", "PATH_SUFFIXES", "opencv4"}


def put(path, text):
    """Only what changes, or it would be built again."""
    if os.path.exists(path) and open(path, encoding="utf-8").read() == text:
        return
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def run(*command, text=True):
    done = subprocess.run(command, capture_output=True, check=False)
    told = (done.stdout + done.stderr).decode(errors="replace")
    assert done.returncode == 0, " ".join(command) + "\n" + told
    return done.stdout.decode() if text else done.stdout


def looked_for(trace, project, host):
    """{name: file and line} of all that the project's own CMake files look for; the host's, which may lie below, are
    its own."""
    found = {}
    with open(trace, encoding="utf-8") as lines:
        for line in lines:
            step = json.loads(line)
            command, file = step.get("cmd", "").lower(), step.get("file", "")
            if not file.startswith(project + os.sep) or file.startswith(host + os.sep):
                continue
            place = f"{os.path.relpath(file, project)}:{step['line']}"
            arguments = [word for argument in step["args"] for word in argument.split(";")]
            if command in ("add_subdirectory", "include"):
                found.setdefault(command + " " + os.path.basename(arguments[0]), place)
            elif command == "find_package":
                found.setdefault(arguments[0], place)
            elif command.startswith(("find_", "pkg_")):
                for word in arguments[1:]:
                    if word not in WORDS:
                        found.setdefault(word, place)
    return found


def configure(project, source, build, needed, *options):
    """Configures, and checks that only what is needed was looked for."""
    cache, trace = os.path.join(build, "CMakeCache.txt"), build + ".trace"
    if os.path.exists(cache) and f"CMAKE_CACHEFILE_DIR:INTERNAL={build}\n" not in open(cache, encoding="utf-8").read():
        shutil.rmtree(build)  # it came along when the tree was moved
    run("cmake", "-S", source, "-B", build, "-G", "Ninja", *options, "--trace-expand", "--trace-format=json-v1",
        f"--trace-redirect={trace}")
    found = looked_for(trace, project, os.path.dirname(build))
    os.remove(trace)
    folders = {name.split()[1] for name in found if name.startswith("add_subdirectory ")}
    assert folders == {"effects"}, f"the core is in effects/; what was added is {folders}"
    names = {name for name in found if " " not in name}
    assert names == needed, "looked for in vain: " + str({name: found[name] for name in names - needed}) + \
        ", or not looked for: " + str(needed - names)
    return open(cache, encoding="utf-8").read()


def builds_the_core(lapfx):
    if os.environ.get("LAPFX_DEEP"):
        return True
    with open(os.path.join(os.path.dirname(lapfx), "CMakeCache.txt"), encoding="utf-8") as cache:
        return "LAPFX_SANITIZE:STRING=OFF\n" not in cache.read()


def link(build, built, target, file):
    """Compiles what the host has itself, and links it with the libraries of the core that are in `built`."""
    inputs = [line.strip("'") for line in run("ninja", "-C", build, "-t", "inputs", file).splitlines()]
    own = [name for name in inputs if name.startswith(f"CMakeFiles/{target}.dir/") and name.endswith(".o")]
    assert own, f"nothing of {target} is the host's own"
    run("ninja", "-C", build, *own)
    command = run("ninja", "-C", build, "-t", "commands", file).splitlines()[-1]
    libraries = sorted({word for word in shlex.split(command) if word.startswith("lapfx/") and word.endswith(".a")})
    assert libraries, f"{target} links nothing of the core: {command}"
    for library in libraries:
        shutil.copy2(os.path.join(built, os.path.relpath(library, "lapfx")), os.path.join(build, library))
    run("sh", "-c", f"cd {shlex.quote(build)} && {command}")


def build_host(build, lapfx):
    if builds_the_core(lapfx):
        run("cmake", "--build", build)
        return
    print("the core is not compiled again; tests/run --deep does that, too")
    run("ninja", "-C", build, "-n")  # there is a rule for all of it
    for target, file in (("simulator", "simulator"), ("plugin", "libplugin.so"), ("scores", "scores")):
        link(build, os.path.dirname(lapfx), target, file)


def check_targets(build, *others):
    targets = run("cmake", "--build", build, "--target", "help")
    for target in ("lapfx_app", "lapfx_ui", "lapfx_unit_tests", "lapfx_host", "make_sample_organs", *others):
        assert not re.search(rf"\b{target}\b", targets), f"{target} is not of the core"


def check_scores(project, folder, build, lapfx):
    """Built and run without OpenGL, it gives the amounts of lapfx's drawing."""
    program = os.path.join(build, "scores")
    made_of = run("ninja", "-C", build, "-t", "inputs", "scores")
    assert "amounts.cpp" in made_of, made_of
    linked = run("readelf", "-d", program)
    assert "NEEDED" in linked and "GL" not in linked, linked
    for text in (made_of, run("ldd", program)):
        found = [line for line in text.splitlines() if OPENGL.search(line)]
        assert not found, f"a host that draws nothing is made of {found}"

    scene, preset = (os.path.join(project, name) for name in ("samples/lagb.scene.json", "presets/gastric_banding.json"))
    table = os.path.join(folder, "amounts.csv")
    run(lapfx, "render", scene, "--preset", preset, "--amounts", table, "--fps", "10", "--size", "32x32", "--backend", "osmesa",
        "-o", os.path.join(folder, "f_%04d.png"))
    drawn, scored = open(table, encoding="utf-8").read(), run(program, scene, preset)
    assert scored == drawn, "the scores are not those of what is drawn:\n" + scored
    rows = list(csv.DictReader(scored.splitlines()))
    last = rows[-1]
    assert float(last["blood_area_mm2"]) > 100 and int(last["wounds"]) > 0 and float(last["haze"]) > 0, f"nothing has happened: {last}"
    assert float(last["burnt_area_mm2"]) > 1, f"nothing is burnt: {last}"
    assert max(float(row["emission"]) for row in rows) > 0.5 and float(rows[0]["emission"]) == 0, "the tool makes no smoke"


def packed_square(plugin):
    """A .glb whose one mesh the plug-in has packed with Draco."""
    room = ctypes.create_string_buffer(4096)
    size = plugin.pack(room, len(room))
    assert size > 0, "Draco packs nothing"
    codec = "KHR_draco_mesh_compression"
    text = json.dumps({
        "asset": {"version": "2.0"}, "extensionsUsed": [codec], "extensionsRequired": [codec], "buffers": [{"byteLength": size}],
        "bufferViews": [{"buffer": 0, "byteLength": size}], "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "accessors": [{"componentType": 5126, "count": 4, "type": "VEC3"}, {"componentType": 5125, "count": 6, "type": "SCALAR"}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "extensions": {
            codec: {"bufferView": 0, "attributes": {"POSITION": 0}}}}]}]}).encode()
    chunks = b"".join(struct.pack("<I4s", len(data) + -len(data) % 4, name) + data + fill * (-len(data) % 4)
                      for name, data, fill in ((b"JSON", text, b" "), (b"BIN\0", room.raw[:size], b"\0")))
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def read_by(file, organ, packed):
    """How many triangles the plug-in reads of an organ. One that Draco has packed it reads too, though libdraco has a
    tinygltf of its own."""
    libraries = run("ldd", file)
    for library in ("glfw", "opencv_videoio", "opencv_highgui", "tinygltf", "Qt"):
        assert f"lib{library}" not in libraries, f"the core does not need {library}"
    shared = re.findall(r"(?m)^.* (?:tinygltf::|stbi).*$", run("nm", "-DC", file))
    assert not shared, f"names that libdraco has too: {shared[:3]}"
    plugin = ctypes.CDLL(file)
    triangles = plugin.triangles(organ.encode())
    assert triangles > 100, f"the plug-in reads {triangles} triangles"
    with open(packed, "wb") as square:
        square.write(packed_square(plugin))
    assert plugin.triangles(packed.encode()) == 2, "of a square"
    return triangles


def main(project, folder, lapfx):
    os.makedirs(folder, exist_ok=True)
    # By itself, with and without drawing; what is built of it is what a host builds of it.
    alone = os.path.join(folder, "alone")
    configure(project, project, alone, NEEDED, "-DLAPFX_EDITOR=OFF")
    check_targets(alone)
    blind = os.path.join(folder, "blind")
    configure(project, project, blind, NEEDED - DRAWING, "-DLAPFX_DRAWING=OFF")
    check_targets(blind, "lapfx_effects", "lapfx_glad", "lapfx_shaders")

    build = os.path.join(folder, "build")
    headers = sorted(os.listdir(os.path.join(project, "effects", "include", "lapfx")))
    put(os.path.join(folder, "CMakeLists.txt"), CMAKE.format(project=project))
    put(os.path.join(folder, "plugin.cpp"), "".join(f'#include "lapfx/{header}"\n' for header in headers) + PLUGIN)
    # Debug: it compiles fastest, and it is the host's own choice.
    cache = configure(project, folder, build, NEEDED, "-DCMAKE_BUILD_TYPE=Debug")
    assert re.search(r"CMAKE_BUILD_TYPE:STRING=Debug\n", cache), "the build type is the host's"
    build_host(build, lapfx)
    check_targets(build)
    check_scores(project, folder, build, lapfx)
    organ = os.path.join(project, "samples", "hook_cautery.glb")
    triangles = read_by(os.path.join(build, "libplugin.so"), organ, os.path.join(folder, "packed.glb"))
    scene = os.path.join(folder, "scene.json")
    put(scene, json.dumps({"format": "lapfx.scene", "version": 1, "organ": {"file": organ}}))
    pictures = [run(os.path.join(build, "simulator"), scene, os.path.join(project, "presets", "slow_ooze.json"),
                    os.path.join(project, "samples", "clips"), shader, "64", "48", "1", text=False) for shader in ("lapfx", "own")]
    for picture in pictures:
        assert picture.startswith(b"P6\n64 48\n255\n") and len(picture) == 13 + 64 * 48 * 3, picture[:20]
        assert len(set(picture[13:])) > 20, "an empty picture"
    assert pictures[0] != pictures[1], "the host's own shader draws what the core's does"
    print(f"a host links the core: {triangles} triangles read by its plug-in")


if __name__ == "__main__":
    main(*map(os.path.realpath, sys.argv[1:]))
