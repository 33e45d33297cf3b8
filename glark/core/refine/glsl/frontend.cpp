// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/glsl/frontend.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <mutex>
#include <unordered_set>
#include <utility>

#include "glark/core/refine/glsl/interface.h"
#include "glark/core/refine/syntax/shadowing.h"

namespace glark::refine {
namespace {

// glark sets no limits of its own: the driver has already accepted the shader.
TBuiltInResource generous_resources() {
  TBuiltInResource resources = *GetDefaultResources();
  int* const begin = &resources.maxLights;
  int* const end = reinterpret_cast<int*>(&resources.limits);
  std::for_each(begin, end, [](int& value) { value = std::max(value, 0); });
  for (int* limit : {&resources.maxVertexAttribs, &resources.maxTextureUnits, &resources.maxTextureCoords,
                     &resources.maxDrawBuffers, &resources.maxClipDistances, &resources.maxCullDistances,
                     &resources.maxCombinedClipAndCullDistances, &resources.maxClipPlanes, &resources.maxLights}) {
    *limit = std::max(*limit, 32);
  }
  for (int* limit :
       {&resources.maxVertexUniformComponents, &resources.maxVertexUniformVectors, &resources.maxVaryingFloats,
        &resources.maxVaryingVectors, &resources.maxVaryingComponents, &resources.maxVertexOutputComponents,
        &resources.maxVertexOutputVectors, &resources.maxVertexTextureImageUnits,
        &resources.maxCombinedTextureImageUnits, &resources.maxImageUnits, &resources.maxVertexImageUniforms,
        &resources.maxCombinedImageUniforms, &resources.maxAtomicCounterBindings, &resources.maxVertexAtomicCounters,
        &resources.maxVertexAtomicCounterBuffers, &resources.maxAtomicCounterBufferSize,
        &resources.maxTransformFeedbackBuffers, &resources.maxTransformFeedbackInterleavedComponents}) {
    *limit = std::max(*limit, 1 << 20);
  }
  resources.limits = {true, true, true, true, true, true, true, true, true};
  return resources;
}

const TBuiltInResource& resources() {
  static const TBuiltInResource value = generous_resources();
  return value;
}

void initialize() {
  static std::once_flag once;
  std::call_once(once, [] { glslang::InitializeProcess(); });
}

constexpr auto messages = static_cast<EShMessages>(EShMsgRelaxedErrors | EShMsgSuppressWarnings);

int default_version(bool es) { return es ? 100 : 110; }

std::string first_error(const char* log) {
  const std::string text = log != nullptr ? log : "";
  std::size_t begin = text.find("ERROR:");
  if (begin == std::string::npos) begin = 0;
  const std::string line = text.substr(begin, text.find('\n', begin) - begin);
  return line.empty() ? "the GLSL front end gave no reason" : line;
}

bool is_extension_macro(const std::string& name) {
  static const std::unordered_set<std::string> others = {"GL_ES", "GL_core_profile", "GL_compatibility_profile",
                                                         "GL_es_profile", "GL_FRAGMENT_PRECISION_HIGH"};
  return name.starts_with("GL_") && !others.contains(name);
}

constexpr const char* present_prefix = "glark_present_";
constexpr const char* absent_prefix = "glark_absent_";

bool tests_macros(std::string_view directive) {
  return directive == "if" || directive == "ifdef" || directive == "ifndef" || directive == "elif" ||
         directive == "define";
}

// glslang rejects `require` of an unknown extension, although the driver has accepted it.
void relax_requirement(Token& directive) {
  Tokens body = tokenize(std::string_view(directive.text).substr(1));
  for (Token& token : body) {
    if (token.is("require")) token.text = "enable";
  }
  directive.text = "#" + to_text(body);
}

// glslang pastes tokens only from GLSL 1.30 on; drivers paste them in every version. So glslang gets another version,
// and the application's is restored afterwards.
struct VersionDisguise {
  std::string directive;  // the application's #version, or empty
  bool worn = false;
};
constexpr const char* disguised_version = "#version 130";

VersionDisguise disguise_version(Tokens& tokens, bool es) {
  VersionDisguise disguise;
  const GlslVersion version = version_of(tokens, es);
  const bool pastes = std::any_of(tokens.begin(), tokens.end(), [](const Token& token) {
    return token.kind == TokenKind::directive && token.text.find("##") != std::string::npos;
  });
  disguise.worn = pastes && !version.es && version.number < 130;
  if (!disguise.worn) return disguise;
  const auto is_version = [](const Token& token) { return directive_name(token) == "version"; };
  const auto directive = std::find_if(tokens.begin(), tokens.end(), is_version);
  if (directive != tokens.end()) {
    disguise.directive = directive->text;
    directive->text = disguised_version;
  } else {
    tokens.front().before.insert(0, std::string(disguised_version) + "\n");
  }
  const std::string number = std::to_string(version.number);
  rename_identifiers(
      tokens, [&](const std::string& name) { return name == "__VERSION__" ? number : std::string(); }, tests_macros);
  return disguise;
}

void remove_disguise(const VersionDisguise& disguise, std::string& text) {
  const std::size_t at = disguise.worn ? text.find(disguised_version) : std::string::npos;
  if (at != std::string::npos) text.replace(at, std::string_view(disguised_version).size(), disguise.directive);
}

// The source as glslang must see it, and the macros to define in front of it.
std::string adapt_source(Tokens tokens, const std::vector<std::string>& extensions, std::string& preamble) {
  for (Token& token : tokens) {
    if (directive_name(token) == "extension") relax_requirement(token);
  }
  if (!extensions.empty()) {
    const std::unordered_set<std::string> known(extensions.begin(), extensions.end());
    std::unordered_set<std::string> present;
    rename_identifiers(
        tokens,
        [&](const std::string& name) -> std::string {
          if (!is_extension_macro(name)) return {};
          if (!known.contains(name)) return absent_prefix + name;
          present.insert(name);
          return present_prefix + name;
        },
        tests_macros);
    for (const std::string& name : present) preamble += std::string("#define ") + present_prefix + name + " 1\n";
  }
  return to_text(tokens);
}

// Some drivers accept more than glslang: subroutines, built-ins of vendors' extensions, features of newer versions.
bool is_limitation(const std::string& error) {
  return error.find("not yet implemented") != std::string::npos || error.find("not supported") != std::string::npos ||
         (error.find("'gl_") != std::string::npos && error.find("undeclared") != std::string::npos);
}

}  // namespace

Preprocessed preprocess(const std::string& source, bool es, const std::vector<std::string>& extensions) {
  initialize();
  std::string preamble;
  Tokens tokens = tokenize(source);
  const VersionDisguise disguise = disguise_version(tokens, es);
  const std::string adapted = adapt_source(std::move(tokens), extensions, preamble);
  const char* const text = adapted.c_str();
  const int length = static_cast<int>(adapted.size());
  glslang::TShader shader(EShLangVertex);
  shader.setStringsWithLengths(&text, &length, 1);
  shader.setPreamble(preamble.c_str());
  glslang::TShader::ForbidIncluder includer;
  Preprocessed result;
  result.ok =
      shader.preprocess(&resources(), default_version(es), ENoProfile, false, false, messages, &result.text, includer);
  if (!result.ok) result.error = first_error(shader.getInfoLog());
  remove_disguise(disguise, result.text);
  return result;
}

namespace {

Parsed parse(const std::string& preprocessed, bool es) {
  const char* const text = preprocessed.c_str();
  const int length = static_cast<int>(preprocessed.size());
  glslang::TShader shader(EShLangVertex);
  shader.setStringsWithLengths(&text, &length, 1);
  // The tree is written to the debug log.
  constexpr auto with_tree = static_cast<EShMessages>(messages | EShMsgAST);
  Parsed result;
  result.ok = shader.parse(&resources(), default_version(es), ENoProfile, false, false, with_tree);
  if (!result.ok) {
    result.error = first_error(shader.getInfoLog());
    result.limited = is_limitation(result.error);
    return result;
  }
  result.tree = std::make_unique<const SyntaxTree>(shader.getInfoDebugLog(), shadowing_names(tokenize(preprocessed)));
  result.writes_memory = writes_memory(*result.tree);
  return result;
}

// The front end has the built-ins of GL_ARB_shader_draw_parameters from GLSL 4.50 on, drivers have them in every version.
std::string with_draw_parameters(const std::string& preprocessed, bool es) {
  Tokens tokens = tokenize(preprocessed);
  const auto directive =
      std::find_if(tokens.begin(), tokens.end(), [](const Token& token) { return directive_name(token) == "version"; });
  const GlslVersion version = version_of(tokens, es);
  if (directive == tokens.end() || version.es || version.number >= 450) return {};
  directive->text = version.compatibility ? "#version 450 compatibility" : "#version 450";
  return to_text(tokens);
}

bool names_draw_parameter(const std::string& error) {
  constexpr std::array names = {"'gl_BaseVertexARB'", "'gl_BaseInstanceARB'", "'gl_DrawIDARB'"};
  return std::any_of(names.begin(), names.end(),
                     [&](const char* name) { return error.find(name) != std::string::npos; });
}

}  // namespace

Parsed parse_vertex_shader(const std::string& preprocessed, bool es) {
  initialize();
  Parsed result = parse(preprocessed, es);
  if (!result.ok && names_draw_parameter(result.error)) {
    const std::string newer = with_draw_parameters(preprocessed, es);
    Parsed second = newer.empty() ? Parsed{} : parse(newer, es);
    if (second.ok) return second;
  }
  return result;
}

bool frontend_knows_extension(const std::string& name) {
  static std::mutex mutex;
  static std::unordered_set<std::string> known;
  static std::unordered_set<std::string> unknown;
  const std::scoped_lock lock(mutex);
  if (known.contains(name)) return true;
  if (unknown.contains(name)) return false;
  initialize();
  const std::string probe = "#version 450\n#extension " + name + " : require\nvoid main() {}\n";
  const char* const text = probe.c_str();
  glslang::TShader shader(EShLangVertex);
  shader.setStrings(&text, 1);
  glslang::TShader::ForbidIncluder includer;
  std::string output;
  const bool ok = shader.preprocess(&resources(), 450, ENoProfile, false, false, messages, &output, includer);
  (ok ? known : unknown).insert(name);
  return ok;
}

}  // namespace glark::refine
