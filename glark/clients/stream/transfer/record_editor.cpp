// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/transfer/record_editor.h"

#include <algorithm>
#include <cmath>

#include "glark/clients/stream/space/spatial_order.h"
#include "glark/clients/stream/transfer/deformation.h"

namespace glark::stream {
namespace {

using common::Vector3f;

constexpr std::size_t piece = 1 << 14;                                     // records, or points in their order
constexpr std::size_t coherent_batch = 1 << 17, shuffled_batch = 1 << 20;  // records, at most
constexpr std::size_t least_batch = 1 << 12;
constexpr std::size_t points_of_a_search = 4;  // fewer: the points that follow each other are far apart

// Copies records to records that may be larger.
void copy_records(std::span<const char> from, std::size_t size, std::size_t size_out, std::span<char> to) {
  for (std::size_t at = 0, out = 0; at < from.size(); at += size, out += size_out)
    std::copy_n(&from[at], size, &to[out]);
}

bool is_finite(const Vector3f& p) { return std::isfinite(p.x + p.y + p.z); }

// Points whose neighbours did not move keep their coordinates to the bit.
bool stay(const Samples& samples, std::span<const Neighbour> neighbours) {
  return std::all_of(neighbours.begin(), neighbours.end(), [&](const Neighbour& near) {
    return samples.before[near.index] == samples.after[near.index] &&
           samples.normals[near.index] == samples.normals_after[near.index];
  });
}

}  // namespace

RecordEditor::RecordEditor(const Sampling& sampling, const Layout& from, const OutputLayout& to,
                           const EditorOptions& options, const common::Workers& workers, std::string file)
    : sampling_(sampling),
      from_(from),
      to_(to),
      options_(options.transfer),
      memory_(options.memory),
      workers_(workers),
      file_(std::move(file)) {}

std::size_t RecordEditor::batch_size() const {
  constexpr std::size_t sorting = 5 * sizeof(std::uint32_t), box = 3 * sizeof(double);
  const std::size_t point =
      3 * (sizeof(double) + sizeof(float)) + sizeof(Vector3f) + sorting + to_.channels().size() * sizeof(EditedValue);
  const std::size_t record =
      from_.record_size + to_.layout().record_size + (point + (to_.has_box() ? box : 0)) * from_.points_per_record;
  const std::size_t fitting = memory_ / record;
  return std::clamp(fitting, least_batch, is_shuffled_ ? shuffled_batch : coherent_batch);
}

void RecordEditor::edit(std::uint64_t first, std::span<const char> records, std::span<char> edited) {
  const std::size_t count = records.size() / from_.record_size, each = from_.points_per_record, points = count * each;
  positions_.resize(3 * points);
  normals_.resize(from_.has_normals() ? 3 * points : 0);
  local_.resize(points);
  values_.assign(to_.channels().size() * points, {});
  order_.resize(points);
  searches_ = 0;
  if (is_shuffled_) {
    workers_.in_pieces(count, piece, [&](std::size_t begin, std::size_t end) { decode_piece(records, begin, end); });
    sort_points(0, points);
    workers_.in_pieces(points, piece, [&](std::size_t begin, std::size_t end) { edit_points(begin, end); });
    workers_.in_pieces(count, piece,
                       [&](std::size_t begin, std::size_t end) { encode_piece(first, records, begin, end, edited); });
  } else {
    workers_.in_pieces(count, piece, [&](std::size_t begin, std::size_t end) {
      decode_piece(records, begin, end);
      sort_points(begin * each, end * each);
      edit_points(begin * each, end * each);
      encode_piece(first, records, begin, end, edited);
    });
  }
  is_shuffled_ |= searches_ * points_of_a_search > points;
}

void RecordEditor::decode_piece(std::span<const char> records, std::size_t begin, std::size_t end) {
  PointArrays points;
  decode(from_, &records[begin * from_.record_size], end - begin, {.channels = false}, points);
  const std::size_t first = begin * from_.points_per_record;
  std::copy(points.positions.begin(), points.positions.end(), &positions_[3 * first]);
  if (!points.normals.empty()) std::copy(points.normals.begin(), points.normals.end(), &normals_[3 * first]);
  for (std::size_t i = 0; i < points.positions.size(); ++i)
    local_[first + i / 3][i % 3] = static_cast<float>(points.positions[i] - sampling_.origin[i % 3]);
}

void RecordEditor::encode_piece(std::uint64_t first, std::span<const char> records, std::size_t begin, std::size_t end,
                                std::span<char> edited) const {
  const std::size_t size = from_.record_size, size_out = to_.layout().record_size, each = from_.points_per_record;
  const std::size_t from = begin * each, count = (end - begin) * each, channels = to_.channels().size();
  const std::span<char> out = edited.subspan(begin * size_out, (end - begin) * size_out);
  copy_records(records.subspan(begin * size, (end - begin) * size), size, size_out, out);
  if (sampling_.is_deformed)
    encode(to_.layout(), file_, first * each + from, std::span(positions_).subspan(3 * from, 3 * count),
           normals_.empty() ? std::span<const float>() : std::span(normals_).subspan(3 * from, 3 * count), out);
  write_channels(std::span(values_).subspan(channels * from, channels * count), out);
}

void RecordEditor::sort_points(std::size_t begin, std::size_t end) {
  const std::vector<std::uint32_t> order = spatial_order(std::span(local_).subspan(begin, end - begin));
  for (std::size_t i = 0; i < order.size(); ++i) order_[begin + i] = static_cast<std::uint32_t>(begin) + order[i];
}

void RecordEditor::edit_points(std::size_t begin, std::size_t end) {
  NearSamples near(*sampling_.store, options_.neighbours);
  std::size_t searches = 0, away = 0;
  for (std::span<const std::uint32_t> order(&order_[begin], end - begin); !order.empty(); ++searches) {
    const std::size_t count = gather(order, near);
    for (const std::uint32_t i : order.first(count)) {
      if (!is_finite(local_[i])) continue;
      edit_point(i, near, near.find(local_[i], options_.singular));
      away += near.is_away() ? 1 : 0;
    }
    order = order.subspan(count);
  }
  searches_ += searches;
  away_ += away;
}

// Gathers the samples around the next points that lie within the reach of the last search. Returns their number.
std::size_t RecordEditor::gather(std::span<const std::uint32_t> order, NearSamples& near) const {
  Vector3f low = local_[order[0]], high = low;
  if (!is_finite(low)) return 1;
  const float most = 4 * near.reach() * near.reach();
  std::size_t count = 1;
  for (; count < order.size(); ++count) {
    const Vector3f wider_low = common::least(low, local_[order[count]]);
    const Vector3f wider_high = common::greatest(high, local_[order[count]]);
    if (!(common::squared_distance(wider_low, wider_high) <= most)) break;
    low = wider_low;
    high = wider_high;
  }
  near.gather((low + high) * 0.5F);
  return count;
}

void RecordEditor::edit_point(std::size_t i, const NearSamples& near, std::span<const Neighbour> neighbours) {
  const Vector3f p = local_[i];
  interpolate(near.samples(), neighbours, values_.data() + to_.channels().size() * i);
  if (!sampling_.is_deformed || stay(near.samples(), neighbours)) return;
  const bool has_normals = !normals_.empty();
  const Vector3f normal = has_normals ? common::vector_at(std::span<const float>(normals_), i) : Vector3f{};
  const Deformed moved = deform(near.samples(), p, normal, neighbours);
  for (std::size_t k = 0; k < 3; ++k) {
    positions_[3 * i + k] += static_cast<double>(moved.position[k]) - static_cast<double>(p[k]);
    if (has_normals) normals_[3 * i + k] = moved.normal[k];
  }
}

void RecordEditor::interpolate(const Samples& samples, std::span<const Neighbour> near, EditedValue* values) const {
  const std::size_t width = sampling_.channels.size();
  for (const WrittenChannel& channel : to_.channels()) *values++ = edited_value(samples, near, width, channel.column);
}

// Writes the channels of the points that an edited sample is near to. The records have the values before.
void RecordEditor::write_channels(std::span<const EditedValue> values, std::span<char> records) const {
  const Layout& layout = to_.layout();
  const std::size_t width = to_.channels().size();
  if (layout.points_per_record != 1) return;
  const Column column{layout.record_size, records.size() / layout.record_size, layout.swapped};
  std::vector<double> mixed(column.count);
  for (std::size_t k = 0; k < width; ++k) {
    const WrittenChannel& channel = to_.channels()[k];
    const auto is_kept = [&](std::size_t i) { return values[width * i + k].share == 0; };
    std::size_t kept = 0;
    for (std::size_t i = 0; i < column.count; ++i) kept += is_kept(i) ? 1 : 0;
    if (kept == column.count) continue;
    read_column(channel.field, column, records.data(), mixed.data(), 1);
    for (std::size_t i = 0; i < column.count; ++i)
      if (!is_kept(i)) mixed[i] = channel.scale * values[width * i + k].mixed_with(mixed[i] / channel.scale);
    write_column(channel.field, column, records.data(), mixed.data(), 1);
  }
}

}  // namespace glark::stream
