# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Threads share an object: some read it while others change it. Arrays that were taken before a change stay as they are."""
import threading
import unittest

import glark
import numpy

from sphere import OCTAHEDRON, TRIANGLES, sphere

ROUNDS = 40


class Threads(unittest.TestCase):
    def run_(self, *steps):
        problems = []

        def work(step):
            try:
                for _ in range(ROUNDS):
                    step()
            except Exception as problem:  # pylint: disable=broad-except
                problems.append(problem)

        threads = [threading.Thread(target=work, args=(step,)) for step in steps for _ in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual([], problems)

    def test_strips(self):
        points = sphere(300)
        strips = glark.surfel.Strips(points, points, levels=2)
        before = strips.indices
        expected = before.copy()
        moved = numpy.arange(300, dtype=numpy.uint32)
        self.run_(lambda: strips.update(points * 1.5, points, moved), lambda: strips.select(numpy.eye(4), 64, 64),
                  lambda: strips.indices.sum(), lambda: strips.nodes()["count"].sum())
        numpy.testing.assert_array_equal(expected, before)

    def test_surfaces(self):
        surface = glark.qas.Surface(6, TRIANGLES)
        loop = glark.qas.LoopSurface(6, TRIANGLES)
        self.run_(lambda: surface.update(OCTAHEDRON), lambda: surface.evaluate(0, [1, 0, 0]), surface.corners,
                  lambda: loop.update(OCTAHEDRON), lambda: loop.refine(3))

    def test_tagger(self):
        tagger = glark.depth.Tagger(6, TRIANGLES, 5)
        self.run_(lambda: tagger.by_curvature(OCTAHEDRON, 0.01), lambda: tagger.by_edge_length(OCTAHEDRON, 20, [0, 0, 3], 500),
                  lambda: tagger.refined_triangles([1, 2, 3, 4, 5, 0]))


if __name__ == "__main__":
    unittest.main()
