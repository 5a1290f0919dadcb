#!/usr/bin/env python3
"""The Debian packages: lintian finds no error, they hold what they should, and what is unpacked works where it lies.

    packages_test.py BUILD SOURCE

`tests/run --deep` (LAPFX_DEEP=1) also installs them in a new Debian 12 of debootstrap, where the program draws, every
sample host is built and draws, and nothing is left once they are removed. That needs root and the network. 77 where
lintian is missing, or of the deep part debootstrap or root.
"""
import glob
import gzip
import os
import re
import shutil
import subprocess
import sys
import tempfile

import help_test
import install_test
import installed_hosts
import real_window
import vtk_host_test
from install_test import run

PACKAGES = ("lapfx", "liblapfx", "liblapfx-dev", "python3-lapfx")
LOADED_LATER = ("fonts-inter", "fonts-dejavu-core", "libgl1-mesa-dri", "libosmesa6")
SAMPLES = ("lagb.glb", "hook_cautery.glb", "liver_lobe.glb", "reference/operation.mp4")
# What hosts are built with, as a stranger has to install it.
FOR_HOSTS = ("g++", "cmake", "ninja-build", "pkg-config", "libglfw3-dev", "python3-glad", "libegl-dev", "libvtk9-dev")
DESKTOP = ("applications/lapfx.desktop", "mime/packages/lapfx.xml", "icons/hicolor/scalable/apps/lapfx.svg",
           "bash-completion/completions/lapfx")


def packed(build):
    """{name: its .deb}, made anew."""
    folder = os.path.join(build, "packages_of_test")
    shutil.rmtree(folder, ignore_errors=True)
    run("cpack", "-G", "DEB", "-B", folder, cwd=build)
    found = {os.path.basename(path).split("_")[0]: path for path in glob.glob(os.path.join(folder, "*.deb"))}
    assert sorted(found) == list(PACKAGES), found
    return found


def unpacked(packages, folder):
    """The names below usr/ in each."""
    names = {}
    for name, package in packages.items():
        one = os.path.join(folder, name)
        run("dpkg-deb", "-x", package, one)
        names[name] = sorted(os.path.relpath(path, os.path.join(one, "usr")) for path in install_test.files_below(one))
        run("dpkg-deb", "-x", package, os.path.join(folder, "root"))
    return names


def names_below(folder, into, pattern=r""):
    paths = install_test.files_below(folder)
    return [os.path.join(into, os.path.relpath(path, folder)) for path in paths if re.search(pattern, path)]


def expected_names(source, program, libraries):
    """`libraries`: usr/lib, or the folder of one architecture below it."""
    topics = help_test.section(help_test.output(program, "help"), "Topics of `lapfx help TOPIC`")
    commands = help_test.section(help_test.output(program, "help"), "Commands")
    pages = ["man1/lapfx.1", *(f"man1/lapfx-{command}.1" for command in commands)]
    for topic in topics:
        section = 5 if topic in ("preset", "scene") else 7
        pages.append(f"man{section}/lapfx-{topic}.{section}")
    data = "share/lapfx"
    names = {
        "lapfx": ["bin/lapfx", *(f"share/man/{page}.gz" for page in pages), *(f"share/{name}" for name in DESKTOP),
                  *(f"{data}/samples/{name}" for name in SAMPLES),
                  *names_below(f"{source}/samples", f"{data}/samples", r"samples/[^/]*\.scene\.json$"),
                  *names_below(f"{source}/samples/clips", f"{data}/samples/clips", r"\.mp4$"),
                  *names_below(f"{source}/presets", f"{data}/presets", r"\.(json|md)$"),
                  *names_below(f"{source}/shaders", f"{data}/shaders", r"\.(glsl|vert|frag)$")],
        "liblapfx": [f"{libraries}/liblapfx.so.0.1", f"{libraries}/liblapfx.so.0.1.0"],
        "liblapfx-dev": [f"{libraries}/liblapfx.so", f"{libraries}/pkgconfig/lapfx.pc", f"{libraries}/pkgconfig/lapfx-c.pc",
                         "include/lapfx.h",
                         *names_below(f"{source}/effects/include/lapfx", "include/lapfx", r"\.h$"),
                         *names_below(f"{source}/samples/host", "share/lapfx/samples/host", r"\.(c|cpp|py)$"),
                         *(f"{libraries}/cmake/lapfx/lapfx{name}.cmake"
                           for name in ("Config", "ConfigVersion", "Targets", "Targets-release"))],
        "python3-lapfx": ["lib/python3/dist-packages/lapfx.py"],
    }
    for package, of in names.items():
        of += [f"share/doc/{package}/copyright", f"share/doc/{package}/changelog.gz"]
    return names


def check_names(names, source, program):
    library = next(name for name in names["liblapfx"] if name.endswith("/liblapfx.so.0.1"))
    for package, expected in expected_names(source, program, os.path.dirname(library)).items():
        more, less = sorted(set(names[package]) - set(expected)), sorted(set(expected) - set(names[package]))
        assert not more and not less, f"{package} also has {more}, and lacks {less}"


def check_control(packages):
    def field(name, of):
        return run("dpkg-deb", "-f", packages[name], of).strip()

    version = field("liblapfx", "Version")
    depends = field("lapfx", "Depends").split(", ")
    assert set(LOADED_LATER) <= set(depends) and any(one.startswith("libegl1") for one in depends), depends
    assert field("liblapfx-dev", "Depends") == f"liblapfx (= {version}), libglm-dev"
    assert field("liblapfx-dev", "Recommends") == "lapfx"
    assert field("python3-lapfx", "Depends") == f"liblapfx (= {version}), python3, python3-numpy"
    assert run("dpkg-deb", "-I", packages["liblapfx"], "shlibs").strip() == f"liblapfx 0.1 liblapfx (= {version})"
    for name in PACKAGES:
        summary, extended = field(name, "Description").split("\n", 1)
        assert len(summary) <= 80 and len(extended.split("\n")) > 2, (summary, extended)


def check_desktop(root):
    """As the programs of a desktop read it."""
    share = os.path.join(root, "usr", "share")
    if shutil.which("desktop-file-validate"):
        run("desktop-file-validate", os.path.join(share, "applications", "lapfx.desktop"))
    if shutil.which("update-mime-database"):
        mime = os.path.join(root, "mime")
        shutil.copytree(os.path.join(share, "mime"), mime)
        run("update-mime-database", mime)
        with open(os.path.join(mime, "globs2"), encoding="utf-8") as file:
            kinds = [line.strip() for line in file if not line.startswith("#")]
        assert sorted(kinds) == ["50:application/x-lapfx-preset+json:*.preset.json",
                                 "50:application/x-lapfx-scene+json:*.scene.json"], kinds
        with open(os.path.join(share, "applications", "lapfx.desktop"), encoding="utf-8") as file:
            entry = file.read()
        assert all(kind.split(":")[1] + ";" in entry for kind in kinds), entry


def check_names_no_folder(root, *folders):
    install_test.check_names_no_folder(root, *folders)
    for path in install_test.files_below(root):
        if path.endswith(".gz"):
            with gzip.open(path) as file:
                data = file.read()
            assert not any(os.fsencode(folder) in data for folder in folders), f"{path} names a folder of this machine"


def mirror():
    """Where apt of this machine has Debian 12 from, or None."""
    sites = run("apt-get", "indextargets", "--format", "$(SITE)", "Created-By: Packages", "Codename: bookworm").split()
    return sites[0] if sites else None


def remove_root(root):
    """What is still mounted there belongs to this machine, too: with it, nothing is removed."""
    with open("/proc/self/mounts", encoding="utf-8") as file:
        mounted = [line.split()[1] for line in file if line.split()[1].startswith(root + "/")]
    for place in sorted(mounted, reverse=True):
        run("umount", place)
    shutil.rmtree(root)


def check_hosts_in_new_debian(root, inside):
    """Built of what lies in share/lapfx; C++, C, Python and each eye draw the same picture."""
    data = "/usr/share/lapfx"
    shown = (f"{data}/samples/lagb.scene.json", f"{data}/presets/gastric_banding.json", f"{data}/samples/clips")
    for name, project in (("cpp", installed_hosts.IN_CPP), ("c", installed_hosts.IN_C), ("vtk", vtk_host_test.PROJECT)):
        installed_hosts.put(f"{root}/srv/{name}/CMakeLists.txt", project.format(source=data))
        inside("cmake", "-S", f"/srv/{name}", "-B", f"/srv/{name}/build", "-G", "Ninja")
        inside("cmake", "--build", f"/srv/{name}/build")
    hosts = f"{data}/samples/host"
    inside("sh", "-c", f"c++ -std=c++20 {hosts}/scores.cpp $(pkg-config --cflags --libs lapfx) -o /srv/scores")
    assert "mm2" in inside("/srv/scores", *shown[:2])

    def drawn(*command):
        inside("sh", "-c", '"$@" > /srv/host.ppm', "sh", *command)
        with open(f"{root}/srv/host.ppm", "rb") as file:
            return file.read()

    size = ("160", "128", "4")
    wanted = drawn("/srv/cpp/build/simulator", *shown, "lapfx", *size)
    assert len(set(wanted[15:])) > 40, "nothing is drawn"
    assert drawn("/srv/c/build/simulator", *shown, *size) == wanted, "the host in C draws another picture"
    assert drawn("python3", f"{hosts}/host.py", *shown, *size) == wanted, "the host in Python draws another picture"
    two = drawn("/srv/cpp/build/stereo", *shown, *size, "0")
    rows = [two[15 + row * 960: 15 + row * 960 + 480] for row in range(128)]
    assert max(abs(a - b) for a, b in zip(b"".join(rows), wanted[15:])) <= 1, "an eye sees another picture"
    display = real_window.Display(os.path.join(root, "srv"))
    try:
        in_vtk = drawn("env", f"DISPLAY={display.name}", "/srv/vtk/build/simulator", *shown, *size)
    finally:
        display.close()
    assert len(in_vtk) == len(wanted) and len(set(in_vtk[15:])) > 40, "the host in VTK draws nothing"


def check_in_new_debian(packages, site):
    root = tempfile.mkdtemp(prefix="lapfx-debian-")
    clean = {"PATH": "/usr/sbin:/usr/bin:/sbin:/bin", "LC_ALL": "C", "DEBIAN_FRONTEND": "noninteractive",
             **{name: value for name, value in os.environ.items() if name.endswith("_proxy")}}

    def inside(*command):
        return run("chroot", root, *command, env=clean)

    try:
        run("debootstrap", "--variant=minbase", "bookworm", root, site)
        run("mount", "-t", "proc", "proc", os.path.join(root, "proc"))  # by it a program knows where it lies
        for file in packages.values():
            shutil.copy(file, os.path.join(root, "srv"))
        debs = [f"/srv/{os.path.basename(package)}" for package in packages.values()]
        inside("apt-get", "-q", "install", "-y", "--no-install-recommends", *debs)
        scene, preset = (f"/usr/share/lapfx/{name}" for name in ("samples/lagb.scene.json", "presets/gastric_banding.json"))
        for backend in ("auto", "osmesa"):
            inside("lapfx", "render", scene, "--at", "4", "--size", "320x256", "--backend", backend, "-o", f"/srv/{backend}.png")
        inside("lapfx", "edit", scene, "--backend", "osmesa", "--screenshot", "/srv/editor.png")
        for name, least in (("auto", 20_000), ("osmesa", 20_000), ("editor", 100_000)):
            size = os.path.getsize(os.path.join(root, "srv", name + ".png"))
            assert size > least, f"{name}.png has {size} bytes"
        inside("apt-get", "-q", "install", "-y", "--no-install-recommends", *FOR_HOSTS)
        check_hosts_in_new_debian(root, inside)
        inside("apt-get", "-q", "purge", "-y", *PACKAGES)
        left = inside("find", "/usr", "/etc", "/var/lib", "-name", "*lapfx*").split()
        assert not left, f"left behind: {left}"
    finally:
        remove_root(root)


def main(build, source):
    build, source = os.path.realpath(build), os.path.realpath(source)
    skipped = []
    packages = packed(build)
    with tempfile.TemporaryDirectory(prefix="lapfx packages ") as folder:
        names = unpacked(packages, folder)
        root = os.path.join(folder, "root")
        check_names_no_folder(root, source, build)
        check_names(names, source, os.path.join(root, "usr", "bin", "lapfx"))
        check_control(packages)
        check_desktop(root)
        install_test.check_program(os.path.join(root, "usr"), build)
    if shutil.which("lintian"):
        print(run("lintian", "--fail-on", "error", *packages.values()))
    else:
        skipped.append("lintian is not installed, so it was not asked about the packages")
    if os.environ.get("LAPFX_DEEP"):
        site = mirror()
        if os.geteuid() != 0 or not shutil.which("debootstrap") or site is None:
            skipped.append("they were not installed in a new Debian: that needs root, debootstrap, and an apt that knows "
                           "where bookworm is")
        else:
            check_in_new_debian(packages, site)
    print("\n".join(skipped))
    sys.exit(77 if skipped else 0)


if __name__ == "__main__":
    main(*sys.argv[1:])
