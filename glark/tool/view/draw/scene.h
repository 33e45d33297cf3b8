// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Draws points as splats, surfel strips, the triangles of the file, or these with their maps. All but the maps use the
// fixed functions of OpenGL, whose triangles the extension refines.
#pragma once

#include <glark/surfel.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "glark/clients/geometry/geometry.h"
#include "glark/tool/view/draw/draw_settings.h"
#include "glark/tool/view/draw/mapped_mesh.h"
#include "glark/tool/view/draw/patterns.h"

namespace glark::tool {

struct Statistics {
  std::size_t draws = 0;
  std::size_t indices = 0;
  std::size_t points = 0;
  std::size_t strips = 0;
  std::size_t nodes_visited = 0;
  std::size_t nodes_out_of_frustum = 0;
  std::size_t nodes_back_facing = 0;
  PatternCounts patterns;             // of the mode `patterns`
  std::size_t refined_triangles = 0;  // of the mode `patterns` and displaced maps, as OpenGL counts them
};

void clear_window();

class Scene {
 public:
  // An OpenGL context must be current during the scene's lifetime.
  explicit Scene(geometry::Geometry geometry, const std::optional<Maps>& maps = {});
  ~Scene();
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  Mode default_mode() const;
  MapsShown most_maps() const;
  Camera default_camera() const;
  // Clears nothing. It draws as many maps as there are and the settings want; without maps, by the settings' mode.
  Statistics draw(const Camera& camera, const DrawSettings& settings, const Part& part);
  // Colours the points by their distances, blue at 0 to red at `greatest`; in the unit of the positions.
  void colour_by(std::span<const float> distances, float greatest);
  // Replaces positions, normals and colours (red green blue alpha; may be empty). The number of points may change if
  // there are no triangles. The same number keeps its strips, which follow the points; they are for settings without
  // culling, then.
  void replace_points(std::vector<float> positions, std::vector<float> normals, std::vector<std::uint8_t> colours);
  std::size_t point_count() const { return geometry_.point_count(); }

 private:
  void add_missing_normals();
  void colour_by_height();
  void upload();
  void upload_again();
  void make_strips();
  void bind() const;
  void set_up(const Camera& camera, const Look& look, const Part& part) const;
  void set_light(const Look& look) const;
  void refine(const DrawSettings& settings) const;
  void draw_splats(const Camera& camera, int height) const;
  void draw_triangles() const;
  const surfel::Frame& select_strips(const Camera& camera, const DrawSettings& settings, const Part& part);
  Statistics draw_strips(const Camera& camera, const DrawSettings& settings, const Part& part);
  Statistics draw_patterns(const Camera& camera, const DrawSettings& settings, const Part& part);

  geometry::Geometry geometry_;
  glm::vec3 low_{}, high_{};
  float spacing_ = 0;  // the approximate distance of neighbouring points
  bool has_lighting_ = false;
  std::unique_ptr<MappedMesh> mapped_;  // or none
  std::optional<surfel::Strips> strips_;
  surfel::Frame frame_;
  std::uint32_t points_buffer_ = 0;
  std::uint32_t triangles_buffer_ = 0;
  std::uint32_t strips_buffer_ = 0;
};

}  // namespace glark::tool
