"""Lines and branches of src/ and include/ that the tests reach, by gcov.

    coverage.py OBJECTS LIST LINES BRANCHES

OBJECTS is a folder with the .gcda files of a build with --coverage that has run its tests. Prints a
table with a row for each layer, writes what was never reached to the file LIST, and exits with 1
where less than LINES or BRANCHES percent were reached.

A line counts once however often a template was instantiated or a file compiled for another
instruction set: it is reached if one of them was, and so is a branch. Not counted are branches that
only an exception takes; lines with SCANSHADE_CHECK, whose other branch only a bug can take; and
lines of nothing but a bracket, where destructors run when an exception passes.
"""

import collections
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys

OURS = ("src/", "include/")
NOT_COUNTED = re.compile(r"SCANSHADE_CHECK\(|^[\s{}();]*$")


class Source:
    """What was reached of one file."""

    def __init__(self, path):
        self.text = pathlib.Path(path).read_text(encoding="utf-8").splitlines()
        self.lines = {}  # number -> reached
        self.branches = {}  # (number, position) -> taken

    def add(self, line):
        number = line["line_number"]
        if NOT_COUNTED.search(self.text[number - 1]):
            return
        self.lines[number] = self.lines.get(number, False) or line["count"] > 0
        ways = [branch for branch in line["branches"] if not branch["throw"]]
        for position, branch in enumerate(ways):
            key = (number, position)
            self.branches[key] = self.branches.get(key, False) or branch["count"] > 0

    def missed(self):
        """(line number, what) in order: lines never run, and lines with branches never taken."""
        half = {number for (number, _), taken in self.branches.items() if not taken}
        for number, reached in sorted(self.lines.items()):
            if not reached or number in half:
                yield number, "branch" if reached else "line"


def gcov(notes):
    """The files that one object file was made of, as gcov describes them."""
    run = subprocess.run(["gcov", "--json-format", "--stdout", "--branch-probabilities", notes],
                         capture_output=True, text=True, check=True)
    return [file for text in run.stdout.splitlines() for file in json.loads(text)["files"]]


def read_sources(objects):
    sources = {}
    notes = sorted(str(path) for path in pathlib.Path(objects).rglob("*.gcda"))
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for files in pool.map(gcov, notes):
            for file in files:
                path = os.path.relpath(file["file"])
                if not path.startswith(OURS):
                    continue
                if path not in sources:
                    sources[path] = Source(path)
                for line in file["lines"]:
                    sources[path].add(line)
    return sources


def layer_of(path):
    parts = path.split("/")
    return parts[2 if parts[0] == "include" and len(parts) > 3 else 1]


def percent(reached):
    return 100.0 * sum(reached) / len(reached) if reached else 100.0


def print_table(sources):
    """Returns the percentages of all lines and branches."""
    rows = collections.defaultdict(lambda: ([], []))
    for path, source in sources.items():
        for name in (layer_of(path), "all"):
            rows[name][0].extend(source.lines.values())
            rows[name][1].extend(source.branches.values())
    print(f"{'':10}{'lines':>8}{'reached':>10}{'branches':>11}{'taken':>9}")
    for name in sorted(rows, key=lambda name: (name == "all", name)):
        lines, branches = rows[name]
        print(f"{name:10}{len(lines):8}{percent(lines):9.1f}%{len(branches):11}"
              f"{percent(branches):8.1f}%")
    return percent(rows["all"][0]), percent(rows["all"][1])


def write_missed(sources, path):
    with open(path, "w", encoding="utf-8") as out:
        for name, source in sorted(sources.items()):
            for number, what in source.missed():
                print(f"{name}:{number}: {what}: {source.text[number - 1].strip()}", file=out)


def main(objects, missed, least_lines, least_branches):
    sources = read_sources(objects)
    if not sources:
        print(f"coverage: {objects} has no counts; run the tests of config=coverage first")
        return 1
    lines, branches = print_table(sources)
    write_missed(sources, missed)
    print(f"what no test reaches is listed in {missed}")
    held = lines >= float(least_lines) and branches >= float(least_branches)
    print(f"coverage: {lines:.1f} % of lines and {branches:.1f} % of branches, "
          f"{'no' if held else 'that is'} less than {least_lines} and {least_branches}")
    return 0 if held else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
