#!/usr/bin/env python3
"""report_test.py LAPFX SCENE: the report of `lapfx fit`, opened in a browser: it shows what it
should and loads nothing.

Needs chromium; without it the file alone is looked at, and the test is skipped.
"""
import html
import json
import os
import re
import shutil
import socketserver
import subprocess
import sys
import tempfile
import threading
import xml.etree.ElementTree as xml

HTML, SVG = "{http://www.w3.org/1999/xhtml}", "{http://www.w3.org/2000/svg}"
REFERENCE = "hidden <b> & \"it's\" <script>alert(1).mp4"  # a file may be called so
DARK, LIGHT = 0, 1  # Blink's numbers of preferred color schemes
LONGEST_PICTURE = 320  # px
SKIPPED = 77
# Without what a browser asks for by itself: updates, the time, accounts.
NOWHERE = "http://localhost:1/"
QUIET = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--no-first-run", "--hide-scrollbars",
         "--disable-sync", "--disable-background-networking", "--disable-component-update", "--disable-default-apps",
         "--disable-extensions", "--disable-features=NetworkTimeServiceQuerying", f"--gaia-url={NOWHERE}",
         f"--component-updater=url-source={NOWHERE},disable-background-downloader"]
# In case another version asks all the same; that the file names no such address is checked apart.
BROWSERS_OWN = ("localhost:1", "update.googleapis.com", "clients2.google.com", "accounts.google.com")
OUTSIDE = "http://outside.invalid/"
# Reads the report in a frame, which a page of the same folder may with --allow-file-access-from-files.
READER = """<!DOCTYPE html><html><body style="margin:0">
<iframe id="frame" src="PAGE" style="border:0;width:WIDTHpx;height:1000px"></iframe><pre id="found"></pre>
<script>
frame.onload = () => {
  const page = frame.contentDocument;
  found.textContent = JSON.stringify({
    images: Array.from(page.images, i => [i.complete, i.naturalWidth, i.naturalHeight, i.alt]),
    plots: Array.from(page.querySelectorAll("svg"), s => [s.getBoundingClientRect().width, s.id]),
    curves: Array.from(page.querySelectorAll("polyline"), p => p.getTotalLength()),
    title: page.title, scripts: page.scripts.length, more: MORE,
    wider: page.documentElement.scrollWidth - page.documentElement.clientWidth});
};
</script></body></html>"""


def run(lapfx, *arguments):
    done = subprocess.run([lapfx, *arguments], capture_output=True, text=True, timeout=1700)
    return done.returncode, done.stdout, done.stderr


def check_refused(lapfx, scene, video, folder):
    """Before the work: nothing is written, nothing measured."""
    fitted, table = os.path.join(folder, "fitted.json"), os.path.join(folder, "table.csv")
    link, taken = os.path.join(folder, "link.html"), os.path.join(folder, "video.html")
    os.link(video, taken)
    os.symlink(fitted, link)
    for report, code, expected in ((os.path.join(folder, "report.htm"), 2, "does not end in .html"),
                                   (os.path.join(folder, "none", "report.html"), 1, "folder is missing"),
                                   (taken, 2, "is a file that is read here"), (link, 1, "not a plain file")):
        done, said, told = run(lapfx, "fit", scene, "--reference", video, "-o", fitted, "--csv", table,
                               "--report", report)
        assert done == code and expected in told and said == "", (report, done, said, told)
    os.remove(taken)
    os.remove(link)
    assert os.listdir(folder) == [os.path.basename(video)], os.listdir(folder)


def make_report(lapfx, scene, folder):
    video, report = os.path.join(folder, REFERENCE), os.path.join(folder, "report.html")
    code, _, told = run(lapfx, "render", scene, "--size", "128x104", "--fps", "5", "--to", "3", "--set",
                        "smoke.haze.accumulation=0.09", "-o", video)
    assert code == 0, told
    check_refused(lapfx, scene, video, folder)
    code, said, told = run(lapfx, "fit", scene, "--reference", video, "--offset", "0", "--window", "0,3",
                           "--parameters", "smoke.haze.accumulation,bleeding.pulse_rate",
                           "-o", os.path.join(folder, "fitted.json"), "--report", report)
    assert code == 0, told
    assert not [name for name in os.listdir(folder) if name.endswith(".tmp")], os.listdir(folder)
    return report, said


def check_file(report, said):
    """A strict parser reads it, and the figures are those that were printed."""
    page = xml.parse(report).getroot()
    text = " ".join("".join(page.find(HTML + "body").itertext()).split())
    assert REFERENCE in page.find(f"{HTML}head/{HTML}title").text and REFERENCE in text, text
    policy = [meta.get("content") for meta in page.iter(HTML + "meta") if meta.get("http-equiv")]
    assert policy == ["default-src 'none'; style-src 'unsafe-inline'; img-src data:"], policy
    assert not list(page.iter(HTML + "script"))
    with open(report, encoding="utf-8") as file:
        addresses = set(re.findall(r"https?://[^\s\"'<>)]*", file.read()))
    assert addresses == {HTML.strip("{}"), SVG.strip("{}")}, addresses  # names of languages
    for plot in page.iter(SVG + "svg"):
        assert plot.find(SVG + "title").text and "of the scene" in plot.find(SVG + "desc").text
    for key in ("smoke.haze.accumulation", "bleeding.pulse_rate"):
        line = next(line for line in said.splitlines() if line.startswith(key))
        for word in re.sub("[,():]|->", " ", line).split():
            assert word in text, (word, line, text)


class Counted(socketserver.BaseRequestHandler):
    """A proxy that only counts who asks for what."""
    def handle(self):
        self.server.asked.append(self.request.recv(4096).split(b"\r\n")[0].decode(errors="replace"))


class Browser:
    def __init__(self, program, folder):
        self.program, self.folder = program, folder
        self.server = socketserver.ThreadingTCPServer(("127.0.0.1", 0), Counted)
        self.server.daemon_threads = True
        self.server.asked = []
        threading.Thread(target=self.server.serve_forever, daemon=True).start()

    def open(self, page, *options):
        """What it prints, and what it asked for outside of the machine's files."""
        self.server.asked.clear()
        profile = tempfile.mkdtemp(dir=self.folder)
        done = subprocess.run(
            [self.program, *QUIET, f"--user-data-dir={profile}",
             f"--proxy-server=http://127.0.0.1:{self.server.server_address[1]}", "--proxy-bypass-list=<-loopback>",
             *options, "file://" + page], capture_output=True, text=True, timeout=300,
            env={**os.environ, "HOME": self.folder})
        shutil.rmtree(profile, ignore_errors=True)
        assert done.returncode == 0, done.stderr[-2000:]
        return done.stdout, [line for line in self.server.asked if not any(own in line for own in BROWSERS_OWN)]

    def corner(self, page, scheme, size):
        """The color of the upper left pixel, 0..255 each, and the picture's size, px."""
        shot = os.path.join(self.folder, "shot.png")
        self.open(page, f"--blink-settings=preferredColorScheme={scheme}", f"--window-size={size[0]},{size[1]}",
                  f"--screenshot={shot}")
        pixels = subprocess.run(["ffmpeg", "-v", "error", "-i", shot, "-f", "rawvideo", "-pix_fmt", "rgb24", "-"],
                                capture_output=True, check=True, timeout=60).stdout
        assert len(pixels) == 3 * size[0] * size[1], (len(pixels), size)
        return tuple(pixels[:3])


def read(browser, folder, width, page="report.html", more="null"):
    """What a page of the folder shows, and what was asked for. `more`: an expression of JavaScript on `page`."""
    reader = os.path.join(folder, "reader.html")
    with open(reader, "w", encoding="utf-8") as file:
        file.write(READER.replace("WIDTH", str(width)).replace("PAGE", page).replace("MORE", more))
    dom, asked = browser.open(reader, "--allow-file-access-from-files", "--dump-dom")
    found = dom.split('<pre id="found">')[1].split("</pre>")[0]
    return json.loads(html.unescape(found)), asked


def check_shown(browser, folder):
    for width in (1200, 400):
        found, asked = read(browser, folder, width)
        assert asked == [] and found["scripts"] == 0 and found["wider"] <= 0, (width, asked, found)
        assert REFERENCE in found["title"], found["title"]
        assert [plot[1] for plot in found["plots"]] == ["plot-blood", "plot-veil"], found["plots"]
        assert all(0.7 * min(width, 480) < plot[0] <= width for plot in found["plots"]), found["plots"]
        assert len(found["curves"]) >= 6 and min(found["curves"]) > 100, found["curves"]
        images = found["images"]
        assert len(images) in (6, 9), images
        for complete, wide, high, name in images:
            assert complete and 0 < wide <= LONGEST_PICTURE and 0 < high <= LONGEST_PICTURE and "of the scene" in name, images
            assert abs(wide / high - 128 / 104) < 0.02, images


def check_requests(browser, report, folder):
    """None of its own, and its policy refuses those of what gets into it; without it they are seen."""
    assert browser.open(report, "--dump-dom")[1] == []
    with open(report, encoding="utf-8") as file:
        page = file.read()
    foreign = (f'<img src="{OUTSIDE}a.png" alt=""/><script src="{OUTSIDE}a.js"></script>'
               f'<link rel="stylesheet" href="{OUTSIDE}a.css"/><iframe src="{OUTSIDE}a.html"></iframe></main>')
    changed = os.path.join(folder, "changed.html")
    for policy, expected in ((True, 0), (False, 4)):
        with open(changed, "w", encoding="utf-8") as file:
            file.write(page.replace("</main>", foreign).replace(*(("", "") if policy else ("Content-Security", "X"))))
        asked = {line for line in browser.open(changed, "--dump-dom")[1] if OUTSIDE in line}
        assert len(asked) == expected, (policy, asked)


def check_schemes(browser, report):
    for size in ((1200, 900), (400, 900)):
        light, dark = browser.corner(report, LIGHT, size), browser.corner(report, DARK, size)
        assert min(light) > 240 and max(dark) < 40, (size, light, dark)


def main(lapfx, scene):
    with tempfile.TemporaryDirectory() as folder:
        report, said = make_report(lapfx, scene, folder)
        check_file(report, said)
        program = shutil.which("chromium")
        if program is None:
            print("skipped: chromium is not installed, so the report was not opened in a browser (.packages names it)")
            return SKIPPED
        browser = Browser(program, folder)
        check_shown(browser, folder)
        check_requests(browser, report, folder)
        check_schemes(browser, report)
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
