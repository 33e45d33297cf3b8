// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/edit/history/change.h"

#include <cassert>
#include <cstring>

namespace glark::edit {
namespace {

// Calls each(array) for all arrays of a change, in their order in the file.
template <class AnyChange, class Each>
void each_array(AnyChange& change, const Each& each) {
  each(change.moved);
  each(change.turned);
  each(change.painted);
  each(change.positions);
  each(change.normals);
  each(change.colours);
  each(change.added_before.positions);
  each(change.added_before.normals);
  each(change.added_before.colours);
  each(change.added.positions);
  each(change.added.normals);
  each(change.added.colours);
}

template <class Value>
void put(std::vector<char>& bytes, const Value* values, std::size_t count) {
  if (count == 0) return;
  const std::size_t begin = bytes.size();
  bytes.resize(begin + count * sizeof(Value));
  std::memcpy(&bytes[begin], values, count * sizeof(Value));
}

template <class Value>
void take(std::span<const char>& bytes, Value* values, std::size_t count) {
  const std::size_t size = count * sizeof(Value);
  assert(bytes.size() >= size);
  if (size > 0) std::memcpy(values, bytes.data(), size);
  bytes = bytes.subspan(size);
}

void exchange_samples(Change& change, Shape& shape, const common::Workers& workers) {
  if (change.added.size() == 0) return;
  if (shape.size() > change.first) {
    shape.before.cut(change.first);
    shape.now.cut(change.first);
  } else {
    shape.before.append(change.added_before);
    shape.now.append(change.added);
  }
  shape.graph = make_graph(shape, workers);
}

}  // namespace

void exchange(Change& change, Shape& shape, const common::Workers& workers) {
  Samples& now = shape.now;
  for (std::size_t k = 0; k < change.moved.size(); ++k) {
    const std::uint32_t i = change.moved[k];
    const Vector3d p = now.position(i);
    now.set_position(i, change.positions[k]);
    change.positions[k] = p;
  }
  for (std::size_t k = 0; k < change.turned.size(); ++k) {
    const std::uint32_t i = change.turned[k];
    const Vector3f n = now.normal(i);
    now.set_normal(i, change.normals[k]);
    change.normals[k] = n;
  }
  for (std::size_t k = 0; k < change.painted.size(); ++k) {
    const std::uint32_t i = change.painted[k];
    const Colour colour = now.colour(i);
    now.set_colour(i, change.colours[k]);
    change.colours[k] = colour;
  }
  std::swap(change.has_colours, shape.has_colours);
  exchange_samples(change, shape, workers);
}

std::vector<char> bytes_of(const Change& change) {
  std::vector<char> bytes;
  const std::uint64_t head[] = {change.first, change.has_colours ? 1U : 0U};
  put(bytes, head, 2);
  each_array(change, [&](const auto& array) {
    const std::uint64_t count = array.size();
    put(bytes, &count, 1);
    put(bytes, array.data(), array.size());
  });
  return bytes;
}

Change change_of(std::span<const char> bytes) {
  Change change;
  std::uint64_t head[2] = {};
  take(bytes, head, 2);
  change.first = head[0];
  change.has_colours = head[1] != 0;
  each_array(change, [&](auto& array) {
    std::uint64_t count = 0;
    take(bytes, &count, 1);
    array.resize(count);
    take(bytes, array.data(), array.size());
  });
  return change;
}

}  // namespace glark::edit
