#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests what the scripts call: run.sh gyrosim, test.sh ctest, setup.sh apt.

Works on a copy of the scripts in which programs that would build, install or run are replaced by ones that record how they
were called.
"""
import json
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

SCRIPTS = Path(__file__).resolve().parent

RECORDER = """#!/usr/bin/python3
import json, os, sys
with open(os.environ["CALLS"], "a") as file:
    file.write(json.dumps([os.path.basename(sys.argv[0]), *sys.argv[1:]]) + "\\n")
sys.exit(int(os.environ.get("EXIT_" + os.path.basename(sys.argv[0]).replace(".sh", "").replace("-", "_"), 0)))
"""


class ScriptTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name, "a copy")  # paths with blanks must work
        self.calls_file = Path(folder.name, "calls")
        self.bin = Path(folder.name, "bin")
        self.bin.mkdir()
        (self.root / "scripts").mkdir(parents=True)
        for script in ("run.sh", "test.sh", "setup.sh", "build.sh", "cuda_device.sh"):
            shutil.copy(SCRIPTS / script, self.root / "scripts")

    def record(self, path):
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(RECORDER)
        path.chmod(0o755)

    def call(self, script, *arguments, cwd="/", **environment):
        path = f"{self.bin}:/usr/bin:/bin"
        done = subprocess.run([self.root / "scripts" / script, *arguments], cwd=cwd, text=True, capture_output=True,
                              env={"PATH": path, "CALLS": str(self.calls_file), **environment}, timeout=60)
        lines = self.calls_file.read_text().splitlines() if self.calls_file.exists() else []
        return done, [json.loads(line) for line in lines]


class Run(ScriptTest):
    def setUp(self):
        super().setUp()
        for file in ("scripts/setup.sh", "scripts/build.sh", "build/release/gyrosim"):
            self.record(self.root / file)
        self.quickstart = str(self.root / "cases/quickstart.yaml")

    def gyrosim_call(self, *arguments, cwd="/"):
        done, calls = self.call("run.sh", *arguments, cwd=cwd)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout, "")  # standard output belongs to gyrosim
        self.assertEqual(calls[:2], [["setup.sh"], ["build.sh", "gyrosim"]])
        self.calls_file.unlink()
        return calls[2]

    def test_arguments(self):
        for given, handed_on in (
            ([], [self.quickstart]),
            (["--until", "20 ms"], [self.quickstart, "--until", "20 ms"]),
            (["--set", "case.title=a b", "--quiet"], [self.quickstart, "--set", "case.title=a b", "--quiet"]),
            (["my case.yaml"], ["my case.yaml"]),
            (["dir/case.yaml", "--out", "a b", "--threads", "2"], ["dir/case.yaml", "--out", "a b", "--threads", "2"]),
        ):
            for cwd in ("/", self.root):
                with self.subTest(given=given, cwd=cwd):
                    self.assertEqual(self.gyrosim_call(*given, cwd=cwd), ["gyrosim", "run", *handed_on])

    def test_help_builds_nothing(self):
        done, calls = self.call("run.sh", "--help")
        self.assertEqual((done.returncode, calls), (0, []))
        self.assertIn("CASE", done.stdout)

    def test_exit_codes_pass_through(self):
        for program, runs in (("setup", 1), ("build", 2), ("gyrosim", 3)):
            done, calls = self.call("run.sh", **{"EXIT_" + program: "75"})
            self.assertEqual((done.returncode, len(calls)), (75, runs))
            self.calls_file.unlink()


class Test(ScriptTest):
    def setUp(self):
        super().setUp()
        self.record(self.root / "scripts/setup.sh")
        self.record(self.root / "scripts/build.sh")
        self.record(self.bin / "ctest")

    def test_nightly_tests_run_only_on_request(self):
        for given, excluded in (
            ([], True), (["-L", "unit"], True), (["-R", "a b"], True),
            (["-L", "nightly"], False), (["-LE", "slow"], False),
        ):
            with self.subTest(given=given):
                done, calls = self.call("test.sh", *given)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertEqual(calls[:2], [["setup.sh"], ["build.sh", "--cuda"]])
                ctest = calls[2]
                self.assertEqual(ctest[len(ctest) - len(given):], given)
                self.assertEqual("-LE" in ctest[:len(ctest) - len(given)], excluded)
                self.calls_file.unlink()

    def test_failures_pass_through(self):
        self.assertEqual(self.call("test.sh", EXIT_ctest="8")[0].returncode, 8)
        self.assertEqual(self.call("test.sh", EXIT_build="1")[0].returncode, 1)


class Build(ScriptTest):
    """With a cmake that only writes down, and an nvcc that may be there."""

    def setUp(self):
        super().setUp()
        self.record(self.bin / "cmake")
        self.device("exit 1")

    def device(self, body):
        (self.root / "scripts/cuda_device.sh").write_text(f"#!/bin/bash\n{body}\n")

    def configured(self, cuda):
        folder = self.root / "build/release"
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "build.ninja").touch()
        (folder / "CMakeCache.txt").write_text(f"GYRO_CUDA:STRING={cuda}\n")

    def configuration(self, *arguments):
        """What cmake was called with before it built; nothing where it only built."""
        done, calls = self.call("build.sh", *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("--build", calls[-1])
        self.calls_file.unlink()
        return [call[1:] for call in calls[:-1]]

    def test_configures_once(self):
        self.assertEqual(self.configuration("gyrosim"), [["--preset", "release"]])
        self.configured("AUTO")
        self.assertEqual(self.configuration("gyrosim"), [])

    def test_cuda_without_device_only_when_asked_for(self):
        self.record(self.bin / "nvcc")
        self.assertEqual(self.configuration(), [["--preset", "release"]])
        self.assertEqual(self.configuration("--cuda"), [["--preset", "release", "-DGYRO_CUDA=ON"]])
        self.configured("AUTO")
        self.assertEqual(self.configuration(), [])
        self.assertIn("-DGYRO_CUDA=ON", self.configuration("--cuda")[0])
        for chosen in ("OFF", "ON"):
            self.configured(chosen)
            self.assertEqual(self.configuration("--cuda"), [])

    def test_looks_again_when_a_device_appears(self):
        self.record(self.bin / "nvcc")
        self.configuration()
        self.configured("AUTO")
        self.device("echo /dev/nvidia0")
        self.assertEqual(len(self.configuration()), 1)
        self.assertEqual(self.configuration(), [])


class Setup(ScriptTest):
    """With a dpkg-query that knows no package, and an id and an apt that only record calls."""

    def setUp(self):
        super().setUp()
        self.record(self.bin / "apt-get")
        self.record(self.bin / "apt-cache")
        self.record(self.bin / "mkdir")
        self.program("dpkg-query", "exit 1")
        self.program("id", "echo ${USER_ID:-0}")
        self.program("sudo", 'if [ "$NO_SUDO" ]; then exit 1; fi; shift; exec "$@"')

    def program(self, name, body):
        (self.bin / name).write_text(f"#!/bin/bash\n{body}\n")
        (self.bin / name).chmod(0o755)

    def apt_calls(self, **environment):
        done, calls = self.call("setup.sh", **environment)
        verbs = ("install", "update")
        return done, [next(word for word in call if word in verbs) for call in calls if call[0] == "apt-get"]

    def test_installs_what_is_missing(self):
        done, verbs = self.apt_calls()
        self.assertEqual((done.returncode, verbs), (0, ["install"]), done.stderr)
        self.assertIn("installing build-essential", done.stderr)

    def test_reads_the_lists_first_on_a_fresh_machine(self):
        self.assertEqual(self.apt_calls(EXIT_apt_cache="100")[1], ["update", "install"])

    def test_reads_the_lists_again_once_when_an_install_fails(self):
        done, verbs = self.apt_calls(EXIT_apt_get="100")
        self.assertEqual((done.returncode, verbs), (1, ["install", "update"]))

    def test_a_user_without_rights_gets_the_command_to_run(self):
        done, verbs = self.apt_calls(USER_ID="1000", NO_SUDO="yes")
        self.assertEqual((done.returncode, verbs), (1, []))
        self.assertIn("apt-get install --no-install-recommends build-essential", done.stderr)

    def test_a_user_with_sudo_installs(self):
        self.assertEqual(self.apt_calls(USER_ID="1000")[1], ["install"])

    def test_does_nothing_when_all_is_there(self):
        self.program("dpkg-query", 'shift 2; printf "installed %s\\n" "$@"')
        done, calls = self.call("setup.sh", USER_ID="1000", NO_SUDO="yes")
        self.assertEqual((done.returncode, done.stderr, calls), (0, "", []))


if __name__ == "__main__":
    unittest.main()
