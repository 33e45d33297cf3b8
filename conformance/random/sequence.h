// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Sequences of random commands and draws from the tables of row.h. Together, the sequences of a seed are a covering array
// of strength 2: each row comes before a draw by each path.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "conformance/random/row.h"

namespace glark::conformance {

// Either a row or a path. All its values follow from its own seed, so other steps can be left out.
struct RandomStep {
  const Row* row = nullptr;
  const RandomPath* path = nullptr;
  std::uint32_t seed = 0;
  int times = 1;  // how often the draw is refined
};

struct RandomSequence {
  WorldKind kind = WorldKind::stage;
  std::vector<RandomStep> steps = {};
};

// What a context has: its API, and the version of desktop GL.
struct Offer {
  Api api;
  int version;
};

std::vector<const Row*> rows_of(WorldKind kind, Offer offer);
std::vector<const RandomPath*> paths_of(WorldKind kind, Offer offer);

// How many sequences of a kind a seed has, so that each row meets each path.
std::size_t sequence_count(WorldKind kind);
std::vector<RandomSequence> random_sequences(std::uint32_t seed, WorldKind kind, Offer offer);

// What is wrong with a draw. The pictures are empty if it is not the picture.
struct WrongDraw {
  std::string what;
  Picture actual = {};
  Picture expected = {};
};

// Runs the sequence in a context of its own, up to the first draw that is wrong.
std::optional<WrongDraw> run(Test& t, const RandomSequence& sequence);

std::string text_of(const RandomSequence& sequence);

}  // namespace glark::conformance
