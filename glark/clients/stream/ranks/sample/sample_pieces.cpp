// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/ranks/sample/sample_pieces.h"

#include <algorithm>

#include "glark/clients/stream/ranks/agreement.h"

namespace glark::stream {
namespace {

constexpr std::uint64_t samples_of_piece = 1 << 16;
constexpr std::size_t samples_of_buffer = 1 << 12;

std::vector<std::uint64_t> ends_of_pieces(const std::vector<std::uint64_t>& counts) {
  std::vector<std::uint64_t> ends;
  std::uint64_t samples = 0;
  for (std::size_t cell = 0; cell < counts.size(); ++cell) {
    if (samples > 0 && samples + counts[cell] > samples_of_piece) {
      ends.push_back(cell);
      samples = 0;
    }
    samples += counts[cell];
  }
  ends.push_back(counts.size());
  return ends;
}

}  // namespace

void SampleSpool::add(const SentSample& sample) {
  buffer_.push_back(sample);
  ++count_;
  if (buffer_.size() == samples_of_buffer) flush();
}

void SampleSpool::flush() {
  file_.append(bytes_of(std::span<const SentSample>(buffer_)));
  buffer_.clear();
}

std::vector<SentSample> SampleSpool::read(std::uint64_t first, std::uint64_t count) {
  if (!buffer_.empty()) flush();
  std::vector<SentSample> samples(static_cast<std::size_t>(count));
  file_.read(first * sizeof(SentSample), bytes_of(samples));
  return samples;
}

SamplePieces::SamplePieces(Ranks& ranks, const Shares& shares, SampleSpool& spool,
                           const std::vector<std::uint64_t>& own_counts, const std::vector<std::uint64_t>& counts)
    : ranks_(ranks),
      shares_(shares),
      spool_(spool),
      own_counts_(own_counts),
      counts_(counts),
      received_(ranks.size()),
      taken_(ranks.size()) {
  if (ranks.rank() == 0) ends_ = ends_of_pieces(counts);
  broadcast_values(ranks, ends_);
}

// The samples of this rank in the next piece.
std::vector<SentSample> SamplePieces::own_part() {
  std::uint64_t count = 0;
  for (; next_owned_ < own_counts_.size() && shares_.owned[next_owned_] < ends_[piece_]; ++next_owned_)
    count += own_counts_[next_owned_];
  std::vector<SentSample> samples = spool_.read(sent_, count);
  sent_ += count;
  return samples;
}

// problem: of this rank since the last piece.
void SamplePieces::exchange_piece(const std::string& problem) {
  std::vector<SentSample> own;
  require_no_problem(ranks_, problem.empty() ? problem_of([&] { own = own_part(); }) : problem);
  gather(ranks_, bytes_of(std::span<const SentSample>(own)), [&](std::size_t from, std::span<const char> bytes) {
    received_[from].resize(bytes.size() / sizeof(SentSample));
    std::copy(bytes.begin(), bytes.end(), bytes_of(received_[from]).begin());
  });
  std::fill(taken_.begin(), taken_.end(), 0);
  ++piece_;
}

void SamplePieces::send_all() {
  while (piece_ < ends_.size()) exchange_piece({});
  require_no_problem(ranks_, {});  // rank 0 has written all
}

void SamplePieces::add_samples(std::size_t cell, CellSamples& samples) {
  while (piece_ == 0 || cell >= ends_[piece_ - 1]) exchange_piece({});
  const std::uint32_t owner = shares_.owners[cell];
  for (std::uint64_t i = 0; i < counts_[cell]; ++i) {
    const SentSample& sent = received_[owner][taken_[owner]++];
    ClusterNode node;
    node.normal = sent.normal;
    node.colour = sent.colour;
    node.count = sent.count;
    node.square = sent.square;
    samples.add({sent.position, node});
  }
}

void SamplePieces::write_all(const std::function<void(const SelectCell&)>& write) {
  std::string problem;
  try {
    write([&](std::size_t cell, Chooser&, CellSamples& samples) { add_samples(cell, samples); });
    while (piece_ < ends_.size()) exchange_piece({});  // pieces without samples
  } catch (const RanksError&) {                        // the others have thrown it, too
    throw;
  } catch (const std::exception& error) {
    problem = error.what();
  }
  require_no_problem(ranks_, problem);
}

}  // namespace glark::stream
