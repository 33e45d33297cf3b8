# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Arrays go in and out without copies; wrong ones are refused; files keep what is written."""
import pathlib
import tempfile
import unittest
import warnings

import glark
import numpy

from sphere import sphere


class Arrays(unittest.TestCase):
    def test_results_keep_their_owner_and_cannot_be_written(self):
        mesh = glark.reconstruct(sphere(2000), sphere(2000))
        positions = mesh.positions
        address = positions.ctypes.data
        self.assertEqual(address, mesh.positions.ctypes.data)  # the same memory each time
        expected = positions.copy()
        del mesh
        self.assertEqual(address, positions.ctypes.data)
        numpy.testing.assert_array_equal(expected, positions)
        with self.assertRaises(ValueError):
            positions[0] = 1

    def test_other_types_and_layouts_give_the_same(self):
        points = sphere(500)
        expected = glark.vstree.estimate_normals(points)
        numpy.testing.assert_array_equal(expected, glark.vstree.estimate_normals(points.astype(numpy.float64)))
        numpy.testing.assert_array_equal(expected, glark.vstree.estimate_normals(numpy.asfortranarray(points)))
        numpy.testing.assert_array_equal(expected, glark.vstree.estimate_normals(points.tolist()))

    def test_bad_shapes_and_values_are_told(self):
        with self.assertRaisesRegex(glark.ArgumentError, r"positions has the shape \(6\); give it the shape \(n, 3\)"):
            glark.vstree.Tree(numpy.zeros(6))
        with self.assertRaisesRegex(ValueError, "metric is 'l3'; use one of 'l2', 'l21', 'qef', 'density'"):
            glark.vstree.Tree(sphere(10), metric="l3")
        points = sphere(10)
        points[4, 1] = numpy.nan
        with self.assertRaisesRegex(glark.ArgumentError, "4"):
            glark.reconstruct(points)

    def test_numbers_that_do_not_fit_are_told(self):
        points = sphere(100)
        for call, told in (
            (lambda: glark.vstree.simplify(points, target=-5), "target is -5; give it a number from 0"),
            (lambda: glark.vstree.estimate_normals(points, neighbours=2 ** 32), "neighbours is 4294967296"),
            (lambda: glark.reconstruct(points, levels=-1), "levels is -1"),
            (lambda: glark.surfel.Strips(points, leaf_points=-1), "leaf_points is -1"),
            (lambda: glark.qas.Surface(-1, [[0, 1, 2]]), "vertices is -1"),
            (lambda: glark.depth.Tagger(3, [[0, 1, 2]], -1), "max_level is -1"),
        ):
            with self.assertRaisesRegex(glark.ArgumentError, told):
                call()

    def test_values_that_do_not_fit_are_told(self):
        corners = numpy.eye(4, 3, dtype=numpy.float32)
        for triangles, told in (
            ([[0, 1, -1]], "triangles has the value -1; give it integers from 0 to 4294967295"),
            (numpy.array([[0, 1, 2**32]], numpy.uint64), "triangles has the value 4294967296"),
            ([[0, 1, 1.5]], "triangles has the type float64; give it integers"),
            ([[0, 1], [2]], "triangles cannot be read as an array"),
        ):
            with self.assertRaisesRegex(glark.ArgumentError, told):
                glark.vstree.simplify(corners, triangles)
        for points, told in (
            (None, "positions is None"),
            (corners + 1j, "positions has the type complex"),
            ([["a", "b", "c"]], "positions has the type <U1; give it numbers"),
            (glark.reconstruct, "positions is of the type builtin_function_or_method; give it an array of numbers"),
        ):
            with self.assertRaisesRegex(glark.ArgumentError, told):
                glark.reconstruct(points)
        with self.assertRaisesRegex(glark.ArgumentError, "colours has the value 300; give it integers from 0 to 255"):
            glark.vstree.simplify(corners, colours=numpy.full((4, 3), 300))

    def test_arrays_at_odd_addresses_are_read(self):
        points = sphere(50)
        odd = numpy.frombuffer(b"x" + points.tobytes(), numpy.uint8)[1:].view(numpy.float32).reshape(-1, 3)
        numpy.testing.assert_array_equal(glark.vstree.estimate_normals(points), glark.vstree.estimate_normals(odd))

    def test_no_points_give_empty_results(self):
        empty = numpy.zeros((0, 3), numpy.float32)
        self.assertEqual((0, 3), glark.reconstruct(empty).positions.shape)
        self.assertEqual((0,), glark.vstree.Tree(empty).nodes.shape)


class Files(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.file = str(pathlib.Path(self.folder.name) / "mesh.ply")
        self.addCleanup(self.folder.cleanup)

    def test_a_format_may_be_named(self):
        other = pathlib.Path(self.file).with_suffix(".scan")
        glark.write(self.file, sphere(10))
        pathlib.Path(self.file).rename(other)
        with self.assertRaisesRegex(glark.FileError, "names no format that glark reads; .* or the option format"):
            glark.read(other)
        for name in ("ply", ".ply"):
            self.assertEqual(10, len(glark.read(other, format=name).positions))

    def test_what_is_written_is_read(self):
        points = sphere(4)
        colours = numpy.arange(12, dtype=numpy.uint8).reshape(4, 3)
        triangles = numpy.array([[0, 1, 2], [2, 1, 3]], numpy.uint32)
        glark.write(self.file, points, points, colours, triangles=triangles)
        read = glark.read(self.file)
        numpy.testing.assert_array_equal(points, read.positions)
        numpy.testing.assert_array_equal(points, read.normals)
        numpy.testing.assert_array_equal(colours, read.colours[:, :3])
        numpy.testing.assert_array_equal(triangles, read.triangles)
        self.assertIsNone(read.texcoords)

    def test_a_path_is_as_good_as_a_name(self):
        path = pathlib.Path(self.file)
        glark.write(path, sphere(4))
        self.assertEqual((4, 3), glark.read(path).positions.shape)

    def test_bad_files_and_meshes_are_told(self):
        with self.assertRaises(glark.FileError):
            glark.read("/nowhere/scan.ply")
        with self.assertRaisesRegex(glark.ArgumentError, "triangles has the index 9, but there are 3 points"):
            glark.write(self.file, sphere(3), triangles=[[0, 1, 9]])
        with self.assertRaisesRegex(glark.ArgumentError, "normals has 2 rows for 3 points"):
            glark.write(self.file, sphere(3), sphere(2))
        with self.assertRaisesRegex(glark.ArgumentError, "positions has the coordinate nan in row 1"):
            glark.write(self.file, [[0, 0, 0], [0, numpy.nan, 0]])
        self.assertFalse(pathlib.Path(self.file).exists())

    def test_invalid_points_are_left_out_with_a_warning(self):
        pathlib.Path(self.file).with_suffix(".xyz").write_text("0 0 0\nnan 0 0\n1 0 0\n")
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            read = glark.read(self.file.replace(".ply", ".xyz"), skip_invalid=True)
        self.assertEqual((2, 3), read.positions.shape)
        self.assertEqual(1, len(told), told)


if __name__ == "__main__":
    unittest.main()
