#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Shows that the lints catch what they are for, and let good code pass."""
import tempfile
import unittest
from pathlib import Path

import hd_lint
import include_lint
import text_lint

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


class IncludeLint(LintTest):
    def test_catches_an_include_against_the_arrows(self):
        for path, header in (
            ("core/base/a.hpp", "core/math/vec3.hpp"),
            ("core/math/a.hpp", "core/laws/bond.hpp"),
            ("core/laws/a.hpp", "core/state/particles.hpp"),
            ("core/dem/a.cpp", "io/case/case.hpp"),
            ("core/dem/a.cpp", "mbd/drivetrain.hpp"),
            ("core/kernels/a.hpp", "gpu/exec_cuda.cuh"),
            ("core/rocks/a.cpp", "app/simulation/simulation.hpp"),
            ("mbd/a.cpp", "core/scene/dem.hpp"),
            ("mbd/a.cpp", "io/case/case.hpp"),
            ("io/a.cpp", "app/simulation/simulation.hpp"),
            ("io/a.cpp", "gpu/report.hpp"),
            ("io/a.cpp", "mbd/cvode_session.hpp"),
            ("gpu/a.cu", "mbd/motor.hpp"),
            ("app/a.cpp", "tests/catch.hpp"),
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
            ("io/a.cpp", "CLI/CLI.hpp"),
        ):
            with self.subTest(path=path, header=header):
                self.assert_caught(include_lint, path, f"#include <{header}>\n")

    def test_catches_a_path_relative_to_the_file(self):
        self.assert_caught(include_lint, "core/math/a.hpp", '#pragma once\n#include "b.hpp"\n', 2,
                           {"core/math/b.hpp": ""})
        self.assert_caught(include_lint, "core/math/a.hpp", '#include "../base/hd.hpp"\n')

    def test_lets_good_includes_pass(self):
        for path, header in (
            ("core/laws/a.hpp", '"core/math/vec3.hpp"'),
            ("core/dem/a.cpp", '"core/rocks/library.hpp"'),
            ("core/geometry/a.cpp", "<CGAL/Surface_mesh.h>"),
            ("core/rocks/a.cpp", "<Eigen/Dense>"),
            ("core/dem/a.cpp", "<vector>"),
            ("mbd/a.cpp", '"core/scene/window.hpp"'),
            ("mbd/a.cpp", "<cvode/cvode.h>"),
            ("io/a.cpp", '"mbd/motor.hpp"'),
            ("io/a.cpp", "<vtkPolyData.h>"),
            ("gpu/a.cu", "<cub/cub.cuh>"),
            ("app/a.cpp", '"mbd/drivetrain.hpp"'),
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


if __name__ == "__main__":
    unittest.main()
