# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
#
# glark_fmt: libfmt for libGLARK.so and the launcher. Client libraries use fmt::fmt-header-only, because they are
# installed as archives.
find_package(fmt REQUIRED)
add_library(glark_fmt STATIC ${PROJECT_SOURCE_DIR}/cmake/fmt.cpp)
target_link_libraries(glark_fmt PRIVATE glark_options)
