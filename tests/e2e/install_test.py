#!/usr/bin/env python3
"""What `cmake --install` puts where: it is moved to another folder, and everything is used from there alone.

    install_test.py BUILD SOURCE FOLDER [--renew]

FOLDER is kept: what is built there once is not built again. --renew writes exported_names.txt again.
"""
import os
import re
import shutil
import subprocess
import sys

import installed_hosts
from installed_hosts import run

NAMES = os.path.join(os.path.dirname(os.path.realpath(__file__)), "exported_names.txt")
HEAD = ("# What liblapfx.so exports: the functions of its headers (effects/include/lapfx, effects/c/include). Renewed by "
        "install_test.py --renew.\n")


def installed(build, folder):
    """Installs, and moves what was installed."""
    at_first, prefix = os.path.join(folder, "first"), os.path.join(folder, "moved here")
    for old in (at_first, prefix):
        shutil.rmtree(old, ignore_errors=True)
    # As after editor/start, which does not build all that is installed.
    os.remove(os.path.join(build, "pages", "lapfx"))
    run("cmake", "--install", build, "--prefix", at_first)
    pages = os.path.join(at_first, "share", "bash-completion", "completions", "lapfx")
    assert os.path.isfile(pages), "what is missing in the build folder is not built when it is installed"
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
            found = re.search(re.escape(os.fsencode(folder)) + rb"(?![\w.-])", data)
            assert not found, f"{path} names {folder}: {data[max(found.start() - 40, 0):found.start() + 80]}"


def check_headers(include):
    """They name no file that is only in the source."""
    for path in files_below(include):
        with open(path, encoding="utf-8") as file:
            found = re.search(r".*\b(effects|editor|authoring|tests|shaders)/.*", file.read())
        assert not found, f"{path}: {found[0]}"


def exported(library):
    lines = run("nm", "-DC", "--defined-only", library).splitlines()
    return sorted({line.split(" ", 2)[2] for line in lines})  # a constructor is there twice


def check_library(prefix, renew):
    library = next(path for path in files_below(prefix) if os.path.basename(path) == "liblapfx.so")
    dynamic = run("readelf", "-d", library)
    assert re.search(r"SONAME.*\[liblapfx\.so\.0\.1\]", dynamic), dynamic
    assert not re.search(r"RPATH|RUNPATH|Qt|highgui|OSMesa", dynamic), dynamic
    names = exported(library)
    if renew:
        with open(NAMES, "w", encoding="utf-8") as file:
            file.write(HEAD + "".join(name + "\n" for name in names))
    listed = [line for line in open(NAMES, encoding="utf-8").read().splitlines() if not line.startswith("#")]
    more, less = sorted(set(names) - set(listed)), sorted(set(listed) - set(names))
    assert not more and not less, f"exported and not in exported_names.txt: {more}; there and not exported: {less}"
    # Those in C are names of functions and no more; all others are of the namespace.
    foreign = [name for name in names if "lapfx::" not in name and not re.fullmatch("lapfx_[a-z_]+", name)]
    assert not foreign, foreign
    header = open(os.path.join(prefix, "include", "lapfx.h"), encoding="utf-8").read()
    in_c = {name for name in names if "lapfx::" not in name}
    assert in_c == set(re.findall(r"\b(lapfx_[a-z_]+)\(", re.sub(r"//.*", "", header))), in_c
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
    for words in (("bench", "bleeding"), ("gallery", "--bare")):
        done = subprocess.run([program, *words], capture_output=True, text=True, timeout=100, env=environment)
        line = f"lapfx: {program}_{words[0]}: not built: `lapfx {words[0]}` needs it; it is built from the source tree: " \
               f"cmake --build build --target lapfx_{words[0]}\n"
        assert (done.returncode, done.stdout, done.stderr) == (1, "", line), done
    return scene, os.path.join(data, "presets", "gastric_banding.json"), os.path.join(data, "samples", "clips")


def main(build, source, folder, *more):
    os.makedirs(folder, exist_ok=True)
    prefix = installed(build, folder)
    check_names_no_folder(prefix, source, build, folder)
    check_headers(os.path.join(prefix, "include"))
    libraries = check_library(prefix, "--renew" in more)
    scene, preset, clips = check_program(prefix, build)
    installed_hosts.check_drawing_host(source, prefix, folder, build, scene, preset, clips)
    installed_hosts.check_scoring_host(source, libraries, folder, build, scene, preset)
    installed_hosts.check_other_languages(source, prefix, libraries, folder, build, scene, preset, clips)


if __name__ == "__main__":
    main(*[os.path.realpath(word) if not word.startswith("--") else word for word in sys.argv[1:]])
