// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Meshes of machine parts and covers. Their proportions follow from a seed. Vertices at one position are one vertex.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace glark::shapes {

struct Part {
  std::vector<float> positions;          // [3 * vertices]
  std::vector<std::uint32_t> triangles;  // [3 * triangles]
  std::size_t triangle_count() const { return triangles.size() / 3; }
};

// detail: the triangles grow by its square; 1 gives some thousands.
Part box_with_fillets(unsigned seed, int detail);
Part gear(unsigned seed, int detail);
Part flange(unsigned seed, int detail);   // a disc with bolt holes
Part bracket(unsigned seed, int detail);  // plates at right angles, with slots
Part pipe(unsigned seed, int detail);     // a bent tube with a wall
Part cup(unsigned seed, int detail);      // a thin wall, round
Part blob(unsigned seed, int detail);     // smooth, without any edge
Part cover(unsigned seed, int detail);    // an open sheet with round holes
// Boxes that touch in faces, edges and corners; each is a part of its own. `detail` divides each box.
Part assembly(unsigned seed, int detail);

struct NamedPart {
  const char* name;
  Part (*make)(unsigned seed, int detail);
};
// The closed machine parts, for figures.
inline constexpr NamedPart machine_parts[] = {{"box with fillets", box_with_fillets},
                                              {"gear", gear},
                                              {"flange", flange},
                                              {"bracket", bracket},
                                              {"pipe", pipe},
                                              {"cup", cup}};

}  // namespace glark::shapes
