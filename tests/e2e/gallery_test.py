#!/usr/bin/env python3
"""`lapfx gallery` in a window, as a person uses it: a display of its own (Xvfb), pointer and keys from xdotool.

gallery_test.py LAPFX [NAME]: with NAME only the cases whose name contains it. 77 where Xvfb, xdotool or OpenGL is missing.

What a case looks at is the log of frames (--statistics) while the window is open, and the tree of widgets once it is closed
(--dump-on-close). Where widgets are is asked beforehand, without a window (--dump).
"""
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time

SKIP = 77
LIMIT_S = 60  # for anything to happen, also under a sanitizer
SIZE = (900, 640)
FRAME = re.compile(r"^frame (\d+) at ([0-9.e+-]+) s: (.*?)(, drawn)?$", re.MULTILINE)


class Skip(Exception):
    pass


def wait_for(what, condition, limit=LIMIT_S):
    end = time.monotonic() + limit
    while time.monotonic() < end:
        found = condition()
        if found:
            return found
        time.sleep(0.02)
    raise AssertionError(f"waited {limit} s for {what}")


class Display:
    """An X server that nobody else uses."""

    def __init__(self, folder):
        self.log = open(os.path.join(folder, "xvfb.log"), "w", encoding="utf-8")
        read, write = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", "1280x1024x24", "-nolisten", "tcp"],
            pass_fds=[write], stdout=self.log, stderr=self.log)
        os.close(write)
        with os.fdopen(read) as number:
            self.name = ":" + number.readline().strip()
        if self.name == ":":
            raise Skip("Xvfb does not start")

    def close(self):
        self.server.terminate()
        self.server.wait()
        self.log.close()


class Gallery:
    """One window. Use as a context: leaving it closes what is still open."""

    def __init__(self, lapfx, display, folder, *options, page="Overview", size=SIZE, environment=None):
        self.folder = folder
        self.dump_file = os.path.join(folder, "closed.json")
        self.log_file = os.path.join(folder, "frames.log")
        self.environment = {**os.environ, "DISPLAY": display.name, "LC_ALL": "C.UTF-8", "LAPFX_SCALE": "1",
                            **(environment or {})}
        self.environment.pop("WAYLAND_DISPLAY", None)
        self.common = ["--page", page, "--size", "%dx%d" % size, *options]
        self.lapfx = lapfx
        self.process = None
        self.window = None

    def __enter__(self):
        if os.path.exists(self.dump_file):
            os.remove(self.dump_file)
        self.log = open(self.log_file, "w", encoding="utf-8")
        self.process = subprocess.Popen(
            [self.lapfx, "gallery", *self.common, "--statistics", "--dump-on-close", self.dump_file],
            env=self.environment, stdout=self.log, stderr=self.log)

        def first_frame():
            if self.process.poll() is not None:
                text = self.text()
                if self.process.returncode == SKIP:
                    raise Skip(text.strip())
                raise AssertionError(f"ended with {self.process.returncode}: {text}")
            return self.frames()
        wait_for("the first frame", first_frame)
        self.window = self.xdotool("search", "--sync", "--onlyvisible", "--name", "lapfx gallery").split()[-1]
        self.xdotool("windowfocus", "--sync", self.window)
        self.settle()
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        self.log.close()

    def text(self):
        with open(self.log_file, encoding="utf-8") as file:
            return file.read()

    def frames(self, since=0):
        """(time, reason, drawn) of each frame from number `since` on."""
        return [(float(m[2]), m[3], bool(m[4])) for m in FRAME.finditer(self.text()) if int(m[1]) > since]

    def drawn(self, since):
        return [frame for frame in self.frames(since) if frame[2]]

    def settle(self, quiet=0.4):
        """Until no frame has been made for `quiet` s."""
        def is_quiet():
            count = len(self.frames())
            time.sleep(quiet)
            return len(self.frames()) == count
        wait_for("a quiet window", is_quiet)

    def xdotool(self, *arguments):
        done = subprocess.run(["xdotool", *arguments], env=self.environment, capture_output=True, encoding="utf-8",
                              timeout=LIMIT_S, check=False)
        assert done.returncode == 0, f"xdotool {' '.join(arguments)}: {done.stderr}"
        return done.stdout

    def act(self, *arguments):
        """One xdotool command, and until the window has answered it."""
        count = len(self.frames())
        self.xdotool(*arguments)
        wait_for(f"an answer to {' '.join(arguments)}", lambda: len(self.frames()) > count)
        self.settle(0.15)

    def act_now(self, *arguments):
        """The same where the window never becomes quiet."""
        count = len(self.frames())
        self.xdotool(*arguments)
        wait_for(f"an answer to {' '.join(arguments)}", lambda: len(self.frames()) > count)

    def tree(self):
        """Of a window that has just been opened."""
        file = os.path.join(self.folder, "before.json")
        subprocess.run([self.lapfx, "gallery", *self.common, "--scale", "1", "--dump", file], check=True)
        with open(file, encoding="utf-8") as dump:
            return json.load(dump)

    def middle(self, path):
        x, y, w, h = node(self.tree(), path)["rect"]
        return int(x + w / 2), int(y + h / 2)

    def click(self, path, button=1):
        x, y = self.middle(path)
        self.act("mousemove", "--window", self.window, str(x), str(y))
        self.act("click", str(button))

    def cpu_ticks(self):
        with open(f"/proc/{self.process.pid}/stat", encoding="utf-8") as stat:
            fields = stat.read().rsplit(")", 1)[1].split()
        return int(fields[11]) + int(fields[12])  # utime, stime

    def close(self):
        """By its command (a window manager's way cannot be gone by this xdotool); gives the tree as it was last."""
        self.xdotool("key", "ctrl+q")
        assert self.process.wait(LIMIT_S) == 0, self.text()
        with open(self.dump_file, encoding="utf-8") as dump:
            return json.load(dump)


def nodes(tree):
    yield tree
    for child in tree.get("children", ()):
        yield from nodes(child)


def node(tree, path):
    found = [n for n in nodes(tree) if n.get("path") == path]
    assert len(found) == 1, f"{path} is there {len(found)} times: " + ", ".join(
        n["path"] for n in nodes(tree) if "path" in n)
    return found[0]


def case_idle(open_gallery):
    """No input, no frames; and the process does not even wake up."""
    with open_gallery() as gallery:
        time.sleep(1)
        ticks, frames = gallery.cpu_ticks(), len(gallery.frames())
        time.sleep(5)
        spent = gallery.cpu_ticks() - ticks
        assert len(gallery.frames()) == frames, gallery.frames(frames)
        assert spent <= 2, f"{spent} ticks of CPU in 5 s"


def case_pointer_over_nothing(open_gallery):
    """The pointer moves over what does not light up: nothing is drawn."""
    with open_gallery() as gallery:
        gallery.act("mousemove", "--window", gallery.window, "600", "630")
        drawn = len(gallery.drawn(0))
        for x in range(560, 640, 8):
            gallery.act("mousemove", "--window", gallery.window, str(x), "632")
        assert len(gallery.drawn(0)) == drawn, gallery.drawn(0)[drawn:]


def case_click(open_gallery):
    """A click is seen, in at most two pictures for each event."""
    with open_gallery() as gallery:
        x, y = gallery.middle("Page/Overview/Follow the tool")
        gallery.act("mousemove", "--window", gallery.window, str(x), str(y))
        drawn = len(gallery.drawn(0))
        gallery.act("click", "1")
        assert len(gallery.drawn(0)) - drawn <= 4, gallery.drawn(0)[drawn:]
        tree = gallery.close()
        assert "checked" not in node(tree, "Page/Overview/Follow the tool").get("states", ())


def case_keys(open_gallery):
    """Tab, space, and Ctrl+= for a larger scale."""
    with open_gallery() as gallery:
        gallery.click("Pages/List/Basic")
        gallery.act("key", "Tab")
        gallery.act("key", "ctrl+equal")
        tree = gallery.close()
        assert "focused" in node(tree, "Pages/List/Fields").get("states", ()), "Tab goes on"
        height = node(tree, "Pages/List/Fields")["rect"][3]
        assert height > 24.5, f"a row is {height} px high at the next scale"


def case_type(open_gallery):
    """Typing, also what takes a compose key; Ctrl+A, Ctrl+C, Ctrl+V; Enter."""
    with open_gallery(page="Fields") as gallery:
        gallery.click("Page/Fields/Text fields/plain/Empty")
        gallery.act("type", "--delay", "20", "smoke 12")
        gallery.act("key", "ctrl+a")
        gallery.act("key", "ctrl+c")
        gallery.act("key", "End")
        gallery.act("key", "ctrl+v")
        gallery.act("key", "Return")
        tree = gallery.close()
        assert node(tree, "Page/Fields/Text fields/plain/Empty")["text"] == "smoke 12smoke 12"


def case_compose(open_gallery):
    """What an input method commits: Compose ' e is an e with an acute accent."""
    with open_gallery(page="Fields") as gallery:
        gallery.xdotool("key", "--delay", "0", "shift")  # wakes the keyboard map
        gallery.click("Page/Fields/Text fields/plain/Empty")
        for key in ("Multi_key", "apostrophe", "e"):
            gallery.xdotool("key", key)
            time.sleep(0.1)
        gallery.settle()
        text = node(gallery.close(), "Page/Fields/Text fields/plain/Empty").get("text", "")
        assert text == "\u00e9", f"composed {text!r}"


def case_caret(open_gallery):
    """A field with the keyboard: two frames a second and no more, for the caret."""
    with open_gallery(page="Fields") as gallery:
        x, y = gallery.middle("Page/Fields/Text fields/plain/Empty")
        gallery.act_now("mousemove", "--window", gallery.window, str(x), str(y), "click", "1")
        time.sleep(1.5)
        count, ticks = len(gallery.frames()), gallery.cpu_ticks()
        time.sleep(4)
        made, spent = len(gallery.frames()) - count, gallery.cpu_ticks() - ticks
        assert 4 <= made <= 9, gallery.frames(count)
        assert spent <= 20, f"{spent} ticks of CPU in 4 s"


def case_drag_past_the_edge(open_gallery):
    """A drag goes on where the screen ends, and the pointer is where it was afterwards."""
    with open_gallery(page="Params") as gallery:
        before = node(gallery.tree(), "Page/Params/Kinds/Count")["value"]
        x, y = gallery.middle("Page/Params/Kinds/Count")
        gallery.act("mousemove", "--window", gallery.window, str(x), str(y))
        gallery.act("mousedown", "1")
        for _ in range(60):
            gallery.xdotool("mousemove_relative", "--", "-60", "0")
            time.sleep(0.01)
        gallery.settle(0.15)
        gallery.act("mouseup", "1")
        where = dict(line.split("=") for line in gallery.xdotool("getmouselocation", "--shell").split())
        corner = dict(line.split("=") for line in gallery.xdotool("getwindowgeometry", "--shell", gallery.window).split())
        off = abs(int(where["X"]) - int(corner["X"]) - x), abs(int(where["Y"]) - int(corner["Y"]) - y)
        assert max(off) <= 80, f"the pointer is {off} px from where it was"
        after = node(gallery.close(), "Page/Params/Kinds/Count")["value"]
        assert after < before and after == 1, f"{before} became {after}"


def case_resize(open_gallery):
    with open_gallery() as gallery:
        gallery.act("windowsize", "--sync", gallery.window, "700", "500")
        assert gallery.drawn(0)[-1][2]
        tree = gallery.close()
        assert tree["rect"][2:] == [700, 500], tree["rect"]


def case_close(open_gallery):
    """Exit code 0, a line of totals, and nothing left behind."""
    with open_gallery() as gallery:
        gallery.close()
        assert re.search(r"lapfx: \d+ frames, \d+ drawn, \d+ waits", gallery.text()), gallery.text()


def main(arguments):
    lapfx, wanted = os.path.abspath(arguments[0]), arguments[1] if len(arguments) > 1 else ""
    for program in ("Xvfb", "xdotool"):
        if shutil.which(program) is None:
            print(f"gallery_test: there is no {program}, so nothing was tested")
            return SKIP
    failed = 0
    cases = [(name[5:], case) for name, case in globals().items() if name.startswith("case_") and wanted in name]
    with tempfile.TemporaryDirectory(prefix="lapfx gallery ") as folder:
        try:
            display = Display(folder)
            try:
                for name, case in cases:
                    print(f"{name} ... ", end="", flush=True)
                    try:
                        case(lambda *options, **more: Gallery(lapfx, display, folder, *options, **more))
                        print("ok")
                    except AssertionError as error:
                        failed += 1
                        print(f"FAILED: {error}")
            finally:
                display.close()
        except Skip as reason:
            print(f"skipped: {reason}")
            return SKIP
    print(f"{len(cases)} cases, {failed} failed")
    return 1 if failed or not cases else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
