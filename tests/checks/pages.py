#!/usr/bin/env python3
"""Checks effects/README.md and editor/README.md: each is one page, its walks are whole, and what it names is there.

With --self-test, checks the checker on made-up pages.
"""
import re
import sys

import source_files

MAX_LINES = {"effects/README.md": 100, "editor/README.md": 140}  # a hop is a line, and no walk leaves one out
WALKS = {"effects/README.md": 1, "editor/README.md": 3}
HOP = re.compile(r"^\| (\d+) \|(?:.*`[\w./]+`: `([\w:]+)` \|$)?", re.MULTILINE)
NAMED = re.compile(r"`([\w./]+/[\w.]+)`(?:: `([\w:]+)`)?")
OWNED = re.compile(r"^ {4,}(\w+)(?:, (\w+))?.*?((?:effects|editor)/[\w./]+)?$", re.MULTILINE)


def defines(text, function):
    """Whether the text of a file has that function; `Type::name` where it is defined outside of its class."""
    return re.search(r"\b" + re.escape(function) + r"\s*\(", text) is not None


def faults(page, texts, max_lines, walks):
    """Faults of the page; `texts`: {path: text} of the tree; `walks`: how many tables of hops it has."""
    lines = page.count("\n")
    if lines > max_lines:
        yield f"{lines} lines; at most {max_lines}"
    found, expected = 0, 1
    for number, function in HOP.findall(page):
        if number == "1":
            found, expected = found + 1, 1
        if int(number) != expected:
            yield f"hop {number}: hops are numbered from 1, and {expected} comes here"
        if not function:
            yield f"hop {number}: does not end with a file and a function"
        expected = int(number) + 1
    if found != walks:
        yield f"{found} walks; expected {walks}"
    for path, function in NAMED.findall(page):
        where = [known for known in texts if known == path or known.startswith(path.rstrip("/") + "/")]
        if "/" in path.rstrip("/") and not where and not path.startswith("lapfx/"):
            yield f"{path}: there is no such file"
        elif function and path in texts and not defines(texts[path], function):
            yield f"{path}: does not define {function}"
    everything = "\n".join(text for path, text in texts.items()
                           if path.startswith(("effects/", "editor/")) and path.endswith(".h"))
    for block in re.findall(r"(?:^ {4}.*\n)+", page, re.MULTILINE):
        for first, second, path in OWNED.findall(block):
            for name in filter(None, (first, second)):
                if not re.search(r"\b(?:class|struct) " + name + r"\b", everything):
                    yield f"{name}: no such class"
            if path and not any(known == path or known.startswith(path) for known in texts):
                yield f"{path}: there is no such file"


def self_test():
    texts = {"effects/a.cpp": "void A::b() {}", "effects/a.h": "class A {};"}
    hop = "| 1 | x | `effects/a.cpp`: `A::b` |\n"
    cases = [
        (hop + "\n    A   text   effects/a.h\n", None),
        (hop + "x\n" * 80, "at most 80"),
        ("no hop\n", "0 walks; expected 1"),
        (hop + "\n" + hop, "2 walks; expected 1"),
        (hop + hop.replace("1", "2") + hop.replace("1", "4"), "3 comes here"),
        (hop + "| 2 | x | somewhere |\n", "hop 2: does not end with a file and a function"),
        (hop.replace("A::b", "A::c"), "does not define A::c"),
        (hop + "`effects/gone.cpp`\n", "no such file"),
        (hop + "\n    Gone   text\n", "no such class"),
        (hop + "\n    A   text   effects/gone.h\n", "no such file"),
    ]
    for page, expected in cases:
        found = list(faults(page, texts, 80, 1))
        if (expected is None and found) or (expected is not None and not any(expected in fault for fault in found)):
            yield f"expected {expected} for {page[:60]!r}, found {found}"


def check():
    texts = {path: source_files.read(path) for path in source_files.project_files()
             if path.endswith(source_files.CPP + source_files.SHADERS + (".py", ".md", "CMakeLists.txt"))}
    for page in WALKS:
        for fault in faults(texts[page], texts, MAX_LINES[page], WALKS[page]):
            yield f"{page}: {fault}"


if __name__ == "__main__":
    sys.exit(source_files.report(list(self_test() if "--self-test" in sys.argv[1:] else check())))
