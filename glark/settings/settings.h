// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The settings of a user: environment variables (the launcher sets them, the shim reads them) and a configuration file.
// table.h lists them. Nothing here calls GL.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "glark/core/context_options.h"
#include "glark/core/refinement.h"
#include "glark/core/report/log.h"
#include "glark/settings/names/keys.h"

namespace glark::settings {

namespace variable {
inline constexpr char enable[] = "GLARK_ENABLE";    // 1: refine a program that does not call the extension
inline constexpr char config[] = "GLARK_CONFIG";    // FILE: replaces the configuration file of the XDG folders
inline constexpr char library[] = "GLARK_LIBRARY";  // FILE: the library that the launcher preloads
}  // namespace variable

struct CaptureRequest {
  unsigned frame = 0;
  std::string file;
  bool operator==(const CaptureRequest&) const = default;
};

struct Settings {
  core::ContextOptions context;  // `transparent` needs GLARK_ENABLE
  core::LogLevel log_level = core::LogLevel::warning;
  std::vector<CaptureRequest> captures;
  std::string statistics_file;            // empty: none
  std::string dump_folder;                // for the sources of shaders; empty: none
  std::string record_file;                // a film; empty: none
  bool overlay = false;                   // a panel may be opened over the program's frames
  bool overlay_open = false;              // it is open from the first frame on
  const Key* overlay_key = nullptr;       // opens and closes it
  const Key* toggle_key = nullptr;        // switches refinement off and on; null: no key does
  bool everything = false;                // refine every draw and shader
  bool leave_alone = false;               // refine nothing in this program
  std::set<std::string_view> given = {};  // keys that the user set, from the table

  bool is_given(std::string_view key) const { return given.contains(key); }
};

// An invalid value leaves its setting unchanged and adds a sentence to `problems`.
struct Parsed {
  Settings settings;
  std::vector<std::string> problems;
};

// Reads the configuration file, then the environment, which wins. `environment` is like `environ`: "NAME=value" strings
// up to a null pointer; it may be null. Of the file's tables, only those of the programs in `names` are read.
Parsed parse(const char* const* environment, std::span<const std::string> names = {});

// Returns the value of a variable, or nothing if the variable is unset.
std::optional<std::string_view> find_variable(const char* const* environment, std::string_view name);

// Parse single values; return nothing if the text is invalid. Setting::needed says in words which texts are valid.
std::optional<unsigned> parse_level(std::string_view text);
std::optional<core::Refinement> parse_refinement(std::string_view text);
std::optional<float> parse_shape_number(const core::ShapeNumber& number, std::string_view text);
std::optional<float> parse_edge_pixels(std::string_view text);
std::optional<float> parse_curvature(std::string_view text);
std::optional<float> parse_screen_error(std::string_view text);
std::optional<float> parse_crease(std::string_view text);
std::optional<unsigned> parse_budget(std::string_view text);
std::optional<std::uint64_t> parse_megabytes(std::string_view text);  // as bytes
std::optional<bool> parse_polygons(std::string_view text);            // true: at their centroids
std::optional<bool> parse_normals(std::string_view text);             // true: from geometry
std::optional<core::LogLevel> parse_log_level(std::string_view text);
std::optional<bool> parse_switch(std::string_view text);
std::optional<const Key*> parse_key(std::string_view text);  // null for "none"
// A comma separates requests only if a frame number follows it.
std::optional<std::vector<CaptureRequest>> parse_captures(std::string_view text);

// Lists, separated by commas.
std::optional<unsigned> parse_left_draws(std::string_view text);
std::optional<std::vector<std::uint64_t>> parse_hashes(std::string_view text);  // 16 hexadecimal digits each
std::optional<std::string> parse_attribute(std::string_view text);              // a GLSL name or a location

}  // namespace glark::settings
