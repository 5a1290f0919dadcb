#!/usr/bin/env python3
"""The man pages and the completion of bash, as they are installed.

man_test.py LAPFX SAMPLES PART: pages | completion. SAMPLES: the folder of samples, which completion looks into.
"""
import glob
import os
import re
import shutil
import subprocess
import sys
import tempfile

import help_test

COMPLETE = """
compopt() { :; }  # bash has it only where it completes by itself
source "$1"; shift
COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1))
_lapfx
printf '%s\\n' "${COMPREPLY[@]}"
"""
# What is typed, up to the key, and what is offered: a pattern stands for the files that are there.
CASES = (
    ("re", ["render"]),
    ("f", ["fit"]),
    ("cli", ["clips"]),
    ("render ", ["*.scene.json", "clips", "host", "organs", "pictures", "reference"]),
    ("render --ba", ["--backend"]),
    ("render lagb.scene.json --backend ", ["auto", "egl", "osmesa"]),
    ("render lagb.scene.json --backend = o", ["osmesa"]),
    ("render lagb.scene.json --backend =", ["auto", "egl", "osmesa"]),
    ("render lagb.scene.json --overlay v", ["vessels"]),
    ("render lagb.scene.json --at ", []),
    ("render lagb.scene.json --layers cl", ["clips"]),
    ("render lagb.scene.json -o lag", ["lagb.glb", "lagb.scene.json"]),
    ("measure clips/plume_t", ["clips/plume_thick.mp4"]),
    ("measure lagb", []),
    ("check lagb", ["lagb.scene.json"]),
    ("check --schema p", ["preset"]),
    ("batch ", ["--help", "-h", "collect", "list", "run"]),
    ("batch run --in", ["--into"]),
    ("batch run --into cl", ["clips"]),
    ("bench streaming --r", ["--rounds"]),
    ("edit --layout K", ["Key"]),
    ("help ove", ["overlays"]),
    ("help re", ["render"]),
    ("help --completion ", ["bash"]),
    ("lagb.scene.json --the", ["--theme"]),
)


def run(*command, **more):
    return subprocess.run(command, capture_output=True, encoding="utf-8", timeout=help_test.LIMIT_S, check=False, **more)


def said(text):
    """The text of a page as a person reads it, however its lines are broken."""
    return "".join(text.split())


def page_faults(lapfx, _):
    with tempfile.TemporaryDirectory(prefix="lapfx man ") as folder:
        pages = os.path.join(folder, "new", "man")
        done = run(lapfx, "help", "--man", pages)
        if done.returncode != 0 or done.stdout or done.stderr:
            yield f"lapfx help --man: {done}"
        shown = {}
        for name in sorted(os.listdir(pages)):
            done = run("groff", "-Kutf8", "-Tutf8", "-man", "-ww", "-P-cbou", os.path.join(pages, name))
            if done.returncode != 0 or done.stderr:
                yield f"{name}: groff says: {done.stderr[:500]}"
            shown[name] = said(done.stdout)
        yield from missing_words(lapfx, shown)
        with open(os.path.join(folder, "file"), "w", encoding="utf-8"):
            pass
        done = run(lapfx, "help", "--man", os.path.join(folder, "file"))
        if done.returncode != 1 or not re.fullmatch(r"lapfx: .*/file: this folder cannot be made: .*\n", done.stderr):
            yield f"into what is no folder: {done}"


def missing_words(lapfx, shown):
    """`shown`: {"lapfx-render.1": what a person reads}."""
    help_of_program = help_test.output(lapfx, "help")
    commands = help_test.section(help_of_program, "Commands")
    topics = help_test.section(help_of_program, "Topics of `lapfx help TOPIC`")
    expected = {"lapfx.1", *(f"lapfx-{command}.1" for command in commands),
                *(f"lapfx-{topic}.{5 if topic in ('preset', 'scene') else 7}" for topic in topics)}
    if expected != set(shown):
        yield f"the pages are {sorted(shown)}, not {sorted(expected)}"
    for words in help_test.commands_and_parts(lapfx):
        text = help_test.output(lapfx, "help", *words)
        options = re.findall(r"^  ((?:-\w,)?--\S+(?: \S+)*)(?:  |$)", text, re.MULTILINE)
        if len(options) != len(re.findall(r"^  -", text, re.MULTILINE)) or "lapfx" + "".join(words) not in shown[f"lapfx-{words[0]}.1"]:
            yield f"lapfx-{words[0]}.1 lacks {' '.join(words)}"
        for option in options:
            if said(option.replace(",-", ", -")) not in shown[f"lapfx-{words[0]}.1"]:
                yield f"lapfx-{words[0]}.1 lacks {option}"
    for number, topic in ((5, "preset"), (5, "scene"), (7, "files")):
        text = help_test.output(lapfx, "help", topic).replace("`", "")
        for name in re.findall(r"^  ([\w.]+)  ", text, re.MULTILINE):
            if name not in shown[f"lapfx-{topic}.{number}"]:
                yield f"lapfx-{topic}.{number} lacks {name}"
    if "EXITSTATUS0done,1failedwhilerunning" not in shown["lapfx.1"]:
        yield "lapfx.1 lacks the exit codes"


def completion_faults(lapfx, samples):
    with tempfile.TemporaryDirectory(prefix="lapfx completion ") as folder:
        script = os.path.join(folder, "lapfx")
        with open(script, "w", encoding="utf-8") as file:
            file.write(help_test.output(lapfx, "help", "--completion", "bash"))
        for typed, offered in CASES:
            done = run("bash", "-c", COMPLETE, "bash", script, "lapfx", *typed.split(" "), cwd=samples)
            found = sorted(set(done.stdout.split("\n")) - {""})
            offered = sorted(name for pattern in offered for name in glob.glob(pattern, root_dir=samples) or [pattern])
            if done.returncode != 0 or done.stderr or found != offered:
                yield f"lapfx {typed}: offers {found}, not {offered}; {done.stderr}"
        if shutil.which("shellcheck"):
            done = run("shellcheck", "-s", "bash", script)
            if done.returncode != 0:
                yield done.stdout
    done = run(lapfx, "help", "--completion", "fish")
    if done.returncode != 2 or "fish not in {bash}" not in done.stderr or done.stdout:
        yield f"another shell: {done}"


def main():
    lapfx, samples, part = sys.argv[1:]
    faults = list({"pages": page_faults, "completion": completion_faults}[part](os.path.realpath(lapfx), samples))
    print("\n".join(faults))
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
