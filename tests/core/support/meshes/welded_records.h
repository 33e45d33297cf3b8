// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The welding stage alone: welds a mesh without drawing it, and reads the control points of its edges back.
#pragma once

#include <bit>

#include "glark/core/weld/weld.h"
#include "glark/gl/dispatch.h"
#include "tests/core/support/meshes/split_meshes.h"

namespace glark::core::test {

// The control points of a half-edge, times 3, less those of the straight edge.
struct WeldedEdge {
  Vector from{};
  Vector to{};
  Vector near_from{};  // the offset of the control point next to `from`
  Vector near_to{};
  std::size_t triangle = 0;

  bool is_straight() const { return near_from == Vector{} && near_to == Vector{}; }
};
using WeldedMesh = std::vector<WeldedEdge>;  // a half-edge for each corner

inline GLfloat length(const Vector& v) { return std::hypot(v[0], v[1], v[2]); }
inline bool same_bits(const Vector& a, const Vector& b) {
  using Bits = std::array<std::uint32_t, 3>;
  return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}
inline bool same_offsets(const WeldedEdge& a, const WeldedEdge& b) {
  return same_bits(a.near_from, b.near_from) && same_bits(a.near_to, b.near_to);
}

// Counts the half-edges whose offsets differ.
inline int changed_edges(const WeldedMesh& a, const WeldedMesh& b) {
  EXPECT_EQ(a.size(), b.size());
  int changed = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) changed += same_offsets(a[i], b[i]) ? 0 : 1;
  return changed;
}

inline int bent_edges(const WeldedMesh& mesh) {
  return static_cast<int>(
      std::count_if(mesh.begin(), mesh.end(), [](const WeldedEdge& edge) { return !edge.is_straight(); }));
}

inline GLfloat greatest_offset(const WeldedMesh& mesh) {
  GLfloat greatest = 0;
  for (const WeldedEdge& edge : mesh) greatest = std::max({greatest, length(edge.near_from), length(edge.near_to)});
  return greatest;
}

// Twice the area, divided by the longest edge.
inline double least_height(const Vector& a, const Vector& b, const Vector& c) {
  std::array<double, 3> first{};
  std::array<double, 3> second{};
  for (std::size_t i = 0; i < 3; ++i) {
    first[i] = double{b[i]} - a[i];
    second[i] = double{c[i]} - a[i];
  }
  const auto size = [](const std::array<double, 3>& v) { return std::hypot(v[0], v[1], v[2]); };
  const double longest = std::max({size(first), size(second), double{length(minus(c, b))}});
  const std::array<double, 3> across{first[1] * second[2] - first[2] * second[1],
                                     first[2] * second[0] - first[0] * second[2],
                                     first[0] * second[1] - first[1] * second[0]};
  return longest > 0 ? size(across) / longest : 0;
}

class WeldedRecords {
 public:
  explicit WeldedRecords(const gl::Dispatch& gl) : gl_(gl), stage_(compilation_, capture::Language::compatibility) {
    gl_.GenBuffers(2, buffers_);
    layout_ = capture::make_layout({{.name = "p", .type = GL_FLOAT_VEC3, .role = capture::Role::position},
                                    {.name = "n", .type = GL_FLOAT_VEC3, .role = capture::Role::normal}},
                                   false, {.controls = true});
  }
  ~WeldedRecords() {
    stage_.release();
    gl_.DeleteBuffers(2, buffers_);
  }
  WeldedRecords(const WeldedRecords&) = delete;
  WeldedRecords& operator=(const WeldedRecords&) = delete;

  WeldedMesh weld(const SplitMesh& mesh, float crease) {
    const weld::WeldPlan plan{.on = true, .crease = crease};
    std::vector<GLfloat> welded = upload(mesh);
    run(plan, mesh);
    gl_.BindBuffer(GL_SHADER_STORAGE_BUFFER, buffers_[0]);
    gl_.GetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, static_cast<GLsizeiptr>(welded.size() * sizeof(GLfloat)),
                         welded.data());
    WeldedMesh edges;
    for (std::size_t corner = 0; corner < mesh.vertices.size(); ++corner) {
      const std::size_t next = corner % 3 == 2 ? corner - 2 : corner + 1;
      const Vector& from = mesh.vertices[corner].position;
      const Vector& to = mesh.vertices[next].position;
      edges.push_back({from, to, offset(welded, corner, 0, from, to), offset(welded, next, 3, to, from), corner / 3});
    }
    return edges;
  }

 private:
  std::vector<GLfloat> upload(const SplitMesh& mesh) {
    const auto words = static_cast<std::size_t>(layout_.corner_words);
    std::vector<GLfloat> records(words * mesh.vertices.size());
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
      std::copy_n(mesh.vertices[i].position.begin(), 3, records.begin() + static_cast<std::ptrdiff_t>(i * words));
      std::copy_n(mesh.vertices[i].normal.begin(), 3, records.begin() + static_cast<std::ptrdiff_t>(i * words + 3));
    }
    const auto bytes = static_cast<GLsizeiptr>(records.size() * sizeof(GLfloat));
    gl_.BindBuffer(GL_SHADER_STORAGE_BUFFER, buffers_[1]);
    gl_.BufferData(GL_SHADER_STORAGE_BUFFER, sizeof(capture::CountCommand), nullptr, GL_STATIC_DRAW);
    gl_.BindBuffer(GL_SHADER_STORAGE_BUFFER, buffers_[0]);
    gl_.BufferData(GL_SHADER_STORAGE_BUFFER, bytes, records.data(), GL_STATIC_DRAW);
    return records;
  }
  void run(const weld::WeldPlan& plan, const SplitMesh& mesh) {
    const auto triangles = static_cast<std::uint32_t>(mesh.triangles());
    EXPECT_TRUE(stage_.reserve(plan, layout_, triangles));
    weld::WeldRequest request;
    request.plan = &plan;
    request.layout = &layout_;
    request.triangles = {buffers_[0], 0, triangles};
    request.edges = true;
    stage_.run(request, buffers_[1]);
  }
  Vector offset(const std::vector<GLfloat>& records, std::size_t corner, std::size_t behind, const Vector& near,
                const Vector& far) const {
    const std::size_t at = corner * static_cast<std::size_t>(layout_.corner_words) +
                           static_cast<std::size_t>(layout_.control_offset) + behind;
    Vector result{};
    for (std::size_t i = 0; i < 3; ++i) result[i] = records[at + i] - (2 * near[i] + far[i]);
    return result;
  }

  const gl::Dispatch& gl_;
  core::Compilation compilation_{gl_};
  weld::WeldStage stage_;
  capture::Layout layout_;
  GLuint buffers_[2] = {};
};

}  // namespace glark::core::test
