#!/usr/bin/env python3
"""Checks the words that people read: texts of the program, the README, comments. No jargon on the surface, no phrase
that is archaic or translated word by word, one word for one thing.

A text is a string literal of editor/ or effects/ with a blank in it, literals that follow each other taken as one.
Measurements (`lapfx bench`) and the words that a search understands are left out. With --self-test, checks the checker
on made-up texts.
"""
import re
import sys

import source_files

TEXTS = ("editor/", "effects/")
LEFT_OUT = ("editor/commands/bench", "editor/app/parameter_words.cpp")
HEADERS = "effects/include"
PAGES = ("README.md", "effects/README.md", "editor/README.md")
# Rooms whose comments have been gone through sentence by sentence; IN_COMMENTS is what must not return.
ROOMS = ("effects/", "shaders/", "samples/", "tests/", "editor/")
# What is found, and what to write instead.
EVERYWHERE = [
    (r"\b(?<!there )(?:is|are) no (?!such\b|longer\b|larger\b|smaller\b|finer\b|more\b|less\b|\w+ (?:to|for|on|in|at)\b)\w+",
     '"is not a ..."'),
    (r"\bpays? (?:no )?heed\b", '"makes no difference", "ignores"'),
    (r"\bfor ever\b", '"always"'),
    (r"\banew\b", '"again", "new"'),
    (r"\b(?:shall|whither|whence|hither|thither|lest|upon|thereof|wherein|whereabouts|wherever)\b", "a modern word"),
    (r"\b(?:of itself|by and by|at one stroke|as a rule)\b", "a plain phrase"),
    (r"\bput on the tool\b", '"placed at the tool tip"'),
    (r"\bwholly\b", '"fully"'),
]
IN_TEXTS = EVERYWHERE + [
    (r"\bcode values?\b|\bof 255\b", '"levels"'),
    (r"\bresident\b", '"in graphics memory"'),
    (r"\bGPU memory\b", '"graphics memory"'),
    (r"\bmiss(?:es)?\b", '"came late"'),
    (r"\btexels?\b", '"pixel of the texture"'),
    (r"\b(?:animation variable)(?! grows|\.)", 'an explanation after "In the paper:"'),
    (r"\b(?:lie|lies|lay)\b", '"is", "are"'),
    (r"\b(?:in|out)side of\b", '"inside", "outside"'),
    (r"\bbeside\b", '"next to", "compared with"'),
    (r"\b(?:told|tells?)\b", '"shown", "found", "says"'),
    (r"\bmend(?:s|ed)?\b", '"repaired", "corrected"'),
    (r"\bformer\b", '"previous"'),
    (r"\b(?:given|gives?) up\b", '"cancelled"'),
    (r"\bfile holds\b|\bholds (?:a|an|no|more|something)\b", '"contains"'),
    (r"\bbrings its own\b", '"has its own"'),
    (r"\bcomes? back as\b", '"is the same when read back"'),
    (r"\bbleeds? alike\b", '"bleeds equally"'),
    (r"\b(?:hot )?contacts\b", '"events"'),
    (r"\b(?:in|from) sight\b", '"visible"'),
    (r"\bgone\b", '"no longer exists", "lost"'),
    (r"\bthere (?:already|before)\b|\bwhat (?:was|is) there\b", '"exists"'),
]
IN_COMMENTS = [
    (r"\b(?:is|are) not heard of\b", '"is ignored"'),
    (r"\bby whom\b", "a sentence with its subject"),
    (r"\b(?<!time )(?:goes|go|going|went) on\b", '"continues"'),
    (r"\bthat (?:is|are|was|were) there\b|\bwhat (?:is|was|were) there\b", '"exists", "earlier"'),
    (r"\bcomes? to be\b", '"exists", "happens"'),
    (r"\b(?:tells?|told) of\b", '"says about", "reports"'),
    (r"\bonce more\b|\banew\b", '"again"'),
    (r"\b(?:takes?|taken|took) the place of\b|\bin the place of\b", '"replaces", "instead of"'),
    (r"\bfor good\b", '"always"'),
    (r"\bby chance\b", '"at random"'),
    (r"\bbut for (?!\w+ing\b)", '"except"'),
    (r"\b(?:takes?|taken) away\b", '"removes"'),
    (r"\b(?:is|are|was) (?:put|given) back\b", '"is restored", "is freed"'),
    (r"\bto and fro\b", '"forwards and backwards"'),
    (r"\b(?:is|are) kept of\b|\bis known of\b|\bthat are of\b", "the noun that it is about"),
]
TOKEN = re.compile(r'R"\((.*?)\)"|//[^\n]*|/\*.*?\*/|#include[^\n]*|"((?:\\.|[^"\\\n])*)"|\'(?:\\.|[^\'\\\n])\'|\s+|.', re.S)


def texts(code):
    """(line, text) of the string literals; of literals that follow each other, one text."""
    found, line, joins = [], 1, False
    for token in TOKEN.finditer(code):
        raw = token[0]
        if token[2] is not None:
            if joins:
                found[-1][1] += token[2]
            else:
                found.append([line, token[2]])
            joins = True
        elif not raw.isspace() and not raw.startswith(("//", "/*")):
            joins = False
        line += raw.count("\n")
    return [(at, text) for at, text in found if " " in text.strip()]


def comments(code):
    """(line, text) of the comments; of those on lines that follow each other, one text."""
    found, last = [], -1
    for number, line in enumerate(code.split("\n"), 1):
        if "//" not in line:
            continue
        text = line.partition("//")[2].lstrip("/< ")
        if last == number - 1 and line.lstrip().startswith("//"):
            found[-1][1] += " " + text
        else:
            found.append([number, text])
        last = number
    return [(at, text) for at, text in found]


def prose(text):
    """Lines of Markdown without what is code in them."""
    kept, fenced = [], False
    for number, line in enumerate(text.split("\n"), 1):
        fenced ^= line.startswith("```")
        if not fenced and not line.startswith("    "):
            kept.append((number, re.sub(r"`[^`]*`", "", line)))
    return kept


def faults(path, lines, rules):
    for number, text in lines:
        for pattern, instead in rules:
            found = re.search(pattern, text, re.IGNORECASE)
            if found:
                around = text[max(0, found.start() - 50):found.end() + 50].strip()
                yield f'{path}:{number}: "{found[0]}" in "{around}"; write {instead}'


def faults_of(path, content):
    if path in PAGES:
        yield from faults(path, prose(content), EVERYWHERE)
        return
    if path.startswith(ROOMS):
        yield from faults(path, comments(content), IN_COMMENTS)
    if path.startswith(HEADERS):
        yield from faults(path, comments(content), EVERYWHERE)
    elif path.startswith(TEXTS) and path.endswith(source_files.CPP) and not path.startswith(LEFT_OUT):
        yield from faults(path, texts(content), IN_TEXTS)


def self_test():
    source, header = "editor/panels/a.cpp", "effects/include/lapfx/a.h"
    cases = [
        (source, 'label("0 pays no heed to them");', 1),
        (source, 'label("0 pays "\n      "no heed to them");', 1),
        (source, 'label("a", "the clip is resident");', 1),
        (source, 'label("16 code values"); label("16 of 255");', 2),
        (source, 'label("is no OBJ, is not an OBJ"); label("there is no folder"); label("is no larger");', 1),
        (source, 'label("it lies outside of the folder");', 2),
        (source, "// it lies there: code values\nint lies;\n", 0),
        (source, 'row("resident");', 0),
        (source, 'join("a ", name, " misses it");', 1),
        ("editor/commands/bench_a.cpp", 'row("resident, clip");', 0),
        ("tests/a.cpp", 'label("0 pays no heed to them");', 0),
        ("tests/a.cpp", "// those are not\n// heard of\n", 1),
        ("tests/a.cpp", "int a;  // those are not heard\n        // of\n", 1),
        ("effects/a.cpp", "/// The clips that play go\n/// on.\nint a;\n/// on it\n", 1),
        ("effects/a.cpp", "// go\nint a;\n// on\n", 0),
        ("shaders/a.glsl", "// turned by chance\n", 1),
        ("tests/ui/a.cpp", "// turned by chance\n", 1),
        (header, "int a;  ///< put on the tool tip\n", 1),
        (header, "int a;  ///< code values\n", 0),
        ("README.md", "It is made anew.\n\n`for ever`\n\n    anew\n", 1),
    ]
    for path, content, expected in cases:
        found = list(faults_of(path, content))
        if len(found) != expected:
            yield f"{path}, {content!r}: expected {expected} faults, found {found}"


def check():
    for path in source_files.project_files():
        if path in PAGES or path.endswith(source_files.CPP + source_files.SHADERS):
            yield from faults_of(path, source_files.read(path))


if __name__ == "__main__":
    sys.exit(source_files.report(list(self_test() if "--self-test" in sys.argv[1:] else check())))
