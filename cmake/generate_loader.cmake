# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
#
# glark_generate_loader(TARGET API EXTENSION ...): a static library that loads the functions of OpenGL, with the header
# <glad/gl.h>. glad 2 (Debian package python3-glad) generates both from gl.xml and glark/gl/glark.xml. API is as glad's
# --api takes it: "gl:compatibility=4.6,gles2=3.2". GL_ARK_adaptive_refinement is always among the extensions.
#
# GLARK_HAS_GLAD says whether glad 2 is there.
execute_process(COMMAND ${Python3_EXECUTABLE} -c "import glad, sys; sys.exit(not glad.__version__.startswith('2.'))"
  RESULT_VARIABLE glad_is_missing OUTPUT_QUIET ERROR_QUIET)
if(glad_is_missing)
  set(GLARK_HAS_GLAD FALSE)
else()
  set(GLARK_HAS_GLAD TRUE)
endif()

function(glark_generate_loader target api)
  set(generated ${PROJECT_BINARY_DIR}/generated/loaders/${target})
  set(script ${PROJECT_SOURCE_DIR}/cmake/generate_loader.py)
  set(own_registry ${PROJECT_SOURCE_DIR}/glark/gl/glark.xml)
  list(JOIN ARGN "," extensions)
  string(JOIN "," extensions GL_ARK_adaptive_refinement ${extensions})
  add_custom_command(OUTPUT ${generated}/src/gl.c ${generated}/include/glad/gl.h ${generated}/include/KHR/khrplatform.h
    COMMAND ${Python3_EXECUTABLE} ${script} ${generated} ${api} ${extensions} ${GLARK_GL_XML} ${own_registry}
    DEPENDS ${script} ${PROJECT_SOURCE_DIR}/cmake/registry.py ${GLARK_GL_XML} ${own_registry}
    COMMENT "Generating the GL loader ${target}" VERBATIM)
  add_library(${target} STATIC ${generated}/src/gl.c ${generated}/include/glad/gl.h)
  target_include_directories(${target} SYSTEM PUBLIC ${generated}/include)
endfunction()
