// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/geometry/read/assimp_reader.h"

#include <fmt/format.h>

#include <assimp/mesh.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cctype>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>

#include "glark/clients/geometry/measure/distance.h"
#include "glark/clients/geometry/measure/topology.h"
#include "glark/clients/geometry/read/gltf_check.h"
#include "glark/clients/geometry/read/material_images.h"
#include "glark/clients/geometry/read/points/point_builder.h"
#include "glark/clients/geometry/read/scene/gltf_textures.h"
#include "glark/clients/geometry/read/scene/mtl_pictures.h"
#include "glark/clients/geometry/read/scene/obj_vertices.h"
#include "glark/clients/geometry/read/scene/placed_meshes.h"
#include "glark/clients/geometry/read/scene/uri_files.h"
#include "glark/clients/geometry/srgb.h"

namespace glark::geometry {
namespace {

// The memory that a read takes, relative to the size of the file. Measured: 7, for OBJ and STL with a quarter million
// triangles.
constexpr double growth = 8;
constexpr std::size_t block_size = std::size_t{1} << 20;
constexpr std::size_t stl_header = 84;
constexpr std::size_t stl_triangle = 50;

std::vector<char> whole(Input& input) {
  if (input.remaining()) require_memory(input.name(), growth * static_cast<double>(*input.remaining()));
  std::vector<char> bytes;
  for (std::span<const char> block = input.take(block_size); !block.empty(); block = input.take(block_size)) {
    bytes.insert(bytes.end(), block.begin(), block.end());
    require_memory(input.name(), growth * static_cast<double>(bytes.size()));
  }
  return bytes;
}

// Returns whether something follows the line of the last "endsolid" of a text.
bool has_more_than_solids(std::string_view text) {
  constexpr std::string_view end = "endsolid";
  const auto same = [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; };
  const auto last = std::find_end(text.begin(), text.end(), end.begin(), end.end(), same);
  const auto line_end = std::find(last, text.end(), '\n');
  return std::any_of(line_end, text.end(), [](unsigned char letter) { return std::isspace(letter) == 0; });
}

// Some binary STL files begin with "solid", as text files do. The size of the file shows whether it is binary. Assimp
// reads beyond the end of the file if the count of triangles is wrong. It rejects a file with more bytes, so this
// function removes them. Returns a warning about ignored contents, or an empty text.
std::string check_stl(const std::string& name, std::vector<char>& bytes) {
  std::uint32_t count = 0;
  if (bytes.size() >= stl_header) std::memcpy(&count, bytes.data() + stl_header - sizeof(count), sizeof(count));
  const bool says_text = bytes.size() >= 5 && std::memcmp(bytes.data(), "solid", 5) == 0;
  const bool has_zero = std::memchr(bytes.data(), 0, bytes.size()) != nullptr;
  if (says_text && !has_zero)
    return has_more_than_solids({bytes.data(), bytes.size()}) ? "something follows the last endsolid; it is ignored"
                                                              : "";
  if (bytes.size() < stl_header)
    throw Error(name + ": is not an STL file: it is too short for the header; check the format");
  if (stl_header + std::uint64_t{stl_triangle} * count > bytes.size())
    throw Error(
        fmt::format("{}: STL header: it announces {} triangles, the file has room for {}; it is cut off or its header "
                    "wrong, get it again",
                    name, count, (bytes.size() - stl_header) / stl_triangle));
  const std::size_t used = stl_header + stl_triangle * std::size_t{count};
  const std::size_t more = bytes.size() - used;
  bytes.resize(used);
  if (more == 0) return {};
  return fmt::format("{} bytes follow the {} triangles that the STL header announces; they are ignored", more, count);
}

// Assimp makes vertices black that have no colour while others have one. Returns a warning, or an empty text.
std::string warning_of_colours(const ObjVertices& vertices) {
  if (vertices.with_colour == 0 || vertices.without_colour == 0) return {};
  return fmt::format("{} of {} vertices have no colour; they are black", vertices.without_colour,
                     vertices.with_colour + vertices.without_colour);
}

class Scene {
 public:
  // uses: of the pictures of materials. loose: positions of points that belong to no mesh.
  Scene(std::string name, const aiScene& scene, MeshFormat format, const ReadOptions& options, TextureUses uses,
        std::vector<std::array<double, 3>> loose)
      : name_(std::move(name)),
        scene_(scene),
        is_gltf_(format == MeshFormat::gltf),
        options_(options),
        meshes_(is_gltf_ ? placed_meshes(scene) : unplaced_meshes(scene)),
        uses_(std::move(uses)),
        loose_(std::move(loose)) {
    for (unsigned i = 0; options.images && i < scene.mNumMaterials; ++i)
      use_of_.push_back(use_of_material(scene, i, uses_));
  }

  Reading gather() const {
    PointBuilder builder(name_, "vertex", attributes(), options_, ColourRange::fraction);
    std::int64_t first = 0;
    std::vector<std::int64_t> corners;
    for (const PlacedMesh& placed : meshes_) {
      const aiMesh& mesh = *placed.mesh;
      const bool mirrors = placed.mirrors();
      const bool with_alpha = has_alpha(mesh);
      for (unsigned k = 0; k < mesh.mNumVertices; ++k) add_vertex(placed, k, with_alpha, builder);
      for (unsigned k = 0; k < mesh.mNumFaces; ++k) {
        const aiFace& face = mesh.mFaces[k];
        if (face.mNumIndices < 3) continue;  // skips points and lines
        corners.clear();
        for (unsigned corner = 0; corner < face.mNumIndices; ++corner) corners.push_back(first + face.mIndices[corner]);
        // The node mirrors the triangle, which turns its front to the inside (glTF 2.0, section 3.7.4).
        if (mirrors) std::reverse(corners.begin() + 1, corners.end());
        builder.add_polygon(corners);
      }
      first += mesh.mNumVertices;
    }
    for (const std::array<double, 3>& position : loose_) builder.add_point({.position = position}, false);
    Reading reading = builder.finish();
    if (options_.images) add_images(reading);
    return reading;
  }

 private:
  // A triangle has the image of the mesh that its points come from.
  void add_images(Reading& reading) const {
    MaterialImages materials = read_material_images(scene_, {.folder = std::filesystem::path(name_).parent_path(),
                                                             .is_gltf = is_gltf_,
                                                             .has_vertex_colours = !reading.geometry.colours.empty(),
                                                             .uses = uses_});
    for (std::string& warning : materials.warnings) reading.warnings.push_back(std::move(warning));
    if (materials.images.empty()) return;
    std::vector<std::uint32_t> ends;    // of the points of each mesh
    std::vector<std::uint32_t> images;  // of each mesh
    std::uint32_t end = 0;
    for (const PlacedMesh& placed : meshes_) {
      for (unsigned k = 0; k < placed.mesh->mNumVertices; ++k) {
        const std::array<double, 3> p = placed.position(k);
        end += std::all_of(p.begin(), p.end(), [](double x) { return std::isfinite(static_cast<float>(x)); }) ? 1 : 0;
      }
      ends.push_back(end);
      const auto mesh = std::find(scene_.mMeshes, scene_.mMeshes + scene_.mNumMeshes, placed.mesh) - scene_.mMeshes;
      images.push_back(materials.of_mesh[static_cast<std::size_t>(mesh)]);
    }
    Geometry& geometry = reading.geometry;
    geometry.images = std::move(materials.images);
    geometry.colours_tint_images = is_gltf_;
    for (std::size_t i = 0; i < geometry.triangles.size(); i += 3) {
      const auto mesh = std::upper_bound(ends.begin(), ends.end(), geometry.triangles[i]) - ends.begin();
      geometry.triangle_images.push_back(images[static_cast<std::size_t>(mesh)]);
    }
  }

  Attributes attributes() const {
    Attributes attributes;
    for (const PlacedMesh& placed : meshes_) {
      attributes.normals |= placed.mesh->HasNormals();
      attributes.colours |= placed.mesh->HasVertexColors(0);
      attributes.texture_coordinates |= placed.mesh->HasTextureCoords(use_of(*placed.mesh).set);
    }
    return attributes;
  }

  // Without images, texture coordinates are the first ones, as they are in the file.
  const TextureUse& use_of(const aiMesh& mesh) const {
    static const TextureUse plain;
    return mesh.mMaterialIndex < use_of_.size() ? use_of_[mesh.mMaterialIndex] : plain;
  }

  // Assimp gives the alpha 0 to colours of glTF without alpha.
  bool has_alpha(const aiMesh& mesh) const {
    if (!mesh.HasVertexColors(0)) return false;
    return !is_gltf_ || std::any_of(mesh.mColors[0], mesh.mColors[0] + mesh.mNumVertices,
                                    [](const aiColor4D& colour) { return colour.a > 0; });
  }

  void add_vertex(const PlacedMesh& placed, unsigned index, bool with_alpha, PointBuilder& builder) const {
    const aiMesh& mesh = *placed.mesh;
    Point point;
    point.position = placed.position(index);
    if (mesh.HasNormals()) point.normal = placed.normal(index);
    const TextureUse& use = use_of(mesh);
    if (mesh.HasTextureCoords(use.set)) {
      const aiVector3D& texture = mesh.mTextureCoords[use.set][index];
      point.texture_coordinate = use.coordinates(texture.x, texture.y);
    }
    if (mesh.HasVertexColors(0)) {
      const aiColor4D& colour = mesh.mColors[0][index];
      const auto shown = [this](float value) { return is_gltf_ ? srgb_from_linear(value) : value; };
      point.colour = {shown(colour.r), shown(colour.g), shown(colour.b),
                      with_alpha ? std::max(0.0F, colour.a) : opaque};
    } else if (is_gltf_) {
      point.colour = {1, 1, 1, opaque};
    }
    builder.add_point(point, false);
  }

  std::string name_;
  const aiScene& scene_;
  bool is_gltf_;
  const ReadOptions& options_;
  std::vector<PlacedMesh> meshes_;
  TextureUses uses_;
  std::vector<TextureUse> use_of_;  // of each material; empty without images
  std::vector<std::array<double, 3>> loose_;
};

// Returns whether Assimp has to open the file itself, and with it the files that it names.
bool names_files(const std::string& name, MeshFormat format, std::span<const char> bytes, const ReadOptions& options) {
  std::error_code error;
  std::string ending = std::filesystem::path(name).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  const bool may_name = format == MeshFormat::obj ? options.images && ending == ".obj"
                                                  : format == MeshFormat::gltf && !bytes.empty() && bytes[0] == '{';
  return may_name && ending != ".zst" && std::filesystem::is_regular_file(name, error);
}

struct Importing {
  const char* name;
  const char* hint;  // the ending that Assimp knows
};

Importing importing(MeshFormat format, std::span<const char> bytes) {
  if (format == MeshFormat::stl) return {"STL", "stl"};
  if (format == MeshFormat::obj) return {"OBJ", "obj"};
  return {"glTF", is_glb(bytes) ? "glb" : "gltf"};
}

// Assimp has a name of its own for what it reads from the memory.
std::string fault_of(const Assimp::Importer& importer) {
  const std::string fault = importer.GetErrorString();
  return fault.find("$$$") == std::string::npos ? fault : "its contents are of no version that is known";
}

// Floats are far apart where coordinates are large. Returns a warning if this shows, or an empty text.
std::string warning_of_coarse_floats(const Geometry& geometry) {
  constexpr double share_that_shows = 1e-4;  // of the diagonal
  float farthest = 0;
  for (const float coordinate : geometry.positions) farthest = std::max(farthest, std::abs(coordinate));
  const double step = static_cast<double>(farthest) * 0x1p-23;
  const double diagonal = diagonal_of(geometry);
  if (step <= share_that_shows * diagonal || diagonal == 0) return {};
  return fmt::format(
      "the coordinates lie so far from zero that floats are {:.2g} apart there, and a model of this format "
      "is read as floats; move it to zero, or convert it to PLY with doubles",
      step);
}

// Checks a file, and returns how its materials use their pictures.
TextureUses checked_gltf(const std::string& name, std::span<const char> bytes, const aiScene& scene,
                         const ReadOptions& options, std::vector<std::string>& warnings) {
  const GltfFile file = read_gltf(name, bytes);
  if (file.model == nullptr) {
    warnings.push_back("its indices cannot be checked: " + file.fault);
    return {};
  }
  check_gltf(name, *file.model);
  if (!options.images) return {};
  const std::vector<std::string> more = warnings_of_gltf_textures(*file.model);
  warnings.insert(warnings.end(), more.begin(), more.end());
  return gltf_texture_uses(*file.model, scene);
}

}  // namespace

Reading read_by_assimp(Input& input, MeshFormat format, const ReadOptions& options) {
  std::vector<char> bytes = whole(input);
  const std::string& name = input.name();
  std::vector<std::string> warnings;
  ObjVertices vertices;
  if (format == MeshFormat::stl) warnings.push_back(check_stl(name, bytes));
  if (format == MeshFormat::obj) {
    vertices = obj_vertices({bytes.data(), bytes.size()}, options.all_points);
    warnings.push_back(warning_of_colours(vertices));
  }
  if (format == MeshFormat::gltf && is_first_gltf(bytes))
    throw Error(name + ": is glTF 1.0, which glark does not read; export it as glTF 2.0");
  const auto [kind, hint] = importing(format, bytes);
  const bool has_names = names_files(name, format, bytes, options);
  const std::filesystem::path folder = std::filesystem::path(name).parent_path();
  Assimp::Importer importer;
  if (has_names && format == MeshFormat::gltf) importer.SetIOHandler(new UriFiles(folder));  // which owns it
  const aiScene* scene =
      has_names ? importer.ReadFile(name, 0) : importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, hint);
  if (scene == nullptr)
    throw Error(fmt::format("{}: is not a valid {} file: {}; check the format or export it again", name, kind,
                            fault_of(importer)));
  TextureUses uses;
  if (format == MeshFormat::gltf) uses = checked_gltf(name, bytes, *scene, options, warnings);
  if (format == MeshFormat::obj && has_names) uses = mtl_texture_uses({bytes.data(), bytes.size()}, folder, *scene);
  // Assimp could join vertices, too. But it treats vertices that are not finite as equal to all others.
  Reading reading = Scene(name, *scene, format, options, std::move(uses), std::move(vertices.loose)).gather();
  importer.FreeScene();
  warnings.push_back(warning_of_coarse_floats(reading.geometry));
  for (std::string& warning : warnings)
    if (!warning.empty()) reading.warnings.push_back(std::move(warning));
  if (format == MeshFormat::stl)
    // These are the normals of the faces. With these normals, no two triangles would share a vertex.
    reading.geometry.normals = {};
  if (!reading.geometry.triangles.empty()) join_identical_points(reading.geometry);
  return reading;
}

}  // namespace glark::geometry
