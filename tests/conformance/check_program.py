# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""glark-conformance as its users see it: verdicts, exit statuses, reports, archives."""
import fnmatch
import json
import os
import subprocess
import tarfile
import tempfile
import time
import unittest
import xml.etree.ElementTree
from pathlib import Path

FAKE, SUITE, LIBRARY = os.environ["FAKE"], os.environ["SUITE"], os.environ["LIBRARY"]
EXCLUDED = Path(__file__).resolve().parents[2] / "conformance/mustpass/excluded.txt"
VERDICTS = {
    "pass": "Pass", "pass_too": "Pass", "fail": "Fail", "equal": "Fail", "error_left": "Fail", "lines": "Fail",
    "nothing": "InternalError", "throws": "InternalError", "control": "InternalError", "not_supported": "NotSupported", "warning": "QualityWarning",
    "planned": "Unimplemented", "crash": "Crash", "vanish": "Missing", "hang": "Timeout", "spin": "Timeout", "unsteady": "Fail",
    "es_only": "NotSupported", "unexpectedly_not_supported": "InternalError",
}


def call(*arguments, program=FAKE, **environment):
    return subprocess.run([program, *map(str, arguments)], env={**os.environ, **environment}, capture_output=True, text=True,
                          timeout=120)


class Folder(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.addCleanup(self.scratch.cleanup)
        self.folder = Path(self.scratch.name)
        self.mark = self.folder / "mark"

    def judge(self, *arguments):
        done = call("--implementation", LIBRARY, "--timeout", 2, "--report", self.folder / "report", *arguments,
                    FAKE_MARK=str(self.mark))
        results = self.folder / "report/results.json"
        records = json.loads(results.read_text())["results"] if results.exists() else []
        return done, {record["name"].rpartition(".")[2]: record for record in records}

    def written(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path


class Verdicts(Folder):
    def test_each_case_in_its_process(self):
        done, records = self.judge()
        self.assertEqual(VERDICTS, {name: record["verdict"] for name, record in records.items()})
        self.assertEqual(1, done.returncode)
        self.assertIn("Segmentation", records["crash"]["messages"][0])
        self.assertIn("about to crash", records["crash"]["output"])

    def test_batch_loses_only_the_case_that_crashed(self):
        _, records = self.judge("--batch", 100)
        self.assertEqual(VERDICTS, {name: record["verdict"] for name, record in records.items()})

    def test_shown_messages_are_comments(self):
        shown = call("--implementation", LIBRARY, "--show", "ark.fake.lines").stdout
        self.assertIn("\n// two\n// lines\n", shown)

    def test_retry_finds_the_flake(self):
        done, records = self.judge("--case", "ark.fake.unsteady", "--retry", 1)
        self.assertEqual(("Flake", 0), (records["unsteady"]["verdict"], done.returncode))

    def test_fail_fast_leaves_out_what_was_not_begun(self):
        chosen = [word for name in ("es_only", "fail", "pass", "pass_too") for word in ("--case", f"ark.fake.{name}")]
        for batch in (1, 100):
            done, records = self.judge("--fail-fast", "--jobs", 1, "--batch", batch, *chosen)
            self.assertEqual(["es_only", "fail"], list(records))
            self.assertEqual(1, done.returncode)
        _, records = self.judge("--fail-fast", "--jobs", 1, "--baseline", self.written("known", "ark.fake.fail,Fail\n"), *chosen)
        self.assertEqual(["es_only", "fail", "pass", "pass_too"], list(records))

    def test_shards_are_the_whole(self):
        names = [call("--list", "--shard", f"{i}/3").stdout.split() for i in (1, 2, 3)]
        self.assertEqual(sorted(f"ark.fake.{name}" for name in VERDICTS), sorted(sum(names, [])))

    def test_baseline(self):
        baseline = self.written("known", "# known failures\nark.fake.fail,Fail # the picture\nark.fake.pass,Fail\n"
                                         "ark.fake.equal,Crash\nark.fake.uns*,Flake\n")
        done, records = self.judge("--baseline", baseline)
        verdicts = {name: records[name]["verdict"] for name in ("fail", "pass", "equal", "unsteady", "crash")}
        self.assertEqual({"fail": "ExpectedFail", "pass": "UnexpectedPass", "equal": "Fail", "unsteady": "Flake",
                          "crash": "Crash"}, verdicts)
        self.assertEqual(1, done.returncode)


class Reports(Folder):
    def test_all_files(self):
        self.judge()
        report = self.folder / "report"
        suite = xml.etree.ElementTree.parse(report / "junit.xml").getroot()[0]
        self.assertEqual((19, 5, 8), tuple(int(suite.get(key)) for key in ("tests", "failures", "errors")))
        html = (report / "index.html").read_text()
        self.assertIn("Every vertex has a depth tag, an integer.", html)
        self.assertIn("a &lt;picture&gt; &amp; more", html)
        images = sorted(path.name for path in (report / "images").iterdir())
        self.assertEqual(["00-expected", "01-actual", "02-difference"], [name[len("ark.fake.fail-"):-4] for name in images])
        self.assertIn("Fail ark.fake.equal", (report / "log.txt").read_text())
        self.assertIn("a number: expected 4, got 3", (report / "log.txt").read_text())

    def test_images_of_an_earlier_run_go(self):
        self.judge("--case", "ark.fake.fail")
        self.judge("--case", "ark.fake.pass")
        self.assertEqual([], list((self.folder / "report/images").iterdir()))


class BadInput(Folder):
    def test_statuses(self):
        empty = self.written("empty", "# nothing\n")
        unknown = self.written("unknown", "ark.fake.pass\nark.fake.gone\n")
        no_verdict = self.written("no_verdict", "ark.fake.pass,Fine\n")
        blocked = self.written("blocked", "")
        for status, words, arguments in [
            (2, "--bogus", ["--bogus"]),
            (2, "platform", ["--platform", "wgl"]),
            (2, "api", ["--api", "gl"]),
            (2, "--shard 3/2", ["--shard", "3/2"]),
            (2, "--shard x", ["--shard", "x"]),
            (2, "jobs", ["--jobs", "0"]),
            (2, "implementation", ["--implementation", "/nonexistent.so"]),
            (2, "NAME,VERDICT", ["--baseline", no_verdict]),
            (2, "cannot read", ["--baseline", self.folder / "none"]),
            (2, "cannot read", ["--caselist", self.folder / "none"]),
            (2, "cannot read", ["--caselist", self.folder]),
            (3, "no case matches ark.none.*", ["--case", "ark.none.*"]),
            (3, "names no case", ["--caselist", empty]),
            (3, "ark.fake.gone", ["--caselist", unknown]),
            (4, str(blocked), ["--report", blocked / "in"]),
            (5, "OSMesa has no OpenGL ES", ["--api", "gles"]),
            (5, "DISPLAY", ["--platform", "glx"]),
        ]:
            with self.subTest(arguments=arguments):
                done = call("--case", "ark.fake.pass", *arguments, DISPLAY=":789") if status != 3 else call(*arguments)
                self.assertEqual(status, done.returncode, done.stderr + done.stdout)
                self.assertIn(words, done.stderr + done.stdout)

    def test_loader_without_the_extension(self):
        done = call("--case", "ark.fake.pass")
        self.assertEqual(6, done.returncode)
        self.assertIn("1 NotSupported", done.stdout)
        self.assertIn("no GL_ARK_adaptive_refinement", done.stderr)

    def test_library_that_cannot_be_preloaded(self):
        done = call("--case", "ark.fake.pass", "--implementation", self.written("no.so", "text"))
        self.assertEqual(2, done.returncode)
        self.assertIn("does not load", done.stderr)

    def test_library_named_without_a_folder(self):
        done = subprocess.run([FAKE, "--case", "ark.fake.pass", "--implementation", Path(LIBRARY).name], cwd=Path(LIBRARY).parent,
                              capture_output=True, text=True, timeout=120)
        self.assertEqual(0, done.returncode, done.stderr)

    def test_hanging_case_ends_with_the_program(self):
        program = subprocess.Popen([FAKE, "--case", "ark.fake.hang", "--implementation", LIBRARY], stdout=subprocess.PIPE)
        worker = self.worker_of(program.pid)
        program.kill()
        program.wait()
        program.stdout.close()
        for _ in range(100):
            if not Path(f"/proc/{worker}/cmdline").exists() or not Path(f"/proc/{worker}/cmdline").read_bytes():
                return
            time.sleep(0.1)
        self.fail(f"process {worker} is still there")

    def worker_of(self, program):
        """Returns the process that runs cases; its arguments contain "run"."""
        for _ in range(300):
            for path in Path("/proc").glob("[0-9]*"):
                try:
                    parent = int((path / "stat").read_text().rpartition(")")[2].split()[1])
                    if parent == program and b"run" in (path / "cmdline").read_bytes().split(b"\0"):
                        time.sleep(0.5)
                        return path.name
                except OSError:
                    continue
            time.sleep(0.1)
        self.fail("no process runs cases")


class Submissions(Folder):
    def test_package_is_read_back(self):
        self.judge("--case", "ark.fake.fail")
        archive = self.folder / "a.tar.gz"
        self.assertEqual(0, call("package", self.folder / "report", archive).returncode)
        with tarfile.open(archive) as files:
            self.assertIn("SHA256SUMS", files.getnames())
            self.assertIn("images/ark.fake.fail-00-expected.png", files.getnames())
        done = call("verify", archive)
        self.assertEqual(1, done.returncode)  # it lacks the cases of the must-pass list
        self.assertIn("is missing", done.stdout)
        self.assertNotIn("SHA-256", done.stdout)

    def test_package_without_a_report(self):
        done = call("package", self.folder, self.folder / "a.tar.gz")
        self.assertEqual(2, done.returncode)
        self.assertIn("results.json", done.stderr)
        self.assertFalse((self.folder / "a.tar.gz").exists())

    def test_package_replaces_plain_files_only(self):
        self.judge("--case", "ark.fake.pass")
        pipe = self.folder / "pipe"
        os.mkfifo(pipe)
        done = call("package", self.folder / "report", pipe)
        self.assertEqual(2, done.returncode)
        self.assertIn("not a plain file", done.stderr)
        self.assertTrue(pipe.is_fifo())
        self.assertEqual([], list(self.folder.glob("*.part")))

    def test_verify_what_is_no_archive(self):
        for name, text in [("text", "no archive at all"), ("empty", "")]:
            done = call("verify", self.written(name, text))
            self.assertEqual(1, done.returncode)


class TheSuite(unittest.TestCase):
    def test_must_pass_list_is_every_written_case_that_is_not_excluded(self):
        excluded = [line.partition("#")[0].strip() for line in EXCLUDED.read_text().splitlines() if not line.startswith("#")]
        cases = json.loads(call("--list", "--json", program=SUITE).stdout)["cases"]
        listed = call("--list", "--must-pass", program=SUITE).stdout.split()
        written = [case["name"] for case in cases if case["written"]]
        for glob in excluded:
            self.assertTrue(fnmatch.filter(written, glob), f"excluded.txt: {glob} matches no case")
        required = [name for name in written if not any(fnmatch.fnmatchcase(name, glob) for glob in excluded)]
        self.assertLess(len(required), len(written))
        self.assertEqual(required, listed, "run conformance/mustpass/update.py")


if __name__ == "__main__":
    unittest.main()
