# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""How scripts/strangers counts refined draws."""
import pathlib
import sys
import unittest

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent.parent / "scripts" / "parts" / "strangers"))
from refined_share import life, mean_of_programs, settled


def frame(number: int, refined: int, **causes: int) -> dict:
    return {"frame": number, "refined": refined, "passed_through": causes}


def statistics(*frames: dict) -> dict:
    causes = {}
    for one in frames:
        for cause, count in one["passed_through"].items():
            causes[cause] = causes.get(cause, 0) + count
    return {"frames": len(frames), "last_frames": list(frames),
            "draws": {"refined": sum(one["refined"] for one in frames), "passed_through": causes}}


class RefinedShare(unittest.TestCase):
    def test_user_interfaces_are_no_objects(self):
        counted = life(statistics(frame(1, 3, overlay=5, mesh_flat=2)))
        self.assertEqual((counted["draws"], counted["objects"], counted["refined"]), (10, 5, 3))

    def test_wire_frames_are_no_objects(self):
        self.assertEqual(life(statistics(frame(1, 0, polygon_mode=7)))["objects"], 0)

    def test_draws_that_are_left_before_they_are_planned_are_objects(self):
        self.assertEqual(life(statistics(frame(1, 0, materials_vary=7)))["objects"], 7)

    def test_the_first_half_of_the_frames_may_wait(self):
        waiting = frame(1, 0, mesh_waits=4), frame(2, 0, mesh_waits=4)
        self.assertEqual(settled(statistics(*waiting, frame(3, 4), frame(4, 4))), (8, 8))

    def test_a_mesh_that_waits_for_ever_counts(self):
        self.assertEqual(settled(statistics(*(frame(i, 1, mesh_waits=1) for i in range(1, 5)))), (4, 2))

    def test_each_program_counts_as_much_as_any_other(self):
        lives = [life(statistics(frame(1, 1000000))), life(statistics(frame(1, 0, mesh_flat=1))), life(statistics(frame(1, 0, overlay=1)))]
        self.assertEqual(mean_of_programs(lives), "50.0 %")

    def test_no_objects_at_all(self):
        self.assertEqual(mean_of_programs([life(statistics(frame(1, 0, overlay=1)))]), "none")


if __name__ == "__main__":
    unittest.main()
