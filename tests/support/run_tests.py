#!/usr/bin/env python3
"""Runs ctest in a build folder and says at a glance what came of it; tests/run calls it.

    run_tests.py BUILD_FOLDER BUILD_SECONDS AGAIN [CTEST OPTION ...]

AGAIN is 1 or 0: whether what was red is run once more, alone. What passes then is called unsteady, and does not fail
the run. At the end come seconds, cases, the ten slowest, what was skipped and why, what was unsteady, and for each
failure the command that repeats it alone. The exit code is ctest's.
"""
import collections
import os
import re
import shutil
import subprocess
import sys
import time
import xml.etree.ElementTree

SLOWEST = 10
Case = collections.namedtuple("Case", "name seconds outcome reason repeat")  # outcome: passed, failed or skipped
SELF_TEST = {
    "fine": ("run", '<testsuites><testsuite name="A"><testcase name="One" status="run" result="completed" time="0.5"/>'
             '<testcase name="Two" status="run" result="skipped" time="0"><skipped message="f.cpp:1&#10;no data"/></testcase>'
             '</testsuite></testsuites>', "[ RUN      ] A.One\n"),
    "red": ("fail", '<testsuites><testsuite name="B"><testcase name="One" status="run" result="completed" time="2">'
            '<failure message="f.cpp:2&#10;1 is not 2"/></testcase></testsuite></testsuites>', ""),
    "crashed": ("fail", None, "[ RUN      ] C.One\n[       OK ] C.One (1 ms)\n[ RUN      ] C.Two\n"),
    "script": ("notrun", None, "script: no data"),
}


def parse(path):
    try:
        return xml.etree.ElementTree.parse(path).getroot()
    except (OSError, xml.etree.ElementTree.ParseError):
        return None


def text_of(element, tag):
    found = element.find(tag)
    return "" if found is None else (found.get("message") or found.text or "")


def cases_of(listed, program):
    """The cases of a group, from what its program has written."""
    for suite in listed:
        for case in suite:
            name = f"{suite.get('name')}.{case.get('name')}"
            outcome = "failed" if case.find("failure") is not None else \
                "skipped" if case.get("result") in ("skipped", "suppressed") else "passed"
            reason = text_of(case, "skipped").split("\n", 1)[-1].strip()
            yield Case(name, float(case.get("time") or 0), outcome, reason, f"{program} --gtest_filter='{name}'")


def outcome_of(test, results, programs):
    """The cases of one test of ctest; a script is one case, and so is a program that ended before its cases did."""
    name, seconds = test.get("name"), float(test.get("time") or 0)
    status = {"run": "passed", "fail": "failed"}.get(test.get("status"), "skipped")
    output = text_of(test, "system-out")
    listed = parse(os.path.join(results, name + ".xml"))
    if listed is not None:
        found = list(cases_of(listed, programs.get(name, name)))
        if status != "failed" or any(case.outcome == "failed" for case in found):
            return found
    begun = re.findall(r"^\[ RUN      \] (\S+)", output, re.MULTILINE)
    reason = text_of(test, "failure") or (output.strip().splitlines() or [""])[-1]
    if status == "failed" and begun:
        reason = f"ended in {begun[-1]}; what came after it has not run"
    return [Case(name, seconds, status, reason, f"tests/run -R '^{re.escape(name)}$'")]


def cases_in(junit, results, programs):
    root = parse(junit)
    found = {}
    for test in root if root is not None else ():
        found.update((case.name, case) for case in outcome_of(test, results, programs))
    return found


def ctest(folder, junit, *options):
    if os.path.exists(junit):
        os.remove(junit)
    return subprocess.run(["ctest", "--test-dir", folder, "--output-on-failure", "--no-tests=error", "--no-label-summary",
                           "--output-junit", junit, *options], check=False).returncode


def programs_of(folder):
    """{group: its program}, from the lists that the programs' build has left."""
    found = {}
    for path, _, names in os.walk(os.path.join(folder, "tests")):
        for name in names:
            if name.endswith("_groups.cmake"):
                with open(os.path.join(path, name), encoding="utf-8") as file:
                    found.update(re.findall(r"^add_test\(\[==\[(.*?)\]==\] \[==\[(.*?)\]==\]", file.read(), re.MULTILINE))
    return found


def told(cases, unsteady, build_seconds, test_seconds):
    """The lines of the table."""
    counts = collections.Counter(case.outcome for case in cases)
    yield f"build {build_seconds:.0f} s, tests {test_seconds:.0f} s, {len(cases)} cases"
    yield f"the {SLOWEST} slowest:"
    for case in sorted(cases, key=lambda case: -case.seconds)[:SLOWEST]:
        yield f"  {case.seconds:7.1f} s  {case.name}"
    for reason, count in collections.Counter(case.reason for case in cases if case.outcome == "skipped").most_common():
        yield f"skipped, {count}: {' '.join(reason.split())[:200] or 'no reason given'}"
    for name in unsteady:
        yield f"unsteady: {name} was red, and passed when it ran again alone: work to do"
    for case in cases:
        if case.outcome == "failed":
            yield f"failed: {case.name}" + (f" ({' '.join(case.reason.split())[:200]})" if case.reason else "")
            yield f"  alone: {case.repeat}"
    yield f"{counts['passed']} passed, {counts['failed']} failed, {counts['skipped']} skipped"


def run(folder, build_seconds, again, options):
    results = os.path.join(folder, "results")
    shutil.rmtree(results, ignore_errors=True)
    junit = os.path.join(folder, "Testing", "tests.xml")
    progress = ["--progress"] if sys.stdout.isatty() else []
    begin = time.monotonic()
    # One more than there are cores: tests of windows mostly wait.
    code = ctest(folder, junit, "--parallel", str(len(os.sched_getaffinity(0)) + 1), *progress, *options)
    if not os.path.exists(junit):  # it lists tests, or says what is wrong with an option
        return code
    programs = {group: os.path.relpath(program) for group, program in programs_of(folder).items()}
    cases, unsteady = cases_in(junit, results, programs), []
    if code != 0 and again:
        print("\nOnce more, alone, what was red:", flush=True)
        shutil.rmtree(results, ignore_errors=True)
        junit = os.path.join(folder, "Testing", "again.xml")
        code = ctest(folder, junit, "--rerun-failed", "--parallel", "1")
        second = cases_in(junit, results, programs)
        if not second:  # it was ended itself: then nothing has passed
            second = cases
        unsteady = [name for name, case in cases.items()
                    if case.outcome == "failed" and (name not in second or second[name].outcome != "failed")]
        # A program that ended too early was one case; now it is all of its own.
        cases = {name: case for name, case in {**cases, **second}.items() if name not in unsteady or name in second}
    print()
    for line in told(list(cases.values()), unsteady, build_seconds, time.monotonic() - begin):
        print(line)
    return code


def self_test():
    import tempfile

    with tempfile.TemporaryDirectory() as folder:
        root = xml.etree.ElementTree.Element("testsuite")
        for name, (status, listed, output) in SELF_TEST.items():
            test = xml.etree.ElementTree.SubElement(root, "testcase", name=name, status=status, time="3")
            xml.etree.ElementTree.SubElement(test, "system-out").text = output
            if listed:
                with open(os.path.join(folder, name + ".xml"), "w", encoding="utf-8") as file:
                    file.write(listed)
        junit = os.path.join(folder, "junit.xml")
        xml.etree.ElementTree.ElementTree(root).write(junit)
        cases = cases_in(junit, folder, {"red": "build/b"})
    outcomes = {name: case.outcome for name, case in cases.items()}
    assert outcomes == {"A.One": "passed", "A.Two": "skipped", "B.One": "failed", "crashed": "failed",
                        "script": "skipped"}, outcomes
    lines = list(told(list(cases.values()), ["D.One"], 1, 2))
    for line in ("skipped, 1: no data", "skipped, 1: script: no data", "failed: B.One",
                 "  alone: build/b --gtest_filter='B.One'", "  alone: tests/run -R '^crashed$'",
                 "failed: crashed (ended in C.Two; what came after it has not run)",
                 "unsteady: D.One was red, and passed when it ran again alone: work to do"):
        assert line in lines, (line, lines)
    assert lines[-1] == "1 passed, 2 failed, 2 skipped", lines


if __name__ == "__main__":
    if sys.argv[1:] == ["--self-test"]:
        self_test()
    else:
        sys.exit(run(sys.argv[1], float(sys.argv[2]), sys.argv[3] == "1", sys.argv[4:]))
