// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The points of a source, read by several threads where the source can seek.
#pragma once

#include <glark/stream.h>
#include <tbb/enumerable_thread_specific.h>

#include <functional>
#include <memory>

#include "glark/clients/common/workers.h"

namespace glark::stream {

class BlockSource {
 public:
  static constexpr std::size_t piece = 1 << 14;  // points

  BlockSource(const Source& source, const ReadOptions& options, const common::Workers& workers);

  const Schema& schema() const { return first_->schema(); }
  std::optional<std::uint64_t> count() const { return first_->count(); }
  bool can_seek() const { return first_->can_seek(); }
  const std::string& name() const { return first_->name(); }

  // Calls visit(points) for pieces of the points from `begin` to `end` at most, in any order and on any thread. Returns
  // the number of points. Without seeking, each call must begin where the last one ended, or at 0.
  using Visit = std::function<void(const Points&)>;
  std::uint64_t each(std::uint64_t begin, std::uint64_t end, const Visit& visit);

 private:
  // Names the option that leaves out a point whose coordinates are not finite.
  Points read(PointReader& reader, std::uint64_t most) const;

  const Source& source_;
  ReadOptions options_;
  const common::Workers& workers_;
  std::unique_ptr<PointReader> first_;
  std::uint64_t next_ = 0;
  tbb::enumerable_thread_specific<std::unique_ptr<PointReader>> readers_;
};

}  // namespace glark::stream
