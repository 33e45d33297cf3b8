// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Surfel strips: the time to build and to update them, how well neighbouring leaves match, and culled frames compared
// with all strips.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <memory>
#include <numeric>

#include "tests/bench/cases/case.h"
#include "tests/bench/gl.h"
#include "tests/surfel/clouds.h"

namespace glark::bench {
namespace {

using surfel::Frame;
using surfel::Strips;
using surfel::View;
using surfel::test::Points;

void report_build(Report& report, const std::string& name, const Points& points, const Effort& effort) {
  // Measures seconds of CPU time, because others may use the machine, too.
  double least = 1e9;
  std::unique_ptr<Strips> strips;
  for (int round = 0; round < effort.fewest_rounds; ++round) {
    strips.reset();
    const std::clock_t start = std::clock();
    strips = std::make_unique<Strips>(points.cloud(), surfel::Options{.threads = 1});
    least = std::min(least, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  const auto count = static_cast<double>(points.size());
  report.add({"surfel/build/" + name,
              "thesis 0.021 M/s",
              Goal::at_least,
              0.7,
              count / least / 1e6,
              "M/s",
              {{"points", count}}});
  const surfel::Counts counts = strips->counts();
  report.add({"surfel/indices/" + name,
              "",
              Goal::at_most,
              1.2,
              static_cast<double>(counts.indices) / static_cast<double>(counts.valid),
              "per triangle",
              {{"outer", static_cast<double>(counts.outer)},
               {"redundant", static_cast<double>(counts.redundant)},
               {"dual", static_cast<double>(counts.dual)},
               {"valid", static_cast<double>(counts.valid)}}});
  const surfel::test::Edges edges = surfel::test::count_edges(*strips);
  const auto matched = static_cast<double>(edges.border_matched);
  report.add({"surfel/match/" + name,
              "thesis > 99 %",
              Goal::at_least,
              99.5,
              100 * matched / (matched + static_cast<double>(edges.border_other)),
              "%",
              {}});
}

// Pulls the highest 5 % of 76 000 points up, a little more each time.
void report_update(Report& report, const Effort& effort) {
  Points points = surfel::test::sphere(76000);
  const Points rest = points;
  std::vector<std::uint32_t> moved(points.size() / 20);
  std::iota(moved.begin(), moved.end(), 0U);  // the points of the sphere begin at its top
  Strips strips(points.cloud(), {.threads = 1});
  int turn = 0;
  const auto times = interleave({{[] {},
                                  [&] {
                                    const float by = 0.05F * static_cast<float>(++turn % 8);
                                    for (const std::uint32_t i : moved) {
                                      const float z = rest.positions[3 * i + 2];
                                      points.positions[3 * i + 2] = z + by * (z - 0.9F);
                                    }
                                    strips.update(points.cloud(), moved);
                                  }}},
                                effort);
  report.add({"surfel/update/5-percent", "thesis 180 ms", Goal::at_most, 8, times[0].least() * 1e3, "ms", {}});
}

// Returns a view from a point towards the middle of the cloud. The cloud lies around the origin and has the radius 1.
View view_from(float x, float y, float z, float slope) {
  const float distance = std::sqrt(x * x + y * y + z * z);
  const float f[3] = {-x / distance, -y / distance, -z / distance};
  const float across = std::hypot(f[0], f[2]);
  const float s[3] = {-f[2] / across, 0, f[0] / across};
  const float u[3] = {s[1] * f[2] - s[2] * f[1], s[2] * f[0] - s[0] * f[2], s[0] * f[1] - s[1] * f[0]};
  const float eye[3] = {x, y, z};
  const float near = 0.01F, far = 1000, a = (far + near) / (far - near), b = -2 * far * near / (far - near);
  View view{.width = 256, .height = 256};
  auto& m = view.clip_from_object;
  m[14] = b;
  for (std::size_t k = 0; k < 3; ++k) {
    m[4 * k] = s[k] / slope;
    m[4 * k + 1] = u[k] / slope;
    m[4 * k + 2] = a * f[k];
    m[4 * k + 3] = f[k];
    for (std::size_t row = 0; row < 4; ++row) m[12 + row] -= m[4 * k + row] * eye[k];
  }
  return view;
}

void report_frame(Report& report, const std::string& name, const Points& points, const View& view, double goal,
                  const Effort& effort) {
  const Strips strips(points.cloud(), {.levels = 5});
  GLuint buffers[3];
  glGenBuffers(3, buffers);
  const auto upload = [](GLenum target, GLuint buffer, auto values) {
    glBindBuffer(target, buffer);
    glBufferData(target, static_cast<GLsizeiptr>(values.size_bytes()), values.data(), GL_STATIC_DRAW);
  };
  upload(GL_ELEMENT_ARRAY_BUFFER, buffers[0], strips.indices());
  upload(GL_ARRAY_BUFFER, buffers[1], std::span(points.positions));
  glVertexPointer(3, GL_FLOAT, 0, nullptr);
  upload(GL_ARRAY_BUFFER, buffers[2], std::span(points.normals));
  glNormalPointer(GL_FLOAT, 0, nullptr);
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_NORMAL_ARRAY);
  for (const GLenum what : {GL_CULL_FACE, GL_LIGHTING, GL_LIGHT0}) glEnable(what);
  glMatrixMode(GL_PROJECTION);
  glPushMatrix();
  glLoadMatrixf(view.clip_from_object.data());
  Frame frame;
  const auto draw = [&](const View& chosen) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    strips.select(chosen, frame);
    glMultiDrawElements(GL_TRIANGLE_STRIP, frame.counts.data(), GL_UNSIGNED_INT, frame.offsets.data(), frame.draws());
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
    glDrawElements(GL_POINTS, static_cast<GLsizei>(frame.points.size()), GL_UNSIGNED_INT, frame.points.data());
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[0]);
    glFinish();
  };
  View all = view;
  all.cull_frustum = all.cull_back_faces = false;
  all.point_pixels = all.level_pixels = 0;
  const auto times = interleave({{[] {}, [&] { draw(all); }}, {[] {}, [&] { draw(view); }}}, effort);
  strips.select(view, frame);
  report.add({"surfel/frame/" + name,
              "thesis up to 2x",
              Goal::at_least,
              goal,
              speed_ratio(times[0], times[1]),
              "x",
              {{"strips", static_cast<double>(frame.strips)},
               {"points", static_cast<double>(frame.points.size())},
               {"level", static_cast<double>(frame.level)}}});
  glPopMatrix();
  for (const GLenum what : {GL_CULL_FACE, GL_LIGHTING, GL_LIGHT0}) glDisable(what);
  glDisableClientState(GL_VERTEX_ARRAY);
  glDisableClientState(GL_NORMAL_ARRAY);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
  glDeleteBuffers(3, buffers);
}

// Scales the cloud into the cube around the origin, for which the views are made.
Points scaled(Points points) {
  std::array<float, 3> low{1e30F, 1e30F, 1e30F}, high{-1e30F, -1e30F, -1e30F};
  for (std::size_t i = 0; i < points.positions.size(); ++i) {
    low[i % 3] = std::min(low[i % 3], points.positions[i]);
    high[i % 3] = std::max(high[i % 3], points.positions[i]);
  }
  const float size = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  for (std::size_t i = 0; i < points.positions.size(); ++i) {
    points.positions[i] = (2 * points.positions[i] - low[i % 3] - high[i % 3]) / size;
  }
  return points;
}

void run_scan(const std::string& name, Report& report, const Effort& effort) {
  const auto points = surfel::test::scan(name);
  if (!points) {
    report.note("surfel: " + name + ".ply.zst is not in ../shared/data, or zstd is missing");
    return;
  }
  report_build(report, name, *points, effort);
}

}  // namespace

void add_surfel_cases(std::vector<Case>& cases) {
  cases.push_back({"surfel/build/sphere", [](Report& report, const Effort& effort) {
                     report_build(report, "sphere", surfel::test::sphere(100000), effort);
                   }});
  for (const std::string name : {"igea", "horse", "bunny", "armadillo", "nefertiti", "bunny_scans"}) {
    cases.push_back(
        {"surfel/build/" + name, [name](Report& report, const Effort& effort) { run_scan(name, report, effort); }});
  }
  cases.push_back({"surfel/update", report_update});
  cases.push_back({"surfel/frame", [](Report& report, const Effort& effort) {
                     const auto scan = surfel::test::scan("igea");
                     const Points points = scan ? scaled(*scan) : surfel::test::sphere(134000);
                     report_frame(report, "oblique-close", points, view_from(0.9F, 0.5F, 1.0F, 0.4F), 2, effort);
                     report_frame(report, "far", points, view_from(4, 3, 12, 0.6F), 5, effort);
                   }});
}

}  // namespace glark::bench
