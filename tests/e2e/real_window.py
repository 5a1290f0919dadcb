"""A program's window as a person uses it: a display of its own (Xvfb), pointer and keys from xdotool. For the tests of
windows.

    class Gallery(Window):
        title = "lapfx gallery"
    ...
    sys.exit(real_window.run(cases_of(globals(), name), lambda display, folder: ...))

What a case looks at is the log of frames (--statistics) while the window is open, which also says when it rests
because nothing is due soon, and the tree of widgets once it is closed (--dump-on-close). Where widgets are is asked
beforehand, without a window (--dump).
"""
import json
import os
import re
import shutil
import subprocess
import tempfile
import time

SKIP = 77
LIMIT_S = 600  # for anything to happen, also under a sanitizer on a busy machine: only what hangs takes so long
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

    def __init__(self, folder, screen="1280x1024"):
        self.log = open(os.path.join(folder, "xvfb.log"), "w", encoding="utf-8")
        read, write = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", screen + "x24", "-nolisten", "tcp"],
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


_trees = {}


class Window:
    """One window of `lapfx VERB`. Use as a context: leaving it closes what is still open."""

    title = verb = ""
    search = "--name"  # how xdotool finds it by its title

    def __init__(self, lapfx, display, folder, *options, environment=None):
        self.folder = folder
        self.dump_file = os.path.join(folder, "closed.json")
        self.log_file = os.path.join(folder, "frames.log")
        self.environment = {**os.environ, "DISPLAY": display.name, "LC_ALL": "C.UTF-8", "LAPFX_SCALE": "1",
                            **(environment or {})}
        self.environment.pop("WAYLAND_DISPLAY", None)
        self.common = list(options)
        self.lapfx = lapfx
        self.process = None
        self.window = None
        self.started = self.first_frame_s = 0.0

    def __enter__(self):
        if os.path.exists(self.dump_file):
            os.remove(self.dump_file)
        self.log = open(self.log_file, "w", encoding="utf-8")
        self.started = time.monotonic()
        self.process = subprocess.Popen(
            [self.lapfx, self.verb, *self.common, "--statistics", "--dump-on-close", self.dump_file],
            env=self.environment, stdout=self.log, stderr=self.log)

        def first_frame():
            if self.process.poll() is not None:
                text = self.text()
                if self.process.returncode == SKIP:
                    raise Skip(text.strip())
                raise AssertionError(f"ended with {self.process.returncode}: {text}")
            return self.frames()
        wait_for("the first frame", first_frame)
        self.first_frame_s = time.monotonic() - self.started
        self.window = self.xdotool("search", "--sync", "--onlyvisible", self.search, self.title).split()[-1]
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

    def latest(self, mark):
        """The last line that begins so; None: there is none."""
        with open(self.log_file, "rb") as file:
            size = file.seek(0, os.SEEK_END)
            for length in (8192, size):  # the log may be long
                file.seek(max(size - length, 0))
                found = [line for line in file.read().split(b"\n")[:-1] if re.match(mark, line)]
                if found:
                    return found[-1].decode()
        return None

    def made(self):
        """How many frames there have been."""
        last = self.latest(rb"frame \d+ at ")
        return int(last.split()[1]) if last else 0

    def rests(self):
        """Whether it has handled all it knows of, and nothing is due soon."""
        last = self.latest(rb"(frame|rests) ")
        return last is not None and last.startswith("rests ") and not self.running()

    def settle(self, quiet=0.4):
        """Waits until it rests and no frame has been made for `quiet` s."""
        def is_quiet():
            count = self.made()
            time.sleep(quiet)
            return self.made() == count and self.rests()
        wait_for("a quiet window", is_quiet)

    def tasks(self, file):
        """That file of /proc of each of its threads."""
        folder = f"/proc/{self.process.pid}/task"
        for task in os.listdir(folder):
            try:
                with open(os.path.join(folder, task, file), encoding="utf-8") as text:
                    yield text.read()
            except FileNotFoundError:  # it has ended
                pass

    def running(self):
        """Threads that use the processor or wait for it."""
        return sum(stat.rsplit(")", 1)[1].split()[0] == "R" for stat in self.tasks("stat"))

    def wakes(self):
        """How often its threads have begun to wait so far."""
        return sum(int(re.search(r"^voluntary_ctxt_switches:\s*(\d+)", status, re.MULTILINE)[1])
                   for status in self.tasks("status"))

    def sleeps(self, seconds, most_wakes):
        """Waits until it has slept for so long: no frames, hardly any wakes, and never a thread that runs. Gives the
        wakes."""
        found = []

        def slept():
            wakes, frames = self.wakes(), self.made()
            for _ in range(seconds):
                time.sleep(1)
                if self.running() or self.made() != frames:
                    return False
            found.append(self.wakes() - wakes)
            return found[-1] <= most_wakes
        assert self.wakes() > 0, "this measures nothing"
        wait_for(f"{seconds} s of sleep with at most {most_wakes} wakes", slept)
        return found[-1]

    def xdotool(self, *arguments):
        done = subprocess.run(["xdotool", *arguments], env=self.environment, capture_output=True, encoding="utf-8",
                              timeout=LIMIT_S, check=False)
        assert done.returncode == 0, f"xdotool {' '.join(arguments)}: {done.stderr}"
        return done.stdout

    def answer(self, count, to):
        """Waits for a frame after the first `count`."""
        def answered():
            assert self.process.poll() is None, f"it ended with {self.process.returncode}: {self.text()[-2000:]}"
            return self.made() > count
        wait_for(f"an answer to {to}", answered)

    def act(self, *arguments):
        """Runs one xdotool command and waits for the window's answer."""
        self.act_now(*arguments)
        self.settle(0.15)

    def act_now(self, *arguments):
        """The same for a window that never becomes quiet."""
        count = self.made()
        self.xdotool(*arguments)
        self.answer(count, " ".join(arguments))

    def tree(self):
        """Of a window that has just been opened: all that are opened alike have the same."""
        alike = (self.verb, *self.common, self.environment["LAPFX_SCALE"], self.environment.get("LAPFX_DATA"))
        if alike not in _trees:
            _trees[alike] = self.new_tree()
        return _trees[alike]

    def new_tree(self):
        file = os.path.join(self.folder, "before.json")
        subprocess.run([self.lapfx, self.verb, *self.common, "--scale", "1", "--dump", file], env=self.environment, check=True)
        with open(file, encoding="utf-8") as dump:
            return json.load(dump)

    def middle(self, path):
        x, y, w, h = node(self.tree(), path)["rect"]
        return int(x + w / 2), int(y + h / 2)

    def click(self, path, button=1):
        x, y = self.middle(path)
        self.act("mousemove", "--window", self.window, str(x), str(y))
        self.act("click", str(button))

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


def cases_of(names, wanted):
    return [(name[5:], case) for name, case in names.items() if name.startswith("case_") and wanted in name]


def run(test, cases, window, **display_options):
    """Each case with a function that opens windows, which is made by `window(display, folder)`. The exit code."""
    for program in ("Xvfb", "xdotool"):
        if shutil.which(program) is None:
            print(f"{test}: there is no {program}, so nothing was tested")
            return SKIP
    failed = 0
    with tempfile.TemporaryDirectory(prefix=f"lapfx {test} ") as folder:
        try:
            display = Display(folder, **display_options)
            try:
                for name, case in cases:
                    print(f"{name} ... ", end="", flush=True)
                    try:
                        said = case(window(display, folder))
                        print(f"ok ({said})" if said else "ok")
                    except AssertionError as error:
                        failed += 1
                        print(f"FAILED: {error}")
            finally:
                display.close()
        except Skip as reason:
            print(f"skipped: {reason}")
            return 1 if failed else SKIP  # what failed before that stays failed
    print(f"{len(cases)} cases, {failed} failed")
    return 1 if failed or not cases else 0
