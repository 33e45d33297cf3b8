// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/geometry/read/assimp_reader.h"

#include <fmt/format.h>

#include <assimp/mesh.h>
#include <assimp/postprocess.h>
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
#include "glark/clients/geometry/read/point_builder.h"
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
std::string check_obj(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  std::size_t with = 0, without = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string_view line = text.substr(begin, end - begin);
    begin = end + 1;
    if (!line.starts_with("v ") && !line.starts_with("v\t")) continue;
    std::size_t words = 0;
    for (line.remove_prefix(1); words < 7; ++words) {
      line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
      if (line.empty()) break;
      line.remove_prefix(std::min(line.find_first_of(blanks), line.size()));
    }
    ++(words >= 6 ? with : without);
  }
  if (with == 0 || without == 0) return {};
  return fmt::format("{} of {} vertices have no colour; they are black", without, with + without);
}

class Scene {
 public:
  // linear: colours are linear, not as they are shown.
  Scene(std::string name, const aiScene& scene, bool linear, const ReadOptions& options)
      : name_(std::move(name)), scene_(scene), linear_(linear), options_(options) {}

  Reading gather() const {
    PointBuilder builder(name_, "vertex", attributes(), options_, ColourRange::fraction);
    std::int64_t first = 0;
    std::vector<std::int64_t> corners;
    for (unsigned i = 0; i < scene_.mNumMeshes; ++i) {
      const aiMesh& mesh = *scene_.mMeshes[i];
      for (unsigned k = 0; k < mesh.mNumVertices; ++k) add_vertex(mesh, k, builder);
      for (unsigned k = 0; k < mesh.mNumFaces; ++k) {
        const aiFace& face = mesh.mFaces[k];
        if (face.mNumIndices < 3) continue;  // skips points and lines
        corners.clear();
        for (unsigned corner = 0; corner < face.mNumIndices; ++corner) corners.push_back(first + face.mIndices[corner]);
        builder.add_polygon(corners);
      }
      first += mesh.mNumVertices;
    }
    Reading reading = builder.finish();
    if (options_.images) add_images(reading);
    return reading;
  }

 private:
  // A triangle has the image of the mesh that its points come from.
  void add_images(Reading& reading) const {
    MaterialImages materials = read_material_images(scene_, std::filesystem::path(name_).parent_path());
    for (std::string& warning : materials.warnings) reading.warnings.push_back(std::move(warning));
    // Colours of vertices are finer than those of materials.
    if (materials.images.empty() || (!materials.has_pictures && !reading.geometry.colours.empty())) return;
    std::vector<std::uint32_t> ends;  // of the points of each mesh
    std::uint32_t end = 0;
    for (unsigned i = 0; i < scene_.mNumMeshes; ++i) {
      const aiMesh& mesh = *scene_.mMeshes[i];
      end += static_cast<std::uint32_t>(std::count_if(
          mesh.mVertices, mesh.mVertices + mesh.mNumVertices,
          [](const aiVector3D& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }));
      ends.push_back(end);
    }
    Geometry& geometry = reading.geometry;
    geometry.images = std::move(materials.images);
    for (std::size_t i = 0; i < geometry.triangles.size(); i += 3) {
      const auto mesh = std::upper_bound(ends.begin(), ends.end(), geometry.triangles[i]) - ends.begin();
      geometry.triangle_images.push_back(materials.of_mesh[static_cast<std::size_t>(mesh)]);
    }
  }

  Attributes attributes() const {
    Attributes attributes;
    for (unsigned i = 0; i < scene_.mNumMeshes; ++i) {
      const aiMesh& mesh = *scene_.mMeshes[i];
      attributes.normals |= mesh.HasNormals();
      attributes.colours |= mesh.HasVertexColors(0);
      attributes.texture_coordinates |= mesh.HasTextureCoords(0);
    }
    return attributes;
  }

  void add_vertex(const aiMesh& mesh, unsigned index, PointBuilder& builder) const {
    Point point;
    const aiVector3D& position = mesh.mVertices[index];
    point.position = {position.x, position.y, position.z};
    if (mesh.HasNormals()) point.normal = {mesh.mNormals[index].x, mesh.mNormals[index].y, mesh.mNormals[index].z};
    if (mesh.HasTextureCoords(0))
      point.texture_coordinate = {mesh.mTextureCoords[0][index].x, mesh.mTextureCoords[0][index].y};
    if (mesh.HasVertexColors(0)) {
      const aiColor4D& colour = mesh.mColors[0][index];
      const auto shown = [this](float value) { return linear_ ? srgb_from_linear(value) : value; };
      point.colour = {shown(colour.r), shown(colour.g), shown(colour.b), std::max(0.0F, colour.a)};
    }
    builder.add_point(point, false);
  }

  std::string name_;
  const aiScene& scene_;
  bool linear_;
  const ReadOptions& options_;
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
  unsigned steps;
};

Importing importing(MeshFormat format, std::span<const char> bytes) {
  if (format == MeshFormat::stl) return {"STL", "stl", 0};
  if (format == MeshFormat::obj) return {"OBJ", "obj", 0};
  return {"glTF", is_glb(bytes) ? "glb" : "gltf", aiProcess_PreTransformVertices};
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

}  // namespace

Reading read_by_assimp(Input& input, MeshFormat format, const ReadOptions& options) {
  std::vector<char> bytes = whole(input);
  std::string warning;
  if (format == MeshFormat::stl) warning = check_stl(input.name(), bytes);
  if (format == MeshFormat::obj) warning = check_obj({bytes.data(), bytes.size()});
  const auto [kind, hint, steps] = importing(format, bytes);
  Assimp::Importer importer;
  const aiScene* scene = names_files(input.name(), format, bytes, options)
                             ? importer.ReadFile(input.name(), steps)
                             : importer.ReadFileFromMemory(bytes.data(), bytes.size(), steps, hint);
  if (scene == nullptr)
    throw Error(fmt::format("{}: is not a valid {} file: {}; check the format or export it again", input.name(), kind,
                            importer.GetErrorString()));
  if (format == MeshFormat::gltf) warning = check_gltf(input.name(), bytes);
  // Assimp could join vertices, too. But it treats vertices that are not finite as equal to all others.
  Reading reading = Scene(input.name(), *scene, format == MeshFormat::gltf, options).gather();
  importer.FreeScene();
  if (!warning.empty()) reading.warnings.push_back(warning);
  if (warning = warning_of_coarse_floats(reading.geometry); !warning.empty()) reading.warnings.push_back(warning);
  if (format == MeshFormat::stl)
    // These are the normals of the faces. With these normals, no two triangles would share a vertex.
    reading.geometry.normals = {};
  if (!reading.geometry.triangles.empty()) join_identical_points(reading.geometry);
  return reading;
}

}  // namespace glark::geometry
