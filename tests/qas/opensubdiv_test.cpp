// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Compares limit points and normals with OpenSubdiv in double precision: coarse vertices by its limit masks, edge
// midpoints by the masks of the mesh that it has refined once.
#include <gtest/gtest.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>

#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "glark/clients/qas/limit_step/masks.h"
#include "tests/qas/meshes.h"

namespace glark::qas::test {
namespace {

namespace Far = OpenSubdiv::Far;

struct Point {
  std::array<double, 3> x{};
  void Clear() { x = {}; }  // NOLINT(readability-identifier-naming): OpenSubdiv's name
  // NOLINTNEXTLINE(readability-identifier-naming)
  void AddWithWeight(const Point& other, double weight) {
    for (std::size_t i = 0; i < 3; ++i) x[i] += weight * other.x[i];
  }
};

Point unit_cross(const Point& a, const Point& b) {
  Point n{{a.x[1] * b.x[2] - a.x[2] * b.x[1], a.x[2] * b.x[0] - a.x[0] * b.x[2], a.x[0] * b.x[1] - a.x[1] * b.x[0]}};
  const double length = std::hypot(n.x[0], n.x[1], n.x[2]);
  for (double& x : n.x) x /= length;
  return n;
}

class Reference {
 public:
  explicit Reference(const ControlMesh& mesh) {
    Far::TopologyDescriptor descriptor;
    const std::vector<int> sizes(mesh.triangles.size() / 3, 3);
    const std::vector<int> indices(mesh.triangles.begin(), mesh.triangles.end());
    const std::vector<int> creases(mesh.creases.begin(), mesh.creases.end());
    const std::vector<float> sharpness(mesh.creases.size() / 2, 10.0F);  // infinite
    descriptor.numVertices = static_cast<int>(mesh.vertex_count());
    descriptor.numFaces = static_cast<int>(sizes.size());
    descriptor.numVertsPerFace = sizes.data();
    descriptor.vertIndicesPerFace = indices.data();
    descriptor.numCreases = static_cast<int>(sharpness.size());
    descriptor.creaseVertexIndexPairs = creases.data();
    descriptor.creaseWeights = sharpness.data();
    OpenSubdiv::Sdc::Options options;
    options.SetVtxBoundaryInterpolation(OpenSubdiv::Sdc::Options::VTX_BOUNDARY_EDGE_ONLY);
    using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
    refiner_.reset(Factory::Create(descriptor, Factory::Options(OpenSubdiv::Sdc::SCHEME_LOOP, options)));
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v)
      coarse_.push_back({{mesh.positions[3 * v], mesh.positions[3 * v + 1], mesh.positions[3 * v + 2]}});
  }

  // The limits of the mesh after `levels` steps.
  void limits(int levels, std::vector<Point>& points, std::vector<Point>& normals) {
    refiner_->Unrefine();
    Far::TopologyRefiner::UniformOptions options(levels);
    options.fullTopologyInLastLevel = true;
    refiner_->RefineUniform(options);
    const Far::PrimvarRefinerReal<double> primvars(*refiner_);
    std::vector<Point> from = coarse_;
    for (int level = 1; level <= levels; ++level) {
      std::vector<Point> to(static_cast<std::size_t>(refiner_->GetLevel(level).GetNumVertices()));
      primvars.Interpolate(level, from, to);
      from = to;
    }
    points.resize(from.size());
    std::vector<Point> first(from.size()), second(from.size());
    primvars.Limit(from, points, first, second);
    normals.clear();
    for (std::size_t i = 0; i < from.size(); ++i) normals.push_back(unit_cross(first[i], second[i]));
  }

  const Far::TopologyLevel& base() const { return refiner_->GetLevel(0); }

 private:
  std::unique_ptr<Far::TopologyRefiner> refiner_;
  std::vector<Point> coarse_;
};

double distance(const Vector& ours, const Point& theirs) {
  return std::hypot(ours.x - theirs.x[0], ours.y - theirs.x[1], ours.z - theirs.x[2]);
}

// Returns false for vertices where several inner creases meet, and for boundary vertices of four and more triangles.
// For these, OpenSubdiv's masks do not belong to its refinement rules. The test TangentMask below checks our masks.
bool has_limit_normal(const Far::TopologyLevel& level, int vertex) {
  bool boundary = false;
  for (const int edge : level.GetVertexEdges(vertex)) {
    const bool outer = level.GetEdgeFaces(edge).size() == 1;
    if (!outer && level.GetEdgeSharpness(edge) > 0) return false;
    boundary = boundary || outer;
  }
  return !boundary || level.GetVertexFaces(vertex).size() < 4;
}

struct Farthest {
  double position = 0, normal = 0;
};

// Returns the errors of all points of all patches, and the errors of normals where the surface has a normal. Errors of
// points are relative to the diagonal, errors of normals to unit length.
Farthest compare(const ControlMesh& mesh) {
  Surface surface(mesh.view());
  surface.update(mesh.positions);
  Reference reference(mesh);
  std::vector<Point> vertex_points, vertex_normals, points, normals;
  reference.limits(0, vertex_points, vertex_normals);
  reference.limits(1, points, normals);
  Farthest farthest;
  for (std::size_t t = 0; t < surface.patches().size(); ++t) {
    const Patch& patch = surface.patches()[t];
    for (std::size_t i = 0; i < 6; ++i) {
      const int first = static_cast<int>(mesh.triangles[3 * t + i % 3]);
      const int second = static_cast<int>(mesh.triangles[3 * t + (i + 1) % 3]);
      const int edge = reference.base().FindEdge(first, second);
      const auto index = static_cast<std::size_t>(i < 3 ? first : reference.base().GetEdgeChildVertex(edge));
      const Point& point = i < 3 ? vertex_points[index] : points[index];
      const Point& normal = i < 3 ? vertex_normals[index] : normals[index];
      farthest.position =
          std::max(farthest.position, distance(surface.limit_positions()[patch.positions[i]], point) / mesh.diagonal());
      if (i < 3 && !has_limit_normal(reference.base(), first)) continue;
      if (i >= 3 && !mesh.creases.empty() && reference.base().GetEdgeSharpness(edge) > 0)
        continue;  // the edge has two normals
      farthest.normal = std::max(farthest.normal, distance(surface.limit_normals()[patch.normals[i]], normal));
    }
  }
  return farthest;
}

class LimitStepAgainstOpenSubdiv : public testing::TestWithParam<ControlMesh> {};

TEST_P(LimitStepAgainstOpenSubdiv, PointsAndNormalsAreTheSame) {
  const Farthest farthest = compare(GetParam());
  EXPECT_LE(farthest.position, 1e-6);
  // The triangles of a fan of 500 are 80 times as long as wide. This costs two digits of single precision.
  EXPECT_LE(farthest.normal, GetParam().vertex_count() == 502 ? 1e-5 : 1e-6);
}

std::vector<ControlMesh> all_meshes() {
  std::vector<ControlMesh> meshes = small_meshes();
  for (ControlMesh& mesh : seven_meshes())
    meshes.push_back({mesh.name + "_of_seven", mesh.positions, mesh.triangles, mesh.creases});
  for (const int valence : {3, 4, 7, 50, 500}) {
    meshes.push_back(shaken(bipyramid(valence), 0.01));
    meshes.back().name += std::to_string(valence);
  }
  meshes.push_back(shaken(sheet(5), 0.01));
  meshes.back().name = "shaken_sheet";
  meshes.push_back(densified(shaken(icosahedron(), 0.1), 4));
  meshes.back().name = "fine";
  return meshes;
}

INSTANTIATE_TEST_SUITE_P(Meshes, LimitStepAgainstOpenSubdiv, testing::ValuesIn(all_meshes()),
                         [](const auto& parameter) { return parameter.param.name; });

// The test finds a left eigenvector of the step at a boundary vertex. A step multiplies its product with any ring by a
// constant.
TEST(TangentMask, IsAnEigenvectorForAnyNumberOfTriangles) {
  for (std::uint32_t last = 1; last <= 40; ++last) {
    const TangentMask mask = tangent_mask(last + 1, false);
    const auto seen = [&](const std::vector<double>& ring, double centre) {
      double sum = 0;
      for (std::uint32_t i = 0; i <= last; ++i) sum += mask.inwards(i) * (ring[i] - centre);
      return sum;
    };
    std::vector<double> ring(last + 1), next(last + 1);
    for (std::uint32_t i = 0; i <= last; ++i) ring[i] = std::sin(1.0 + 2.3 * i * i);
    const double centre = 0.37;
    for (std::uint32_t i = 1; i < last; ++i) next[i] = (3 * (centre + ring[i]) + ring[i - 1] + ring[i + 1]) / 8;
    next[0] = (centre + ring[0]) / 2;
    next[last] = (centre + ring[last]) / 2;
    const double eigenvalue = last == 1 ? 0.25 : 3.0 / 8 + std::cos(std::numbers::pi / last) / 4;
    EXPECT_NEAR(seen(next, 0.75 * centre + (ring[0] + ring[last]) / 8), eigenvalue * seen(ring, centre), 1e-12) << last;
  }
}

}  // namespace
}  // namespace glark::qas::test
