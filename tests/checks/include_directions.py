#!/usr/bin/env python3
"""Checks that dependencies run one way.

    editor, samples -> effects/include/lapfx/*.h, and what is for lapfx's own programs:
                       effects/include_authoring/lapfx/authoring/*.h
    samples/host, as any host -> effects/include/lapfx/*.h, effects/c/include/lapfx.h alone
    editor: commands -> window, panels -> app -> match -> document -> lapfx/*.h
    editor/app: browser -> files -> measure -> {clips, reference} -> tuning -> preview -> base
    editor/match: use -> report -> fit -> {compare, explain, scene} -> video -> frame -> picture
    effects/c -> effects/*.{h,cpp} -> render -> {bleeding, smoke, cautery} -> organ -> {media, tool}
              -> {preset, gl, work} -> effects/include/lapfx/*.h
    lapfx::simulation (all of effects/ that does not draw, by the list in effects/CMakeLists.txt) -> nothing that draws,
                      no OpenGL

With --self-test, checks the checker: each rule on made-up files that break it and on ones that keep it.
"""
import os
import re
import sys

import source_files

PUBLIC = "effects/include/lapfx/"
IN_C = "effects/c/include/"
AUTHORING = "effects/include_authoring/lapfx/authoring/"
# The facade: it knows all of the core, so nothing that it is made of may include it.
FACADE = (PUBLIC + "effects.h", PUBLIC + "frame.h", AUTHORING + "preview.h")
LEVELS = {"preset": 0, "gl": 0, "work": 0, "media": 1, "tool": 1, "organ": 2, "bleeding": 3, "smoke": 3, "cautery": 3, "render": 4,
          "": 5, "c": 6}
# Public headers of what draws; what else of effects/ draws is said once, where the two libraries are made of it.
DRAWN = (*FACADE, PUBLIC + "context.h")
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*(?:"([^"]+)"|<([^>]+)>)', re.MULTILINE)
STANDARD = re.compile(r"[a-z_0-9]+")
# Of editor/, but its toolkit: a folder may include those below it, and those that share its number and are itself.
EDITOR_LEVELS = {"document": 0, "output": 0, "match": 1, "app": 2, "panels": 3, "window": 3, "commands": 4}
# Of what is edited, measuring and fitting know what it holds, and not how it is edited.
SEEN_BY_MATCH = "editor/document/content.h"
# Of editor/app/: what lies in no room is above all rooms.
APP_LEVELS = {"base": 0, "preview": 1, "tuning": 2, "clips": 3, "reference": 3, "measure": 4, "files": 5, "browser": 6, "": 7}
# Of editor/match/: every file lies in a room.
MATCH_LEVELS = {"picture": 0, "frame": 1, "video": 2, "compare": 3, "explain": 3, "scene": 3, "fit": 4, "report": 5, "use": 6}
ROOMS = {"app": APP_LEVELS, "match": MATCH_LEVELS}
# Of its toolkit, editor/ui/: events in, list of shapes out; gl/ draws that list.
TOOLKIT_LEVELS = {"value": 0, "draw": 1, "text": 2, "paint": 3, "gl": 4, "core": 4, "widgets": 5, "canvas": 6, "shell": 7}
GL = ("glad/", "GL/", "EGL/", "GLES", "KHR/")


def includes_of(text):
    """(quoted, name) of every #include."""
    return [(bool(quoted), quoted or angled) for quoted, angled in INCLUDE.findall(text)]


def part(path):
    """The folder of effects/ that a file lies in, '' at its top, None outside of it or in its public headers."""
    pieces = path.split("/")
    if pieces[0] != "effects" or path.startswith((PUBLIC, AUTHORING, IN_C)):
        return None
    return pieces[1] if len(pieces) > 2 else ""


def resolve(path, name, files):
    """The project's file that an #include in `path` means; None for a system header or a generated one."""
    top = path.split("/")[0]
    for folder in (os.path.dirname(path), top, "effects/include", "effects/include_authoring", IN_C, "effects", "editor", "samples", "tests"):
        candidate = os.path.normpath(os.path.join(folder, name)).replace(os.sep, "/")
        if candidate in files:
            return candidate
    return None


def public_fault(path, target, name):
    """A public header is small and stands alone: the standard library, GLM and its likes."""
    if target is None:
        allowed = STANDARD.fullmatch(name) or name.startswith("glm/")
        return None if allowed else f"a public header may include the standard library, GLM and lapfx/*.h, not {name}"
    if target.startswith(AUTHORING) and not path.startswith(AUTHORING):
        return "a host does not see what is for lapfx's own programs"
    if not target.startswith((PUBLIC, AUTHORING)):
        return "a public header may not include an internal one"
    if target in FACADE and path not in FACADE:
        return "only the headers of the facade know each other: they are above the other headers"
    return None


def c_fault(name):
    """The header in C is all that a host needs."""
    return None if name in ("stddef.h", "stdint.h") else f"the header in C includes <stddef.h> and <stdint.h>, not {name}"


def effects_fault(path, target):
    """Inside the core: downwards only."""
    here = part(path)
    if target is None:
        return None
    if target.startswith(IN_C):
        return None if here == "c" else f"effects/c is above effects/{here}"
    if target.startswith((PUBLIC, AUTHORING)):
        if target in FACADE and here not in ("", "render", "c"):
            return f"{target[target.index('lapfx/'):]} is above effects/{here}"
        return None
    there = part(target)
    if there is None:
        return f"the core knows nothing of {target.split('/')[0]}/"
    if here == there:
        return None
    if here not in LEVELS or there not in LEVELS:
        return f"effects/{here if here not in LEVELS else there} has no level in {os.path.basename(__file__)}"
    if LEVELS[here] == LEVELS[there]:
        return f"effects/{here} and effects/{there} are of one level and do not know each other"
    if LEVELS[here] < LEVELS[there]:
        return f"effects/{there} is above effects/{here}" if there else f"the top of effects/ is above effects/{here}"
    return None


def toolkit_fault(path, target, name):
    """The UI toolkit: events in, draw list out; a folder knows those below it."""
    if name.startswith("GLFW/"):
        return "the UI toolkit does not know the window system"
    if target is not None and not target.startswith("editor/ui/"):
        return "the UI toolkit stands alone"
    if target is None:
        return None
    here, there = (file.split("/")[2] for file in (path, target))
    if here == there or "/" not in path[len("editor/ui/"):]:
        return None
    if here not in TOOLKIT_LEVELS or there not in TOOLKIT_LEVELS:
        return f"editor/ui/{here if here not in TOOLKIT_LEVELS else there} has no level in {os.path.basename(__file__)}"
    if TOOLKIT_LEVELS[there] >= TOOLKIT_LEVELS[here]:
        return f"editor/ui/{there} is above or beside editor/ui/{here}"
    return None


def room(path):
    """The room of editor/app/ or editor/match/ that a file lies in, '' in none of them."""
    pieces = path.split("/")
    return pieces[2] if len(pieces) > 3 else ""


def room_fault(path, target):
    """Inside a folder of editor/ that has rooms: downwards only."""
    folder, here, there = path.split("/")[1], room(path), room(target)
    levels = ROOMS[folder]
    if here == there:
        return None
    if here not in levels or there not in levels:
        return f"editor/{folder}/{here if here not in levels else there} has no level in {os.path.basename(__file__)}"
    if levels[there] >= levels[here]:
        return f"editor/{folder}/{there} is above or beside editor/{folder}/{here}"
    return None


def outside_fault(path, target):
    """The editor and the samples see of the core what any simulator sees, and what there is for them; the sample host
    no more."""
    if target is not None and target.startswith("tests/"):
        return "this is of tests/: the product knows nothing of benches, the gallery and tests"
    seen = (PUBLIC, IN_C) if path.startswith("samples/host/") else (PUBLIC, IN_C, AUTHORING)
    if target is None or not target.startswith("effects/") or target.startswith(seen):
        return None
    if target.startswith(AUTHORING):
        return "a host does not see what is for lapfx's own programs"
    return "this is an internal header of effects/; only lapfx/*.h may be included here"


def editor_fault(path, target, name):
    """What is edited or measured knows no UI; the editor knows no panels; panels know no window and no OpenGL."""
    here = path.split("/")[1]
    if here in ("document", "match", "panels") and name.startswith((*GL, "GLFW/")):
        return f"editor/{here} does not know OpenGL and the window system"
    if target is None or not target.startswith("editor/") or here not in EDITOR_LEVELS:
        return None
    there = target.split("/")[1]
    if here == there and here in ROOMS:
        return room_fault(path, target)
    if there == "ui" and here in ("document", "match"):
        return "what is edited knows nothing of the UI" if here == "document" else "measuring knows nothing of the UI"
    if here == "match" and there == "document" and target != SEEN_BY_MATCH:
        return f"of what is edited, editor/match knows {SEEN_BY_MATCH} alone"
    if there in EDITOR_LEVELS and there != here and EDITOR_LEVELS[there] >= EDITOR_LEVELS[here]:
        return f"editor/{there} is above or beside editor/{here}"
    return None


def fault_of(path, target, name):
    if path.startswith((PUBLIC, AUTHORING)):
        return public_fault(path, target, name)
    if path.startswith(IN_C):
        return c_fault(name)
    if path.startswith("effects/"):
        return effects_fault(path, target)
    if path.startswith("editor/ui/"):
        return toolkit_fault(path, target, name)
    if path.startswith("editor/"):
        return outside_fault(path, target) or editor_fault(path, target, name)
    if path.startswith("samples/"):
        return outside_fault(path, target)
    return None  # tests may look anywhere


def reachable(path, graph):
    """{file: the file that includes it} for every file that `path` includes, directly or not."""
    seen, waiting = {}, [path]
    while waiting:
        current = waiting.pop()
        for target in graph[current]:
            if target not in seen and target != path:
                seen[target] = current
                waiting.append(target)
    return seen


def cpu_gpu_faults(texts, graph):
    """An effect's CPU part and GPU part never include each other; `_cpu` is in a name only if there is a `_gpu`."""
    for path in sorted(texts):
        kind = re.search(r"_(cpu|gpu)\.(?:h|cpp)$", path)
        if not path.startswith("effects/") or not kind:
            continue
        other = "_gpu." if kind[1] == "cpu" else "_cpu."
        if kind[1] == "cpu" and not any(path[:kind.start()] + f"_gpu.{end}" in texts for end in ("h", "cpp")):
            yield f"{path}: there is no _gpu beside it: leave _cpu out of its name"
        for target, by in sorted(reachable(path, graph).items()):
            through = "" if by == path else f" (through {by})"
            if other in os.path.basename(target):
                yield f"{path}: includes {target}{through}: the CPU part and the GPU part never include each other"


def drawing_files():
    """Pattern of the files that draw, below effects/: the list in its CMakeLists.txt."""
    text = source_files.read("effects/CMakeLists.txt")
    found = re.search(r'string\(JOIN "\|" DRAWS((?:\s*"[^"]+")+)\)', text)
    patterns = re.findall(r'"([^"]+)"', found[1]) if found else []
    assert patterns, "effects/CMakeLists.txt: does not list what draws"
    return re.compile("|".join(patterns))


def opengl_faults(texts, graph):
    """The simulation links without OpenGL: none of its files includes one that draws, directly or not."""
    pattern = drawing_files()
    drawing = {path for path in texts if part(path) is not None and pattern.search(path[len("effects/"):])}.union(DRAWN)
    for path in sorted(texts):
        if part(path) is None or path in drawing:
            continue
        reached = {**reachable(path, graph), path: path}
        for target in sorted(reached):
            through = f"{target} (through {reached[target]})"
            if target in drawing:
                yield f"{path}: includes {through}, which draws: this part knows no OpenGL"
            elif name := next((name for _, name in includes_of(texts[target]) if name.startswith(GL)), None):
                yield f"{path}: includes {name} in {through}: this part knows no OpenGL"


def check(texts):
    """Faults of {path: text}."""
    files = set(texts)
    graph = {}
    for path, text in sorted(texts.items()):
        graph[path] = []
        for _, name in includes_of(text):
            target = resolve(path, name, files)
            if target is not None:
                graph[path].append(target)
            fault = fault_of(path, target, name)
            if fault:
                yield f"{path}: includes {name}: {fault}"
    yield from cpu_gpu_faults(texts, graph)
    yield from opengl_faults(texts, graph)


# (what is wrong, or None if nothing is; {path: text}).
EXAMPLES = [
    (None, {"effects/render/frame.cpp": '#include "bleeding/wounds.h"', "effects/bleeding/wounds.h": "",
            "effects/effects.cpp": '#include "lapfx/effects.h"\n#include "render/frame.h"',
            "effects/render/frame.h": '#include "lapfx/authoring/preview.h"\n#include <glad/gl.h>', PUBLIC + "effects.h": "",
            AUTHORING + "preview.h": '#include "lapfx/effects.h"\n#include <glm/vec3.hpp>\n#include <vector>'}),
    (None, {"tests/bench/fit/fit.cpp": '#include "bench/report.h"\n#include "commands/options.h"', "tests/bench/report.h": "",
            "editor/commands/options.h": ""}),
    ("the product knows nothing of benches",
     {"editor/commands/a.cpp": '#include "bench/report.h"', "tests/bench/report.h": ""}),
    (None, {"editor/match/fit/fit.cpp": '#include "lapfx/effects.h"\n#include <nlopt.hpp>', PUBLIC + "effects.h": ""}),
    (None, {"tests/parity/ooze_test.cpp": '#include "bleeding/ooze_cpu.h"\n#include "bleeding/ooze_gpu.h"',
            "effects/bleeding/ooze_cpu.h": "", "effects/bleeding/ooze_gpu.h": ""}),
    (None, {"effects/smoke/smoke.cpp": '#include "smoke/keying_cpu.h"\n#include "smoke/keying_gpu.h"',
            "effects/smoke/keying_cpu.h": "", "effects/smoke/keying_gpu.h": "#include <glad/gl.h>"}),
    ("effects/render is above effects/bleeding",
     {"effects/bleeding/wounds.cpp": '#include "render/frame.h"', "effects/render/frame.h": ""}),
    ("effects/smoke is above effects/gl", {"effects/gl/a.cpp": '#include "../smoke/b.h"', "effects/smoke/b.h": ""}),
    ("are of one level", {"effects/smoke/a.cpp": '#include "cautery/b.h"', "effects/cautery/b.h": ""}),
    ("the top of effects/ is above", {"effects/render/a.cpp": '#include "all.h"', "effects/all.h": ""}),
    ("has no level", {"effects/new/a.cpp": '#include "gl/b.h"', "effects/gl/b.h": ""}),
    ("lapfx/effects.h is above effects/organ",
     {"effects/organ/a.cpp": '#include "lapfx/effects.h"', PUBLIC + "effects.h": ""}),
    ("lapfx/authoring/preview.h is above effects/smoke",
     {"effects/smoke/a.cpp": '  #  include <lapfx/authoring/preview.h>', AUTHORING + "preview.h": ""}),
    (None, {"effects/organ/a.cpp": '#include "lapfx/authoring/file.h"', "editor/app/a.cpp": '#include "lapfx/authoring/file.h"',
            AUTHORING + "file.h": '#include "lapfx/error.h"', PUBLIC + "error.h": ""}),
    (None, {"samples/host/a.c": "#include <lapfx.h>\n#include <stdio.h>", IN_C + "lapfx.h": "#include <stddef.h>",
            "effects/c/a.cpp": '#include "lapfx.h"\n#include "lapfx/effects.h"\n#include "render/b.h"', "effects/render/b.h": "",
            PUBLIC + "effects.h": ""}),
    ("the header in C includes", {IN_C + "lapfx.h": "#include <lapfx/organ.h>", PUBLIC + "organ.h": ""}),
    ("effects/c is above effects/render", {"effects/render/a.cpp": '#include "lapfx.h"', IN_C + "lapfx.h": ""}),
    ("effects/c is above effects/", {"effects/render/a.cpp": '#include "c/b.h"', "effects/c/b.h": ""}),
    ("this is an internal header", {"samples/host/a.c": '#include "c/b.h"', "effects/c/b.h": ""}),
    ("a host does not see", {PUBLIC + "organ.h": '#include "lapfx/authoring/file.h"', AUTHORING + "file.h": ""}),
    ("a host does not see", {"samples/host/a.cpp": '#include <lapfx/authoring/file.h>', AUTHORING + "file.h": ""}),
    ("may not include an internal one", {AUTHORING + "file.h": '#include "gl/b.h"', "effects/gl/b.h": ""}),
    ("the core knows nothing of editor/",
     {"effects/render/a.cpp": '#include "../../editor/ui/id.h"', "editor/ui/id.h": ""}),
    ("they are above the other headers",
     {PUBLIC + "organ.h": '#include "lapfx/effects.h"', PUBLIC + "effects.h": ""}),
    ("may not include an internal one", {PUBLIC + "organ.h": '#include "gl/b.h"', "effects/gl/b.h": ""}),
    ("not glad/gl.h", {PUBLIC + "effects.h": "#include <glad/gl.h>"}),
    ("not opencv2/core.hpp", {PUBLIC + "organ.h": "#include <opencv2/core.hpp>"}),
    ("not OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh",
     {PUBLIC + "organ.h": "#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>"}),
    ("not tiny_gltf.h", {PUBLIC + "organ.h": '#include "tiny_gltf.h"'}),
    ("not nlohmann/json.hpp", {PUBLIC + "preset.h": "#include <nlohmann/json.hpp>"}),
    ("the UI toolkit does not know the window system", {"editor/ui/input.h": "#include <GLFW/glfw3.h>"}),
    ("the UI toolkit stands alone", {"editor/ui/a.cpp": '#include "lapfx/preset.h"', PUBLIC + "preset.h": ""}),
    ("the UI toolkit stands alone", {"editor/ui/a.cpp": '#include "panels/b.h"', "editor/panels/b.h": ""}),
    ("editor/ui/widgets is above or beside editor/ui/core",
     {"editor/ui/core/a.cpp": '#include "ui/widgets/b.h"', "editor/ui/widgets/b.h": ""}),
    ("editor/ui/new has no level", {"editor/ui/new/a.cpp": '#include "ui/core/b.h"', "editor/ui/core/b.h": ""}),
    (None, {"editor/ui/shell/a.cpp": '#include "ui/core/b.h"', "editor/ui/core/b.h": ""}),
    ("editor/panels does not know OpenGL", {"editor/panels/a.cpp": "#include <glad/gl.h>"}),
    ("what is edited knows nothing of the UI",
     {"editor/document/a.cpp": '#include "ui/b.h"', "editor/ui/b.h": ""}),
    ("editor/panels is above or beside editor/app",
     {"editor/app/a.cpp": '#include "panels/b.h"', "editor/panels/b.h": ""}),
    (None, {"editor/panels/a.cpp": '#include "app/b.h"\n#include "ui/c.h"', "editor/app/b.h": "",
            "editor/ui/c.h": ""}),
    ("editor/app/files is above or beside editor/app/clips",
     {"editor/app/clips/a.cpp": '#include "app/files/b.h"', "editor/app/files/b.h": ""}),
    ("editor/app/clips is above or beside editor/app/reference",
     {"editor/app/reference/a.cpp": '#include "app/clips/b.h"', "editor/app/clips/b.h": ""}),
    ("editor/app/ is above or beside editor/app/files",
     {"editor/app/files/a.cpp": '#include "app/editor.h"', "editor/app/editor.h": ""}),
    ("editor/app/new has no level",
     {"editor/app/new/a.cpp": '#include "app/base/b.h"', "editor/app/base/b.h": ""}),
    (None, {"editor/app/editor.cpp": '#include "app/files/a.h"', "editor/app/files/a.h": '#include "app/base/b.h"',
            "editor/app/base/b.h": '#include "c.h"', "editor/app/base/c.h": "", "editor/panels/d.cpp": '#include "app/base/b.h"'}),
    ("editor/match/fit is above or beside editor/match/scene",
     {"editor/match/scene/a.h": '#include "match/fit/b.h"', "editor/match/fit/b.h": ""}),
    ("editor/match/compare is above or beside editor/match/explain",
     {"editor/match/explain/a.cpp": '#include "match/compare/b.h"', "editor/match/compare/b.h": ""}),
    ("editor/match/new has no level",
     {"editor/match/new/a.cpp": '#include "match/picture/b.h"', "editor/match/picture/b.h": ""}),
    ("editor/match/ has no level",
     {"editor/match/a.cpp": '#include "match/picture/b.h"', "editor/match/picture/b.h": ""}),
    ("editor/match is above or beside editor/output",
     {"editor/output/a.cpp": '#include "match/video/b.h"', "editor/match/video/b.h": ""}),
    ("editor/app is above or beside editor/match",
     {"editor/match/video/a.cpp": '#include "app/base/b.h"', "editor/app/base/b.h": ""}),
    ("measuring knows nothing of the UI", {"editor/match/video/a.cpp": '#include "ui/b.h"', "editor/ui/b.h": ""}),
    ("editor/match does not know OpenGL", {"editor/match/scene/a.cpp": "#include <glad/gl.h>"}),
    ("editor/match knows editor/document/content.h alone",
     {"editor/match/fit/a.h": '#include "document/document.h"', "editor/document/document.h": ""}),
    (None, {"editor/match/report/a.cpp": '#include "match/fit/b.h"\n#include "c.h"', "editor/match/report/c.h": "",
            "editor/match/fit/b.h": '#include "document/content.h"', "editor/document/content.h": "",
            "editor/app/measure/d.cpp": '#include "match/report/c.h"'}),
    ("only lapfx/*.h may be included here",
     {"editor/app.cpp": '#include "../effects/render/frame.h"', "effects/render/frame.h": ""}),
    ("only lapfx/*.h may be included here", {"samples/make.cpp": '#include "gl/b.h"', "effects/gl/b.h": ""}),
    ("never include each other",
     {"effects/smoke/key_cpu.cpp": '#include "smoke/key_gpu.h"', "effects/smoke/key_gpu.h": ""}),
    ("never include each other",
     {"effects/smoke/key_gpu.cpp": '#include "key_cpu.h"', "effects/smoke/key_cpu.h": ""}),
    ("(through effects/smoke/key.h)",
     {"effects/smoke/key_cpu.cpp": '#include "key.h"', "effects/smoke/key.h": '#include "key_gpu.h"',
      "effects/smoke/key_gpu.h": ""}),
    ("knows no OpenGL", {"effects/smoke/key_cpu.cpp": '#include "gl/a.h"', "effects/gl/a.h": "#include <glad/gl.h>"}),
    ("knows no OpenGL", {"effects/smoke/key_cpu.h": "#include <glad/gl.h>"}),
    ("knows no OpenGL", {"effects/simulation.h": '#include "smoke/a.h"', "effects/smoke/a.h": "#include <glad/gl.h>"}),
    ("knows no OpenGL", {"effects/cautery/a.h": "#include <EGL/egl.h>"}),
    ("knows no OpenGL", {"effects/smoke/haze.cpp": "#include <glad/gl.h>"}),
    ("knows no OpenGL", {"effects/amounts.cpp": '#include "lapfx/context.h"', PUBLIC + "context.h": ""}),
    ("knows no OpenGL", {"effects/organ/a.cpp": '#include "gl/b.h"', "effects/gl/b.h": ""}),
    ("knows no OpenGL", {"effects/smoke/a.cpp": '#include "media/clip_set.h"', "effects/media/clip_set.h": ""}),
    ("(through effects/media/b.h)",
     {"effects/media/a.cpp": '#include "b.h"', "effects/media/b.h": '#include "clip_player.h"',
      "effects/media/clip_player.h": ""}),
    (None, {"effects/smoke/haze_gpu.cpp": "#include <glad/gl.h>"}),
    (None, {"effects/media/clip_set.cpp": '#include "gl/a.h"', "effects/gl/a.h": "#include <glad/gl.h>"}),
    ("leave _cpu out of its name", {"effects/smoke/haze_cpu.h": ""}),
]


def self_test():
    for expected, texts in EXAMPLES:
        found = list(check(texts))
        if expected is None and found:
            yield f"clean files, yet: {found}"
        if expected is not None and not any(expected in fault for fault in found):
            yield f"expected a fault with '{expected}' for {texts}, found: {found}"


def main():
    if "--self-test" in sys.argv[1:]:
        return source_files.report(list(self_test()))
    paths = [path for path in source_files.project_files() if path.endswith(source_files.CPP)]
    if not any(path.startswith("effects/") for path in paths):
        return source_files.report(["no source files found: the check has nothing to look at"])
    return source_files.report(list(check({path: source_files.read(path) for path in paths})))


if __name__ == "__main__":
    sys.exit(main())
