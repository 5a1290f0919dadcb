#!/usr/bin/env python3
"""`lapfx gallery` in a window, as a person uses it.

gallery_test.py LAPFX [NAME]: with NAME only the cases whose name contains it. 77 where Xvfb, xdotool or OpenGL is
missing.
"""
import os
import re
import sys

import real_window
from real_window import node, wait_for

SIZE = (900, 640)


class Gallery(real_window.Window):
    title, verb = "lapfx gallery", "gallery"

    def __init__(self, lapfx, display, folder, *options, page="Overview", size=SIZE, environment=None):
        super().__init__(lapfx, display, folder, "--page", page, "--size", "%dx%d" % size, *options,
                         environment=environment)


def case_idle(open_gallery):
    """Without input there are no frames, and the process does not even wake up."""
    with open_gallery() as gallery:
        return f"{gallery.sleeps(5, 0)} wakes"


def case_pointer_over_nothing(open_gallery):
    """The pointer moves over widgets that do not react: nothing is drawn."""
    with open_gallery() as gallery:
        gallery.act("mousemove", "--window", gallery.window, "600", "630")
        drawn = len(gallery.drawn(0))
        for x in range(560, 640, 8):
            gallery.act("mousemove", "--window", gallery.window, str(x), "632")
        assert len(gallery.drawn(0)) == drawn, gallery.drawn(0)[drawn:]


def case_click(open_gallery):
    """A click shows, with at most two pictures for each event."""
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
        gallery.settle()
        text = node(gallery.close(), "Page/Fields/Text fields/plain/Empty").get("text", "")
        assert text == "\u00e9", f"composed {text!r}"


def case_caret(open_gallery):
    """A field with the keyboard: two frames a second and no more, for the caret."""
    with open_gallery(page="Fields") as gallery:
        x, y = gallery.middle("Page/Fields/Text fields/plain/Empty")
        gallery.act_now("mousemove", "--window", gallery.window, str(x), str(y), "click", "1")
        gallery.settle(0.15)
        count = len(gallery.frames())
        wait_for("the caret", lambda: len(gallery.frames(count)) >= 8)
        frames = gallery.frames(count)
        took = frames[-1][0] - frames[0][0]
        assert len(frames) - 1 <= 2 * took + 1, frames


def case_drag_past_the_edge(open_gallery):
    """A drag continues beyond the edge of the screen, and the pointer then returns to its place."""
    with open_gallery(page="Params") as gallery:
        before = node(gallery.tree(), "Page/Params/Kinds/Count")["value"]
        x, y = gallery.middle("Page/Params/Kinds/Count")
        gallery.act("mousemove", "--window", gallery.window, str(x), str(y))
        gallery.act("mousedown", "1")
        # It returns to where the window began to hold it, which a window under load does some moves late.
        gallery.act("mousemove_relative", "--", "-60", "0")
        for _ in range(60):
            gallery.xdotool("mousemove_relative", "--", "-60", "0")
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

    def window(display, folder):
        return lambda *options, **more: Gallery(lapfx, display, folder, *options, **more)
    return real_window.run("gallery", real_window.cases_of(globals(), wanted), window)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
