// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The steps of bake(): charts, a census of the points, places in the maps, all points, diffusion, seams, and the model.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>

#include "glark/clients/maps/atlas/atlas.h"
#include "glark/clients/maps/charts/hard_edges.h"
#include "glark/clients/maps/charts/islands.h"
#include "glark/clients/maps/charts/segmentation.h"
#include "glark/clients/maps/fill/diffusion.h"
#include "glark/clients/maps/output/assembly.h"
#include "glark/clients/maps/output/seam_check.h"
#include "glark/clients/maps/project/census.h"
#include "glark/clients/maps/project/coverage.h"
#include "glark/clients/maps/project/splatter.h"
#include "glark/clients/maps/seam_list.h"
#include "glark/clients/maps/states.h"
#include "glark/clients/maps/validation.h"

namespace glark::maps {
namespace {

constexpr std::size_t points_a_step = 1 << 16;

// The part of the work that is done after each step.
constexpr double after_census = 0.1, after_points = 0.75, after_filling = 0.85, after_seams = 0.95;

class Baker {
 public:
  Baker(const CoarseMesh& mesh, const stream::Source& source, const BakeOptions& options)
      : source_(source),
        options_(options),
        workers_(options.threads),
        origin_(mesh.origin),
        texcoords_(mesh.texcoords),
        surface_(surface_of(mesh)),
        states_(mesh, source, options) {
    find_islands();
  }

  Baked bake() {
    report(0);
    const Census census = look_at_points();
    report(after_census);
    set_reach(census);
    if (!census.spreads.empty()) find_hard_edges(census.spreads, surface_);
    if (!model_.has_own_texcoords) segment_mesh();
    place_charts(census);
    make_maps();
    report(after_filling);
    model_.origin = origin_;
    if (model_.has_own_texcoords)
      assemble_islands();
    else
      assemble_charts();
    model_.hard_edges = count_hard_edges(surface_);
    const std::vector<SeamJumps> jumps = check_seams(surface_, charts_, model_, kept_levels);
    model_.seams = jumps.front();
    model_.mip_seams.assign(jumps.begin() + 1, jumps.end());
    to_unit_of_mesh();
    report(1);
    return std::move(model_);
  }

 private:
  void find_islands() {
    if (options_.texcoords != Texcoords::charts) {
      model_.texcoords_fault = fault_of_texcoords(surface_);
      model_.has_own_texcoords = model_.texcoords_fault.empty();
      if (options_.texcoords == Texcoords::own && !model_.has_own_texcoords)
        throw Error(
            Element::array, 0,
            fmt::format("the coarse mesh cannot keep its texture coordinates: {}; let new ones be made, or give a "
                        "mesh whose triangles each have a place of their own in the texture",
                        model_.texcoords_fault));
    }
    if (model_.has_own_texcoords) charts_ = islands_of(surface_);
    model_.charts = charts_.size();
  }

  // Charts end at hard edges, unless so many charts were too much for the maps.
  void segment_mesh() {
    constexpr std::uint64_t texels_of_chart = std::uint64_t{4} * (2 * gutter + 1) * (2 * gutter + 1);
    charts_ = segment(surface_);
    if (!surface_.hard.empty() && charts_.size() * texels_of_chart > most_texels()) charts_ = segment(surface_, false);
    model_.charts = charts_.size();
  }

  // A normal and a colour have three bytes, a height two. The mipmap levels are a third of the first one.
  std::uint64_t most_texels() const {
    const std::uint64_t bytes = channels_ == channels_with_colour ? 8 : 5;
    return options_.width > 0 ? std::uint64_t{options_.width} * options_.height
                              : options_.texture_memory / bytes * 3 / 4;
  }

  void assemble_charts() {
    equalise_seams(surface_, charts_, atlas_, channels_, maps_);
    report(after_seams);
    assemble({surface_, charts_, atlas_, maps_, channels_}, workers_, model_);
  }

  void assemble_islands() {
    WholeMap whole = join_maps(charts_, surface_, atlas_, channels_, maps_);
    equalise_seams(surface_, charts_, atlas_, channels_, whole);
    report(after_seams);
    assemble(surface_, texcoords_, charts_, whole, channels_, model_);
  }

  void report(double fraction) const {
    if (options_.progress) options_.progress(fraction);
  }

  void to_unit_of_mesh() {
    const double unit = 1 / surface_.scale;
    const auto scaled = [unit](float length) { return static_cast<float>(static_cast<double>(length) * unit); };
    for (float& x : model_.positions) x = scaled(x);
    for (float* length : {&model_.scale, &model_.bias}) *length = scaled(*length);
    const auto scale_jump = [&](Jump& jump) { jump = {scaled(jump.greatest), scaled(jump.root_mean_square)}; };
    scale_jump(model_.seams.displacement);
    for (SeamJumps& jumps : model_.mip_seams) scale_jump(jumps.displacement);
    model_.reach *= unit;
  }

  double widest_reach() const { return options_.reach > 0 ? options_.reach * surface_.scale : 2 * surface_.mean_edge; }

  Census look_at_points() {
    SampleStream stream(source_, origin_, surface_.scale, options_.skip_invalid);
    has_normals_ = stream.has_normals();
    channels_ = stream.has_colours() ? channels_with_colour : channels_without_colour;
    if (Census saved; states_.load(saved)) return saved;
    Census census = take_census(stream, Shell(surface_, widest_reach()), surface_.triangles.size(), workers_);
    if (census.points_with_foot == 0)
      throw Error(
          Element::array, 0,
          fmt::format("no point of {} is within {:.3g} of the coarse mesh and faces the same side; both must be "
                      "in one place, and normals must point to the outside",
                      source_.name, widest_reach() / surface_.scale));
    states_.save(census);
    return census;
  }

  void set_reach(const Census& census) {
    constexpr double deviations = 6;
    model_.reach = options_.reach > 0
                       ? options_.reach * surface_.scale
                       : std::clamp(deviations * census.root_mean_square, surface_.mean_edge / 4, widest_reach());
  }

  void place_charts(const Census& census) {
    std::vector<double> wanted;
    for (const Chart& chart : charts_) {
      double points = 0;
      for (const std::uint32_t t : chart.triangles) points += census.points[t];
      wanted.push_back(points * options_.texels_per_point);
    }
    constexpr double texel_of_noise = 3.5;
    const AtlasLimits limits{
        .width = options_.width,
        .height = options_.height,
        .most_texels = most_texels(),
        .most_side = options_.most_side,
        .most_density = options_.noise > 0 ? 1 / (texel_of_noise * options_.noise * surface_.scale) : 0};
    if (model_.has_own_texcoords)
      place_islands(std::accumulate(wanted.begin(), wanted.end(), 0.0), limits);
    else
      atlas_ = pack(charts_, surface_, wanted, limits);
    model_.density = static_cast<double>(atlas_.scale);
    maps_.resize(charts_.size());
    for (std::size_t c = 0; c < charts_.size(); ++c) maps_[c].resize(atlas_.places[c], channels_);
  }

  // Islands whose rectangles overlap much, as rings within rings, would take much memory one by one.
  void place_islands(double wanted, const AtlasLimits& limits) {
    constexpr std::uint64_t most_layers = 4;
    atlas_ = keep_places(charts_, surface_, wanted, limits);
    std::uint64_t texels = 0;
    for (const Place& place : atlas_.places) texels += std::uint64_t{place.width} * place.height;
    if (texels <= most_layers * atlas_.width * atlas_.height) return;
    charts_ = join_islands(charts_, surface_);
    atlas_ = keep_places(charts_, surface_, wanted, limits);
  }

  // Continues from what a killed run has saved.
  void make_maps() {
    SampleStream stream(source_, origin_, surface_.scale, options_.skip_invalid);
    states_.begin_points(maps_, stream.count());
    PointCounts points;
    FillCounts counts;
    if (!states_.load_filled(points, counts, maps_, workers_)) {
      states_.load_points(points, maps_, workers_);
      add_points(stream, points);
      report(after_points);
      counts = fill();
      states_.save_filled(points, counts, maps_, workers_);
    }
    model_.points = points.read;
    model_.left_out = points.left_out;
    model_.invalid = points.invalid;
    model_.texels = counts.texels;
    model_.filled = counts.filled;
    model_.empty_charts = counts.empty_charts;
  }

  void add_points(SampleStream& stream, PointCounts& points) {
    const Shell shell(surface_, model_.reach);
    Splatter splatter(charts_, atlas_, surface_, shell, channels_);
    std::vector<Sample> samples;
    const auto count = static_cast<double>(stream.count().value_or(0));
    if (points.read > 0) stream.continue_after(points.read, points.invalid);
    while (stream.next(points_a_step, samples)) {
      points.left_out += splatter.add(samples, workers_, maps_);
      points.read = stream.read_points();
      points.invalid = stream.invalid();
      states_.save_points(points, maps_, workers_);
      const double done = count > 0 ? std::min(1.0, static_cast<double>(points.read) / count) : 0;
      report(after_census + (after_points - after_census) * done);
    }
    states_.save_all_points(points, maps_, workers_);
  }

  FillCounts fill() {
    std::atomic<std::uint64_t> filled = 0, texels = 0, empty = 0;
    workers_.each(charts_.size(), 1, [&](std::size_t begin, std::size_t end) {
      Diffuser diffuser;
      for (std::size_t c = begin; c < end; ++c) {
        ChartMap& map = maps_[c];
        map.divide(channels_);
        const Raster raster{map.width, map.height, channels_, map.values, map.weights};
        const std::size_t texels_filled = diffuser.fill(raster).filled;
        filled += texels_filled;
        texels += map.weights.size();
        const bool is_empty = std::none_of(map.weights.begin(), map.weights.end(), [](float w) { return w > 0; });
        empty += is_empty ? 1 : 0;
        set_normals(c, is_empty);
        map.is_changed = true;
      }
    });
    set_colours_of_empty_charts();
    return {texels, filled, empty};
  }

  // Charts without points get the colours of their neighbours, or the mean colour of all charts.
  void set_colours_of_empty_charts() {
    if (channels_ != channels_with_colour) return;
    std::array<double, 3> sum{};
    double count = 0;
    std::vector<bool> is_empty(maps_.size());
    for (std::size_t c = 0; c < maps_.size(); ++c) {
      const ChartMap& map = maps_[c];
      const double before = count;
      for (std::size_t at = 0; at < map.weights.size(); ++at) {
        if (!(map.weights[at] > 0)) continue;
        for (std::size_t k = 0; k < 3; ++k)
          sum[k] += static_cast<double>(map.values[at * channels_ + colour_channel + k]);
        ++count;
      }
      is_empty[c] = count == before;
    }
    if (count == 0) return;
    for (std::size_t c = 0; c < maps_.size(); ++c)
      for (std::size_t at = 0; is_empty[c] && at < maps_[c].weights.size(); ++at)
        for (std::size_t k = 0; k < 3; ++k)
          maps_[c].values[at * channels_ + colour_channel + k] = static_cast<float>(sum[k] / count);
    spread_colours(surface_, charts_, atlas_, maps_, is_empty);
  }

  // Normals in tangent space, of unit length. Scans without normals get those of the displaced surface.
  void set_normals(std::size_t c, bool is_empty) {
    ChartMap& map = maps_[c];
    if (!has_normals_ || is_empty) {
      const Coverage coverage = is_empty && charts_[c].is_own ? nearest_places(charts_[c], atlas_.places[c], surface_)
                                                              : cover(charts_[c], atlas_.places[c], surface_);
      if (is_empty)
        set_coarse_normals(charts_[c], surface_, coverage, channels_, map.values);
      else
        set_normals_from_heights(charts_[c], atlas_.places[c], surface_, coverage, channels_, map.values);
    }
    normalise(map, charts_[c].vertex_normal);
    to_tangent_space(charts_[c], atlas_.places[c], surface_, channels_, map.values);
  }

  void normalise(ChartMap& map, Vector instead) const {
    for (std::size_t at = 0; at < map.weights.size(); ++at) {
      float* n = map.values.data() + at * channels_;
      Vector normal = common::unit(Vector{n[0], n[1], n[2]});
      if (common::is_zero(normal)) normal = instead;
      for (std::size_t k = 0; k < 3; ++k) n[k] = normal[k];
    }
  }

  const stream::Source& source_;
  const BakeOptions& options_;
  common::Workers workers_;
  std::array<double, 3> origin_;
  std::span<const float> texcoords_;  // of the mesh
  Surface surface_;
  BakeStates states_;
  std::vector<Chart> charts_;
  Atlas atlas_;
  std::vector<ChartMap> maps_;
  unsigned channels_ = 0;
  bool has_normals_ = false;
  Baked model_;
};

}  // namespace

Baked bake(const CoarseMesh& mesh, const stream::Source& points, const BakeOptions& options) {
  check(options);
  return Baker(mesh, points, options).bake();
}

}  // namespace glark::maps
