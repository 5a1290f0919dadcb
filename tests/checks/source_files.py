"""The project's files, for the checks: with git those that it tracks or would track, without git what lies there."""
import os
import subprocess

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))
CPP = (".cpp", ".c", ".h")
SHADERS = (".vert", ".frag", ".glsl", ".comp")


def _git(*arguments):
    done = subprocess.run(["git", "-C", ROOT, *arguments], capture_output=True, text=True, check=True)
    return done.stdout


def project_files():
    """Paths relative to ROOT, with '/', sorted."""
    try:
        # Empty only where ROOT itself is the work tree; a tree that was unpacked inside another one is not.
        if _git("rev-parse", "--show-prefix").strip() == "":
            listed = _git("ls-files", "-z", "--cached", "--others", "--exclude-standard").split("\0")
            return sorted({path for path in listed if path and os.path.lexists(os.path.join(ROOT, path))})
    except (OSError, subprocess.CalledProcessError):
        pass
    found = []
    for folder, names, files in os.walk(ROOT):
        if folder == ROOT:  # what .gitignore leaves out
            names[:] = [n for n in names if not n.startswith("build") and n not in (".git", ".cache")]
        names[:] = [n for n in names if n not in ("__pycache__", "failed")]
        found += [os.path.relpath(os.path.join(folder, name), ROOT).replace(os.sep, "/") for name in files]
    return sorted(found)


def read(path):
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        return file.read()


def report(faults):
    """Prints a line per fault; the exit code."""
    for fault in faults:
        print(fault)
    return 1 if faults else 0
