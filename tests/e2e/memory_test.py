#!/usr/bin/env python3
"""What the editor's window holds in main memory while it is used at random, on the sample scene.

memory_test.py LAPFX [ACTS]: how often something is done after all has been used once, 40 unless told otherwise, with
`tests/run --deep` (LAPFX_DEEP=1) 300; of more than 600 every fiftieth is printed, too.
77 where Xvfb, xdotool or OpenGL is missing, or the process's memory cannot be read.

A person's hands, from a fixed seed: drags, clicks and wheel all over the window, tools on the organ, keys of layouts,
overlays, snapshots, undo. Each is done when the window has answered the one before, so that a busy machine does the
same in more time. What counts is all memory but the frames of clips, which have a budget of their own
(StreamingOptions::memory).
"""
import os
import random
import re
import subprocess
import sys

import editor_test
import real_window

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))  # has what is shipped
# After every layout was used: a preview beside the reference has more pixels, and a driver without a GPU keeps the
# triangles of the frame that it draws, up to 100 MB of them, which come and go.
MOST_USED = 675e6
GROWTH = 100e6  # bytes, from when all of it has been used once to the end
DEEP = bool(os.environ.get("LAPFX_DEEP"))
# Bytes beside the clips, as it opens and plays: 455 to 500 were seen, the more the busier the machine, and up to 505
# while clips were still decoded.
MOST = 525e6 if DEEP else 575e6
USED = 200 if DEEP else 40  # acts, or half of all if that is more, until all of it has been used
EMPTY = 5  # frames for each act that draw nothing, at most; under 1 was seen
REPORTS = 15  # about a second each: what is compared is their mean
WIDTH, HEIGHT = 1440, 900
MENU_BAR = 34  # px: what lies there may close the window
CORES = 2  # the bounds are for these; drivers and decoders have memory for each thread
LINE = re.compile(r"^memory at ([0-9.e+-]+) s: (\d+) bytes, (\d+) of clips$", re.MULTILINE)
LAYOUTS = ["ctrl+1", "ctrl+2", "ctrl+3", "ctrl+4"]
KEYS = LAYOUTS + ["space", "Home", "v", "t", "g", "e", "a", "shift+a", "m", "f", "Tab", "Left", "Right", "Escape", "Escape",
                  "ctrl+z", "ctrl+z", "ctrl+y", "ctrl+r", "ctrl+k", "Page_Down", "BackSpace"]
TOOLS = "123456"


class Person:
    def __init__(self, editor, held, seed):
        self.editor, self.held = editor, held
        self.random = random.Random(seed)

    def xdotool(self, *arguments):
        count = self.editor.made()
        subprocess.run(["xdotool", *map(str, arguments)], env=self.editor.environment, check=False, capture_output=True,
                       timeout=real_window.LIMIT_S)
        self.editor.answer(count, "something that a person did")

    def place(self):
        return self.random.randrange(4, WIDTH - 4), self.random.randrange(MENU_BAR, HEIGHT - 4)

    def drag(self, x, y, reach):
        path = []
        for _ in range(6):
            path += ["mousemove_relative", "--", self.random.randint(-reach, reach), self.random.randint(-reach, reach),
                     "sleep", "0.03"]
        self.xdotool("mousemove", "--window", self.editor.window, x, y, "mousedown", "1", *path, "mouseup", "1")

    def act(self):
        kind = self.random.random()
        if kind < 0.35:
            self.drag(*self.place(), 25)
        elif kind < 0.5:
            x, y = self.place()
            self.xdotool("mousemove", "--window", self.editor.window, x, y, "click", "1")
        elif kind < 0.62:
            x, y = self.place()
            self.xdotool("mousemove", "--window", self.editor.window, x, y, "click", "--repeat", self.random.randint(1, 5),
                         self.random.choice("45"))
        elif kind < 0.72:
            self.xdotool("key", "Escape", "key", self.random.choice(TOOLS))
            self.drag(WIDTH // 2 + self.random.randint(-150, 150), HEIGHT // 3 + self.random.randint(-80, 80), 12)
            self.xdotool("key", "0")
        else:
            self.xdotool("key", self.random.choice(KEYS))

    def look_around(self):
        for keys in LAYOUTS + LAYOUTS[:1]:
            self.xdotool("key", keys)
            self.held.more(2)


class Held:
    """The window's reports, about once a second: (s, bytes, bytes of clips)."""

    def __init__(self, editor):
        self.editor = editor

    def all(self):
        return [(float(m[1]), int(m[2]), int(m[3])) for m in LINE.finditer(self.editor.text())]

    def more(self, count):
        """Waits for as many new reports: the window draws, and tells what it holds."""
        before = len(self.all())
        real_window.wait_for("word of memory", lambda: len(self.all()) >= before + count)

    def beside_clips(self, count):
        """Mean of the latest reports."""
        found = [held - clips for _, held, clips in self.all()[-count:]]
        return sum(found) / len(found)


def play(editor, held):
    """Plays the scene; gives the bytes beside the clips. A long walk waits until all frames of clips are in memory,
    which takes a minute where there is no GPU; while they come, their decoders have memory, too."""
    editor.xdotool("key", "space")

    def played():
        latest = [clips for *_, clips in held.all()[-10:]]
        return len(latest) == 10 and latest[0] > 0 and (len(set(latest)) == 1 or not DEEP)
    real_window.wait_for("clips that have been played", played)
    return held.beside_clips(5)


def use(open_editor, acts):
    with open_editor() as editor:
        held = Held(editor)
        if not real_window.wait_for("word of memory", held.all):
            raise real_window.Skip("the process's memory is not known")
        opened = play(editor, held)
        said = f"{opened / 1e6:.0f} MB beside the clips as it opens"
        assert opened <= MOST, f"{said}; allowed: {MOST / 1e6:.0f}"
        person = Person(editor, held, 11)
        person.look_around()
        begin, all_used = None, max(USED, acts // 2)
        for act in range(USED + acts):
            assert editor.process.poll() is None, f"it ended with {editor.process.returncode}: {editor.text()[-2000:]}"
            person.act()
            if act == all_used:
                begin = held.beside_clips(REPORTS)
            if acts > 600 and act % 50 == 0:
                _, all_of_it, clips = held.all()[-1]
                print(f"\n{act:5d}: {all_of_it / 1e6:4.0f} MB, clips {clips / 1e6:4.0f}", end="", flush=True)
        end = held.beside_clips(REPORTS)
        said += f", {begin / 1e6:.0f} once all has been used, {end / 1e6:.0f} at the end"
        assert max(begin, end) <= MOST_USED, f"{said}; allowed: {MOST_USED / 1e6:.0f}"
        empty = sum(not drawn for *_, drawn in editor.frames())
        assert empty <= EMPTY * (USED + acts), f"{empty} frames drew nothing: the window is busy without a reason"
        assert end - begin <= GROWTH, f"{said}; allowed to grow by {GROWTH / 1e6:.0f}"
        return f"{said}; {empty} frames drew nothing"


def main(arguments):
    acts = int(arguments[1]) if len(arguments) > 1 else 300 if DEEP else 40
    if not DEEP:
        print("a short walk; tests/run --deep takes a long one")
    editor_test.SIZE = (WIDTH, HEIGHT)
    os.sched_setaffinity(0, sorted(os.sched_getaffinity(0))[:CORES])

    def window(display, folder):
        return lambda *options: editor_test.Editor(arguments[0], "", ROOT, display, folder, *options)
    return real_window.run("memory", [("random_use", lambda open_editor: use(open_editor, acts))], window,
                           screen=f"{WIDTH}x{HEIGHT}")


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
