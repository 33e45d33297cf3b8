// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/frames/frame_capture.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

#include "glark/core/report/log.h"
#include "shim/contexts/contexts.h"
#include "shim/frames/read_frame.h"
#include "shim/report/options.h"
#include "shim/report/statistics.h"

namespace glark::shim {
namespace {

void write_png(core::Context& context, const settings::CaptureRequest& request) {
  const Size size = current_size();
  const auto complain = [&](std::string_view reason) {
    core::log(core::LogLevel::error,
              fmt::format("frame {} cannot be written to {}: {}", request.frame, request.file, reason));
  };
  if (size.width <= 0 || size.height <= 0) {
    complain("the size of the window is unknown");
    return;
  }
  const std::vector<unsigned char> colors = read_frame(context, size);
  errno = 0;
  if (stbi_write_png(request.file.c_str(), size.width, size.height, 3, colors.data(), 0) == 0)
    complain(fmt::format("{}; name a file in a folder that exists and can be written with GLARK_CAPTURE",
                         errno != 0 ? std::strerror(errno) : "writing failed"));
}

// The user of a program that ended early learns why there is no picture.
__attribute__((destructor)) void report_missing_frames() {
  if (!has_made_context()) return;
  const unsigned long ended = current_frame() - 1;
  for (const settings::CaptureRequest& request : options().captures)
    if (request.frame > ended)
      core::log(core::LogLevel::warning,
                fmt::format("frame {} was not written to {}: the program ended after frame {}; choose an earlier one",
                            request.frame, request.file, ended));
}

}  // namespace

void capture_frame(core::Context& context, unsigned long frame) {
  for (const settings::CaptureRequest& request : options().captures)
    if (request.frame == frame) write_png(context, request);
}

}  // namespace glark::shim
