# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""scripts/parts/picture_row.py: reads PNG rows of every filter, and joins pictures."""
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts" / "parts"))
import picture_row  # noqa: E402 (lies in the folder that the line above names)


class PictureRow(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_filters(self):
        # Pixels of one byte: left is 10, above are 20 and 30, the corner is 20.
        for kind, expected in [(0, [10, 1]), (1, [10, 11]), (2, [30, 31]), (3, [20, 26]), (4, [30, 31])]:
            row = bytearray([10, 1])
            picture_row.unfilter(kind, row, bytes([20, 30]), 1)
            self.assertEqual(expected, list(row), kind)

    def test_paeth_takes_the_nearest(self):
        self.assertEqual([5, 9, 7], [picture_row.paeth(5, 9, 9), picture_row.paeth(5, 9, 5), picture_row.paeth(2, 12, 7)])

    def test_join(self):
        left, right, row = (self.folder / name for name in ("left.png", "right.png", "row.png"))
        picture_row.write_png(left, 1, [b"abc", b"def"])
        picture_row.write_png(right, 2, [b"ghijkl", b"mnopqr"])
        picture_row.join([left, right], row)
        self.assertEqual((3, [b"abcghijkl", b"defmnopqr"]), picture_row.read_png(row))

    def test_other_heights_are_refused(self):
        low, high = (self.folder / name for name in ("low.png", "high.png"))
        picture_row.write_png(low, 1, [b"abc"])
        picture_row.write_png(high, 1, [b"abc", b"def"])
        with self.assertRaises(ValueError):
            picture_row.join([low, high], self.folder / "row.png")

    def test_other_files_are_refused(self):
        other = self.folder / "other.png"
        other.write_bytes(bytes(40))
        with self.assertRaises(ValueError):
            picture_row.read_png(other)


if __name__ == "__main__":
    unittest.main()
