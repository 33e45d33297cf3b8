// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glark-qas-errors: the table of errors of QAS, of QAS after one more step, and of PN triangles. The reference is
// Loop's limit surface.
//
//   glark-qas-errors [--csv] [MESH.obj ...]      without meshes: the seven of tests/qas/meshes.h
#include <charconv>
#include <cstdio>
#include <cstring>
#include <exception>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "tests/bench/qas/qas_errors.h"

namespace {

using glark::bench::Deviation;
using glark::qas::test::ControlMesh;

// Returns 6 for "7", "7/1" or "7//3".
std::uint32_t index_of(const std::string& word, const std::string& path) {
  std::uint32_t number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc{} || number == 0 || (end != word.data() + word.size() && *end != '/'))
    throw std::runtime_error(path + ": '" + word + "' is no vertex of a face");
  return number - 1;
}

// Reads vertices and triangles. Polygons become fans.
ControlMesh read_obj(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + ": cannot be read");
  ControlMesh mesh{path.substr(path.find_last_of('/') + 1), {}, {}};
  std::string line;
  while (std::getline(file, line)) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "v") {
      float x = 0;
      for (int i = 0; i < 3 && words >> x; ++i) mesh.positions.push_back(x);
    } else if (word == "f") {
      std::vector<std::uint32_t> corners;
      while (words >> word) corners.push_back(index_of(word, path));
      for (std::size_t i = 2; i < corners.size(); ++i)
        mesh.triangles.insert(mesh.triangles.end(), {corners[0], corners[i - 1], corners[i]});
    }
  }
  if (mesh.triangles.empty() || mesh.positions.empty() || !(mesh.diagonal() > 0))
    throw std::runtime_error(path + ": no surface; a Wavefront OBJ with lines of v and f is needed");
  return mesh;
}

void print(const ControlMesh& mesh, bool csv) {
  const auto errors = glark::bench::qas_errors(mesh);
  const std::pair<const char*, const Deviation&> rows[] = {
      {"QAS", errors.qas}, {"QAS, splits 1", errors.split}, {"QAS, quartic", errors.quartic}, {"PN", errors.pn}};
  for (const auto& [method, d] : rows) {
    std::printf(
        csv ? "%s,%zu,\"%s\",%g,%g,%g,%g,%g,%g\n" : "%-14s %6zu  %-13s  %8.4f %8.4f  %8.4f %8.4f  %8.3f %8.3f\n",
        errors.mesh.c_str(), errors.triangles, method, d.position_rms, d.position_most, d.surface_rms, d.surface_most,
        d.normal_rms, d.normal_most);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const bool csv = argc > 1 && std::strcmp(argv[1], "--csv") == 0;
  std::puts(csv ? "mesh,triangles,method,position_rms_percent,position_max_percent,surface_rms_percent,surface_max_"
                  "percent,normal_rms_degrees,normal_max_degrees"
                : "                                      same parameter     to the surface     normal\n"
                  "mesh           triangles  method      RMS %    max %     RMS %    max %     RMS deg  max deg");
  try {
    const int first = csv ? 2 : 1;
    for (int i = first; i < argc; ++i) print(read_obj(argv[i]), csv);
    if (first >= argc) {
      for (const ControlMesh& mesh : glark::qas::test::seven_meshes()) print(mesh, csv);
    }
  } catch (const std::exception& exception) {
    std::fprintf(stderr, "glark-qas-errors: %s\n", exception.what());
    return 1;
  }
  return 0;
}
