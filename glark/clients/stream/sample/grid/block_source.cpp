// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/sample/grid/block_source.h"

#include <algorithm>

namespace glark::stream {

BlockSource::BlockSource(const Source& source, const ReadOptions& options, const common::Workers& workers)
    : source_(source), options_(options), workers_(workers), first_(source.open(options)) {}

Points BlockSource::read(PointReader& reader, std::uint64_t most) const {
  try {
    return reader.read(static_cast<std::size_t>(most));
  } catch (const Error& error) {
    if (error.element() != Element::point || options_.keep_invalid) throw;
    throw Error(error.element(), error.index(), std::string(error.what()) + " by the option skip_invalid");
  }
}

std::uint64_t BlockSource::each(std::uint64_t begin, std::uint64_t end, const Visit& visit) {
  if (!can_seek()) {
    if (begin < next_) {
      first_ = source_.open(options_);
      next_ = 0;
    }
    while (next_ < end) {
      const std::uint64_t wanted = next_ < begin ? begin : end;
      const Points points = read(*first_, std::min<std::uint64_t>(piece, wanted - next_));
      if (points.size() == 0) break;
      if (next_ >= begin) visit(points);
      next_ += points.size();
    }
    return next_ > begin ? next_ - begin : 0;
  }
  end = std::min(end, count().value_or(end));
  if (begin >= end) return 0;
  workers_.in_pieces(static_cast<std::size_t>(end - begin), piece, [&](std::size_t from, std::size_t to) {
    std::unique_ptr<PointReader>& reader = readers_.local();
    if (!reader) reader = source_.open(options_);
    reader->seek(begin + from);
    for (std::size_t done = from; done < to;) {
      const Points points = read(*reader, to - done);
      visit(points);
      done += points.size();
    }
  });
  return end - begin;
}

}  // namespace glark::stream
