# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""glark.maps: maps of an octahedron, baked from a sphere around it."""
import pathlib
import tempfile
import unittest

import glark
import glark.maps
import numpy

from sphere import OCTAHEDRON, TRIANGLES, sphere

SMALL = {"texture_memory": 1 << 20}


class Maps(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.points = sphere(5000)
        self.fine = glark.maps.FineMesh(self.points, normals=self.points, colours=numpy.full((5000, 3), 90, numpy.uint8))

    def path(self, name: str) -> pathlib.Path:
        return pathlib.Path(self.folder.name) / name

    def test_model(self):
        model = glark.maps.bake(OCTAHEDRON, TRIANGLES, self.fine, origin=(7, 0, 0), reach=20, **SMALL)
        self.assertEqual((8, 3), model.triangles.shape)
        vertices = len(model.positions)
        self.assertEqual([(vertices, 3), (vertices, 4), (vertices, 2)],
                         [array.shape for array in (model.normals, model.tangents, model.texcoords)])
        self.assertEqual([7, 0, 0], list(model.origin))
        corners = numpy.unique(model.positions.round(5), axis=0)
        self.assertEqual(6, len(corners))

    def test_maps(self):
        model = glark.maps.bake(OCTAHEDRON, TRIANGLES, self.fine, **SMALL)
        size = (model.height, model.width)
        self.assertEqual([(*size, 3), (*size, 3), size],
                         [array.shape for array in (model.normal_map, model.colour_map, model.displacement_map)])
        self.assertEqual([numpy.uint8, numpy.uint16], [model.normal_map.dtype, model.displacement_map.dtype])
        self.assertIn(90, model.colour_map)
        self.assertFalse(model.displacement_map.flags.writeable)
        heights = model.scale * model.displacement_map.astype(float) / 65535 + model.bias
        self.assertAlmostEqual(1 - 3 ** -0.5, heights.max(), delta=0.03)  # the sphere above the centre of a face
        self.assertEqual((5000, 0, 0), (model.points, model.invalid, model.empty_charts))
        self.assertGreater(model.texels, 1000)
        self.assertGreater(model.reach, 0.4)
        self.assertGreater(model.seams.edges, 0)
        self.assertLessEqual(model.seams.normal.root_mean_square, model.seams.normal.greatest)
        self.assertEqual([jumps.edges for jumps in model.mip_seams], 2 * [model.seams.edges])

    def test_files_give_what_arrays_give(self):
        glark.write(self.path("scan.ply"), self.points, self.points, numpy.full((5000, 3), 90, numpy.uint8))
        one = glark.maps.bake(OCTAHEDRON, TRIANGLES, self.path("scan.ply"), **SMALL)
        other = glark.maps.bake(OCTAHEDRON, TRIANGLES, self.fine, threads=1, **SMALL)
        for name in ("positions", "triangles", "normal_map", "colour_map", "displacement_map"):
            numpy.testing.assert_array_equal(getattr(other, name), getattr(one, name), name)
        raw = self.points.astype("<f4")
        raw.tofile(self.path("scan.bin"))
        plain = glark.maps.bake(OCTAHEDRON, TRIANGLES, str(self.path("scan.bin")), format="raw", **SMALL)
        self.assertIsNone(plain.colour_map)

    def test_fine_meshes_are_sampled(self):
        fine = glark.maps.FineMesh(2 * OCTAHEDRON, TRIANGLES, spacing=0.1)
        self.assertEqual(((6, 3), (8, 3), 0.1), (fine.positions.shape, fine.triangles.shape, fine.spacing))
        model = glark.maps.bake(OCTAHEDRON, TRIANGLES, fine, **SMALL)
        self.assertEqual(6 + 8 * 29 ** 2, model.points)  # an edge has the length 2.83
        whole = glark.maps.bake(OCTAHEDRON, TRIANGLES, glark.maps.FineMesh(2 * OCTAHEDRON, TRIANGLES), **SMALL)
        self.assertEqual(6 + 8, whole.points)

    def test_fine_meshes_keep_their_arrays(self):
        fine = glark.maps.FineMesh(self.points.astype(float), normals=self.points.tolist())
        same = glark.maps.FineMesh(self.points, normals=self.points)
        one, other = (glark.maps.bake(OCTAHEDRON, TRIANGLES, source, **SMALL) for source in (fine, same))
        numpy.testing.assert_array_equal(one.displacement_map, other.displacement_map)

    def test_texture_coordinates_of_the_mesh(self):
        corners = OCTAHEDRON[TRIANGLES].reshape(-1, 3)
        triangles = numpy.arange(24).reshape(8, 3)
        places = numpy.array([[.2, .2], [.9, .2], [.2, .9]])
        texcoords = numpy.concatenate([(places + [t % 4, t // 4]) / [4, 2] for t in range(8)])
        model = glark.maps.bake(corners, triangles, self.fine, texcoords=texcoords, size=(128, 64))
        self.assertTrue(model.has_own_texcoords)
        self.assertEqual("", model.texcoords_fault)
        self.assertEqual((64, 128), model.displacement_map.shape)
        numpy.testing.assert_array_equal(triangles, model.triangles)
        numpy.testing.assert_allclose(texcoords * [1, -1] + [0, 1], model.texcoords, atol=1e-6)
        model = glark.maps.bake(corners, triangles, self.fine, texcoords=texcoords + .5, **SMALL)
        self.assertFalse(model.has_own_texcoords)
        self.assertIn("beyond 0 to 1", model.texcoords_fault)
        for options, text in (({"texture_coordinates": "own"}, "it has no texture coordinates"),
                              ({"texture_coordinates": "mine"}, 'texture_coordinates is "mine"'),
                              ({"size": (100, 64)}, "width, height is 100 x 64"),
                              ({"texcoords": texcoords[:, :1]}, "texcoords has the shape")):
            with self.assertRaisesRegex(glark.ArgumentError, text):
                glark.maps.bake(corners, triangles, self.fine, **options)

    def test_write_model(self):
        model = glark.maps.bake(OCTAHEDRON, TRIANGLES, self.fine, **SMALL)
        glark.maps.write_model(self.path("a.glb"), model)
        self.assertEqual(8, len(glark.read(self.path("a.glb")).triangles))
        header = self.path("a.displacement.png").read_bytes()[:26]
        self.assertEqual((b"\x89PNG", model.width, 16, 0),
                         (header[:4], int.from_bytes(header[16:20], "big"), header[24], header[25]))
        with self.assertRaisesRegex(glark.FileError, "none"):
            glark.maps.write_model(self.path("none") / "a.glb", model)

    def test_write_ply(self):
        model = glark.maps.bake(OCTAHEDRON, TRIANGLES, self.fine, **SMALL)
        for strips in (False, True):
            glark.maps.write_ply(self.path("a.ply"), model, strips=strips)
            self.assertEqual(8, len(glark.read(self.path("a.ply")).triangles))
            self.assertEqual(strips, b"tristrips" in self.path("a.ply").read_bytes())
        self.assertTrue(self.path("a.normals.png").exists())
        with self.assertRaisesRegex(glark.FileError, "none"):
            glark.maps.write_ply(self.path("none") / "a.ply", model)

    def test_resume(self):
        work = self.path("work")
        model = glark.maps.bake(OCTAHEDRON, TRIANGLES, self.fine, work=work, **SMALL)
        again = glark.maps.bake(OCTAHEDRON, TRIANGLES, self.fine, work=work, resume=True, **SMALL)
        self.assertTrue((model.normal_map == again.normal_map).all())
        with self.assertRaisesRegex(glark.FileError, "noise"):
            glark.maps.bake(OCTAHEDRON, TRIANGLES, self.fine, work=work, resume=True, noise=1, **SMALL)

    def test_errors(self):
        def bake(source=self.fine, **options):
            return glark.maps.bake(OCTAHEDRON, TRIANGLES, source, **options)
        with self.assertRaisesRegex(glark.FileError, "none.ply: cannot be read"):
            bake(self.path("none.ply"))
        for options, text in (({"reach": -1}, "the option reach is -1"), ({"threads": -1}, "threads is -1"),
                              ({"texture_memory": 1}, "texture_memory is 1 bytes"), ({"source": 3}, "source is of the type int"),
                              ({"source": glark.maps.FineMesh(self.points, spacing=0)}, "spacing is 0"),
                              ({"source": glark.maps.FineMesh(self.points + 99)}, "no point of the fine mesh is within"),
                              ({"normals": self.points[:, :2]}, r"normals has the shape \(5000, 2\)")):
            with self.assertRaisesRegex(glark.ArgumentError, text):
                bake(**options)
        with self.assertRaisesRegex(glark.ArgumentError, "triangle 0 of the coarse mesh has the vertex 99"):
            glark.maps.bake(OCTAHEDRON, [[0, 2, 99]], self.fine)
        with self.assertRaisesRegex(glark.ArgumentError, "positions has the shape"):
            glark.maps.FineMesh(OCTAHEDRON[:, :2])
        with self.assertRaises(TypeError):
            bake(glark.maps.FineMesh.__new__(glark.maps.FineMesh))


if __name__ == "__main__":
    unittest.main()
