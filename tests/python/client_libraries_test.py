# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Each client library in Python: properties of its results."""
import unittest

import glark
import numpy

from sphere import OCTAHEDRON, TRIANGLES, sphere


class ClientLibraries(unittest.TestCase):
    def test_tree(self):
        points = sphere(3000)
        tree = glark.vstree.Tree(points, points, threshold=1e-3)
        leaves = tree.nodes[tree.nodes["first_child"] == 0]
        self.assertEqual(tree.leaf_count, len(leaves))
        self.assertEqual(3000, (leaves["end"] - leaves["begin"]).sum())
        self.assertEqual(list(range(3000)), sorted(tree.order))
        leaf = tree.nodes[tree.leaf_of(points[17])]
        self.assertIn(17, tree.order[leaf["begin"]:leaf["end"]])
        self.assertIsNone(tree.leaf_of([9, 9, 9]))
        self.assertAlmostEqual(12 ** 0.5, tree.diagonal, 2)
        lengths = numpy.linalg.norm(tree.frames["normal"], axis=1)
        numpy.testing.assert_allclose(1, lengths, atol=1e-5)

    def test_normals(self):
        points = sphere(2000)
        normals = glark.vstree.estimate_normals(points)
        self.assertGreater((normals * points).sum(axis=1).min(), 0.99)
        inwards = glark.vstree.estimate_normals(points, scanner=[0, 0, 0])
        self.assertLess((inwards * points).sum(axis=1).max(), -0.99)

    def test_reconstruct_and_simplify(self):
        points = sphere(5000)
        mesh = glark.reconstruct(points, points, numpy.full((5000, 3), 90, numpy.uint8))
        edges = numpy.sort(mesh.triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
        self.assertTrue((numpy.unique(edges, axis=0, return_counts=True)[1] == 2).all())  # closed
        numpy.testing.assert_allclose(1, numpy.linalg.norm(mesh.positions, axis=1), atol=0.02)
        self.assertTrue((mesh.colours == 90).all())
        small = glark.vstree.simplify(mesh.positions, mesh.triangles, target=500)
        self.assertTrue(450 <= len(small.triangles) <= 500, len(small.triangles))
        self.assertEqual(len(mesh.positions), len(small.representatives))
        self.assertEqual(("cluster", 0), (small.method, small.error))
        small = glark.vstree.simplify(mesh.positions, mesh.triangles, target=500, method="collapse")
        self.assertTrue(490 <= len(small.triangles) <= 500, len(small.triangles))
        self.assertTrue((mesh.positions[small.representatives < len(small.positions)] == small.positions).all())
        small = glark.vstree.simplify(mesh.positions, mesh.triangles, method="automatic", max_error=0.01)
        self.assertTrue(small.method == "collapse" and 0 < small.error <= 0.01, small.error)

    def test_strips(self):
        points = sphere(4000)
        strips = glark.surfel.Strips(points, points, levels=2)
        self.assertEqual(2, strips.level_count)
        self.assertGreater(strips.counts()["valid"], 7000)
        half = numpy.diag([0.5, 0.5, 0.5, 1])
        half[0, 3] = 0.25  # a shift along x: wrong if rows and columns are exchanged
        frame = strips.select(half, 800, 800, level_pixels=0)
        self.assertEqual(frame.counts.sum(), frame.indices)
        self.assertEqual(len(frame.counts), len(frame.offsets))
        away = half.copy()
        away[0, 3] = 5
        self.assertEqual(0, len(strips.select(away, 800, 800).counts))
        points[2000] += 0.2
        self.assertEqual(2, strips.update(points, points, [2000]).shape[1])

    def test_subdivision(self):
        surface = glark.qas.Surface(6, TRIANGLES)
        surface.update(OCTAHEDRON)
        self.assertEqual((24, 12), surface.corners().shape)
        loop = glark.qas.LoopSurface(6, TRIANGLES)
        loop.update(OCTAHEDRON)
        positions, normals = loop.refine(1)
        self.assertEqual((8 * 6, 3), positions.shape)
        position, normal = loop.evaluate(0, [1, 0, 0])
        numpy.testing.assert_allclose(position, positions[0], atol=1e-6)
        numpy.testing.assert_allclose(normal, normals[0], atol=1e-6)
        self.assertIn("place", glark.qas.refinement_shader(position="place"))

    def test_pn_tags(self):
        tagged = glark.pn.derive_tags(OCTAHEDRON, TRIANGLES, crease_degrees=40)
        self.assertEqual(len(tagged.positions), len(tagged.tags))
        self.assertEqual(6, tagged.corners + tagged.crease_vertices)
        smooth = glark.pn.derive_tags(OCTAHEDRON, TRIANGLES, crease_degrees=120)
        self.assertEqual(0, smooth.corners + smooth.crease_vertices)

    def test_depth_tags(self):
        tagger = glark.depth.Tagger(6, TRIANGLES, 5)
        tags = tagger.by_distance(OCTAHEDRON, [1, 0, 0], nearest=0.5, farthest=2, finest=4)
        self.assertEqual([4, 0], tags[:2].tolist())
        kept, triangles, fits = tagger.keep_budget(tags, 40)
        self.assertTrue(fits)
        self.assertLessEqual(triangles, 40)
        self.assertEqual(triangles, tagger.refined_triangles(kept))
        heights = numpy.zeros((4, 4))
        self.assertEqual([0] * 6, tagger.by_displacement(OCTAHEDRON[:, :2], heights, 0.1).tolist())
        for by in (tagger.by_edge_length(OCTAHEDRON, 20, [0, 0, 3], 500), tagger.by_curvature(OCTAHEDRON, 0.01),
                   tagger.by_curvature_on_screen(OCTAHEDRON, 1, [0, 0, 3], 500)):
            self.assertGreater(by.min(), 0)


if __name__ == "__main__":
    unittest.main()
