// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "tests/shapes/parts.h"

#include <algorithm>
#include <utility>

#include "tests/shapes/part_builder.h"

namespace glark::shapes {
namespace {

class Numbers {
 public:
  explicit Numbers(unsigned seed) : random_(seed) {}
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }

 private:
  std::mt19937 random_;
};

Point around(double radius, double angle, double z) { return {radius * std::cos(angle), radius * std::sin(angle), z}; }

// Adds a box. `fillet` is the radius of its edges; `flat` and `bent` are the divisions of a face and of a fillet.
void add_box(PartBuilder& builder, const Point& middle, const Point& half, double fillet, int flat, int bent) {
  std::array<std::vector<double>, 3> lines;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double inner = half[axis] - fillet;
    for (int i = 0; i < bent; ++i) lines[axis].push_back(-inner - fillet * std::tan(pi / 4 * (bent - i) / bent));
    for (int i = 0; i <= flat; ++i) lines[axis].push_back(inner * (2.0 * i / flat - 1));
    for (int i = 1; i <= bent; ++i) lines[axis].push_back(inner + fillet * std::tan(pi / 4 * i / bent));
  }
  const auto rounded = [&](const Point& cube) {
    Point inner{}, out{};
    for (std::size_t i = 0; i < 3; ++i) {
      inner[i] = std::clamp(cube[i], fillet - half[i], half[i] - fillet);
      out[i] = cube[i] - inner[i];
    }
    const double length = std::hypot(out[0], out[1], out[2]);
    for (std::size_t i = 0; i < 3; ++i) inner[i] += middle[i] + (length > 0 ? out[i] * fillet / length : 0);
    return inner;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::vector<double>&u = lines[(axis + 1) % 3], &v = lines[(axis + 2) % 3];
    for (const double side : {-1.0, 1.0}) {
      const auto at = [&](double a, double b) {
        Point cube{};
        cube[axis] = side * half[axis];
        cube[(axis + 1) % 3] = u[static_cast<std::size_t>(std::lround(a * static_cast<double>(u.size() - 1)))];
        cube[(axis + 2) % 3] = v[static_cast<std::size_t>(std::lround(b * static_cast<double>(v.size() - 1)))];
        return rounded(cube);
      };
      builder.grid(static_cast<int>(u.size()) - 1, static_cast<int>(v.size()) - 1, at, side < 0);
    }
  }
}

// Adds the plate between two closed outlines, of thickness 2 * half. Points at equal angles belong together.
template <typename Outer, typename Inner>
void add_ring(PartBuilder& builder, const Outer& outer, const Inner& inner, double half, int around, int across,
              int high) {
  for (const double z : {half, -half})
    builder.grid(
        across, around, [&](double t, double a) { return between(inner(2 * pi * a, z), outer(2 * pi * a, z), t); },
        z < 0);
  const auto height = [half](double t) { return half * (2 * t - 1); };
  builder.grid(around, high, [&](double a, double t) { return outer(2 * pi * a, height(t)); });
  builder.grid(
      around, high, [&](double a, double t) { return inner(2 * pi * a, height(t)); }, true);
}

}  // namespace

Part box_with_fillets(unsigned seed, int detail) {
  Numbers numbers(seed);
  PartBuilder builder;
  const Point half{1, numbers.between(0.3, 0.8), numbers.between(0.15, 0.4)};
  add_box(builder, {}, half, numbers.between(0.03, 0.12), 14 * detail, 5 * detail);
  return builder.take();
}

Part gear(unsigned seed, int detail) {
  Numbers numbers(seed);
  const int teeth = numbers.whole(12, 24);
  const double depth = numbers.between(0.08, 0.16), hole = numbers.between(0.2, 0.4);
  const auto outer = [=](double angle, double z) {
    const double phase = std::fmod(angle * teeth / (2 * pi), 1.0);
    const double rise =
        std::clamp(8 * std::abs(phase - 0.5) - 1.5, 0.0, 1.0);  // flat tips and grounds, straight flanks
    return around(1 - depth * rise, angle, z);
  };
  PartBuilder builder;
  add_ring(
      builder, outer, [=](double angle, double z) { return around(hole, angle, z); }, numbers.between(0.1, 0.3),
      16 * teeth * (detail + 1) / 2, 8 * detail, 4 * detail);
  return builder.take();
}

Part flange(unsigned seed, int detail) {
  Numbers numbers(seed);
  const int bolts = numbers.whole(4, 8), sides = 6 * detail, arcs = 10 * detail;
  const double inner = numbers.between(0.25, 0.4), bolt = numbers.between(0.08, 0.12),
               half = numbers.between(0.04, 0.1);
  const double middle = (1 + inner) / 2;
  PartBuilder builder;
  for (int k = 0; k < bolts; ++k) {
    const double first = 2 * pi * k / bolts, last = 2 * pi * (k + 1) / bolts;
    // The outline of the bolt's sector, and the points of the hole at the same parameter.
    std::vector<std::array<double, 2>> outline;  // radius, angle
    for (int i = 0; i < sides; ++i) outline.push_back({inner + (1 - inner) * i / sides, first});
    for (int i = 0; i < arcs; ++i) outline.push_back({1, first + (last - first) * i / arcs});
    for (int i = 0; i < sides; ++i) outline.push_back({1 - (1 - inner) * i / sides, last});
    for (int i = 0; i < arcs; ++i) outline.push_back({inner, last - (last - first) * i / arcs});
    const auto count = static_cast<int>(outline.size());
    const Point centre = around(middle, (first + last) / 2, 0);
    const auto outer_at = [&](double a, double z) {
      const auto& [radius, angle] = outline[static_cast<std::size_t>(std::lround(a * count)) % outline.size()];
      return around(radius, angle, z);
    };
    const auto hole_at = [&](double a, double z) {
      const Point there = outer_at(a, z);
      const double x = there[0] - centre[0], y = there[1] - centre[1], length = std::hypot(x, y);
      return Point{centre[0] + bolt * x / length, centre[1] + bolt * y / length, z};
    };
    for (const double z : {half, -half})
      builder.grid(
          5 * detail, count, [&](double t, double a) { return between(hole_at(a, z), outer_at(a, z), t); }, z < 0);
    const auto height = [half](double t) { return half * (2 * t - 1); };
    builder.grid(
        count, 3 * detail, [&](double a, double t) { return hole_at(a, height(t)); }, true);
    const double span = last - first;
    builder.grid(arcs, 3 * detail, [&](double a, double t) { return around(1, first + span * a, height(t)); });
    builder.grid(
        arcs, 3 * detail, [&](double a, double t) { return around(inner, first + span * a, height(t)); }, true);
  }
  return builder.take();
}

Part bracket(unsigned seed, int detail) {
  Numbers numbers(seed);
  const double wall = numbers.between(0.08, 0.2);
  const std::array<std::vector<double>, 3> lines{{{0, wall, numbers.between(0.4, 0.5), numbers.between(0.6, 0.8), 1.2},
                                                  {0, numbers.between(0.2, 0.3), numbers.between(0.5, 0.6), 0.8},
                                                  {0, wall, numbers.between(0.4, 0.6), 1}}};
  const auto is_solid = [&](int x, int y, int z) {
    if (x < 0 || y < 0 || z < 0 || x > 3 || y > 2 || z > 2) return false;
    const bool is_slot = y == 1 && (x == 2 || z == 1);
    return (z == 0 || x == 0) && !is_slot;
  };
  PartBuilder builder;
  const int divisions = 6 * detail;
  for (int x = 0; x < 4; ++x) {
    for (int y = 0; y < 3; ++y) {
      for (int z = 0; z < 3; ++z) {
        if (!is_solid(x, y, z)) continue;
        const std::array<int, 3> cell{x, y, z};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          for (const int side : {0, 1}) {
            std::array<int, 3> beside = cell;
            beside[axis] += 2 * side - 1;
            if (is_solid(beside[0], beside[1], beside[2])) continue;
            const auto along = [&](std::size_t i, double t) {
              const auto from = static_cast<std::size_t>(cell[i]);
              return lines[i][from] + t * (lines[i][from + 1] - lines[i][from]);
            };
            const auto at = [&](double a, double b) {
              Point point{};
              point[axis] = along(axis, side);
              point[(axis + 1) % 3] = along((axis + 1) % 3, a);
              point[(axis + 2) % 3] = along((axis + 2) % 3, b);
              return point;
            };
            builder.grid(divisions, divisions, at, side == 0);
          }
        }
      }
    }
  }
  return builder.take();
}

Part pipe(unsigned seed, int detail) {
  Numbers numbers(seed);
  const double bend = numbers.between(0.6, 1.2), outer = numbers.between(0.2, 0.3), angle = numbers.between(1, 2.5);
  const double inner = outer * numbers.between(0.8, 0.92);
  // t: along the pipe; first a straight piece, then the bend.
  const auto at = [=](double radius, double a, double t) {
    const double x = radius * std::cos(2 * pi * a), z = radius * std::sin(2 * pi * a);
    if (t < 0.3) return Point{bend + x, 2 * (t - 0.3), z};
    const double turn = angle * (t - 0.3) / 0.7;
    return Point{(bend + x) * std::cos(turn), (bend + x) * std::sin(turn), z};
  };
  PartBuilder builder;
  const int around = 32 * detail, along = 30 * detail;
  builder.grid(
      around, along, [&](double a, double t) { return at(outer, std::fmod(a, 1.0), t); }, true);
  builder.grid(around, along, [&](double a, double t) { return at(inner, std::fmod(a, 1.0), t); });
  for (const double end : {0.0, 1.0})
    builder.grid(
        around, detail, [&](double a, double t) { return at(inner + t * (outer - inner), std::fmod(a, 1.0), end); },
        end == 0);
  return builder.take();
}

Part cup(unsigned seed, int detail) {
  Numbers numbers(seed);
  const double wall = numbers.between(0.02, 0.06), height = numbers.between(0.8, 1.6),
               lean = numbers.between(-0.2, 0.3);
  PartBuilder builder;
  const int around_count = 48 * detail;
  const auto radius = [=](double z) { return 0.5 + lean * z / height; };
  const auto turned = [](double r, double a, double z) { return around(r, 2 * pi * std::fmod(a, 1.0), z); };
  builder.grid(around_count, 16 * detail,
               [&](double a, double t) { return turned(radius(t * height), a, t * height); });
  builder.grid(
      around_count, 16 * detail,
      [&](double a, double t) {
        const double z = wall + t * (height - wall);
        return turned(radius(z) - wall, a, z);
      },
      true);
  builder.grid(around_count, detail, [&](double a, double t) { return turned(radius(height) - t * wall, a, height); });
  builder.grid(around_count, 6 * detail, [&](double a, double t) { return turned(radius(0) * t, a, 0.0); });
  builder.grid(
      around_count, 6 * detail, [&](double a, double t) { return turned((radius(wall) - wall) * t, a, wall); }, true);
  return builder.take();
}

Part blob(unsigned seed, int detail) {
  Numbers numbers(seed);
  std::array<Point, 5> waves{};
  std::array<double, 5> sizes{};
  for (std::size_t i = 0; i < waves.size(); ++i) {
    waves[i] = {numbers.between(-4, 4), numbers.between(-4, 4), numbers.between(-4, 4)};
    sizes[i] = numbers.between(0.02, 0.08);
  }
  PartBuilder builder;
  const int divisions = 24 * detail;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      const auto at = [&](double a, double b) {
        Point point{};
        point[axis] = side;
        point[(axis + 1) % 3] = std::tan(pi / 4 * (2 * a - 1));
        point[(axis + 2) % 3] = std::tan(pi / 4 * (2 * b - 1));
        const double length = std::hypot(point[0], point[1], point[2]);
        for (double& number : point) number /= length;
        double radius = 1;
        for (std::size_t i = 0; i < waves.size(); ++i)
          radius += sizes[i] * std::sin(waves[i][0] * point[0] + waves[i][1] * point[1] + waves[i][2] * point[2]);
        for (double& number : point) number *= radius;
        return point;
      };
      builder.grid(divisions, divisions, at, side < 0);
    }
  }
  return builder.take();
}

Part cover(unsigned seed, int detail) {
  Numbers numbers(seed);
  const double u = numbers.between(1, 2), v = numbers.between(1, 2), high = numbers.between(0.1, 0.3);
  PartBuilder builder;
  const int sides = 10 * detail;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 3; ++row) {
      const double hole = numbers.between(0.1, 0.3);
      const auto bent = [&](double x, double y) {
        return Point{column + x, row + y, high * std::sin(u * (column + x)) * std::cos(v * (row + y))};
      };
      // a: around the tile; t: from the hole to the tile's outline.
      const auto at = [&](double t, double a) {
        const int step = static_cast<int>(std::lround(a * 4 * sides)) % (4 * sides);
        const double part = static_cast<double>(step % sides) / sides;
        const std::array<std::array<double, 2>, 4> outline{{{part, 0}, {1, part}, {1 - part, 1}, {0, 1 - part}}};
        const auto [x, y] = outline[static_cast<std::size_t>(step / sides)];
        const double length = std::hypot(x - 0.5, y - 0.5);
        const double hole_x = 0.5 + hole * (x - 0.5) / length, hole_y = 0.5 + hole * (y - 0.5) / length;
        return bent(hole_x + t * (x - hole_x), hole_y + t * (y - hole_y));
      };
      builder.grid(6 * detail, 4 * sides, at);
    }
  }
  return builder.take();
}

Part assembly(unsigned seed, int detail) {
  Numbers numbers(seed);
  PartBuilder builder;
  for (int x = 0; x < 4; ++x) {
    for (int y = 0; y < 4; ++y) {
      for (int z = 0; z < 3; ++z) {
        if (numbers.between(0, 1) < 0.35) continue;
        builder.begin_part();
        add_box(builder, {x + 0.5, y + 0.5, z + 0.5}, {0.5, 0.5, 0.5}, numbers.between(0, 1) < 0.5 ? 0 : 0.1,
                5 * detail, 2 * detail);
      }
    }
  }
  return builder.take();
}

}  // namespace glark::shapes
