// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The user's settings, from environment variables (the launcher sets them, the shim reads them) or a configuration file. table.h lists
// them all. No GL here.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "glark/core/refinement.h"
#include "glark/core/report.h"

namespace glark::settings {

namespace variable {
inline constexpr char enable[] = "GLARK_ENABLE";  // 1: refine a program that does not know of glark
inline constexpr char config[] = "GLARK_CONFIG";  // FILE: the configuration file, instead of those of the XDG folders
}  // namespace variable

struct CaptureRequest {
  unsigned frame = 0;
  std::string file;
  bool operator==(const CaptureRequest&) const = default;
};

struct Settings {
  core::ContextOptions context;  // transparent only with GLARK_ENABLE
  core::LogLevel log_level = core::LogLevel::warning;
  std::vector<CaptureRequest> captures;
  std::string statistics_file;  // empty: none
  std::string dump_folder;      // of the sources of derived programs; empty: none
  bool everything = false;      // no draw and no shader is left alone
  bool leave_alone = false;     // this program is not refined
  bool max_level_set = false;   // by the user
};

// A value that is not understood leaves its setting at the default and adds a sentence to `problems`.
struct Parsed {
  Settings settings;
  std::vector<std::string> problems;
};

// `environment`: as `environ`, "NAME=value" strings up to a null pointer; may be null. The configuration file's tables for the programs
// `names` are used. Variables override the file.
Parsed parse(const char* const* environment, std::span<const std::string> names = {});

// The value of a variable; nothing if it is not there.
std::optional<std::string_view> find_variable(const char* const* environment, std::string_view name);

// Each reads one value. Nothing if the text is not such a value.
std::optional<unsigned> parse_level(std::string_view text);
std::optional<core::Refinement> parse_refinement(std::string_view text);
std::optional<float> parse_shape_number(const core::ShapeNumber& number, std::string_view text);
std::optional<float> parse_edge_pixels(std::string_view text);
std::optional<float> parse_curvature(std::string_view text);
std::optional<unsigned> parse_budget(std::string_view text);
std::optional<bool> parse_polygons(std::string_view text);  // whether at their centroids
std::optional<core::LogLevel> parse_log_level(std::string_view text);
std::optional<bool> parse_switch(std::string_view text);
// A comma separates requests only where a frame number follows it.
std::optional<std::vector<CaptureRequest>> parse_captures(std::string_view text);

// A list with commas.
std::optional<unsigned> parse_left_draws(std::string_view text);
std::optional<std::vector<std::uint64_t>> parse_hashes(std::string_view text);  // 16 hexadecimal digits each
std::optional<std::string> parse_attribute(std::string_view text);              // a GLSL name or a location

}  // namespace glark::settings
