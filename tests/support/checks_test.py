"""Tests of the checkers: each must find what it is for."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
import check_equations
import check_headers
import check_layers
import coverage

LAYERED = {
    "include/scanshade/base/error.hpp": "#include <string>\n",
    "include/scanshade/num/real.hpp": "#if defined(A) == defined(HWY_TARGET_TOGGLE)\n",
    "include/scanshade/scene/mesh.hpp": '#include "scanshade/base/error.hpp"\n',
    "include/scanshade/render/plan.hpp": '#include "scanshade/scene/mesh.hpp"\n',
    "src/render/raster.hpp": "",
    "src/render/raster.cpp": '#include "raster.hpp"\n#include "scanshade/num/real.hpp"\n',
    "src/viewer/window.hpp": '#include "cli/options.hpp"\n',
    "src/cli/options.hpp": "",
    "src/viewer/window.cpp": '#include "render/raster.hpp"\n#include <SDL2/SDL.h>\n',
    "src/scene/obj.cpp": "#include <tiny_obj_loader.h>\n",
    "src/image/png.cpp": "#include <stb/stb_image.h>\n",
    "src/cli/label.cpp": "#include <stb/stb_easy_font.h>\n",
    "src/brdf/phong.cpp": "#define SCANSHADE_MODEL phong\n#include <hwy/highway.h>\n",
    "tests/render/plan_test.cpp": '#include "scanshade/render/plan.hpp"\n',
}


class Layers(unittest.TestCase):
    def faults(self, path, text):
        return check_layers.check(LAYERED | {path: text})

    def test_a_layered_project_passes(self):
        self.assertEqual(check_layers.check(LAYERED), [])

    def test_an_include_that_points_up_is_found(self):
        for path, text in [
            ("src/scene/a.cpp", '#include "scanshade/render/plan.hpp"'),
            ("src/scene/a.cpp", "#include <scanshade/render/plan.hpp>"),
            ("src/scene/a.cpp", '#include "render/raster.hpp"'),
            ("src/scene/a.cpp", '#include "../render/raster.hpp"'),
            ("include/scanshade/base/a.hpp", '#include "scanshade/num/real.hpp"'),
            ("src/cli/a.cpp", '#include "viewer/window.hpp"'),
            ("src/cli/a.cpp", '  #  include "../../tests/render/plan_test.cpp"'),
        ]:
            with self.subTest(path=path, text=text):
                found = self.faults(path, "\n" + text + "\n")
                self.assertEqual(len(found), 1)
                self.assertTrue(found[0].startswith(f"{path}:2: "))

    def test_a_library_outside_its_file_is_found(self):
        for path, name in [("src/cli/a.cpp", "SDL2/SDL.h"), ("src/render/a.cpp", "SDL.h"),
                           ("src/scene/mesh.cpp", "tiny_obj_loader.h"),
                           ("src/cli/a.cpp", "stb/stb_image_write.h"),
                           ("src/render/a.cpp", "stb/stb_easy_font.h"),
                           ("src/render/a.cpp", "hwy/highway.h"),
                           ("src/brdf/registry.cpp", "hwy/highway.h"),
                           ("src/base/a.cpp", "catch2/catch.hpp")]:
            with self.subTest(path=path, name=name):
                self.assertEqual(len(self.faults(path, f"#include <{name}>\n")), 1)

    def test_a_header_for_both_modes_may_not_see_number_types(self):
        text = '#include "scanshade/num/real.hpp"\n'
        self.assertEqual(len(self.faults("include/scanshade/scene/a.hpp", text)), 1)

    def test_an_include_inside_a_target_region_is_found(self):
        region = "SCANSHADE_TARGET_BEGIN;\n{}SCANSHADE_TARGET_END;\n{}"
        path, include = "include/scanshade/eq/a.hpp", "#include <vector>\n"
        self.assertEqual(len(self.faults(path, region.format(include, ""))), 1)
        self.assertEqual(self.faults(path, region.format("", include)), [])

    def test_a_quoted_include_of_no_file_is_found(self):
        self.assertEqual(len(self.faults("src/scene/a.cpp", '#include "nothing.hpp"\n')), 1)


HEADER = """
/// Spherical to Cartesian.
///
///     x = sinθ cosφ                                    (A4)
///
/// in      s        angles
/// error   ≤ 3 u
/// checks  |ω| = 1                                      tests/eq/directions_test.cpp
/// source  the formula sheet
template <Real R>
Vec3<R> to_cartesian(const Spherical<R>& s) {
    return helper(s);
}
"""
TEST = 'TEST_CASE("angles and vectors (A4) agree",\n          "[eq]") {}\n'
CATALOGUE = [("A4", "spherical to Cartesian", ""), ("A5", "solid angle", "")]


class Equations(unittest.TestCase):
    def faults(self, header=HEADER, test=TEST, finished=("A4",)):
        entries = check_equations.parse_header("include/scanshade/eq/directions.hpp", header)
        tests = {} if test is None else {"tests/eq/directions_test.cpp": test}
        return check_equations.check(entries, tests, CATALOGUE, finished)

    def assert_fault(self, words, faults):
        self.assertEqual(len(faults), 1, faults)
        self.assertIn(words, faults[0])

    def test_an_equation_with_function_and_test_passes(self):
        self.assertEqual(self.faults(), [])

    def test_an_equation_without_a_function_is_found(self):
        self.assert_fault("(A5) has no function", self.faults(finished=("A4", "A5")))

    def test_a_function_without_a_number_is_found(self):
        extra = "\n/// Doubles x.\ntemplate <Real R>\nR twice(R x) {\n    return x + x;\n}\n"
        self.assert_fault("twice shows no formula", self.faults(header=HEADER + extra))
        bare = "\ntemplate <Real R>\nR twice(R x) {\n    return x + x;\n}\n"
        self.assert_fault("twice shows no formula", self.faults(header=HEADER + bare))

    def test_a_missing_test_file_is_found(self):
        self.assert_fault("does not exist", self.faults(test=None))

    def test_a_number_that_no_test_case_mentions_is_found(self):
        self.assert_fault("no test case there mentions", self.faults(test=TEST.replace("A4", "A5")))
        comment = '// (A4)\nTEST_CASE("angles", "[eq]") {}\n'
        self.assert_fault("no test case there mentions", self.faults(test=comment))

    def test_a_missing_field_is_found(self):
        for field in ("error", "source"):
            header = "".join(line for line in HEADER.splitlines(True) if f"/// {field}" not in line)
            self.assert_fault(f"no line '{field}'", self.faults(header=header))

    def test_a_number_outside_the_catalogue_is_found(self):
        faults = self.faults(header=HEADER.replace("(A4)", "(A44)"), finished=())
        self.assert_fault("the catalogue does not have", faults)

    def test_a_page_that_is_not_current_is_found(self):
        script = str(Path(check_equations.__file__).resolve())
        with tempfile.TemporaryDirectory() as root:
            for path, text in [("include/scanshade/eq/a.hpp", HEADER), ("docs/equations.md", "")]:
                file = Path(root, path)
                file.parent.mkdir(parents=True)
                file.write_text(text, encoding="utf-8")

            def run(*arguments):
                return subprocess.run([sys.executable, script, *arguments, root], text=True,
                                      capture_output=True, check=False).stdout

            self.assertIn("is not current", run())
            run("--write")
            self.assertNotIn("is not current", run())
            self.assertIn("to_cartesian", Path(root, "docs/equations.md").read_text("utf-8"))


class Headers(unittest.TestCase):
    def test_a_header_that_needs_another_or_has_no_guard_is_found(self):
        with tempfile.TemporaryDirectory() as folder:
            sources = {"good": "#pragma once\n#include <string>\nstruct A { std::string s; };\n",
                       "needs_another": "#pragma once\nstruct A { std::string s; };\n",
                       "no_guard": "struct A {};\n"}
            for name, text in sources.items():
                Path(folder, name).write_text(text, encoding="utf-8")
            failed = [name for name in sources
                      if check_headers.check([f"{folder}/{name}"], ["-std=c++20"])]
            self.assertEqual(failed, ["needs_another", "no_guard"])


class Coverage(unittest.TestCase):
    def source(self, *lines):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "a.cpp")
            path.write_text("".join(line + "\n" for line in lines), encoding="utf-8")
            return coverage.Source(str(path))

    @staticmethod
    def line(number, count, *branches):
        return {"line_number": number, "count": count,
                "branches": [{"count": taken, "throw": throw} for taken, throw in branches]}

    def test_a_line_is_reached_if_one_of_its_instances_is(self):
        source = self.source("a", "b", "c")
        for line in (self.line(1, 0), self.line(1, 3), self.line(2, 0), self.line(2, 0)):
            source.add(line)
        self.assertEqual(source.lines, {1: True, 2: False})
        self.assertEqual(list(source.missed()), [(2, "line")])

    def test_branches_of_exceptions_and_of_checks_and_brackets_do_not_count(self):
        source = self.source("if (a)", "    SCANSHADE_CHECK(a);", "}")
        source.add(self.line(1, 2, (2, False), (0, True), (0, False)))
        source.add(self.line(1, 1, (0, False), (0, True), (0, False)))
        source.add(self.line(2, 1, (1, False), (0, False)))
        source.add(self.line(3, 0))
        self.assertEqual(source.branches, {(1, 0): True, (1, 1): False})
        self.assertEqual(list(source.missed()), [(1, "branch")])

    def test_layers_are_those_of_the_folders(self):
        self.assertEqual(coverage.layer_of("src/render/a.cpp"), "render")
        self.assertEqual(coverage.layer_of("include/scanshade/num/a.hpp"), "num")


class Packages(unittest.TestCase):
    def look_for(self, *needs):
        return subprocess.run(["bash", ".ci/deps", "--check", *needs], text=True,
                              capture_output=True, check=False)

    def test_what_is_there_is_found_by_header_command_or_path(self):
        found = self.look_for("no-such-a:cstdio.h,string.h", "no-such-b:bash", "no-such-c:/bin")
        self.assertEqual((found.returncode, found.stdout, found.stderr), (0, "", ""))

    def test_what_is_missing_is_named_in_one_line_that_says_how_to_get_it(self):
        missing = self.look_for("no-such-a:no/such/header.hpp", "bash:bash", "no-such-b:/no/path")
        self.assertEqual(missing.returncode, 1)
        self.assertEqual(missing.stderr.count("\n"), 1)
        self.assertIn("no-such-a no-such-b;", missing.stderr)
        self.assertIn("make deps", missing.stderr)


if __name__ == "__main__":
    unittest.main()
