// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/plan/tell_notes.h"

#include <fmt/format.h>

#include <string>

#include "glark/core/refine/program/labels.h"
#include "glark/core/report/log.h"

namespace glark::core {

void tell_notes(const Environment& environment, Program& program, DrawNoteFacts facts) {
  const bool audible = !facts.transparent && environment.bindings().debug_output;
  ToldNotes& told = *program.told_notes;
  const unsigned all = note_bits(facts);
  const unsigned logs = all & ~told.logged;
  const unsigned sends = audible ? all & ~told.sent : 0;
  if ((logs | sends) == 0) {
    return;
  }
  told.logged |= logs;
  told.sent |= sends;
  const refine::OutputVariation* const position = program.traits.variation.position();
  facts.fixed_function = program.fixed_function;
  facts.construct = facts.fallback == RefinementFallback::unsound_stage && position != nullptr ? position->reason : "";
  const auto text_of_note = [&](const DrawNote& note) {
    return fmt::format("{} {}", refine::label(program), note.text);
  };
  for (const DrawNote& note : draw_notes(facts, logs)) {
    log(facts.transparent ? LogLevel::info : LogLevel::warning, text_of_note(note));
  }
  const DebugOutput application{environment.gl, audible, true};
  for (const DrawNote& note : draw_notes(facts, sends)) {
    application.send(note.id, text_of_note(note));
  }
}

}  // namespace glark::core
