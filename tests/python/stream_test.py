# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""glark.stream: a scan is read in parts, sampled, edited by its sampling, and refined."""
import pathlib
import tempfile
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
        self.assertEqual((COUNT, True), (report.points, report.is_deformed))
        numpy.testing.assert_allclose(self.points + [0, 0, 2], glark.read(self.path("out.ply")).positions, atol=1e-5)

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
