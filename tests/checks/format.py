#!/usr/bin/env python3
"""Checks that every .cpp and .h is as clang-format writes it. To mend: the command that it prints."""
import subprocess
import sys

import source_files

PER_CALL = 16  # one clang-format for a few files: starting it costs more than a small file


def wrong_format(paths):
    done = subprocess.run(["clang-format", "--dry-run", "-Werror", *paths], cwd=source_files.ROOT,
                          capture_output=True, text=True, check=False)
    if done.returncode == 0:
        return []
    if len(paths) == 1:
        return [(paths[0], done.stderr)]
    return [wrong for path in paths for wrong in wrong_format([path])]


def main():
    paths = [path for path in source_files.project_files() if path.endswith(source_files.CPP)]
    if not paths:
        return source_files.report(["no source files found: the check has nothing to look at"])
    wrong = [w for i in range(0, len(paths), PER_CALL) for w in wrong_format(paths[i:i + PER_CALL])]
    for _, message in wrong:
        print("\n".join(message.splitlines()[:3]))
    if wrong:
        print("\nclang-format -i " + " ".join(path for path, _ in wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
