#!/usr/bin/env python3
"""write_groups.py PROGRAM TESTS_FOLDER LIST LABEL [BY_FILE]: asks a program of tests for its cases and writes into
LIST, for ctest, one test for each folder of test files (unit.smoke), or with BY_FILE for each file (editor.document).

Each writes what became of its cases to results/GROUP.xml beside the program, which tests/support/run_tests.py reads.
"""
import collections
import os
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

TIMEOUT_S = 3600  # ten times what the slowest group takes alone, and more


def cases(program, tests):
    """(suite, file) of every case. A compiler tells files as from the project's folder, or from where it ran."""
    folders = os.path.dirname(tests), os.path.dirname(program)
    with tempfile.TemporaryDirectory() as folder:
        listed = os.path.join(folder, "list.xml")
        done = subprocess.run([program, "--gtest_list_tests", "--gtest_output=xml:" + listed], capture_output=True, text=True,
                              check=False)
        if done.returncode != 0:
            sys.exit(f"{program} --gtest_list_tests: {done.returncode}\n{done.stdout}{done.stderr}")
        for suite in xml.etree.ElementTree.parse(listed).getroot():
            for case in suite:
                paths = [os.path.realpath(os.path.join(folder, case.get("file"))) for folder in folders]
                found = [path for path in paths if path.startswith(tests + os.sep) and os.path.exists(path)]
                if not found:
                    sys.exit(f"{program}: {case.get('file')} is no file below {tests}")
                yield suite.get("name"), found[0]


def group_of(file, tests, by_file):
    parts = os.path.relpath(file, tests).split(os.sep)
    if by_file:
        return parts[0] + "." + parts[-1].removesuffix("_test.cpp")
    return ".".join(parts[:2]) if len(parts) > 2 else parts[0] + ".top"


def labels_of(group, label):
    """`tests/run --quick` runs what is labelled quick."""
    return [label, "quick"] if label in ("unit", "ui") or group == "editor.document" else [label]


def quoted(text):
    return f"[==[{text}]==]"


def main(program, tests, out, label, by_file=""):
    tests = os.path.realpath(tests)
    group = {}  # each suite has one; a suite that several files share has that of the first
    for suite, file in cases(program, tests):
        group.setdefault(suite, group_of(file, tests, by_file))
    groups = collections.defaultdict(list)
    for suite, name in group.items():
        groups[name].append(suite)
    results = os.path.join(os.path.dirname(program), "results")
    lines = []
    for group, suites in sorted(groups.items()):
        words = [program, "--gtest_filter=" + ":".join(suite + ".*" for suite in suites),
                 f"--gtest_output=xml:{os.path.join(results, group)}.xml"]
        lines.append(f"add_test({quoted(group)} {' '.join(map(quoted, words))})\n"
                     f"set_tests_properties({quoted(group)} PROPERTIES TIMEOUT {TIMEOUT_S} "
                     f"LABELS {quoted(';'.join([*labels_of(group, label), *suites]))})\n")
    with open(out, "w", encoding="utf-8") as file:
        file.writelines(lines)


if __name__ == "__main__":
    main(*sys.argv[1:])
