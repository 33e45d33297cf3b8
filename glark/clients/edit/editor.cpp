// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/edit/editor_state.h"

namespace glark::edit {

Editor::Editor(Sampling sampling, EditorOptions options)
    : state_(std::make_unique<State>(std::move(sampling), std::move(options))) {}
Editor::~Editor() = default;
Editor::Editor(Editor&& other) noexcept = default;
Editor& Editor::operator=(Editor&& other) noexcept = default;

void Editor::apply(const Operation& operation) {
  if (const auto* symmetric = std::get_if<Symmetric>(&operation); symmetric != nullptr && symmetric->axis > 2)
    throw Error(Element::operation, 0, "symmetric: the axis is not 0, 1 or 2");
  if (const auto* project = std::get_if<Project>(&operation);
      project != nullptr && project->picture.find_first_of("\"\n") != std::string::npos)
    throw Error(Element::operation, 0, "project: the name of the picture has a quote or a line break; rename it");
  // The checks of the text are those of the numbers: an operation of a program meets the same ones.
  state_->apply(parse(text_of(operation)));
}

std::size_t Editor::size() const { return state_->shape.size(); }
std::size_t Editor::undo_count() const { return state_->history.undo_count(); }
std::size_t Editor::redo_count() const { return state_->history.redo_count(); }
const Symmetric& Editor::symmetric() const { return state_->symmetric; }

std::span<const double> Editor::positions() const { return state_->shape.now.positions; }
std::span<const float> Editor::normals() const { return state_->shape.now.normals; }
std::span<const double> Editor::positions_before() const { return state_->shape.before.positions; }
std::span<const float> Editor::normals_before() const { return state_->shape.before.normals; }
std::span<const std::uint8_t> Editor::colours() const {
  if (!state_->shape.has_colours) return {};
  return state_->shape.now.colours;
}
std::span<const std::uint8_t> Editor::colours_before() const {
  if (!state_->shape.had_colours) return {};
  return state_->shape.before.colours;
}

}  // namespace glark::edit
