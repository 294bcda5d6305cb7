#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests that the lints catch what they are for, and let good code pass."""
import tempfile
import unittest
from pathlib import Path

import function_lint
import hd_lint
import include_lint
import text_lint
import words_lint

SPDX = "// SPDX-License-Identifier: GPL-3.0-or-later\n"


class LintTest(unittest.TestCase):
    def problems(self, lint, files):
        with tempfile.TemporaryDirectory() as folder:
            for path, text in files.items():
                file = Path(folder, path)
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(text, encoding="utf-8")
            return lint.problems(Path(folder))

    def assert_caught(self, lint, path, text, line=1, others=None):
        found = self.problems(lint, {path: text, **(others or {})})
        self.assertEqual(len(found), 1, f"{path}: {text[:200]!r} gave {found}")
        self.assertTrue(found[0].startswith(f"{path}:{line}:"), found)

    def assert_passes(self, lint, path, text, others=None):
        self.assertEqual(self.problems(lint, {path: text, **(others or {})}), [])


# What each folder may include. Written out, so that a mistake in the lint's own tables shows.
CORE = "base math scene surfaces laws state kernels exec dem geometry rocks fragments walls feed"
ENGINE = "base math scene surfaces laws state kernels exec dem"
DATA = "base math scene surfaces geometry rocks fragments walls feed"
IO = "io/files io/yaml io/case io/schema io/fmu io/hdf5 io/mesh io/run io/fields io/rocks"
ARROWS = {
    "base": "base",
    "math": "base math",
    "scene": "base math scene",
    "surfaces": "base math scene surfaces",
    "laws": "base math scene surfaces laws",
    "state": "base math scene surfaces laws state",
    "kernels": "base math scene surfaces laws state kernels",
    "exec": "base math exec",
    "dem": ENGINE,
    "geometry": "base math scene surfaces laws geometry",
    "rocks": "base math scene surfaces laws geometry rocks",
    "fragments": "base math scene surfaces laws geometry fragments",
    "walls": "base math scene surfaces laws walls",
    "feed": "base math scene surfaces laws rocks walls feed",
    "gpu": f"{ENGINE} gpu",
    "mbd": "base math scene mbd",
    "io/case": f"{DATA} mbd {IO}",
    "io/yaml": "base io/yaml",
    "io/schema": f"{DATA} mbd io/yaml io/schema",
    "io/fmu": f"{DATA} mbd {IO}",
    "io/files": "base io/files",
    "io/hdf5": "base io/hdf5",
    "io/mesh": f"{DATA} io/files io/mesh",
    "io/run": f"{DATA} mbd io/files io/hdf5 io/run",
    "io/fields": f"{DATA} io/hdf5 io/run io/fields",
    "io/rocks": f"{DATA} io/files io/mesh io/hdf5 io/run io/rocks",
    "app/simulation": f"{CORE} gpu mbd app/simulation",
    "app/assembly": f"{CORE} gpu mbd {IO} app/simulation app/assembly",
    "app/output": f"{CORE} gpu mbd {IO} app/simulation app/assembly app/output",
    "app/run": f"{CORE} gpu mbd {IO} app/simulation app/assembly app/output app/run",
    "app/sweep": f"{CORE} gpu mbd {IO} app/simulation app/assembly app/output app/run app/sweep",
    "app/report": f"{DATA} mbd {IO} app/report",
    "app/verify": f"{CORE} gpu mbd {IO} app/simulation app/verify",
    "app/bench": f"{CORE} gpu mbd {IO} app/simulation app/assembly app/output app/run app/bench",
    "app/examples": f"{CORE} gpu mbd app/simulation app/examples",
    "app/commands": f"{CORE} gpu mbd {IO} app/simulation app/assembly app/output app/run app/sweep app/report app/verify app/bench app/examples app/commands app/command_line",
    "app/command_line": f"{CORE} gpu mbd {IO} app/simulation app/assembly app/output app/run app/sweep app/report app/verify app/bench app/examples app/commands app/command_line",
}


def path_of(folder):
    return f"core/{folder}" if folder in CORE.split() else folder


class IncludeLint(LintTest):
    def test_knows_every_pair_of_folders(self):
        pairs = {(f"{path_of(giver)}/to_{path_of(taker).replace('/', '_')}.cpp", f"{path_of(taker)}/b.hpp"):
                 taker in allowed.split() for giver, allowed in ARROWS.items() for taker in ARROWS}
        self.assertEqual(len(pairs), len(ARROWS) ** 2)
        found = self.problems(include_lint, {path: f'#include "{header}"\n' for path, header in pairs})
        caught = {problem.split(":")[0] for problem in found}
        for (path, header), may in pairs.items():
            with self.subTest(path=path, header=header):
                self.assertEqual(path in caught, not may)

    def test_every_folder_of_the_project_is_in_the_table(self):
        root = Path(include_lint.__file__).resolve().parent.parent
        for top in include_lint.FOLDERS:
            for file in (root / top).rglob("*.[ch]pp"):
                path = file.relative_to(root).as_posix()
                with self.subTest(path=path):
                    self.assertTrue(path == "app/main.cpp" or path.startswith(tuple(path_of(f) + "/" for f in ARROWS)))

    def test_catches_a_header_that_its_folder_hides(self):
        for path, header in (
            ("mbd/a.cpp", "core/scene/dem.hpp"),
            ("mbd/fmi/a.cpp", "core/scene/dem.hpp"),
            ("io/case/a.cpp", "mbd/cvode_session.hpp"),
            ("io/fmu/a.cpp", "mbd/shaft.hpp"),
            ("app/commands/a.cpp", "tests/catch.hpp"),
            ("core/new_folder/a.cpp", "core/base/hd.hpp"),
        ):
            with self.subTest(path=path, header=header):
                self.assert_caught(include_lint, path, f'#include "{header}"\n')

    def test_catches_a_library_outside_its_folder(self):
        for path, header in (
            ("core/dem/a.cpp", "yaml-cpp/yaml.h"),
            ("core/dem/a.cpp", "hdf5.h"),
            ("core/dem/a.cpp", "H5Cpp.h"),
            ("core/state/a.hpp", "cuda_runtime.h"),
            ("core/exec/a.hpp", "cub/cub.cuh"),
            ("core/dem/a.cpp", "cvode/cvode.h"),
            ("core/dem/a.cpp", "CGAL/Surface_mesh.h"),
            ("core/geometry/a.cpp", "vtkPolyData.h"),
            ("io/a.cpp", "sundials/sundials_types.h"),
            ("mbd/a.cpp", "yaml-cpp/yaml.h"),
            ("io/run/a.cpp", "CLI/CLI.hpp"),
            ("app/commands/a.cpp", "CLI/CLI.hpp"),
            ("io/run/a.cpp", "hdf5.h"),
            ("app/simulation/a.cpp", "hdf5.h"),
            ("io/schema/a.cpp", "yaml-cpp/yaml.h"),
            ("io/hdf5/a.cpp", "vtkPolyData.h"),
            ("io/run/a.cpp", "zip.h"),
            ("core/dem/a.cpp", "omp.h"),
            ("core/laws/a.hpp", "Eigen/Dense"),
            ("app/simulation/a.cpp", "cvode/cvode.h"),
            ("mbd/a.cpp", "spdlog/logger.h"),
            ("core/rocks/a.cpp", "nlohmann/json.hpp"),
        ):
            with self.subTest(path=path, header=header):
                self.assert_caught(include_lint, path, f"#include <{header}>\n")

    def test_catches_a_path_relative_to_the_file(self):
        self.assert_caught(include_lint, "core/math/a.hpp", '#pragma once\n#include "b.hpp"\n', 2,
                           {"core/math/b.hpp": ""})
        self.assert_caught(include_lint, "core/math/a.hpp", '#include "../base/hd.hpp"\n')

    def test_lets_good_includes_pass(self):
        for path, header in (
            ("core/geometry/a.cpp", "<CGAL/Surface_mesh.h>"),
            ("core/rocks/a.cpp", "<Eigen/Dense>"),
            ("core/dem/a.cpp", "<vector>"),
            ("mbd/a.cpp", '"core/scene/window.hpp"'),
            ("mbd/a.cpp", "<cvode/cvode.h>"),
            ("mbd/fmi/a.cpp", '"mbd/shaft.hpp"'),
            ("io/case/a.cpp", '"mbd/drivetrain_parameters.hpp"'),
            ("io/yaml/a.cpp", "<yaml-cpp/parser.h>"),
            ("io/hdf5/a.cpp", "<hdf5.h>"),
            ("io/run/a.cpp", "<vtkPolyData.h>"),
            ("io/run/a.cpp", '"core/scene/dem.hpp"'),
            ("io/fmu/a.cpp", "<zip.h>"),
            ("gpu/a.cu", "<cub/cub.cuh>"),
            ("app/command_line/a.cpp", "<CLI/CLI.hpp>"),
            ("app/main.cpp", '"app/commands/commands.hpp"'),
            ("app/verify/a.cpp", '"app/version.hpp"'),
            ("app/verify/a.cpp", '"mbd/shaft.hpp"'),
        ):
            with self.subTest(path=path, header=header):
                self.assert_passes(include_lint, path, f"#include {header}\n")


class HdLint(LintTest):
    def test_catches_what_a_device_cannot_do(self):
        for snippet in (
            "throw 1;", "auto p = new int;", "virtual void f();", "std::vector<int> v;", "std::string s;",
            "std::min(a, b);", "std::max(a, b);", "std::function<void()> f;", "std::cout << a;", "assert(a > 0);",
            "#include <iostream>", "#include <vector>", "#ifdef __CUDA_ARCH__",
        ):
            for folder in hd_lint.FOLDERS:
                with self.subTest(snippet=snippet, folder=folder):
                    self.assert_caught(hd_lint, f"{folder}/a.hpp", "#pragma once\n" + snippet + "\n", 2)

    def test_catches_inexact_functions_on_the_device(self):
        self.assert_caught(hd_lint, "core/laws/a.hpp", "GYRO_HD double f(double x) {\n  return std::sin(x);\n}\n", 2)
        self.assert_caught(hd_lint, "core/laws/a.hpp", "GYRO_HD double f(double x) {\n  return pow(x, 1.5);\n}\n", 2)
        self.assert_passes(hd_lint, "core/laws/a.hpp",
                           "GYRO_HD double f(double x);\ninline double g(double x) { return std::sin(x); }\n")

    def test_catches_a_host_header_in_a_device_header(self):
        self.assert_caught(hd_lint, "core/kernels/a.hpp", '#include "core/math/b.hpp"\n', 1,
                           {"core/math/b.hpp": "// Host only.\n#include <vector>\n"})

    def test_lets_good_code_pass(self):
        for snippet in (
            "// throws nothing; new, virtual and std::vector are for the host\n",
            "/* std::string\n throw */ int a;\n",
            "GYRO_HD double f(double x) { using std::sqrt; return sqrt(x) + norm(x) + this->log(x); }\n",
            "GYRO_HD double f(double x) { return std::fma(x, x, x); }\n",
            'static_assert(sizeof(int) == 4, "new and throw are words here");\n',
            "struct A { A(const A&) = delete; };\n",
            "int renewed = 1, throwing = 1'000'000;\n",
        ):
            with self.subTest(snippet=snippet):
                self.assert_passes(hd_lint, "core/laws/a.hpp", snippet)

    def test_leaves_other_folders_alone(self):
        self.assert_passes(hd_lint, "core/dem/a.hpp", "std::vector<int> v;\n")


class TextLint(LintTest):
    def test_catches_form(self):
        for path, text, line in (
            ("core/a.hpp", "#pragma once\n", 1),
            ("core/a.cpp", SPDX + "int a;\n" * text_lint.LONGEST, text_lint.LONGEST + 1),
            ("tests/a.cpp", SPDX + 'TEST_' + 'CASE("One; two") {}\n', 2),
            ("tests/a.cpp", SPDX + 'TEST_' + 'CASE("--quiet is quiet") {}\n', 2),
            ("core/a.hpp", SPDX + "int a;\n", 1),
            ("core/a.cpp", SPDX + "int a;  // " + "TO" + "DO: more\n", 2),
            ("core/a.cpp", SPDX + "int a; \n", 2),
            ("core/a.cpp", SPDX + "\tint a;\n", 2),
        ):
            with self.subTest(text=text[:80]):
                self.assert_caught(text_lint, path, text, line)

    def test_lets_good_text_pass(self):
        self.assert_passes(text_lint, "core/a.hpp", SPDX + "#pragma once\n\nint a;\n")
        self.assert_passes(text_lint, "scripts/a.py", "#!/usr/bin/python3\n#" + SPDX[2:])


class WordsLint(LintTest):
    def test_catches_old_words(self):
        for path, text, line in (
            ("core/a.cpp", "int a;\nbool glued;\n", 2),
            ("core/a.cpp", "const Index bonds_unglued = 0;\n", 1),
            ("core/a.hpp", "struct SheetCheck {};\n", 1),
            ("app/a.cpp", '"particles touch through a sheet"\n', 1),
            ("mbd/a.hpp", "int most_events;\n", 1),
            ("scripts/a.py", "MOST_EVENTS = 8\n", 1),
            ("cases/a/README.md", "The margin of neighbour lists.\n", 1),
            ("README.md", "Lists are built anew.\n", 1),
            ("cases/a.yaml", "# glued\n", 1),
        ):
            with self.subTest(text=text):
                self.assert_caught(words_lint, path, text, line)

    def test_lets_good_words_pass(self):
        for text in ("spreadsheet, datasheets, at_most_half, almost_done, mostly, utmost\n", "max_events, intact, pressed\n",
                     "a margin of 5 %; a list of margins\n"):
            with self.subTest(text=text):
                self.assert_passes(words_lint, "core/a.cpp", text)
        self.assert_passes(words_lint, "CHANGELOG.md", "glued\n")


class FunctionLint(LintTest):
    LONG = "  a();\n" * (function_lint.LONGEST - 1)  # with the head and the closing brace a line too long

    def test_catches_long_functions(self):
        for path, text, line in (
            ("core/a.cpp", f"int b;\nvoid f(int a) {{\n{self.LONG}}}\n", 2),
            ("core/a.cpp", f"namespace a {{\nstruct S {{\n  S(int b) : b_{{b}}, c_{{1, 2}} {{\n{self.LONG}}}\n}};\n}}\n", 3),
            ("core/a.hpp", f"template <class T>\nauto f(const T& t) const noexcept -> T {{\n{self.LONG[7:]}}}\n", 1),
            ("tests/a.cpp", f'TEST_CASE("{{", "[a]") {{\n{self.LONG}}}\n', 1),
            ("core/a.cpp", f"void f() {{\n  auto g = [] {{\n    b();\n  }};\n{self.LONG[21:]}}}\n", 1),
            ("scripts/a.py", f"class C:\n  def f(self):\n{self.LONG.replace('  a', '    a')}    a()\n", 2),
        ):
            with self.subTest(path=path, text=text[:60]):
                self.assert_caught(function_lint, path, text, line)

    def test_lets_good_functions_pass(self):
        short = self.LONG[7:]
        for path, text in (
            ("core/a.cpp", f"void f(int a) {{\n{short}}}\n\nvoid g() {{\n{short}}}\n"),
            ("core/a.cpp", f"namespace b {{\n{self.LONG.replace('a();', 'int a;')}int c;\n}}\n"),
            ("core/a.cpp", f"const Row rows[] = {{\n{self.LONG.replace(';', ',')}{self.LONG.replace(';', ',')}}};\n"),
            ("core/a.cpp", f'const char* text = R"({{\n{self.LONG}){{\n{self.LONG})";\n'),
            ("core/a.hpp", f"class A : public B<int> {{\n public:\n{self.LONG}  void f();\n}};\n"),
        ):
            with self.subTest(path=path, text=text[:60]):
                self.assert_passes(function_lint, path, text)


if __name__ == "__main__":
    unittest.main()
