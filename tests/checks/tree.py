#!/usr/bin/env python3
"""Checks the tree: what lies at the top, that code is ASCII (strings of C++ aside) without stray blanks, that files
and comments stay readable (those of C++ are wrapped by clang-format).

With --self-test, checks the checker on made-up files.
"""
import ast
import os
import re
import sys

import source_files

TOP = {"CMakeLists.txt", "README.md", "editor", "effects", "shaders", "presets", "samples", "tests"}
TEXT = source_files.CPP + source_files.SHADERS + (".cmake", "CMakeLists.txt", ".py", ".sh", ".md")
LIMITED = source_files.CPP + source_files.SHADERS
MAX_LINES = 600
MAX_COLUMNS = 120  # a comment has no more
# What a person reads, such as a unit, may be UTF-8: raw strings, strings; characters only so that '"' opens none.
STRING = re.compile(rb'''R"\((?s:.*?)\)"|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])[']''')
PRINTED = "presets/REFERENCE.md"  # the program prints it from such strings
COMMANDS = ("editor/start", "tests/run", "tests/accept", ".ci/run")


def top_faults(paths):
    for top in sorted({path.split("/")[0] for path in paths}):
        if top not in TOP and not top.startswith("."):
            yield f"{top}: not one of the entries of the top level ({', '.join(sorted(TOP))}, dot-files)"
    for path in paths:
        if path.endswith((".pyc", ".o", ".orig")):
            yield f"{path}: made by a program, not to be kept"


def comment_lines(path, text):
    """Numbers of the lines that are, or end in, a comment or belong to a docstring."""
    if path.endswith(".md"):
        return set()
    mark = re.compile(r"(?:^|\s)//" if path.endswith(LIMITED) else r"(?:^|\s)#")
    found = {number for number, line in enumerate(text.split("\n"), 1) if mark.search(line)}
    if path.endswith(".py"):
        for node in ast.walk(ast.parse(text)):
            if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef)) and ast.get_docstring(node):
                found.update(range(node.body[0].lineno, node.body[0].end_lineno + 1))
    return found


def text_faults(path, data):
    lines = code = data.split(b"\n")
    if path.endswith(source_files.CPP):
        code = STRING.sub(lambda found: b"\n" * found[0].count(b"\n"), data).split(b"\n")
    elif path == PRINTED:
        code = [b""] * len(lines)
    for number, line in enumerate(lines, 1):
        if not code[number - 1].isascii():
            yield f"{path}:{number}: not ASCII"
        if line != line.rstrip():
            yield f"{path}:{number}: blanks or a carriage return at the end of the line"
    long = [number for number, line in enumerate(lines, 1) if len(line.decode()) > MAX_COLUMNS]
    for number in sorted(comment_lines(path, data.decode()).intersection(long)) if long else ():
        yield f"{path}:{number}: a comment of more than {MAX_COLUMNS} columns"
    if data and lines[-1] != b"":
        yield f"{path}:{len(lines)}: no newline at the end of the file"
    if path.endswith(LIMITED) and len(lines) - 1 > MAX_LINES:
        yield f"{path}: {len(lines) - 1} lines; at most {MAX_LINES}, then it is two files"


def self_test():
    cases = [
        (list(top_faults(["effects/a.cpp", ".ci/run", "README.md"])), 0),
        (list(top_faults(["docs/a.md", "tests/run", "Makefile"])), 2),
        (list(top_faults(["tests/e2e/__pycache__/a.pyc"])), 1),
        (list(text_faults("a.cpp", b"int a;\n")), 0),
        (list(text_faults("a.cpp", b"int a; \n")), 1),
        (list(text_faults("a.cpp", b"int a;\r\n")), 1),
        (list(text_faults("a.cpp", b"int a;")), 1),
        (list(text_faults("a.cpp", "// 3 \u00b5m\n".encode())), 1),
        (list(text_faults("a.cpp", 'const char* unit = "3 \\"\u00b5m";\n'.encode())), 0),
        (list(text_faults("a.cpp", 'f("s"); // \u00b5m\n'.encode())), 1),
        (list(text_faults("a.cpp", 'a(R"(x \u00b5\n"y)"); b(\'"\'); // \u00b5\n'.encode())), 1),
        (list(text_faults("a.cmake", 'message("\u00b5m")\n'.encode())), 1),
        (list(text_faults("a.cpp", b"\n" * MAX_LINES)), 0),
        (list(text_faults("a.cpp", b"\n" * (MAX_LINES + 1))), 1),
        (list(text_faults("a.md", b"\n" * (MAX_LINES + 1))), 0),
        (list(text_faults("a.cpp", b"// " + b"c" * (MAX_COLUMNS - 3) + b"\n")), 0),
        (list(text_faults("a.cpp", b"    // " + b"c" * (MAX_COLUMNS - 6) + b"\n")), 1),
        (list(text_faults("a.glsl", b"float a;  // " + b"c" * MAX_COLUMNS + b"\n")), 1),
        (list(text_faults("a.frag", b"float a = " + b"1" * MAX_COLUMNS + b";\n")), 0),
        (list(text_faults("CMakeLists.txt", b"#" + b"c" * MAX_COLUMNS + b"\n")), 1),
        (list(text_faults("a.py", b'"""A' + b"c" * MAX_COLUMNS + b'"""\na = 1\n')), 1),
        (list(text_faults("a.py", b'a = "' + b"c" * MAX_COLUMNS + b'"\n')), 0),
        (list(text_faults("a.md", "3 \u00b5m\n".encode())), 1),
        (list(text_faults(PRINTED, "3 \u00b5m\n".encode())), 0),
        (list(text_faults("a.md", b"# " + b"c" * MAX_COLUMNS + b"\n")), 0),
    ]
    for number, (faults, expected) in enumerate(cases):
        if len(faults) != expected:
            yield f"case {number}: expected {expected} faults, found {faults}"


def check():
    paths = source_files.project_files()
    yield from top_faults(paths)
    for path in paths:
        if path.endswith(TEXT) or path in COMMANDS:
            with open(os.path.join(source_files.ROOT, path), "rb") as file:
                yield from text_faults(path, file.read())
    for path in COMMANDS:
        if not os.access(os.path.join(source_files.ROOT, path), os.X_OK):
            yield f"{path}: missing, or has no executable bit"


if __name__ == "__main__":
    sys.exit(source_files.report(list(self_test() if "--self-test" in sys.argv[1:] else check())))
