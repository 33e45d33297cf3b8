# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
#
# Every build checks that includes follow cmake/layers.txt: each target of ours depends on this one through
# glark_options.
add_custom_target(glark_layers
  COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/cmake/check_layers.py ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/generated
  COMMENT "Checking that includes follow cmake/layers.txt" VERBATIM)
add_dependencies(glark_options glark_layers)
