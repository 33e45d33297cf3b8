// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The interactive viewer.
#pragma once

#include <optional>
#include <string>

#include "glark/clients/geometry/geometry.h"
#include "glark/tool/view/scene.h"

namespace glark::tool {

struct ViewOptions {
  std::optional<Mode> mode;
  std::optional<float> yaw, pitch, zoom;
  std::optional<bool> z_is_up;
  int width = 1024;
  int height = 768;
  int level = 2;  // the level of refinement
  bool cull = true;
};

Camera camera_for(const Scene& scene, const ViewOptions& options);

// Returns when the window is closed. Throws std::runtime_error if there is no display.
void show_window(const std::string& title, geometry::Geometry geometry, const ViewOptions& options);

}  // namespace glark::tool
