# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""How scripts/strangers --panel compares frames, and finds the panel in a picture."""
import pathlib
import sys
import unittest

PARTS = pathlib.Path(__file__).resolve().parent.parent.parent / "scripts" / "parts"
sys.path[:0] = [str(PARTS / "strangers"), str(PARTS)]
try:
    import numpy
    from panel import TITLE, different, is_healthy, shows_panel, summary
except ModuleNotFoundError:
    sys.exit(77)

GREY = numpy.full((480, 640, 3), 90, numpy.uint8)


def with_pixel(x: int, y: int) -> numpy.ndarray:
    picture = GREY.copy()
    picture[y, x] = 200
    return picture


class OpenPanel(unittest.TestCase):
    def test_pixels_count_beside_the_panel_or_under_it(self):
        self.assertEqual(different([GREY], [GREY]), (0, 0))
        self.assertEqual(different([GREY], [with_pixel(450, 100)]), (1, 0))
        self.assertEqual(different([GREY], [with_pixel(50, 100)]), (0, 1))
        self.assertEqual(different([GREY], [with_pixel(5, 5)]), (1, 0))

    def test_a_missing_frame_is_an_error(self):
        with self.assertRaises(ValueError):
            different([GREY, GREY], [GREY])

    def test_the_title_shows_the_panel(self):
        picture = GREY.copy()
        self.assertFalse(shows_panel(picture))
        picture[10:29, 10:400] = TITLE
        self.assertTrue(shows_panel(picture))

    def test_only_a_healthy_program_counts(self):
        healthy = {"name": "a", "beside": 0, "within": 0, "replayed": True, "shown": True, "problems": []}
        broken = [{**healthy, "beside": 3},
                  {**healthy, "replayed": False}, {**healthy, "shown": False}, {**healthy, "problems": ["glark: error"]},
                  {"name": "a", "failure": "status 1"}]
        self.assertTrue(is_healthy(healthy))
        self.assertFalse(any(map(is_healthy, broken)))
        text = summary([healthy, *broken, {"name": "b", "left_out": "fails without glark, too"}])
        self.assertIn("1 of 6 programs", text)
        self.assertIn("fail without glark, too: b", text)


unittest.main()
