// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Appearance maps: a normal map, a colour map and a displacement map of a coarse mesh, baked from a scan of any size or
// from a fine mesh. Link to glark-maps.
//
//   const glark::maps::Baked model = glark::maps::bake({.positions = positions, .triangles = triangles},
//                                                      glark::stream::file_source("scan.ply"));
//   glark::maps::write_model("model.glb", model);  // and model.displacement.png beside it
//
// The surface of the maps is P + (scale h + bias) N / |N|. P and N are the position and the normal of the coarse mesh,
// interpolated linearly, and h is the displacement map. GL_DISPLACEMENT_UNIT_ARK draws this surface. Lengths have the
// unit of the positions.
//
// The result does not depend on the number of threads.
// Source: Boubekeur 2007, ch. 6. docs/reference/maps.md lists the differences.
#ifndef GLARK_MAPS_H
#define GLARK_MAPS_H

#include <glark/error.h>
#include <glark/point_stream.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace glark::maps {

enum class Element { option, array, triangle, point, file };

// An error in an argument, the element that has it, and the remedy.
class GLARK_EXPORT Error : public ElementError<Element> {
 public:
  Error(Element element, std::size_t index, const std::string& what);
};

// The mesh that gets the maps. The caller owns the arrays. Vertices at one position count as one vertex.
struct CoarseMesh {
  std::array<double, 3> origin{};                 // added to all positions
  std::span<const float> positions = {};          // [3 * vertices]
  std::span<const float> normals = {};            // [3 * vertices], of any length; empty: those of the triangles
  std::span<const std::uint32_t> triangles = {};  // [3 * triangles], counter-clockwise from outside
  std::span<const float> texcoords = {};  // [2 * vertices], or empty: there are none; the lower left texel is at 0 0
};

// A picture of colours, as they are shown. The caller owns the pixels.
struct Picture {
  unsigned width = 0, height = 0;
  std::span<const std::uint8_t> pixels =
      {};  // [3 * width * height], red green blue; the first row is the upper one, at t = 1
};

inline constexpr std::uint32_t no_picture = 0xFFFFFFFF;

// What a picture shows beyond texture coordinates of 0 to 1: itself again, its mirror image, or its border.
enum class Wrap : std::uint8_t { repeat, mirror, clamp };

struct PictureWrap {
  Wrap s = Wrap::repeat, t = Wrap::repeat;
};

// A fine mesh. The caller owns the arrays, which must live as long as sources of it.
struct FineMesh {
  std::array<double, 3> origin{};         // added to all positions
  std::span<const float> positions = {};  // [3 * vertices]
  // [3 * vertices], or empty: means of the triangles' normals. Triangles that meet in more than 40 degrees keep a crease.
  std::span<const float> normals = {};
  std::span<const std::uint8_t> colours = {};     // [3 * vertices], red green blue; or empty
  std::span<const std::uint32_t> triangles = {};  // [3 * triangles]
  // Pictures that give the colours of triangles, in place of `colours`. Empty: there are none.
  std::span<const Picture> pictures = {};
  std::span<const std::uint32_t> triangle_pictures = {};  // [triangles]: the picture of each, or no_picture
  std::span<const float> texcoords = {};                  // [2 * vertices], or empty: 0; the lower left pixel is at 0 0
  std::span<const PictureWrap> picture_wraps = {};        // [pictures], or empty: all repeat
  // Colours that multiply those of pictures, red green blue, as they are shown: the product is that of linear colours.
  // A mesh of glTF gives `colours` here, too.
  std::span<const std::uint8_t> tints = {};  // [3 * vertices], or empty: white
};

// Samples the triangles of a mesh evenly: at each triangle's corners, and so densely that neighbours on a triangle are
// at most `spacing` apart, and a triangle has at least as many samples as pixels of its picture. Errors: Error for a spacing
// that is not above zero, for arrays that do not fit together.
GLARK_EXPORT stream::Source mesh_source(const FineMesh& mesh, double spacing);

// Whose texture coordinates the model has. Those of the coarse mesh are usable if each triangle has a place of its own in
// the texture: all coordinates are within 0 to 1, triangles of at most 0.1 % of the surface have no area there, and at most
// 0.2 % of the area is covered more than once.
enum class Texcoords : std::uint8_t {
  automatic,  // those of the coarse mesh if they are usable, or else those of charts
  own,        // those of the coarse mesh; Error if they are not usable
  charts,     // those of charts, which are made for the maps
};

struct BakeOptions {
  std::size_t texture_memory = std::size_t{128} << 20;  // bytes, of all maps with their mipmap levels; 1 MiB or more
  unsigned most_side = 16384;                           // the greatest width and height of the maps, 64 to 32768
  // The width and height of the maps, powers of two from 64 to 32768, in place of `texture_memory` and `most_side`. 0: by
  // the number of points.
  unsigned width = 0, height = 0;
  Texcoords texcoords = Texcoords::automatic;
  // The root mean square noise of the points, in their unit. A texel is at least 3.5 times as wide, so that points of
  // several layers are averaged; 0: points are exact.
  double noise = 0;
  double texels_per_point = 2;  // the most texels of the surface for each point, above 0 to 64
  // Points farther from the coarse mesh are left out, in the unit of the positions. 0: six times the root mean square
  // distance of the points, between a quarter of the mean coarse edge and two edges.
  double reach = 0;
  bool skip_invalid = false;  // leaves out points whose coordinates are not finite, instead of Error
  unsigned threads = 0;       // the most threads; 0: as many as the machine has
  // A folder for the state of the work, beside the model; empty: nothing is saved. After a run was killed, or the disk was
  // full, the next one continues from there with `resume`, and repeats a twentieth of the second pass at most, or ten times
  // the time that saving takes. The folder stays, so that writing the model may be interrupted, too: remove it then, by
  // std::filesystem::remove_all. Only for sources with an identity.
  std::filesystem::path work = {};
  bool resume = false;  // Error if the folder has the work of another mesh, source, version or other options
  // Receives the finished fraction of the work, 0 to 1, in the calling thread. If it throws, the work ends with this
  // exception.
  std::function<void(double fraction)> progress = {};
};

struct Jump {
  float greatest = 0, root_mean_square = 0;
};

// The differences of the two sides along the edges where two places of the maps meet, as a shader sees them: bilinear
// filtering of one mipmap level, two places a texel.
struct SeamJumps {
  Jump colour;            // of the channel that differs most, 0 to 1
  Jump normal;            // degrees; not at hard edges
  Jump displacement;      // in the unit of the positions
  std::size_t edges = 0;  // the number of such edges
};

struct Baked {
  std::array<double, 3> origin{};
  std::vector<float> positions, normals;  // [3 * vertices]; normals have unit length
  // [4 * vertices]: the direction in which s grows, and a sign: -1 where the mesh's own coordinates are mirrored, otherwise 1
  std::vector<float> tangents;
  std::vector<float> texcoords;          // [2 * vertices], 0 to 1; the first row of a map is at t = 0
  std::vector<std::uint32_t> triangles;  // [3 * triangles], in the order of the coarse mesh
  unsigned width = 0, height = 0;        // of all maps; powers of two
  // Whether the texture coordinates are those of the coarse mesh. Then the vertices are those of the coarse mesh, in their
  // order, and copies of some of them after these.
  bool has_own_texcoords = false;
  std::string texcoords_fault;  // why they are not; empty: they are, or were not to be
  // [3 * width * height], in tangent space: x along the tangent, y along cross(normal, tangent) times the tangent's fourth
  // number, z along the normal.
  std::vector<std::uint8_t> normal_map;
  std::vector<std::uint8_t> colour_map;         // [3 * width * height], red green blue; empty without colours
  std::vector<std::uint16_t> displacement_map;  // [width * height]
  float scale = 0, bias = 0;                    // 65535 in the displacement map is the height scale + bias

  std::uint64_t points = 0;                  // that were read
  std::uint64_t left_out = 0;                // points that are beyond the reach, or face away from all triangles nearby
  std::uint64_t invalid = 0;                 // points whose coordinates are not finite
  std::size_t charts = 0, empty_charts = 0;  // charts or islands, and those without any point
  std::size_t hard_edges = 0;                // edges of the coarse mesh that are creases of the fine surface
  std::uint64_t texels = 0, filled = 0;      // texels of charts, and those that got their values by diffusion
  double reach = 0;                          // the reach that was used
  double density = 1;                        // of texels, relative to what the options ask for without limits of size
  SeamJumps seams;                           // in the first mipmap level
  std::vector<SeamJumps> mip_seams;  // in the second level and the third one, if a viewer takes means of four texels
};

// Bakes the maps of a coarse mesh. The source is read twice: first one point of several, which tell how many texels each
// chart needs, then all points. Colours are the channels red, green and blue.
// Errors: Error for arrays that do not fit together, a triangle with a vertex that does not exist, a number that is not
// finite, no triangles, no point near the mesh, options out of range, texture coordinates that are to be kept and cannot,
// a texture memory that is too small for the number of charts, and a state of the work that cannot be written or is of
// other work. stream::Error for a source that cannot be read.
GLARK_EXPORT Baked bake(const CoarseMesh& mesh, const stream::Source& points, const BakeOptions& options = {});

// Writes a binary glTF file with the normal map and the colour map in it, and the displacement map beside it, as a PNG of
// 16 bits: "model.displacement.png" for "model.glb". The material's "extras" name it, with scale and bias. Files appear
// complete. Errors: Error for files that cannot be written, or a model of more than 4 GiB.
GLARK_EXPORT void write_model(const std::filesystem::path& file, const Baked& model);

// Writes a binary PLY file with normals, texture coordinates and, with colours, the texel at each vertex, and the maps beside
// it: "model.normals.png", "model.displacement.png" and, with colours, "model.colours.png" for "model.ply". Comments in the
// header name them, and tell scale and bias; "TextureFile" is the colour map, which MeshLab and CloudCompare show.
// strips: writes triangle strips ("tristrips") instead of faces. Files appear complete. Errors: Error for files that cannot
// be written.
GLARK_EXPORT void write_ply(const std::filesystem::path& file, const Baked& model, bool strips = false);

// Returns the normal map in object space, for programs without tangent spaces: [3 * width * height], from -1 to 1 on each
// axis of the positions, as bytes. Texels more than 4 from all charts have 128 128 128.
GLARK_EXPORT std::vector<std::uint8_t> object_normals(const Baked& model);

// Writes the maps that are in a model as files beside it: "model.normals.png" and, with colours, "model.colours.png" for
// "model.glb". Errors: Error for files that cannot be written.
GLARK_EXPORT void write_pictures(const std::filesystem::path& file, const Baked& model);

// Writes object_normals() beside a model: "model.object_normals.png" for "model.glb". Errors: the same.
GLARK_EXPORT void write_object_normals(const std::filesystem::path& file, const Baked& model);

}  // namespace glark::maps

#endif  // GLARK_MAPS_H
