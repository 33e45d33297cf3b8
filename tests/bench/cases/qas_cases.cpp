// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// QAS: compares the step on the CPU with OpenSubdiv's evaluator, and frames with the same surface refined beforehand.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "tests/bench/cases/case.h"
#include "tests/bench/offscreen.h"
#include "tests/bench/qas/qas_errors.h"
#include "tests/bench/subject/subject.h"

#ifdef GLARK_BENCH_OPENSUBDIV
#include <opensubdiv/far/ptexIndices.h>
#include <opensubdiv/far/stencilTableFactory.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/osd/cpuEvaluator.h>
#endif

namespace glark::bench {
namespace {

using qas::test::ControlMesh;

double million_triangles(const ControlMesh& mesh, const Times& times) {
  return static_cast<double>(mesh.triangles.size()) / 3 / times.least() / 1e6;
}

#ifdef GLARK_BENCH_OPENSUBDIV
namespace Far = OpenSubdiv::Far;

// Evaluates limit positions and derivatives at the same points: once at each vertex and each edge midpoint.
class OpenSubdivStep {
 public:
  explicit OpenSubdivStep(const ControlMesh& mesh) {
    Far::TopologyDescriptor descriptor;
    const std::vector<int> sizes(mesh.triangles.size() / 3, 3), indices(mesh.triangles.begin(), mesh.triangles.end());
    descriptor.numVertices = static_cast<int>(mesh.vertex_count());
    descriptor.numFaces = static_cast<int>(sizes.size());
    descriptor.numVertsPerFace = sizes.data();
    descriptor.vertIndicesPerFace = indices.data();
    using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
    const std::unique_ptr<Far::TopologyRefiner> refiner(
        Factory::Create(descriptor, Factory::Options(OpenSubdiv::Sdc::SCHEME_LOOP, OpenSubdiv::Sdc::Options())));
    Far::LimitStencilTableFactory::LocationArrayVec locations;
    locations_of(refiner->GetLevel(0), locations);
    refiner->RefineAdaptive(Far::TopologyRefiner::AdaptiveOptions(4));
    table_.reset(Far::LimitStencilTableFactory::Create(*refiner, locations));
    if (!table_) throw std::runtime_error("OpenSubdiv makes no stencils");
    const auto points = static_cast<std::size_t>(table_->GetNumStencils());
    for (std::vector<float>* values : {&positions_, &du_, &dv_, &normals_}) values->resize(3 * points);
  }

  std::size_t points() const { return positions_.size() / 3; }

  void run(const std::vector<float>& from) {
    using OpenSubdiv::Osd::BufferDescriptor;
    const BufferDescriptor three(0, 3, 3);
    OpenSubdiv::Osd::CpuEvaluator::EvalStencils(
        from.data(), three, positions_.data(), three, du_.data(), three, dv_.data(), three, table_->GetSizes().data(),
        table_->GetOffsets().data(), table_->GetControlIndices().data(), table_->GetWeights().data(),
        table_->GetDuWeights().data(), table_->GetDvWeights().data(), 0, static_cast<int>(points()));
    for (std::size_t i = 0; i < positions_.size(); i += 3) {
      const float *const u = &du_[i], *const v = &dv_[i];
      const float x = u[1] * v[2] - u[2] * v[1], y = u[2] * v[0] - u[0] * v[2], z = u[0] * v[1] - u[1] * v[0];
      const float length = std::sqrt(x * x + y * y + z * z);
      normals_[i] = x / length;
      normals_[i + 1] = y / length;
      normals_[i + 2] = z / length;
    }
  }

 private:
  using Array = Far::LimitStencilTableFactory::LocationArray;

  void locations_of(const Far::TopologyLevel& level, Far::LimitStencilTableFactory::LocationArrayVec& locations) {
    std::vector<bool> vertices(static_cast<std::size_t>(level.GetNumVertices())),
        edges(static_cast<std::size_t>(level.GetNumEdges()));
    constexpr std::array<float, 6> s = {0, 1, 0, 0.5F, 0.5F, 0}, t = {0, 0, 1, 0, 0.5F, 0.5F};
    coordinates_.resize(2 * (vertices.size() + edges.size()));
    std::size_t used = 0;
    for (int face = 0; face < level.GetNumFaces(); ++face) {
      for (int i = 0; i < 6; ++i) {
        auto&& seen = i < 3 ? vertices[static_cast<std::size_t>(level.GetFaceVertices(face)[i])]
                            : edges[static_cast<std::size_t>(level.GetFaceEdges(face)[i - 3])];
        if (seen) continue;
        seen = true;
        Array array;
        array.ptexIdx = face;
        array.numLocations = 1;
        coordinates_[used] = s[static_cast<std::size_t>(i)];
        coordinates_[used + 1] = t[static_cast<std::size_t>(i)];
        array.s = &coordinates_[used];
        array.t = &coordinates_[used + 1];
        locations.push_back(array);
        used += 2;
      }
    }
  }

  std::vector<float> coordinates_, positions_, du_, dv_, normals_;
  std::unique_ptr<const Far::LimitStencilTable> table_;
};

void against_opensubdiv(Report& report, const ControlMesh& mesh, qas::Surface& surface, const Effort& effort) {
  OpenSubdivStep theirs(mesh);
  const auto times = interleave(
      {{[] {}, [&] { surface.update(mesh.positions); }}, {[] {}, [&] { theirs.run(mesh.positions); }}}, effort);
  report.add({"qas/step/" + mesh.name + "/OpenSubdiv",
              "OpenSubdiv 1x",
              Goal::at_least,
              1,
              speed_ratio(times[1], times[0]),
              "x",
              {{"opensubdiv_million_triangles", million_triangles(mesh, times[1])}}});
}
#else
void against_opensubdiv(Report& report, const ControlMesh&, qas::Surface&, const Effort&) {
  report.note("qas/step: not compared with OpenSubdiv, which was missing when this was built");
}
#endif

// One thread takes one core.
void run_step(const ControlMesh& mesh, Report& report, const Effort& effort) {
  qas::Surface surface(mesh.view(), {.threads = 1}), split(mesh.view(), {.splits = 1, .threads = 1});
  std::vector<qas::Corner> corners(surface.corner_count());
  std::vector<qas::QuarticCorner> quartic(split.quartic_corner_count());
  const auto times = interleave({{[] {}, [&] { surface.update(mesh.positions); }},
                                 {[] {}, [&] { split.update(mesh.positions); }},
                                 {[] {}, [&] { surface.write_corners(corners); }},
                                 {[] {}, [&] { split.write_quartic_corners(quartic); }}},
                                effort);
  const std::string name = "qas/step/" + mesh.name;
  report.add({name, "", Goal::at_least, 5, million_triangles(mesh, times[0]), "M/s", {}});
  report.add({name + "/corners", "", Goal::none, 0, million_triangles(mesh, times[2]), "M/s", {}});
  report.add({name + "/quartic-corners", "", Goal::none, 0, million_triangles(mesh, times[3]), "M/s", {}});
  report.add({name + "/splits-1", "", Goal::at_most, 4, times[1].least() / times[0].least(), "x", {}});
  against_opensubdiv(report, mesh, surface, effort);
}

void run_errors(const ControlMesh& mesh, Report& report) {
  const QasErrors errors = qas_errors(mesh, 4);
  const std::string name = "qas/error/" + mesh.name;
  report.add({name + "/position", "measured 0.0075-0.074 %", Goal::none, 0, errors.qas.position_rms, "%", {}});
  report.add({name + "/normal", "measured 0.11-2.7 deg", Goal::none, 0, errors.qas.normal_rms, "deg", {}});
  const auto more_exact = [&](const std::string& mode, const Deviation& deviation) {
    report.add(
        {name + mode + "/position", "measured 0.002-0.014 %", Goal::at_most, 0.014, deviation.position_rms, "%", {}});
    report.add({name + mode + "/surface", "", Goal::at_most, 0.014, deviation.surface_rms, "%", {}});
    report.add({name + mode + "/normal", "measured 0.03-0.8 deg", Goal::at_most, 0.8, deviation.normal_rms, "deg", {}});
  };
  more_exact("/splits-1", errors.split);
  more_exact("/quartic", errors.quartic);
  report.add({name + "/pn/position", "measured 0.042-0.29 %", Goal::none, 0, errors.pn.position_rms, "%", {}});
}

}  // namespace

void add_qas_cases(std::vector<Case>& cases) {
  for (const ControlMesh& mesh : qas::test::seven_meshes()) {
    cases.push_back(
        {"qas/step/" + mesh.name, [mesh](Report& report, const Effort& effort) { run_step(mesh, report, effort); }});
    cases.push_back({"qas/error/" + mesh.name, [mesh](Report& report, const Effort&) { run_errors(mesh, report); }});
  }
}

}  // namespace glark::bench
