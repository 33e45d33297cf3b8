// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Makes corner normals from positions, on the GPU, for meshes without normals (--normals geometry). The normals are a
// function of the positions in the draw: all passes that draw the same triangles get the same bits.
#pragma once

#include <array>
#include <cstdint>

#include "glark/core/capture/coarse_triangles.h"
#include "glark/core/capture/layout.h"
#include "glark/core/objects/programs/compilation.h"
#include "glark/core/objects/programs/compute_pass.h"
#include "glark/gl/dispatch.h"

namespace glark::weld {

struct GeometryNormalsRequest {
  const capture::Layout* layout = nullptr;  // its normal is written
  capture::CoarseTriangles triangles;
  GLint keys = 0;           // number of WeldRequest::key_words
  GLint key_offset = 0;     // of them, in words of the tables
  float crease = 0;         // degrees; faces that meet at more keep their own normals
  std::uint64_t slots = 0;  // of the table: 4 or more for each triangle
};

class GeometryNormals {
 public:
  GeometryNormals(core::Compilation& compilation, capture::Language language)
      : gl_(compilation.gl()), compilation_(compilation), language_(language) {}

  bool built() const { return passes_.back().built(); }
  // Compiles the passes when first called. Rare path: wrap in an ErrorScope.
  bool build();
  // Takes the storage buffers that WeldStage::run() binds. The table needs 2 words for each slot and 6 for each triangle.
  void run(const GeometryNormalsRequest& request) const;
  void release();

 private:
  const gl::Dispatch& gl_;
  core::Compilation& compilation_;
  capture::Language language_;
  std::array<core::ComputePass, 3> passes_;  // clear, link, write
};

}  // namespace glark::weld
