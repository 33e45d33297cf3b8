# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Counts the draws of objects of a replay, and how many of them were refined: docs/reference/strangers.md, "How draws are counted"."""

# Causes of draws that smooth cannot refine: points and lines, user interfaces, what draws nothing, no normals.
NO_OBJECTS = {"not_triangles", "polygon_mode", "screen_quad", "overlay", "orthographic", "render_mode", "rasterizer_discard",
              "invalid_draw", "left_shader", "blended", "no_depth_test", "no_depth_writes", "no_surface"}


def objects(refined: int, causes: dict) -> int:
    return refined + sum(count for cause, count in causes.items() if cause not in NO_OBJECTS)


def settled(statistics: dict) -> tuple:
    """The draws of objects, and those refined, in the last half of the frames; of at most as many as the file has."""
    frames = [frame for frame in statistics.get("last_frames", []) if 2 * frame["frame"] > statistics["frames"]]
    return (sum(objects(frame["refined"], frame["passed_through"]) for frame in frames),
            sum(frame["refined"] for frame in frames))


def life(statistics: dict) -> dict:
    """What the table needs of a replay's statistics."""
    draws = statistics["draws"]
    causes = draws["passed_through"]
    return {"draws": draws["refined"] + sum(causes.values()), "objects": objects(draws["refined"], causes),
            "refined": draws["refined"], "settled": settled(statistics), "causes": causes}


def percent(part: float, whole: float) -> str:
    return f"{100 * part / whole:.1f} %" if whole else "none"


def mean_of_programs(lives: list) -> str:
    """The mean share of the programs that draw objects in the last half of their frames."""
    shares = [refined / all_of_them for all_of_them, refined in (one.get("settled", (0, 0)) for one in lives) if all_of_them]
    return percent(sum(shares), len(shares))


def share_text(lives: list) -> str:
    lives = [one for one in lives if one.get("objects")]
    refined, all_of_them = (sum(one[key] for one in lives) for key in ("refined", "objects"))
    together = f"Of all {all_of_them} draws of objects together, first frames included, {percent(refined, all_of_them)} are refined."
    if not any("settled" in one for one in lives):
        return together
    return (f"Of the draws of objects, a program has {mean_of_programs(lives)} refined on average, counted in the last half of "
            f"its frames. {together}")
