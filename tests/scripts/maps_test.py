# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""How scripts/maps compares pictures, and what it makes of models."""
import math
import pathlib
import sys
import tempfile
import unittest

try:
    import numpy
    from PIL import Image  # noqa: F401
except ImportError as error:
    print(f"skipped: {error}; scripts/install_packages installs it")
    sys.exit(77)

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "scripts" / "parts" / "maps"))
import camera  # noqa: E402
import displaced  # noqa: E402
import glb  # noqa: E402
import pixels  # noqa: E402
import tables  # noqa: E402


def square(grey: int, size: int = 20, side: int = 12) -> numpy.ndarray:
    """A picture with a grey square in its middle, transparent around it."""
    picture = numpy.zeros((size, size, 4), numpy.uint8)
    low = (size - side) // 2
    picture[low:low + side, low:low + side] = (grey, grey, grey, 255)
    return picture


def one_triangle() -> glb.Glb:
    model = glb.Glb({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 0}], "bufferViews": [], "accessors": [],
                     "meshes": [{"primitives": [{"attributes": {}, "material": 0}]}],
                     "materials": [{"normalTexture": {"index": 0},
                                    "extras": {"displacement": {"uri": "h.png", "scale": 2.0, "bias": -0.5}}}]}, b"")
    model = model.with_new_array("POSITION", numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]]))
    model = model.with_new_array("NORMAL", numpy.array([[0, 0, 1]] * 3))
    model = model.with_new_array("TANGENT", numpy.array([[1, 0, 0, 1]] * 3))
    model = model.with_new_array("TEXCOORD_0", numpy.array([[0.25, 0.25], [0.75, 0.25], [0.25, 0.75]]))
    return model.with_triangles(numpy.array([[0, 1, 2]]))


class Pixels(unittest.TestCase):
    def test_a_difference_of_one_in_each_channel(self):
        errors = pixels.errors_of(square(100), square(101))
        self.assertAlmostEqual(20 * math.log10(255), pixels.psnr_of_object(errors))

    def test_the_background_does_not_count(self):
        wide = numpy.pad(square(100), ((50, 50), (50, 50), (0, 0))), numpy.pad(square(110), ((50, 50), (50, 50), (0, 0)))
        self.assertEqual(pixels.errors_of(square(100), square(110)), pixels.errors_of(*wide))

    def test_a_smaller_outline_counts_outside_only(self):
        errors = pixels.errors_of(square(100), square(100, side=10))
        self.assertEqual(math.inf, pixels.psnr_inside(errors))
        self.assertEqual(3 * 12 * 12, errors.count_outline + errors.count_inside)
        self.assertLess(pixels.psnr_of_object(errors), 30)

    def test_pictures_without_an_object(self):
        empty = numpy.zeros((4, 4, 4), numpy.uint8)
        with self.assertRaisesRegex(ValueError, "no pixels"):
            pixels.psnr_of_object(pixels.errors_of(empty, empty))

    def test_pictures_of_two_sizes(self):
        with self.assertRaisesRegex(ValueError, "shapes"):
            pixels.errors_of(square(1), square(1, size=22))

    def test_views_add_up(self):
        errors = sum((pixels.errors_of(square(100), square(grey)) for grey in (100, 102)), pixels.NO_ERRORS)
        self.assertAlmostEqual(10 * math.log10(255 * 255 / 2), pixels.psnr_of_object(errors))

    def test_a_background_becomes_transparent(self):
        opaque = pixels.shown(square(100)).astype(numpy.uint8)
        self.assertTrue((pixels.with_alpha(opaque)[..., 3] == square(100)[..., 3]).all())


class Models(unittest.TestCase):
    def test_written_models_are_read_back(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "model.glb"
            one_triangle().write(file)
            model = glb.read(file)
        self.assertEqual([[0, 1, 2]], model.triangles().tolist())
        self.assertEqual([1, 0, 0], model.array("POSITION")[1].tolist())

    def test_without_maps(self):
        model = one_triangle()
        self.assertNotIn("normalTexture", model.without_maps().material)
        self.assertIn("normalTexture", model.material)

    def test_other_files_are_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "model.glb"
            file.write_bytes(b"solid")
            with self.assertRaisesRegex(ValueError, "no binary glTF"):
                glb.read(file)

    def test_the_pattern_covers_the_triangle(self):
        weights, triangles = displaced.pattern(4)
        self.assertEqual(16, len(triangles))
        self.assertTrue(numpy.allclose(weights.sum(axis=1), 1))
        corners = weights[triangles][..., 1:]
        sides = corners[:, 1:] - corners[:, :1]
        areas = numpy.cross(sides[:, 0], sides[:, 1]) / 2
        self.assertTrue(numpy.allclose(areas, 0.5 / 16))

    def test_heights_between_texels(self):
        heights = numpy.array([[0.0, 1.0], [0.0, 1.0]])
        places = numpy.array([[0.25, 0.5], [0.5, 0.5], [1.0, 0.5]])
        self.assertTrue(numpy.allclose([0, 0.5, 1], displaced.bilinear(heights, places)))

    def test_displaced_along_the_normal(self):
        arrays = displaced.displace(one_triangle(), numpy.full((2, 2), 0.75), 2)
        self.assertTrue(numpy.allclose(2 * 0.75 - 0.5, arrays["POSITION"][:, 2]))
        self.assertEqual((4, 3), arrays["triangles"].shape)


class Cameras(unittest.TestCase):
    def test_the_camera_of_glark_view(self):
        points = numpy.array([[-1, -1, -1], [1, 1, 1]])
        view = camera.camera_of(points, 90, 0)
        distance = math.sqrt(3) / math.sin(math.radians(20))
        self.assertTrue(numpy.allclose((distance, 0, 0), view.position))

    def test_an_upright_z_axis(self):
        view = camera.camera_of(numpy.array([[-1, -1, -1], [1, 1, 1]]), 0, 90, "z")
        self.assertGreater(view.position[2], 5)
        self.assertEqual((0, 0, 1), view.up)


class Tables(unittest.TestCase):
    def test_the_page_keeps_its_other_lines(self):
        value = {"object": 30.0, "inside": 31.0}
        result = {"three": {"figures": {"reference": {"coarse": value, "blender_0": value, "model": value}}},
                  "f3d": {"coarse": value, "model": value}, "view": {"plain": value},
                  "reports": {"same mesh": {"seconds": 1.0, "processor_seconds": 2.0},
                              "blender": [{"file": "blender_0", "extrusion": 0.01, "seconds": 9.0, "processor_seconds": 8.0}]}}
        with tempfile.TemporaryDirectory() as folder:
            page = pathlib.Path(folder) / "page.md"
            page.write_text("before\n" + "\nold\n".join(tables.MARKS) + "\nafter\n")
            tables.write(page, {"igea": result})
            text = page.read_text()
        self.assertTrue(text.startswith("before\n") and text.endswith("\nafter\n"))
        self.assertNotIn("old", text)
        self.assertIn("| igea | Blender, extrusion 0.01 of the diagonal | 9.0 | 8.0 | 30.0 | 31.0 |", text)


if __name__ == "__main__":
    unittest.main()
