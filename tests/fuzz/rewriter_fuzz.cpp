// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Any text as a vertex stage: no crash, no hang, and as many derived shaders as there were shaders. The first byte chooses
// among the requests, a NUL ends a shader.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "glark/core/refine/derive.h"
#include "glark/core/refine/glsl/geometry_shader.h"
#include "glark/core/refine/glsl/rewrite.h"
#include "glark/core/refine/glsl/types.h"

namespace {

using namespace glark;

const std::vector<std::string> extensions = {"GL_ARB_gpu_shader5", "GL_ARB_shader_draw_parameters"};

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> shaders;
  std::size_t begin = 0;
  for (std::size_t end = 0; end != std::string::npos; begin = end + 1) {
    end = text.find('\0', begin);
    shaders.push_back(text.substr(begin, end == std::string::npos ? end : end - begin));
  }
  return shaders;
}

// Returns the record from the inputs as GL would report them: numbers only, arrays of a few elements, in the order of declaration.
capture::Layout layout_of(const std::vector<std::string>& shaders, bool es, const refine::VertexStageTraits& traits) {
  std::vector<refine::VertexUnit> units;
  std::string error;
  capture::Layout layout;
  const auto add = [&](const std::string& name, const refine::NumericType& type, bool is_array) {
    capture::Field field{.name = name, .type = type.gl, .array_size = is_array ? 2 : 1, .is_array = is_array};
    field.offset = layout.corner_words;
    field.words = field.array_size * type.words();
    layout.corner_words += field.words;
    layout.fields.push_back(field);
  };
  if (!refine::read_units(shaders, es, extensions, units, error)) return layout;
  for (const refine::VertexUnit& unit : units) {
    for (const refine::Declaration& declaration : unit.interface.declarations) {
      if (declaration.storage != refine::Storage::input) continue;
      for (const refine::Variable& variable : declaration.variables) {
        const refine::NumericType* const type = refine::numeric_type(std::string_view(variable.type));
        if (type != nullptr && layout.fields.size() < 16) add(variable.name, *type, !variable.sizes.empty());
      }
    }
  }
  for (const std::string& name : traits.system_values) add(name, *refine::numeric_type(std::string_view("int")), false);
  return layout;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const unsigned choice = data[0];
  const std::vector<std::string> shaders = split(std::string(reinterpret_cast<const char*>(data) + 1, size - 1));
  refine::DeriveRequest request;
  request.vertex_sources = shaders;
  request.es = (choice & 1U) != 0;
  const refine::Inspection inspection = refine::inspect_vertex_stage(shaders, request.es, extensions);
  if (refine::makes_its_own_positions(shaders) && refine::words_of_positions(shaders).empty()) std::abort();
  if (inspection.ok == !inspection.error.empty()) std::abort();
  if (!inspection.ok) return 0;
  request.layout = layout_of(shaders, request.es, inspection.traits);
  request.refinement = (choice & 2U) != 0   ? core::Refinement::linear_outputs
                       : (choice & 4U) != 0 ? core::Refinement::pn
                                            : core::Refinement::linear_inputs;
  request.placed = (choice & 8U) != 0;
  request.stored = (choice & 16U) != 0;
  request.outputs.flat_colors = (choice & 32U) != 0;
  request.outputs.clamp_colors = (choice & 64U) != 0;
  request.provoking_corner = (choice & 128U) != 0 ? 0 : 2;
  request.extensions = extensions;
  const refine::Derivation derivation = refine::derive_vertex_stage(request);
  if (derivation.ok ? derivation.vertex_sources.size() != shaders.size() : derivation.error.empty()) std::abort();
  return 0;
}
