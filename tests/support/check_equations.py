"""Keeps equations, functions, tests and docs/equations.md together.

    check_equations.py [--write] [ROOT]

Reads the docstrings of include/scanshade/{eq,num}/*.hpp. A docstring that implements an equation shows
its formula with the number at the right, and names its test:

    /// Cartesian from spherical coordinates.
    ///
    ///     x = sinθ cosφ,   y = sinθ sinφ,   z = cosθ                                   (A4)
    ///
    /// in      ...
    /// checks  |ω| = 1; round trip with A3                tests/eq/directions_test.cpp

Several functions may be parts of one equation. Faults are: an equation of the finished chapters
without a function, a function of eq/ without a number, a test file that does not exist or has no
test case whose name or tags mention the number as (A4), and an outdated docs/equations.md, which
--write writes again. Types in num/ are read as well, but need no number.
"""

import collections
import glob
import os
import re
import sys

from equation_catalogue import CHAPTERS, EQUATIONS, FINISHED

HEADERS = ["include/scanshade/eq", "include/scanshade/num"]
OUTPUT = "docs/equations.md"

NUMBER = re.compile(r"\(([A-G]\d+[a-d]?)\)")
FORMULA = re.compile(r"^ {4,}(\S.*?)(?: +printed)?\s*((?:\([A-G]\d+[a-d]?\)[,\s]*)+)$")
TEST_FILE = re.compile(r"tests/\w+/\w+\.cpp")
FIELD = re.compile(r"^(error|checks|source)\b")
# The name that a declaration gives: of a struct, or of a function before its parameters.
DECLARED = re.compile(r"\bstruct (\w+)|(?<!operator)\b(\w+)\s*\(")
TEST_CASE = re.compile(r'(?:TEST_CASE|TEMPLATE_TEST_CASE)\(\s*((?:"(?:[^"\\]|\\.)*"[\s,]*)+)')

Entry = collections.namedtuple("Entry", "name path line formulas numbers fields tests")


def docstrings(text):
    """Yields (line of the declaration, documentation lines, declaration) of each /// block, and of
    each template function without one."""
    lines = text.splitlines()
    block = []
    for number, line in enumerate(lines, 1):
        if line.startswith("///"):
            block.append(line[3:].removeprefix(" "))
        elif re.match(r"(template|struct|inline|constexpr|R |Rgb|Vec3)", line):
            declaration = " ".join(lines[number - 1:number + 3])
            if block or line.startswith("template"):
                yield number, block, re.sub(r"^template <[^>]*>\s*", "", declaration)
            block = []
        elif not line.strip():
            block = []


def parse_header(path, text):
    entries = []
    for line, block, declaration in docstrings(text):
        declared = DECLARED.search(declaration)
        if not declared:
            continue
        formulas, fields = [], set()
        for row in block:
            formula = FORMULA.match(row)
            if formula:
                formulas.append((formula[1], NUMBER.findall(formula[2])))
            field = FIELD.match(row)
            if field:
                fields.add(field[1])
        entries.append(Entry(
            name=declared[1] or declared[2], path=path, line=line,
            formulas=formulas,
            numbers=[number for _, numbers in formulas for number in numbers], fields=fields,
            tests=TEST_FILE.findall("\n".join(block))))
    return entries


def tested_numbers(text):
    """Numbers that the names and tags of a file's test cases mention."""
    return {number for names in TEST_CASE.findall(text) for number in NUMBER.findall(names)}


def check(entries, tests, catalogue=EQUATIONS, finished=FINISHED):
    """tests: path of a test file -> its text. Returns lines of faults."""
    faults = []
    known = {number for number, _, _ in catalogue}
    implemented = set()
    for entry in entries:
        where = f"{entry.path}:{entry.line}: {entry.name}"
        if not entry.numbers:
            if "/eq/" in entry.path:
                faults.append(f"{where} shows no formula with a number like (C3)")
            continue
        for field in ("error", "checks", "source"):
            if field not in entry.fields:
                faults.append(f"{where} has no line '{field}'")
        if not entry.tests:
            faults.append(f"{where} names no test file in its line 'checks'")
        for path in entry.tests:
            if path not in tests:
                faults.append(f"{where} names {path}, which does not exist")
        tested = set().union(*(tested_numbers(tests.get(path, "")) for path in entry.tests))
        for number in entry.numbers:
            implemented.add(number)
            if number not in known:
                faults.append(f"{where} implements ({number}), which the catalogue does not have")
            elif number not in tested and all(path in tests for path in entry.tests):
                faults.append(f"{where} implements ({number}), but no test case there mentions it")
    faults += [f"({number}) has no function in {HEADERS[0]}/" for number in finished
               if number not in implemented]
    return faults


def cell(text):
    return text.replace("|", "\\|").strip()


def equation_rows(chapter, by_number):
    for number, name, note in EQUATIONS:
        if number[0] != chapter:
            continue
        for entry, formula in by_number.get(number, []):
            links = ", ".join(f"[{os.path.basename(path)}](../{path})" for path in entry.tests)
            yield (f"| {number} | {name} | {cell(formula)} | [`{entry.name}`](../{entry.path}) "
                   f"| {links} | {cell(note)} |")


def render(entries):
    """The text of docs/equations.md."""
    by_number = collections.defaultdict(list)
    for entry in entries:
        for formula, numbers in entry.formulas:
            for number in numbers:
                by_number[number].append((entry, formula))
    lines = ["# Equations", "", *PREFACE.strip().splitlines(), ""]
    for letter, title in CHAPTERS.items():
        rows = list(equation_rows(letter, by_number))
        if rows:
            lines += [f"## {letter}  {title}", "",
                      "| number | what | as printed | function | test | note |",
                      "|---|---|---|---|---|---|", *rows, ""]
    lines += ["## Known to the catalogue, without a function", ""]
    for letter, title in CHAPTERS.items():
        names = [f"{number} {name}" for number, name, _ in EQUATIONS
                 if number[0] == letter and number not in by_number]
        if names:
            lines += [f"- **{title}:** " + " · ".join(names)]
    return "\n".join(lines) + "\n"


PREFACE = """
*Generated by `make docs` from the docstrings in `include/scanshade/eq/` and the catalogue in
`tests/support/equation_catalogue.py`; `make check` fails where this page is not current.*

The numbers are those of a formula sheet of classic image synthesis, by chapter (A to G). A function
in `eq/` quotes its equation as printed, says which form is computed and why, gives the range and
unit of each input and bounds the error. The notes say where the printed form is wrong (*Corrected*)
or unsafe in floating point (*Care*); a test holds each correction.

| symbol | in code | meaning |
|---|---|---|
| n | `n` | unit surface normal |
| ω_i, ω_o | `wi`, `wo` | unit directions from the surface to the light and to the viewer |
| ω_r, ω_h or h | `wr`, `wh` | mirror direction of ω_i; half vector of ω_i and ω_o |
| θ_i, θ_o | `cos_i`, `cos_o` | angles of ω_i and ω_o with n |
| θ_r | `r_o` | angle between ω_r and ω_o |
| θ_h | `n_h` | angle between h and n |
| φ | `phi` | azimuth about n |
| k_a, k_d, k_s | `ka`, `kd`, `ks` | ambient, diffuse and specular coefficients, a channel |
| n (exponent), s | `shininess` | Phong exponent |
| f_r | | BRDF, 1/sr |
| L, E, I, Φ | | radiance, irradiance, intensity, flux |
| f_att | | attenuation 1/(c + l d + q d²) |
| u | | unit roundoff of the number type: 2⁻²⁴ float, 2⁻⁵³ double |
"""


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def main(arguments):
    write = "--write" in arguments
    roots = [argument for argument in arguments if argument != "--write"]
    os.chdir(roots[0] if roots else ".")
    headers = sorted(path for folder in HEADERS for path in glob.glob(f"{folder}/*.hpp"))
    entries = [entry for path in headers for entry in parse_header(path, read(path))]
    page = render(entries)
    if write:
        with open(OUTPUT, "w", encoding="utf-8") as file:
            file.write(page)
        print(f"wrote {OUTPUT}")
        return 0
    paths = {path for entry in entries for path in entry.tests if os.path.exists(path)}
    faults = check(entries, {path: read(path) for path in paths})
    if not os.path.exists(OUTPUT) or read(OUTPUT) != page:
        faults.append(f"{OUTPUT} is not current; run 'make docs'")
    numbers = {number for entry in entries for number in entry.numbers}
    print("\n".join(faults) if faults else f"equations: {len(numbers)} of {len(EQUATIONS)} have a "
          "function and a test")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
