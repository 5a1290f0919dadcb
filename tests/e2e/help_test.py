#!/usr/bin/env python3
"""`lapfx help`, the reference page and README: complete, and every command in them works as printed.

help_test.py LAPFX SOURCE_DIR SHIPPED_DIR PART: reference | examples | readme. Commands run in a folder that has copies
of presets/ and samples/ of SHIPPED_DIR, smaller ones, and the program as build/lapfx, so that what they write stays
there.
"""
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

LIMIT_S = 600  # for one command, also under a sanitizer
README_LINES = 200
# Each is e2e.bench.PART's, word by word.
RUN_ELSEWHERE = re.compile(r"lapfx bench (\w+) --short --json \1\.json$")


def run(command, folder, lapfx):
    """`command`: words; the first is lapfx or build/lapfx."""
    return subprocess.run([lapfx, *command[1:]], cwd=folder, capture_output=True, encoding="utf-8", timeout=LIMIT_S,
                          stdin=subprocess.DEVNULL, check=False)


def output(lapfx, *words):
    done = run(["lapfx", *words], None, lapfx)
    assert done.returncode == 0 and not done.stderr, f"lapfx {' '.join(words)}: {done.returncode}, {done.stderr}"
    return done.stdout


def section(text, title):
    """The names in a section of `lapfx help`: "  render     Render ..." under "Commands:"."""
    body = text.split(f"{title}:\n", 1)[1].split("\n\n", 1)[0]
    return re.findall(r"^  (\w+) ", body, re.MULTILINE)


def commands_and_parts(lapfx):
    for command in section(output(lapfx, "help"), "Commands"):
        yield (command,)
        text = output(lapfx, "help", command)
        if "\nParts:\n" in text:
            for part in section(text, "Parts"):
                yield command, part


def keys_of(schema, place="", first=""):
    """(place, key, row) of all values that a JSON Schema describes. `first`: ".0" where the place is a list."""
    for key, row in schema["properties"].items():
        inner = row.get("items", row)
        if "properties" in inner:
            yield from keys_of(inner, f"{place}{first}.{key}".lstrip("."), ".0" if "items" in row else "")
        elif key not in ("format", "version"):
            yield place, key, row


def sections_by_title(text):
    """{title: text} of a topic: a title is underlined."""
    parts = re.split(r"^(.+)\n-+\n", text, flags=re.MULTILINE)
    return dict(zip(parts[1::2], parts[2::2]))


def key_faults(topic, text, schema):
    sections = sections_by_title(text)
    for place, key, row in keys_of(schema):
        found = re.search(rf"^  {key}\s(.*?)(?=^  \w|^$|\Z)", sections.get(place or "At the top", ""), re.MULTILINE | re.DOTALL)
        if not found:
            yield f"lapfx help {topic}: lacks {place}.{key}"
            continue
        said = " ".join(found[1].split())
        if row.get("type") in ("number", "integer"):
            wanted = [f"from {row['minimum']:g} to ", f"default {row['default']:g}"] if "default" in row else []
        else:
            wanted = [f'"{name}"' for name in row.get("enum", [])]
        meaning = row["description"].split(". ", 1)[1].split(' Default: as "')[0]
        for words in (*wanted, meaning):
            if words not in said:
                yield f"lapfx help {topic}: of {place}.{key} it does not say {words!r}, but {said!r}"


def reference_faults(lapfx, source, _):
    with open(os.path.join(source, "presets", "REFERENCE.md"), encoding="utf-8") as file:
        page = file.read()
    printed = output(lapfx, "help", "--page")
    if page != printed:
        yield "presets/REFERENCE.md is out of date; renew it: build/lapfx help --page > presets/REFERENCE.md"
    with open(os.path.join(source, "editor", "TOUR.md"), encoding="utf-8") as file:
        if file.read() != output(lapfx, "help", "tour", "--page"):
            yield "editor/TOUR.md is out of date; renew it: build/lapfx help tour --page > editor/TOUR.md"
    if output(lapfx, "help", "render", "--page") != f"```text\n{output(lapfx, 'help', 'render')}```\n":
        yield "lapfx help render --page is not the help of render, fenced"
    for words in commands_and_parts(lapfx):
        text = output(lapfx, "help", *words)
        if text != output(lapfx, *words, "--help"):
            yield f"lapfx help {' '.join(words)} and lapfx {' '.join(words)} --help differ"
        if text not in printed.replace("```", ""):
            yield f"the page lacks lapfx {' '.join(words)}"
    if output(lapfx, "help") != output(lapfx, "--help"):
        yield "lapfx help and lapfx --help differ"
    if "Exit codes: 0 done, 1 failed while running, 2 wrong usage or bad input, 77 no usable OpenGL." not in printed:
        yield "the page lacks the exit codes"
    for topic in section(output(lapfx, "help"), "Topics of `lapfx help TOPIC`"):
        text = output(lapfx, "help", topic)
        if f"## lapfx help {topic}\n" not in printed:
            yield f"the page lacks the topic {topic}"
        if topic in ("preset", "scene"):
            yield from key_faults(topic, text, json.loads(output(lapfx, "check", "--schema", topic)))
    presets = output(lapfx, "help", "preset")
    for name in sorted(os.listdir(os.path.join(source, "presets"))):
        if name.endswith(".json") and not name.endswith(".schema.json"):
            with open(os.path.join(source, "presets", name), encoding="utf-8") as file:
                description = json.load(file)["description"]
            if description not in " ".join(presets.split()) or f"presets/{name}" not in presets:
                yield f"lapfx help preset lacks {name} and its description"
    for wrong, said in ((("shet",), "is not a command or topic of help; nearest is sheet"),
                        (("bench", "stream"), "is not a part of lapfx bench; nearest is streaming")):
        done = run(["lapfx", "help", *wrong], None, lapfx)
        if done.returncode != 2 or said not in done.stderr or done.stdout:
            yield f"lapfx help {' '.join(wrong)}: {done.returncode}, {done.stderr!r}"


def workplace(folder, shipped):
    """A place like the root of the repository, to run what is printed. What matters is that the commands work: behind
    the names of the sample's organ and video are a mesh of few triangles and one frame of twenty."""
    for name in ("presets", "samples"):
        shutil.copytree(os.path.join(shipped, name), os.path.join(folder, name))
    samples = os.path.join(folder, "samples")
    shutil.copy(os.path.join(samples, "liver_lobe.glb"), os.path.join(samples, "lagb.glb"))
    video = os.path.join(samples, "reference", "operation.mp4")
    subprocess.run(["ffmpeg", "-v", "error", "-i", os.path.join(shipped, "samples", "reference", "operation.mp4"), "-r", "1.25",
                    "-y", video], check=True)


def command_faults(lapfx, folder, line):
    done = run(shlex.split(line, comments=True), folder, lapfx)
    if done.returncode != 0:
        yield f"{line}: exit code {done.returncode}: {done.stderr[-500:]}"
    for name in re.findall(r"(?:-o|--json|--screenshot|--amounts|--dump|--report) (\S+)", line.split(" #")[0]):
        if not os.path.isfile(os.path.join(folder, name)) or os.path.getsize(os.path.join(folder, name)) == 0:
            yield f"{line}: left no {name}"


def examples(lapfx):
    """(command, its examples)."""
    for words in commands_and_parts(lapfx):
        yield words, re.findall(r"^  (lapfx .*)$", output(lapfx, "help", *words).split("\nExample", 1)[-1], re.MULTILINE)


def example_faults(lapfx, _, shipped):
    lines = []
    for words, found in examples(lapfx):
        if not found and words not in (("bench",), ("batch",)):  # their parts have them
            yield f"lapfx help {' '.join(words)}: has no example"
        lines += found
    with tempfile.TemporaryDirectory(prefix="lapfx help ") as folder:
        workplace(folder, shipped)
        for line in lines:
            if not RUN_ELSEWHERE.match(line):
                yield from command_faults(lapfx, folder, line)


def readme_faults(lapfx, source, shipped):
    with open(os.path.join(source, "README.md"), encoding="utf-8") as file:
        text = file.read()
    if text.count("\n") > README_LINES:
        yield f"README.md has {text.count(chr(10))} lines; at most {README_LINES}"
    for name in re.findall(r"\]\(([^)#]+)\)", text):
        if "://" not in name and not os.path.exists(os.path.join(source, name)):
            yield f"README.md: there is no {name}"
    actions = re.findall(r"^\| `(\w+)` \| .*; key (\d) \|", output(lapfx, "help", "--page"), re.MULTILINE)
    if len(actions) < 7:
        yield f"the page lists only {len(actions)} actions with keys"
    tour = " ".join(output(lapfx, "help", "tour").split())
    yield from (f"lapfx help tour: key {key} is {action}" for action, key in actions
                if not re.search(rf"\b{key} (to )?{action}\b", tour))
    lines = re.findall(r"^    (build/lapfx .*)$", text, re.MULTILINE)
    if len(lines) < 3:
        yield f"README.md has only {len(lines)} commands to run"
    elsewhere = [shlex.split(line)[1:] for _, found in examples(lapfx) for line in found]  # run by the part examples
    with tempfile.TemporaryDirectory(prefix="lapfx readme ") as folder:
        workplace(folder, shipped)
        for line in lines:
            if shlex.split(line, comments=True)[1:] not in elsewhere:
                yield from command_faults(lapfx, folder, line)


def main():
    lapfx, source, shipped, part = sys.argv[1:]
    faults = {"reference": reference_faults, "examples": example_faults, "readme": readme_faults}[part](
        os.path.realpath(lapfx), source, shipped)
    count = 0
    for fault in faults:
        print(fault)
        count += 1
    sys.exit(1 if count else 0)


if __name__ == "__main__":
    main()
