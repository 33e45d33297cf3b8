// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A model with maps, as `glark bake` writes it: a glTF file of one mesh with one primitive whose material has a normal
// map, a texture of colours, or in its extras a displacement map.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "glark/clients/geometry/geometry.h"
#include "glark/tool/view/maps/picture.h"

namespace glark::tool {

// A point of the displaced surface is P + (scale h + bias) N / |N|, with h from 0 to 1.
struct Displacement {
  Heights heights;
  float scale = 1, bias = 0;  // in the unit of the positions
};

struct Maps {
  std::string file;                        // for messages
  std::vector<float> texture_coordinates;  // 2 per point; t = 0 is the upper edge of the pictures
  std::vector<float> tangents;             // 4 per point: right in the picture, and the sign of the bitangent
  std::optional<Picture> colours;
  std::optional<Picture> normals;  // in tangent space, with y up in the picture; only with tangents
  std::optional<Displacement> displacement;

  bool empty() const { return !colours && !normals && !displacement; }
};

struct MappedModel {
  geometry::Geometry geometry;  // with normals; the node's translation is the origin
  Maps maps;
};

struct MapsReading {
  std::optional<MappedModel> model;   // nothing: the file has no maps, or none that can be drawn
  std::vector<std::string> warnings;  // each names the file, the fault and the remedy
};

// Reads a .glb or .gltf file with its maps. It throws nothing: a file that is no valid glTF has no maps.
MapsReading read_maps(const std::string& file);

}  // namespace glark::tool
