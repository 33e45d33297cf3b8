# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""glark.stream: a scan is read in parts, sampled, edited by its sampling, and refined."""
import os
import pathlib
import signal
import tempfile
import time
import unittest

import glark
import glark.stream
import numpy

from sphere import sphere

COUNT = 60000


class Stream(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.points = sphere(COUNT)
        glark.write(self.path("large.ply"), self.points, colours=numpy.full((COUNT, 3), 90, numpy.uint8))
        self.report = glark.stream.sample(self.path("large.ply"), self.path("small.ply"), target=2000)

    def path(self, name: str) -> str:
        return str(pathlib.Path(self.folder.name) / name)

    def edit(self) -> None:
        small = glark.read(self.path("small.ply"))
        glark.write(self.path("edited.ply"), small.positions + [0, 0, 2], small.normals, small.colours)

    def test_reader_gives_all_points(self):
        reader = glark.stream.Reader(self.path("large.ply"))
        self.assertEqual(COUNT, reader.count)
        self.assertEqual(["red", "green", "blue"], reader.channel_names[:3])
        first = reader.read(7)
        self.assertEqual((0, (7, 3), None), (first.first, first.positions.shape, first.normals))
        self.assertTrue((first.channels[:, :3] == 90).all())
        rest = list(reader)
        self.assertEqual(7, rest[0].first)
        numpy.testing.assert_array_equal(self.points, numpy.concatenate([first.positions, *(p.positions for p in rest)]))
        self.assertIsNone(reader.read())

    def test_sample(self):
        self.assertEqual((COUNT, True, False), (self.report.points, self.report.in_core, self.report.is_shuffled))
        self.assertTrue(1980 <= self.report.samples <= 2000, self.report.samples)
        self.assertEqual(COUNT, self.report.cells["points"].sum())
        self.assertEqual(self.report.samples, len(glark.read(self.path("small.ply")).positions))

    def test_transfer(self):
        self.edit()
        report = glark.stream.transfer(self.path("large.ply"), self.path("small.ply"), self.path("edited.ply"),
                                       self.path("out.ply"))
        self.assertEqual((COUNT, True, 0), (report.points, report.is_deformed, report.cells_on_disk))
        numpy.testing.assert_allclose(self.points + [0, 0, 2], glark.read(self.path("out.ply")).positions, atol=1e-5)

    def test_a_sampling_larger_than_the_memory(self):
        points = sphere(300000)
        glark.write(self.path("many.ply"), points, normals=points)
        glark.write(self.path("moved.ply"), points * 2, normals=points)
        files = [self.path(name) for name in ("large.ply", "many.ply", "moved.ply", "out.ply")]
        report = glark.stream.transfer(*files, memory=48 << 20, threads=2)
        self.assertGreater(report.cells_on_disk, 50)
        numpy.testing.assert_allclose(self.points * 2, glark.read(self.path("out.ply")).positions, atol=1e-3)
        with self.assertRaisesRegex(glark.ArgumentError, "is the least"):
            glark.stream.transfer(*files, memory=1 << 20)

    def test_refine(self):
        self.edit()
        files = [self.path(name) for name in ("large.ply", "small.ply", "finer.ply")]
        report = glark.stream.refine(*files, edited=self.path("edited.ply"), edited_output=self.path("both.ply"),
                                     sphere=([0, 0, 3], 0.5), target=1000)
        self.assertGreater(report.samples, 900)
        both = glark.read(self.path("both.ply")).positions
        self.assertEqual(self.report.samples + report.samples, len(both))
        self.assertLess(numpy.linalg.norm(both[self.report.samples:] - [0, 0, 3], axis=1).max(), 0.6)
        for region in ({}, {"box": ([0, 0, 0], [1, 1, 1]), "channel": "red"}):
            with self.assertRaisesRegex(glark.ArgumentError, "one of box, sphere and channel"):
                glark.stream.refine(*files, **region)

    def test_a_reader_stays_with_its_error(self):
        points = self.points.copy()
        points[70, 1] = numpy.nan
        path = pathlib.Path(self.path("bad.raw"))
        path.write_bytes(points.astype("<f4").tobytes())
        reader = glark.stream.Reader(path)
        self.assertEqual(50, len(reader.read(50).positions))
        for _ in range(2):
            with self.assertRaisesRegex(glark.ArgumentError, "point 70 has a coordinate"):
                reader.read(50)
        with self.assertRaisesRegex(glark.ArgumentError, "most is 0"):
            reader.read(0)
        for name in ("raw", ".raw"):
            self.assertEqual(COUNT, glark.stream.Reader(path, format=name).count)

    def test_names(self):
        large = self.path("large.ply")
        latin = self.path(os.fsdecode(b"caf\xe9.ply"))
        with self.assertRaisesRegex(glark.FileError, "caf\udce9.ply: cannot be read: No such file"):
            glark.stream.Reader(latin)
        with self.assertRaisesRegex(glark.FileError, "caf\udce9.ply: cannot be read"):
            glark.read(latin)
        self.assertEqual(10, glark.stream.sample(large, latin, target=10).samples)
        long_name = self.path("a" * 300 + ".ply")
        for call in (lambda: glark.stream.Reader(long_name), lambda: glark.stream.sample(long_name, self.path("b.ply")),
                     lambda: glark.stream.sample(large, long_name, target=10), lambda: glark.read(long_name),
                     lambda: glark.write(long_name, self.points)):
            with self.assertRaisesRegex(glark.FileError, "File name too long"):
                call()
        for call in (lambda: glark.stream.sample(large, "", target=10), lambda: glark.write("", self.points),
                     lambda: glark.stream.transfer(large, self.path("small.ply"), self.path("small.ply"), ""),
                     lambda: glark.stream.refine(large, self.path("small.ply"), "", box=([0, 0, 0], [1, 1, 1]))):
            with self.assertRaisesRegex(glark.ArgumentError, "is empty; name a file"):
                call()

    def test_numbers_below_zero_name_their_argument(self):
        large, small = self.path("large.ply"), self.path("small.ply")
        for name in ("target", "memory", "threads"):
            with self.assertRaisesRegex(glark.ArgumentError, f"{name} is -1; give it a number from 0"):
                glark.stream.sample(large, self.path("a.ply"), **{name: -1})
        with self.assertRaisesRegex(glark.ArgumentError, "neighbours is -3"):
            glark.stream.transfer(large, small, small, self.path("out.ply"), neighbours=-3)
        with self.assertRaisesRegex(glark.ArgumentError, "most is -1"):
            glark.stream.Reader(large).read(-1)
        with self.assertRaisesRegex(glark.ArgumentError, "target is 1000000000000000000000"):
            glark.stream.sample(large, self.path("a.ply"), target=10 ** 21)
        with self.assertRaises(TypeError):
            glark.stream.sample(large, self.path("a.ply"), target=1.5)

    def test_formats_without_normals_are_told(self):
        with self.assertWarnsRegex(UserWarning, "a.raw: the format has no normals"):
            glark.stream.sample(self.path("large.ply"), self.path("a.raw"), target=10)
        with self.assertWarnsRegex(UserWarning, "finer.raw: the format has no normals"):
            glark.stream.refine(self.path("large.ply"), self.path("small.ply"), self.path("finer.raw"),
                                box=([0, 0, 0], [1, 1, 1]), target=100)

    def test_messages_name_options_as_python_has_them(self):
        numpy.full(30, numpy.nan, "<f4").tofile(self.path("bad.raw"))
        with self.assertRaisesRegex(glark.ArgumentError, "by the option skip_invalid"):
            glark.stream.sample(self.path("bad.raw"), self.path("a.ply"), target=10)
        far = self.points[:100].astype("<f4")
        far[7] = 1e20
        far.tofile(self.path("far.raw"))
        with self.assertRaisesRegex(glark.ArgumentError, "far.raw: point 7 has the coordinate"):
            glark.stream.sample(self.path("far.raw"), self.path("a.ply"), target=10)

    def interrupted(self, output: str, call) -> None:
        def stop(*_):
            raise KeyboardInterrupt
        self.addCleanup(signal.signal, signal.SIGALRM, signal.signal(signal.SIGALRM, stop))
        begun = time.monotonic()
        call()
        whole = time.monotonic() - begun
        pathlib.Path(output).unlink()
        begun = time.monotonic()
        signal.setitimer(signal.ITIMER_REAL, whole / 8)
        with self.assertRaises(KeyboardInterrupt):
            call()
        self.assertFalse(pathlib.Path(output).exists())
        self.assertLess(time.monotonic() - begun, whole)

    def test_interrupts_stop_the_work(self):
        count = 1500000
        sphere(count).astype("<f4").tofile(self.path("many.raw"))
        small = self.path("few.ply")
        self.interrupted(small, lambda: glark.stream.sample(self.path("many.raw"), small, target=2000, memory=40 << 20))
        glark.stream.sample(self.path("many.raw"), small, target=2000)
        samples = glark.read(small)
        glark.write(self.path("edited.ply"), samples.positions + [0, 0, 2])
        out = self.path("out.raw")
        self.interrupted(out, lambda: glark.stream.transfer(self.path("many.raw"), small, self.path("edited.ply"), out))
        self.assertEqual([], [path.name for path in pathlib.Path(self.folder.name).iterdir() if path.name.startswith(".")])

    def test_errors(self):
        with self.assertRaisesRegex(glark.FileError, "cannot be read"):
            glark.stream.Reader(self.path("none.ply"))
        with self.assertRaisesRegex(glark.FileError, "none.ply"):
            glark.stream.sample(self.path("none.ply"), self.path("a.ply"), target=10)
        with self.assertRaises(glark.ArgumentError):
            glark.stream.sample(self.path("large.ply"), self.path("a.ply"), target=10, memory=1)
        with self.assertRaises(TypeError):
            glark.stream.Reader.__new__(glark.stream.Reader).read()


if __name__ == "__main__":
    unittest.main()
