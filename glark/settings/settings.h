// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What a user may ask of glark through environment variables: their names, values and limits. The launcher sets them, the
// shim reads them. No GL here.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "glark/core/refinement.h"
#include "glark/core/report.h"

namespace glark::settings {

namespace variable {
inline constexpr char enable[] = "GLARK_ENABLE";            // 1: refine a program that does not know of glark
inline constexpr char level[] = "GLARK_LEVEL";              // 0..11: uniform level of refinement
inline constexpr char max_level[] = "GLARK_MAX_LEVEL";      // 0..11: deepest level that patterns are made for
inline constexpr char refine[] = "GLARK_REFINE";            // linear, outputs or pn
inline constexpr char edge_pixels[] = "GLARK_EDGE_PIXELS";  // depths from the screen: longest segment, in pixels
inline constexpr char curvature[] = "GLARK_CURVATURE";  // depths from normals: greatest turn of a segment, in degrees
inline constexpr char budget[] = "GLARK_BUDGET";        // refined triangles a frame that those give way to
inline constexpr char wireframe[] = "GLARK_WIREFRAME";  // 1: draw the refined triangles as lines
inline constexpr char capture[] = "GLARK_CAPTURE";      // FRAME:FILE.png[,FRAME:FILE.png...]; the first frame is 1
inline constexpr char log[] = "GLARK_LOG";              // error, warning, info or debug
inline constexpr char statistics[] = "GLARK_STATS";     // FILE.json
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
};

// A value that is not understood leaves its setting at the default and adds a sentence to `problems`.
struct Parsed {
  Settings settings;
  std::vector<std::string> problems;
};

// `environment`: as `environ`, "NAME=value" strings up to a null pointer; may be null.
Parsed parse(const char* const* environment);

// Of single values; nothing if the text is not one. What would be one, in words, is in needed_*().
std::optional<unsigned> parse_level(std::string_view text);
std::optional<core::Refinement> parse_refinement(std::string_view text);
std::optional<float> parse_edge_pixels(std::string_view text);
std::optional<float> parse_curvature(std::string_view text);
std::optional<unsigned> parse_budget(std::string_view text);
std::optional<core::LogLevel> parse_log_level(std::string_view text);
std::optional<bool> parse_switch(std::string_view text);
// A comma separates requests only where a frame number follows it.
std::optional<std::vector<CaptureRequest>> parse_captures(std::string_view text);

std::string_view needed_level();
std::string_view needed_refinement();
std::string_view needed_edge_pixels();
std::string_view needed_curvature();
std::string_view needed_budget();
std::string_view needed_log_level();
std::string_view needed_switch();
std::string_view needed_captures();

}  // namespace glark::settings
