# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
#
# Installs what a program needs to be compiled against glark: headers, libraries, pkg-config files and a CMake package.
# All of them find each other by relative paths, so that `cmake --install --prefix` and a moved folder both work.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(GLARK_PACKAGE_FOLDER ${CMAKE_INSTALL_LIBDIR}/cmake/glark)
set(GLARK_REGISTRY_FOLDER ${CMAKE_INSTALL_DATADIR}/glark)
set(GLARK_WRITTEN_FOLDER ${PROJECT_BINARY_DIR}/package)

configure_file(cmake/glark_version.h.in ${GLARK_WRITTEN_FOLDER}/glark_version.h @ONLY)
install(FILES include/GL/glark.h ${GLARK_WRITTEN_FOLDER}/glark_version.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/GL)
install(FILES include/glark/error.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/glark)
install(FILES glark/gl/glark.xml DESTINATION ${GLARK_REGISTRY_FOLDER})

configure_package_config_file(cmake/glarkConfig.cmake.in ${GLARK_WRITTEN_FOLDER}/glarkConfig.cmake
  INSTALL_DESTINATION ${GLARK_PACKAGE_FOLDER} PATH_VARS GLARK_REGISTRY_FOLDER NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${GLARK_WRITTEN_FOLDER}/glarkConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${GLARK_WRITTEN_FOLDER}/glarkConfig.cmake ${GLARK_WRITTEN_FOLDER}/glarkConfigVersion.cmake
  DESTINATION ${GLARK_PACKAGE_FOLDER})

# Writes and installs NAME.pc. LIBS are the linker's flags; REQUIRES are the names of other .pc files that a program needs, too.
function(glark_install_pkg_config name)
  cmake_parse_arguments(PACKAGE "" "DESCRIPTION;LIBS" "REQUIRES" ${ARGN})
  set(PACKAGE_NAME ${name})
  list(JOIN PACKAGE_REQUIRES ", " PACKAGE_REQUIRES)
  file(RELATIVE_PATH PACKAGE_PREFIX ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
  string(REGEX REPLACE "/$" "" PACKAGE_PREFIX ${PACKAGE_PREFIX})
  configure_file(${PROJECT_SOURCE_DIR}/cmake/package.pc.in ${GLARK_WRITTEN_FOLDER}/${name}.pc @ONLY)
  install(FILES ${GLARK_WRITTEN_FOLDER}/${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endfunction()

# Installs the client library glark-NAME with its header, glark-NAME.pc, and the target glark::NAME of the CMake package.
# It exists only as a static library, so REQUIRES is public in the .pc file: every program links to those libraries itself.
function(glark_install_client name)
  cmake_parse_arguments(CLIENT "" "DESCRIPTION" "REQUIRES" ${ARGN})
  set(library glark-${name})
  set_target_properties(${library} PROPERTIES EXPORT_NAME ${name})
  target_compile_features(${library} INTERFACE cxx_std_20)
  install(TARGETS ${library} EXPORT ${library} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
    INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  install(FILES ${PROJECT_SOURCE_DIR}/include/glark/${name}.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/glark)
  install(EXPORT ${library} NAMESPACE glark:: DESTINATION ${GLARK_PACKAGE_FOLDER} FILE glark-${name}.cmake)
  glark_install_pkg_config(${library} DESCRIPTION "${CLIENT_DESCRIPTION}" LIBS -l${library} REQUIRES ${CLIENT_REQUIRES})
endfunction()

# Installs libGLARK.so, glark.pc and the target glark::GLARK. The launcher preloads the library from its own folder; the link in
# the folder of libraries is for -lGLARK.
function(glark_install_preloaded_library)
  # Without this flag, the linker drops the library if the program calls none of its functions by name.
  target_link_options(GLARK INTERFACE $<INSTALL_INTERFACE:-Wl,--no-as-needed>)
  install(TARGETS GLARK EXPORT glark-GLARK LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/glark
    INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  install(EXPORT glark-GLARK NAMESPACE glark:: DESTINATION ${GLARK_PACKAGE_FOLDER} FILE glark-GLARK.cmake)
  set(link ${GLARK_WRITTEN_FOLDER}/libGLARK.so)
  file(CREATE_LINK glark/libGLARK.so ${link} SYMBOLIC)
  install(FILES ${link} DESTINATION ${CMAKE_INSTALL_LIBDIR})
  glark_install_pkg_config(glark DESCRIPTION "OpenGL extension GL_ARK_adaptive_refinement" LIBS "-Wl,--no-as-needed -lGLARK")
endfunction()
