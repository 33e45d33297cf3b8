// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/plan/draw_notes.h"

#include <gtest/gtest.h>

namespace glark::core {

TEST(DrawNotes, ADrawThatGetsEverythingHasNone) { EXPECT_EQ(note_bits({.refinement = Refinement::pn}), 0u); }

TEST(DrawNotes, EachNoteHasItsBitAndItsMessage) {
  const DrawNoteFacts facts{.refinement = Refinement::linear_inputs,
                            .fallback = RefinementFallback::no_normal,
                            .transparent = false,
                            .ignores_shader = true,
                            .undisplaced = true};
  const unsigned bits = note_bits(facts);
  const std::vector<DrawNote> notes = draw_notes(facts, bits);
  ASSERT_EQ(notes.size(), 3u);
  EXPECT_EQ(notes[0].id, MessageId::other_refinement);
  EXPECT_EQ(notes[1].id, MessageId::ignored_shader);
  EXPECT_EQ(notes[2].id, MessageId::not_displaced);
  EXPECT_NE(notes[0].text.find("is refined by linear: "), std::string::npos) << notes[0].text;
  EXPECT_EQ(notes[0].text.find("--normal"), std::string::npos) << notes[0].text;  // no option of glark run
  EXPECT_TRUE(draw_notes(facts, 0).empty());
}

TEST(DrawNotes, FixedFunctionHasNoAttributesToName) {
  const DrawNoteFacts facts{.fallback = RefinementFallback::no_normal, .fixed_function = true};
  EXPECT_NE(draw_notes(facts, note_bits(facts)).at(0).text.find("lighting"), std::string::npos);
}

TEST(DrawNotes, AUserIsToldTheOptions) {
  const DrawNoteFacts facts{.fallback = RefinementFallback::no_normal, .transparent = true};
  EXPECT_NE(draw_notes(facts, note_bits(facts)).at(0).text.find("--normal"), std::string::npos);
}

TEST(DrawNotes, BitsOfReasonsDiffer) {
  unsigned all = 0;
  for (unsigned i = 0; i < refinement_fallback_count; ++i) {
    const unsigned bit = note_bits({.fallback = static_cast<RefinementFallback>(i)});
    EXPECT_EQ(all & bit, 0u);
    all |= bit;
  }
  EXPECT_EQ(all & note_bits({.ignores_shader = true}), 0u);
  EXPECT_EQ(note_bits({.ignores_shader = true}) & note_bits({.undisplaced = true}), 0u);
}

}  // namespace glark::core
