#!/usr/bin/env python3
"""`lapfx edit` in a window, as a person uses it.

editor_test.py LAPFX DROP_FILES SHIPPED [NAME]: with NAME only the cases whose name contains it. DROP_FILES: the program
that drops files on a window, or a path that is not there. SHIPPED: the folder of presets and samples that the editor
opens. 77 where Xvfb, xdotool or OpenGL is missing.
"""
import json
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import time

import real_window
from real_window import node, nodes, wait_for

SIZE = (1200, 800)
IDLE_S = 10
IDLE_WAKES = 50  # all threads together wake no more often in that time; one a second was seen
SAMPLE_CLIPS = ["plume_thick.mp4", "wisps_thin.mp4", "haze_rolling.mp4"]
SPEED = "/Bleeding/Speed"  # end of the path of the parameter that is moved


class Editor(real_window.Window):
    title, verb = "lapfx", "edit"
    search = "--class"  # its name goes with what is open

    def __init__(self, lapfx, drop_files, shipped, display, folder, *options):
        self.drop_files = drop_files
        self.samples = os.path.join(shipped, "samples")
        self.clip = os.path.join(self.samples, "clips", "wisps_thin.mp4")
        # A home for each: an editor that a case ends with unsaved work would be offered for recovery in the next.
        self.home = tempfile.mkdtemp(prefix="home ", dir=folder)
        homes = {key: os.path.join(self.home, key.lower()) for key in ("XDG_CONFIG_HOME", "XDG_STATE_HOME")}
        homes["XDG_CACHE_HOME"] = os.path.join(folder, "cache")  # compiled shaders are the same for all
        for path in homes.values():
            os.makedirs(path, exist_ok=True)
        # The first steps are not in what --dump tells, as in pictures of the editor.
        os.makedirs(os.path.join(homes["XDG_CONFIG_HOME"], "lapfx"), exist_ok=True)
        with open(os.path.join(homes["XDG_CONFIG_HOME"], "lapfx", "settings.json"), "w", encoding="utf-8") as settings:
            json.dump({"hint_seen": True}, settings)
        if "--at" not in options:  # without it, it plays, and is never quiet
            options = ("--at", "3", *options)
        super().__init__(lapfx, display, folder, "--size", "%dx%d" % SIZE, "--layout", "Tune", *options,
                         environment={"HOME": self.home, "LAPFX_DATA": shipped, **homes})

    def brightness(self, x, y):
        """Mean of 32 x 32 px of the screen around a place of the window, 0 to 255."""
        place = f"{self.environment['DISPLAY']}+{int(x) - 16},{int(y) - 16}"
        shot = subprocess.run(["ffmpeg", "-loglevel", "error", "-f", "x11grab", "-draw_mouse", "0", "-video_size", "32x32",
                               "-i", place, "-frames:v", "1", "-f", "rawvideo", "-pix_fmt", "gray", "-"],
                              check=True, capture_output=True, timeout=real_window.LIMIT_S)
        return sum(shot.stdout) / len(shot.stdout)

    def ending(self, end):
        """The one path that ends so, of a window that has just been opened."""
        found = [n["path"] for n in nodes(self.tree()) if n.get("path", "").endswith(end)]
        assert len(found) == 1, f"{end}: {found}"
        return found[0]

    def type(self, text):
        self.act_now("type", "--delay", "15", text)
        self.settle(0.15)

    def drop(self, path, file):
        """Drops a file on the middle of the widget with this path."""
        x, y = self.middle(path)
        count = len(self.frames())
        done = subprocess.run([self.drop_files, self.window, str(x), str(y), file], env=self.environment, check=False,
                              capture_output=True, encoding="utf-8", timeout=real_window.LIMIT_S)
        assert done.returncode == 0, f"the drop was not taken: {done.stderr}"
        wait_for("a frame for what was dropped", lambda: any(f[1] == "drop" for f in self.frames(count)))
        self.settle()

    def save_as(self, name):
        """Saves the preset under that name in the folder of the test, by keyboard; gives what is on disk."""
        file = os.path.join(self.folder, name)
        if os.path.exists(file):
            os.remove(file)
        self.act("key", "ctrl+shift+s")
        self.act("key", "ctrl+a")
        self.type(file)
        self.act("key", "Return")
        wait_for(f"{name} on disk", lambda: os.path.exists(file))
        self.settle()
        with open(file, encoding="utf-8") as saved:
            return json.load(saved)

    def discard(self):
        """Closes with unsaved work: the question's second answer."""
        self.act("key", "ctrl+q")
        assert self.process.poll() is None, "it closed without a question"
        self.act_now("key", "Tab")
        self.xdotool("key", "Return")
        assert self.process.wait(real_window.LIMIT_S) == 0, self.text()


def case_start_tab_resize(open_editor):
    """The sample scene is visible without any input; a click on a tab shows its panel; the window becomes tiny and
    large again."""
    with open_editor() as editor:
        assert editor.frames()[0][2], "the first frame is drawn"
        tree = editor.tree()
        assert "Gastric banding" in node(tree, "Status bar/Preset")["text"]
        assert node(tree, "Workspace/View/Preview")["rect"][2] > 300
        assert "selected" not in node(tree, "Workspace/tabs/Amounts").get("states", ())
        editor.click("Workspace/tabs/Amounts")
        for width, height in ((40, 30), (1, 1), SIZE):
            editor.act("windowsize", "--sync", editor.window, str(width), str(height))
        tree = editor.close()
        assert "Gastric banding" in node(tree, "Status bar/Preset")["text"]
        assert "selected" in node(tree, "Workspace/tabs/Amounts")["states"]
        assert node(tree, "Workspace/Amounts")["rect"][3] > 100
        assert tree["rect"][2:] == list(SIZE), tree["rect"]
        assert node(tree, "Workspace/View/Preview")["rect"][2] > 300
        return f"first frame after {editor.first_frame_s:.2f} s"


def case_picture_comes(open_editor):
    """Paused, without input: the organ is visible as soon as it is loaded."""
    with open_editor("--at", "0") as editor:
        start = time.monotonic()
        x, y = editor.middle("Workspace/View/Preview")
        wait_for("the organ in the middle of the view", lambda: editor.brightness(x, y) > 60)
        return f"{editor.first_frame_s + time.monotonic() - start:.1f} s after the start at the latest"


def case_idle(open_editor):
    """Paused, without input: once what runs beside the UI has ended, no frames, and its threads sleep."""
    with open_editor("--at", "6") as editor:
        return f"{editor.sleeps(IDLE_S, IDLE_WAKES)} wakes in {IDLE_S} s"


def same_as_rendered(editor, file):
    """The same bytes as those of `lapfx render`, where no UI has drawn before."""
    with open(file, "rb") as picture:
        exported = picture.read()
    assert exported.startswith(b"\x89PNG\r\n\x1a\n")
    width, height = struct.unpack(">II", exported[16:24])
    rendered = os.path.join(editor.folder, "rendered.png")
    subprocess.run([editor.lapfx, "render", os.path.join(editor.samples, "lagb.scene.json"), "--at", "3", "--size",
                    f"{width}x{height}", "-o", rendered], env=editor.environment, check=True, capture_output=True)
    with open(rendered, "rb") as picture:
        assert picture.read() == exported, "the editor's picture is not the one that is rendered"


def case_export(open_editor):
    """A picture by keyboard alone: Ctrl+E, the kind, a name, Enter; the file is there, as it is rendered, and the
    editor goes on."""
    with open_editor() as editor:
        file = os.path.join(editor.folder, "still.png")
        if os.path.exists(file):
            os.remove(file)
        editor.act("key", "ctrl+e")
        editor.act("key", "Right")
        editor.act("key", "Right")  # preset, bundle, picture
        editor.act("key", "Tab")
        editor.type(file)
        editor.act_now("key", "Return")
        wait_for("the picture", lambda: os.path.exists(file))
        editor.settle()
        tree = editor.close()
        assert any("Exported still.png, checked" in n.get("label", "") + n.get("text", "") for n in nodes(tree))
        same_as_rendered(editor, file)


def case_drop_opens(open_editor):
    """A file manager's drop comes through the window's callback: the clip is in the preset that is saved then."""
    with open_editor() as editor:
        if not os.path.exists(editor.drop_files):
            return "not tested: there is no Xlib to drop files with"
        editor.drop("Workspace/View/Preview", editor.clip)
        assert editor.process.poll() is None, editor.text()
        saved = editor.save_as("dropped.json")
        assert [c["file"] for c in saved["smoke"]["clips"]] == [*SAMPLE_CLIPS, "wisps_thin.mp4"], saved["smoke"]["clips"]
        return None


def case_surgery_named_at_start(open_editor):
    """A surgery video named on the command line is the reference: no clip is gone, and quitting asks."""
    with tempfile.TemporaryDirectory() as folder:
        video = os.path.join(folder, "operation_2.mp4")
        shutil.copy(os.path.join(sys.argv[3], "samples", "reference", "operation.mp4"), video)
        with open_editor(video) as editor:
            told = "operation_2.mp4 becomes the reference"
            wait_for("the notice", lambda: any(told in n.get("label", "") for n in nodes(editor.new_tree())))
            clips = [c["file"] for c in editor.save_as("named.json")["smoke"]["clips"]]
            assert clips == SAMPLE_CLIPS, clips
            editor.discard()


def case_drag_type_save_undo_close(open_editor):
    """A parameter is dragged and typed, the preset saved, and both undone; what is on disk tells. Then the editor asks
    about unsaved work: Esc keeps the window, Discard closes it."""
    with open_editor() as editor:
        start = editor.save_as("start.json")["bleeding"]["speed"]
        x, y = editor.middle(editor.ending(SPEED))
        x += 30  # in the field, right of its name
        editor.act("mousemove", "--window", editor.window, str(x), str(y))
        editor.act("mousedown", "1")
        for _ in range(10):
            editor.xdotool("mousemove_relative", "6", "0")
        editor.settle(0.15)
        editor.act("mouseup", "1")
        dragged = editor.save_as("dragged.json")["bleeding"]["speed"]
        assert dragged > start, f"{start} became {dragged}"
        editor.act("mousemove", "--window", editor.window, str(x), str(y))
        editor.act("click", "--repeat", "2", "--delay", "60", "1")
        editor.type("7.5")
        editor.act("key", "Return")
        assert editor.save_as("typed.json")["bleeding"]["speed"] == 7.5
        editor.act("key", "ctrl+z")
        assert editor.save_as("undone.json")["bleeding"]["speed"] == dragged
        editor.act("key", "ctrl+z")
        assert editor.save_as("undone.json")["bleeding"]["speed"] == start
        editor.act("key", "ctrl+shift+z")
        assert editor.save_as("redone.json")["bleeding"]["speed"] == dragged
        editor.act("click", "--repeat", "2", "--delay", "60", "1")
        editor.type("8.5")
        editor.act("key", "Return")
        editor.act("key", "ctrl+q")
        assert editor.process.poll() is None, "it closed without a question"
        editor.act("key", "Escape")
        assert editor.process.poll() is None
        assert editor.save_as("kept.json")["bleeding"]["speed"] == 8.5, "the work is still there"
        editor.act("key", "ctrl+z")
        editor.discard()


class FirstWindow(real_window.Window):
    """Opened without a size, by somebody who has never opened it before."""
    title, verb, search = "lapfx", "edit", "--class"


def case_small_screen(open_editor):
    """Without a size of its own, the window is no larger than the screen."""
    editor = open_editor()
    kept = ("HOME", "XDG_CONFIG_HOME", "XDG_STATE_HOME", "XDG_CACHE_HOME", "LAPFX_DATA")
    display = real_window.Display(editor.folder, "800x600")
    try:
        with FirstWindow(editor.lapfx, display, editor.folder, "--at", "0",
                         environment={key: editor.environment[key] for key in kept}) as window:
            shape = dict(line.split("=") for line in
                         window.xdotool("getwindowgeometry", "--shell", window.window).split() if "=" in line)
            left, top, width, height = (int(shape[key]) for key in ("X", "Y", "WIDTH", "HEIGHT"))
            assert left >= 0 and top >= 0 and left + width <= 800 and top + height <= 600, shape
            return f"{width} x {height} at {left}, {top}"
    finally:
        display.close()


def main(arguments):
    lapfx, drop_files, shipped = (os.path.abspath(a) for a in arguments[:3])
    wanted = arguments[3] if len(arguments) > 3 else ""
    cases = real_window.cases_of(globals(), wanted)

    def window(display, folder):
        return lambda *options: Editor(lapfx, drop_files, shipped, display, folder, *options)
    return real_window.run("editor", cases, window)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
