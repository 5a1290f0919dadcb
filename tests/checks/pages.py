#!/usr/bin/env python3
"""Checks effects/README.md and editor/README.md: each is one page, and what it names is there.

With --self-test, checks the checker on made-up pages.
"""
import re
import sys

import source_files

MAX_LINES = 80
PAGES = ("effects/README.md", "editor/README.md")
MAX_HOPS = {"effects/README.md": 11}
NAMED = re.compile(r"`([\w./]+/[\w.]+)`(?:: `([\w:]+)`)?")
OWNED = re.compile(r"^ {4,}(\w+)(?:, (\w+))?.*?((?:effects|editor)/[\w./]+)?$", re.MULTILINE)


def defines(text, function):
    """Whether the text of a file has that function; `Type::name` where it is defined outside of its class."""
    return re.search(r"\b" + re.escape(function) + r"\s*\(", text) is not None


def faults(page, texts, most_hops=None):
    """Faults of the page; `texts`: {path: text} of the tree; `most_hops`: None where any number will do."""
    lines = page.count("\n")
    if lines > MAX_LINES:
        yield f"{lines} lines; at most {MAX_LINES}"
    hops = re.findall(r"^\| (\d+) \|.*`[\w./]+`: `[\w:]+` \|$", page, re.MULTILINE)
    if not hops or hops != [str(n + 1) for n in range(len(hops))]:
        yield f"hops are numbered from 1 and name a file and a function each; found {hops}"
    if most_hops is not None and len(hops) > most_hops:
        yield f"{len(hops)} hops; at most {most_hops}"
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
        (hop + "x\n" * MAX_LINES, "at most 80"),
        ("no hop\n", "numbered from 1"),
        ("".join(hop.replace("1", str(n + 1), 1) for n in range(12)), "12 hops; at most 11"),
        (hop.replace("A::b", "A::c"), "does not define A::c"),
        (hop + "`effects/gone.cpp`\n", "no such file"),
        (hop + "\n    Gone   text\n", "no such class"),
        (hop + "\n    A   text   effects/gone.h\n", "no such file"),
    ]
    for page, expected in cases:
        found = list(faults(page, texts, 11))
        if (expected is None and found) or (expected is not None and not any(expected in fault for fault in found)):
            yield f"expected {expected} for {page[:60]!r}, found {found}"


def check():
    texts = {path: source_files.read(path) for path in source_files.project_files()
             if path.endswith(source_files.CPP + source_files.SHADERS + (".py", ".md", "CMakeLists.txt"))}
    for page in PAGES:
        for fault in faults(texts[page], texts, MAX_HOPS.get(page)):
            yield f"{page}: {fault}"


if __name__ == "__main__":
    sys.exit(source_files.report(list(self_test() if "--self-test" in sys.argv[1:] else check())))
