# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""The judge finds the faults that it is made for."""
import unittest

import judge


def picture(*levels: int) -> tuple:
    return len(levels), 1, bytes(channel for level in levels for channel in (level, level, level))


class Judge(unittest.TestCase):
    def test_empty_picture(self):
        self.assertTrue(judge.picture_complaints(picture(7, 7, 7)))
        self.assertFalse(judge.picture_complaints(picture(7, 9, 7)))

    def test_one_level_breaks_identity(self):
        self.assertTrue(judge.identity_complaints(picture(1, 2), picture(1, 3)))
        self.assertFalse(judge.identity_complaints(picture(1, 2), picture(1, 2)))
        self.assertTrue(judge.identity_complaints(picture(1, 2), picture(1, 2, 2)))

    def test_likeness_allows_two_levels(self):
        self.assertFalse(judge.likeness_complaints(picture(10, 20), picture(12, 18)))
        self.assertTrue(judge.likeness_complaints(picture(10, 20), picture(13, 20)))

    def test_likeness_allows_half_a_percent(self):
        self.assertFalse(judge.likeness_complaints(picture(*[0] * 200), picture(9, *[0] * 199)))
        self.assertTrue(judge.likeness_complaints(picture(*[0] * 200), picture(9, 9, *[0] * 198)))

    def test_signs_of_life(self):
        draws = {"seen": 1, "refined": 0}
        self.assertTrue(judge.life_complaints({"coarse_triangles": 2, "refined_triangles": 0, "draws": draws}, 2))
        self.assertTrue(judge.life_complaints({"coarse_triangles": 2, "refined_triangles": 8, "draws": draws}, 2))
        self.assertFalse(judge.life_complaints({"coarse_triangles": 2, "refined_triangles": 32, "draws": draws}, 2))

    def test_measured_depths_refine(self):
        draws = {"seen": 1, "refined": 1}
        self.assertTrue(judge.measured_complaints({"coarse_triangles": 2, "refined_triangles": 2, "draws": draws}))
        self.assertTrue(judge.measured_complaints({"coarse_triangles": 0, "refined_triangles": 0, "draws": draws}))
        self.assertFalse(judge.measured_complaints({"coarse_triangles": 2, "refined_triangles": 3, "draws": draws}))

    def test_off_means_off(self):
        self.assertTrue(judge.off_complaints({"refined_triangles": 1}))
        self.assertFalse(judge.off_complaints({"refined_triangles": 0}))


if __name__ == "__main__":
    unittest.main()
