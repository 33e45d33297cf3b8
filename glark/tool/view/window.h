// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The interactive viewer.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "glark/clients/geometry/geometry.h"
#include "glark/tool/view/draw/scene.h"

namespace glark::tool {

struct ViewOptions {
  std::optional<Mode> mode;
  std::optional<MapsShown> maps;
  std::optional<float> yaw, pitch, zoom;
  std::optional<bool> z_is_up;
  int width = 1024;
  int height = 768;
  bool has_depth = false;  // the settings' level or edge_pixels is given
  DrawSettings settings;
};

// A model of a file, before there is a context.
struct Model {
  geometry::Geometry geometry;
  std::vector<float> distances;  // of the points from a reference, or empty
  std::optional<Maps> maps;
};

using Scenes = std::vector<std::unique_ptr<Scene>>;

// The most maps that one of the scenes has.
MapsShown most_maps(const Scenes& scenes);
// How the scenes are drawn first.
DrawSettings settings_for(const Scenes& scenes, const ViewOptions& options);

Camera camera_for(const Scene& scene, const ViewOptions& options);
// The part of the window for model `index` of `count`, side by side.
Part part_of(std::size_t index, std::size_t count, int width, int height);
// The greatest distance of the colours: that of 98 % of the points.
float greatest_shown(std::vector<float> distances);

// Returns when the window is closed. Throws std::runtime_error if there is no display.
void show_window(const std::string& title, std::vector<Model> models, const ViewOptions& options);

}  // namespace glark::tool
