"""lapfx inspect on many files, for the walks through test data: some at a time in one process, because a start costs
more than most files do. What a process says is told apart by file; where that cannot be done, and where it crashed or
hung, its files are inspected one by one."""
import concurrent.futures
import subprocess

TOGETHER = 12
LIMIT_S = 1200  # for one process


def inspect(program, files):
    try:
        done = subprocess.run([program, "inspect", *files], capture_output=True, text=True, errors="replace", timeout=LIMIT_S,
                              check=False)
    except subprocess.TimeoutExpired:
        return None, "", f"not done after {LIMIT_S} s"
    return done.returncode, done.stdout, done.stderr


def told_apart(files, code, output, errors):
    """(file, code, output, errors) of each; None: what was said cannot be."""
    wanted, texts = list(files), {}
    for line in output.splitlines(keepends=True):
        name = next((file for file in wanted if line.startswith(file + ": ")), None)
        if name is not None:
            del wanted[:wanted.index(name) + 1]  # they come in the order that was asked for
            texts[name] = ""
        if not texts:
            return None
        texts[next(reversed(texts))] += line
    faults = {file: "".join(line for line in errors.splitlines(keepends=True) if line.startswith(f"lapfx: {file}: "))
              for file in files}
    refused = [file for file in files if faults[file]]
    if code != (2 if refused else 0) or any(file not in texts and not faults[file] for file in files):
        return None
    return [(file, 2 if faults[file] else 0, texts.get(file, ""), faults[file]) for file in files]


def inspect_some(program, files):
    found = told_apart(files, *inspect(program, files)) if len(files) > 1 else None
    return found or [(file, *inspect(program, [file])) for file in files]


def inspect_all(program, files):
    """(file, exit code or None for a hang, stdout, stderr) of each."""
    files = list(files)
    # Neighbours are alike: every so manieth goes to the same process, so that none gets all large ones.
    count = max(1, -(-len(files) // TOGETHER))
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for found in pool.map(lambda first: inspect_some(program, files[first::count]), range(count)):
            yield from found
