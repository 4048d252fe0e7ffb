"""Checks that includes only point down.

    cli, viewer, tests -> report -> render, brdf -> kernels -> scene, image | eq -> num -> base

Also that each library stays behind the files that wrap it, and what per-target compilation forbids
(docs/architecture.md, "Number types"). Prints one line a fault and exits with 1 if there is any.
"""

import os
import re
import sys

# Layer -> layers that it may see besides itself.
BELOW = {"base": set()}
BELOW["num"] = {"base"}
BELOW["eq"] = BELOW["num"] | {"num"}
BELOW["scene"] = BELOW["eq"] | {"eq", "image"}
BELOW["image"] = BELOW["eq"] | {"eq", "scene"}
BELOW["kernels"] = BELOW["scene"] | {"scene"}
BELOW["brdf"] = BELOW["kernels"] | {"kernels"}
BELOW["render"] = BELOW["brdf"] | {"brdf"}
BELOW["report"] = BELOW["render"] | {"render"}
BELOW["cli"] = BELOW["report"] | {"report"}
BELOW["viewer"] = BELOW["cli"] | {"cli"}  # options and exit status; never the other way: SDL
BELOW["tests"] = BELOW["viewer"] | {"viewer"}

# Included name -> files that may include it.
LIBRARIES = [
    (r"SDL", r"(src|tests)/viewer/"),
    (r"imgui", r"src/viewer/"),
    (r"tiny_obj_loader", r"src/scene/obj\.cpp$"),
    (r"toml\+\+", r"src/scene/toml\.hpp$"),
    (r"(stb/)?stb_easy_font", r"src/(cli|viewer)/"),
    (r"(stb/)?stb_", r"src/image/png\.cpp$"),
    (r"catch2/", r"tests/"),
    (r"CLI/", r"(src/cli|tests/bench)/"),
    (r"(GL|embree3)/", r"tests/bench/"),
]
HIGHWAY_HEADERS = re.compile(r"include/scanshade/num/(lanes|target)\.hpp$|src/brdf/model_\w+\.hpp$")

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
GENERATED = {"brdf_models.inc", "build_facts.inc"}
MACRO_CALLS = ("_end.hpp", "_rows.hpp")  # files whose text belongs to what includes them
TOGGLES = "HWY_TARGET_TOGGLE"  # in the include guard of the headers compiled for each target


def layer_of(path):
    parts = path.split("/")
    if parts[:2] == ["include", "scanshade"]:
        return parts[2] if len(parts) > 3 else "umbrella"
    return "tests" if parts[0] == "tests" else parts[1]


def resolve(name, including, files):
    """The project file that a quoted include means, or None."""
    for folder in (os.path.dirname(including), "include", "src", "tests"):
        path = os.path.normpath(os.path.join(folder, name))
        if path in files:
            return path
    return None


def may_use_highway(path, text):
    if HIGHWAY_HEADERS.search(path) or path.startswith("src/kernels/"):
        return True
    if path.startswith("tests/"):
        return "#define SCANSHADE_SIMD" in text
    return path.startswith("src/brdf/") and "#define SCANSHADE_MODEL" in text


def check_project_include(path, target, files):
    layer, below = layer_of(path), layer_of(target)
    if layer == "umbrella" or layer == below:
        return
    if below == "umbrella":
        yield "includes the umbrella header, which is for users of the library"
    elif below not in BELOW.get(layer, ()):
        yield f"{layer}/ may not include {target}: includes point down"
    elif path.endswith(".hpp") and layer not in ("num", "eq") and path.startswith("include/"):
        # Such a header is seen from vector and ordinary files alike, where the types differ.
        if TOGGLES in files[target]:
            yield f"a header outside num/ and eq/ may not include {target}, compiled for each target"


def check_library_include(path, text, name):
    for library, allowed in LIBRARIES:
        if re.match(library, name):
            if not re.match(allowed, path):
                yield f"may not include <{name}>: only {allowed} does"
            return
    if name.startswith("hwy/") and not may_use_highway(path, text):
        yield f"may not include <{name}>: only kernels, models, num/lanes.hpp and tests of vectors do"


def check_file(path, files):
    """Yields (line number, fault)."""
    text = files[path]
    region_begin = 0  # line of the open SCANSHADE_TARGET_BEGIN
    for number, line in enumerate(text.splitlines(), 1):
        if re.match(r"SCANSHADE_TARGET_BEGIN\b", line):
            region_begin = number
        elif re.match(r"SCANSHADE_TARGET_END\b", line):
            region_begin = 0
        include = INCLUDE.match(line)
        if not include:
            continue
        quote, name = include.groups()
        own = quote == '"' or name.startswith("scanshade/")
        target = resolve(name, path, files) if own else None
        if region_begin and not name.endswith(MACRO_CALLS):
            # Its inline functions would be emitted for a newer machine than the one that runs them.
            yield number, f"<{name}> is included inside SCANSHADE_TARGET_BEGIN of line {region_begin}"
        if target:
            faults = check_project_include(path, target, files)
        elif own and name not in GENERATED:
            faults = [f'"{name}" is no file of this project; libraries are included with <>']
        else:
            faults = check_library_include(path, text, name)
        for fault in faults:
            yield number, fault


def check(files):
    """files: path -> text. Returns lines "path:line: fault"."""
    return [f"{path}:{number}: {fault}" for path in sorted(files)
            for number, fault in check_file(path, files)]


def read_sources(root):
    files = {}
    for top in ("include", "src", "tests"):
        for folder, _, names in os.walk(os.path.join(root, top)):
            for name in names:
                if name.endswith((".hpp", ".cpp")):
                    path = os.path.join(folder, name)
                    with open(path, encoding="utf-8") as source:
                        files[os.path.relpath(path, root)] = source.read()
    return files


if __name__ == "__main__":
    faults = check(read_sources(sys.argv[1] if len(sys.argv) > 1 else "."))
    print("\n".join(faults) if faults else "layers: every include points down")
    sys.exit(1 if faults else 0)
