# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
#
# glark_embed_glsl(TARGET file.glsl ...): makes "generated/<path of the file>.inc" with the text as a raw string
# literal, to be included as: inline constexpr char source[] = #include "...". #include "..." lines within are expanded
# once.
function(glark_embed_glsl target)
  foreach(file ${ARGN})
    set(input ${CMAKE_CURRENT_SOURCE_DIR}/${file})
    file(RELATIVE_PATH relative ${PROJECT_SOURCE_DIR} ${input})
    set(output ${PROJECT_BINARY_DIR}/generated/${relative}.inc)
    add_custom_command(OUTPUT ${output}
      COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/cmake/embed_glsl.py ${PROJECT_SOURCE_DIR} ${input} ${output}
      DEPENDS ${input} ${PROJECT_SOURCE_DIR}/cmake/embed_glsl.py ${GLARK_GLSL_HEADERS}
      VERBATIM)
    target_sources(${target} PRIVATE ${output})
  endforeach()
endfunction()
set(GLARK_GLSL_HEADERS
  ${PROJECT_SOURCE_DIR}/glark/clients/qas/shader/precise.glsl
  ${PROJECT_SOURCE_DIR}/glark/core/pattern/pieces.glsl.h
  ${PROJECT_SOURCE_DIR}/glark/core/pattern/expand.glsl.h
  ${PROJECT_SOURCE_DIR}/glark/core/depth/measure/curve_points.glsl
  ${PROJECT_SOURCE_DIR}/glark/core/depth/measure/edge_depth.glsl
  ${PROJECT_SOURCE_DIR}/glark/core/depth/measure/hidden_triangle.glsl
  ${PROJECT_SOURCE_DIR}/glark/core/depth/measure/limits.glsl
  ${PROJECT_SOURCE_DIR}/glark/core/depth/edge_steps.glsl
  ${PROJECT_SOURCE_DIR}/glark/core/depth/measure/measured_edge.glsl
  ${PROJECT_SOURCE_DIR}/glark/core/depth/measure/screen_error.glsl
  ${PROJECT_SOURCE_DIR}/glark/core/depth/measure/straight_edge.glsl
  ${PROJECT_SOURCE_DIR}/glark/core/weld/border.glsl
  ${PROJECT_SOURCE_DIR}/glark/core/weld/cells.glsl
  ${PROJECT_SOURCE_DIR}/glark/core/weld/creases.glsl
  ${PROJECT_SOURCE_DIR}/glark/core/weld/edges.glsl
  ${PROJECT_SOURCE_DIR}/glark/core/weld/tables.glsl
  ${PROJECT_SOURCE_DIR}/glark/core/weld/tangent.glsl)
