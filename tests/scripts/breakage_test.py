# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Pictures that are broken on purpose, and pictures that refinement may make: the numbers tell one from the other.

With the argument --report it prints, for each kind of picture, how many of 40 random ones each number finds.
"""
import pathlib
import sys
import unittest

try:
    import numpy
except ModuleNotFoundError:
    sys.exit(77)  # the test is skipped

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent.parent / "scripts" / "parts" / "strangers"))
from breakage import breakage, curved, exact

HEIGHT, WIDTH = 180, 240
ROWS, COLUMNS = numpy.mgrid[0:HEIGHT, 0:WIDTH]
NAMES = ("vanished", "appeared", "stripes", "strays", "thin")


class Scene:
    """A background with a gradient, and objects: where they are, and their colours."""

    def __init__(self, seed: int) -> None:
        self.random = numpy.random.default_rng(seed)
        low, high = self.random.integers(10, 60, 3), self.random.integers(60, 110, 3)
        share = (ROWS / HEIGHT)[..., None]
        self.picture = low * (1 - share) + high * share
        self.colour = self.random.integers(150, 250, 3)

    def fill(self, where: numpy.ndarray, colour) -> "Scene":
        self.picture = numpy.where(where[..., None], colour, self.picture)
        return self

    def pixels(self) -> numpy.ndarray:
        return numpy.clip(self.picture, 0, 255).astype(numpy.uint8)


def disc(radius: float, x: float = 120, y: float = 90) -> numpy.ndarray:
    return (COLUMNS - x) ** 2 + (ROWS - y) ** 2 < radius ** 2


def polygon(radius: float, corners: int) -> numpy.ndarray:
    """A regular polygon about the middle."""
    angles = numpy.arctan2(ROWS - 90, COLUMNS - 120) % (2 * numpy.pi / corners) - numpy.pi / corners
    return numpy.hypot(ROWS - 90, COLUMNS - 120) * numpy.cos(angles) < radius * numpy.cos(numpy.pi / corners)


def bar(x: float, width: float) -> numpy.ndarray:
    return (numpy.abs(COLUMNS - x) < width / 2) & (numpy.abs(ROWS - 90) < 70)


def shading(radius: float) -> numpy.ndarray:
    """Diffuse light on a ball."""
    height = numpy.sqrt(numpy.maximum(radius ** 2 - (COLUMNS - 120.0) ** 2 - (ROWS - 90.0) ** 2, 0))
    return numpy.clip((height + 0.5 * (COLUMNS - 120)) / radius, 0.1, 1)[..., None]


def facets(radius: float) -> numpy.ndarray:
    """The same light, constant over tiles of 8 pixels."""
    return shading(radius)[numpy.minimum(ROWS // 8 * 8 + 4, HEIGHT - 1), COLUMNS // 8 * 8 + 4]


def pair(make):
    """Makes a maker of a plain and a refined picture from a function that paints both scenes."""
    def made(seed: int) -> tuple:
        plain, refined = Scene(seed), Scene(seed)
        make(plain, refined, plain.random)
        return plain.pixels(), refined.pixels()
    return made


def object_gone(plain, refined, random):
    plain.fill(disc(random.integers(20, 60)), plain.colour)


def object_came(plain, refined, random):
    refined.fill(disc(random.integers(20, 60)), plain.colour)


def stick_gone(plain, refined, random):
    plain.fill(bar(120, random.integers(3, 6)), plain.colour)


def pole_swollen(plain, refined, random):
    width = random.integers(3, 6)
    plain.fill(bar(120, width), plain.colour)
    refined.fill(bar(120, 10 * width), plain.colour)


def fight(pattern):
    def paint(plain, refined, random):
        radius = random.integers(35, 60)
        plain.fill(disc(radius), plain.colour)
        refined.fill(disc(radius), plain.colour).fill(disc(radius - 4) & pattern(random), plain.colour * 0.4)
    return paint


def stripes(random):
    return (COLUMNS + random.integers(0, 2) * ROWS) % 4 < 2


def noise(random):
    return random.random((HEIGHT, WIDTH)) < 0.5


def cracks(plain, refined, random):
    """Pixels between triangles through which the background is seen."""
    for scene in (plain, refined):
        scene.fill(disc(60), plain.colour * shading(60))
    holes = (random.random((HEIGHT, WIDTH)) < 0.05) & (COLUMNS % 20 == 0) & disc(45, 130)
    refined.fill(holes, plain.picture[0, 0])


def black_triangle(plain, refined, random):
    for scene in (plain, refined):
        scene.fill(disc(60), plain.colour)
    refined.fill((COLUMNS > 110) & (ROWS > 70) & (COLUMNS + ROWS < 210 + random.integers(0, 20)), 0)


def tiles():
    """Tiles of 26 pixels with gaps between them."""
    return (COLUMNS % 30 < 26) & (ROWS % 30 < 26)


def poked_through(plain, refined, random):
    """The dark body behind the tiles pokes through them. Its colour is known from the gaps."""
    x, y = random.integers(8, 16, 2)
    for scene in (plain, refined):
        scene.fill(disc(200), plain.colour * 0.2).fill(tiles(), plain.colour)
    refined.fill((COLUMNS % 30 - x) ** 2 + 2 * (ROWS % 30 - y) ** 2 < 25, plain.colour * 0.2)


def spots_moved(plain, refined, random):
    """Dark spots of a texture move by four pixels."""
    for scene, shift in ((plain, 0), (refined, 4)):
        spots = ((COLUMNS + shift) % 30 - 15) ** 2 + (ROWS % 30 - 15) ** 2 < random.integers(20, 21)
        scene.fill(disc(60), plain.colour).fill(spots & disc(50), plain.colour * 0.2)


def wires(spacing: int) -> numpy.ndarray:
    return (COLUMNS % spacing < 2) | (ROWS % spacing < 2)


def wires_sank(plain, refined, random):
    """Wires over a ball: where it bulges, they lie inside it."""
    spacing = random.integers(12, 20)
    for scene, hidden in ((plain, 0), (refined, random.integers(35, 50))):
        scene.fill(disc(60), plain.colour * shading(61)).fill(disc(58) & ~disc(hidden) & wires(spacing), 20)


def small_balls_gone(plain, refined, random):
    """Balls of five pixels on a surface of several colours that occur nearby."""
    balls = ((COLUMNS % 24 - 12) ** 2 + (ROWS % 24 - 12) ** 2 < 7) & disc(70)
    for scene in (plain, refined):
        scene.fill(disc(70), plain.colour).fill((COLUMNS // 24 + ROWS // 24) % 2 == 0, plain.colour * 0.5)
    plain.fill(balls, 20)
    refined.fill(balls & (COLUMNS < random.integers(60, 90)), 20)


def wires_kept(plain, refined, random):
    """Wires over a ball that becomes round, and moves some of them by up to three pixels."""
    bulge = numpy.where(disc(58), 3 * (1 - numpy.hypot(ROWS - 90, COLUMNS - 120) / 58), 0)
    plain.fill(polygon(60, 12), plain.colour * shading(61)).fill(disc(56) & wires(16), 20)
    refined.fill(disc(60), plain.colour * shading(61))
    refined.fill(disc(56) & (((COLUMNS + bulge) % 16 < 2) | (ROWS % 16 < 2)), 20)


def unchanged(plain, refined, random):
    for scene in (plain, refined):
        scene.fill(disc(50), plain.colour)


def rounded(plain, refined, random):
    corners = int(random.integers(10, 24))
    plain.fill(polygon(60, corners), plain.colour * shading(61))
    refined.fill(disc(60), plain.colour * shading(61))


def smooth_light(plain, refined, random):
    plain.fill(disc(50), plain.colour * facets(61))
    refined.fill(disc(50), plain.colour * shading(61))


def highlight(plain, refined, random):
    """The light's reflection appears in the middle of a large triangle."""
    x, size = random.integers(100, 140), random.integers(12, 20)
    light = numpy.exp(-((COLUMNS - x) ** 2 + (ROWS - 80) ** 2) / (2 * size ** 2))[..., None]
    plain.fill(disc(60), 0.5 * plain.colour)
    refined.fill(disc(60), 0.5 * plain.colour + 100 * light)


def texture_moved(plain, refined, random):
    """A textured surface bulges: its texture moves by up to three pixels."""
    checks = lambda shift: ((COLUMNS + shift).astype(int) // 6 + ROWS // 6) % 2
    bulge = numpy.where(disc(58), 3 * (1 - numpy.hypot(ROWS - 90, COLUMNS - 120) / 58), 0)
    for scene, shift in ((plain, 0 * bulge), (refined, bulge)):
        scene.fill(disc(60), plain.colour * (0.6 + 0.4 * checks(shift))[..., None])


def lit_texture(plain, refined, random):
    """A highlight on a texture with sharp edges."""
    x, size = random.integers(100, 140), random.integers(12, 20)
    light = numpy.exp(-((COLUMNS - x) ** 2 + (ROWS - 80) ** 2) / (2 * size ** 2))[..., None]
    texture = numpy.where((COLUMNS // 9 + ROWS // 9) % 2, 1.0, 0.2)[..., None]
    plain.fill(disc(60), 0.4 * plain.colour * texture)
    refined.fill(disc(60), (0.4 * plain.colour + 130 * light) * texture)


def rounding(plain, refined, random):
    """A vertical edge moves by a pixel, and colours by a level."""
    plain.fill(COLUMNS < 100, plain.colour)
    refined.fill(COLUMNS < 101, plain.colour - 1)


BROKEN = {
    "object gone": (object_gone, "vanished"), "object came": (object_came, "appeared"), "stick gone": (stick_gone, "vanished"),
    "pole swollen": (pole_swollen, "appeared"), "stripes": (fight(stripes), "stripes"), "noise": (fight(noise), "stripes"),
    "cracks": (cracks, "strays"), "black triangle": (black_triangle, "appeared"),
    "poked through": (poked_through, "appeared"), "wires sank": (wires_sank, "thin"),
    "small balls gone": (small_balls_gone, "thin"),
}
HEALTHY = {function.__name__.replace("_", " "): function for function in
           (unchanged, rounded, smooth_light, highlight, lit_texture, texture_moved, spots_moved, wires_kept, rounding)}


def counts(paint, seed: int, allowance) -> dict:
    plain, refined = pair(paint)(seed)
    return dict(zip(NAMES, breakage(plain, refined, allowance).counts()))


class Breakage(unittest.TestCase):
    def test_finds_what_is_broken(self):
        for name, (paint, number) in BROKEN.items():
            for seed in range(3):
                with self.subTest(picture=name, seed=seed):
                    self.assertGreater(counts(paint, seed, curved(WIDTH, HEIGHT))[number], 0)

    def test_outputs_allow_no_breakage_either(self):
        for name, (paint, number) in BROKEN.items():
            with self.subTest(picture=name):
                self.assertGreater(sum(counts(paint, 1, exact()).values()), 0)

    def test_healthy_curves_count_nothing(self):
        for name, paint in HEALTHY.items():
            for seed in range(3):
                with self.subTest(picture=name, seed=seed):
                    self.assertEqual(dict.fromkeys(NAMES, 0), counts(paint, seed, curved(WIDTH, HEIGHT)))

    def test_outputs_may_round_an_edge(self):
        self.assertEqual(dict.fromkeys(NAMES, 0), counts(rounding, 1, exact()))

    def test_outputs_may_not_change_light(self):
        self.assertGreater(counts(lit_texture, 1, exact())["appeared"], 0)
        self.assertGreater(counts(highlight, 1, exact())["appeared"], 0)

    def test_outputs_may_not_round_a_ball(self):
        paint = lambda plain, refined, random: (plain.fill(polygon(60, 6), plain.colour), refined.fill(disc(60), plain.colour))
        self.assertGreater(counts(paint, 1, exact())["appeared"], 0)


def report() -> None:
    kinds = {**{name: paint for name, (paint, _) in BROKEN.items()}, **HEALTHY}
    for name, paint in kinds.items():
        found = [counts(paint, seed, curved(WIDTH, HEIGHT)) for seed in range(40)]
        print(name, *(f"{number} {sum(f[number] > 0 for f in found)}" for number in NAMES), sep=" | ")


if __name__ == "__main__":
    if "--report" in sys.argv:
        report()
    else:
        unittest.main()
