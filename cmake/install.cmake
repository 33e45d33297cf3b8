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
# The number in the names of shared libraries. It rises when programs that were linked before no longer work.
set(GLARK_SOVERSION 0)

configure_file(cmake/glark_version.h.in ${GLARK_WRITTEN_FOLDER}/glark_version.h @ONLY)
install(FILES include/GL/glark.h ${GLARK_WRITTEN_FOLDER}/glark_version.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/GL)
install(FILES include/glark/error.h include/glark/export.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/glark)
install(FILES include/glark/c/types.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/glark/c)
install(FILES glark/gl/glark.xml DESTINATION ${GLARK_REGISTRY_FOLDER})
install(DIRECTORY docs/man/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man3 FILES_MATCHING PATTERN "*.3")

configure_package_config_file(cmake/glarkConfig.cmake.in ${GLARK_WRITTEN_FOLDER}/glarkConfig.cmake
  INSTALL_DESTINATION ${GLARK_PACKAGE_FOLDER} PATH_VARS GLARK_REGISTRY_FOLDER NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${GLARK_WRITTEN_FOLDER}/glarkConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${GLARK_WRITTEN_FOLDER}/glarkConfig.cmake ${GLARK_WRITTEN_FOLDER}/glarkConfigVersion.cmake
  DESTINATION ${GLARK_PACKAGE_FOLDER})

# Writes and installs NAME.pc. LIBS are the linker's flags. REQUIRES are the names of other .pc files that a program needs, too;
# PRIVATE are those that it needs only with `pkg-config --static`. PRIVATE_LIBRARIES are libraries without a .pc file that it needs then.
function(glark_install_pkg_config name)
  cmake_parse_arguments(PACKAGE "" "DESCRIPTION;LIBS" "REQUIRES;PRIVATE;PRIVATE_LIBRARIES" ${ARGN})
  set(PACKAGE_NAME ${name})
  list(JOIN PACKAGE_REQUIRES ", " PACKAGE_REQUIRES)
  list(JOIN PACKAGE_PRIVATE ", " PACKAGE_PRIVATE)
  list(TRANSFORM PACKAGE_PRIVATE_LIBRARIES PREPEND -l)
  list(JOIN PACKAGE_PRIVATE_LIBRARIES " " PACKAGE_PRIVATE_LIBRARIES)
  file(RELATIVE_PATH PACKAGE_PREFIX ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
  string(REGEX REPLACE "/$" "" PACKAGE_PREFIX ${PACKAGE_PREFIX})
  configure_file(${PROJECT_SOURCE_DIR}/cmake/package.pc.in ${GLARK_WRITTEN_FOLDER}/${name}.pc @ONLY)
  install(FILES ${GLARK_WRITTEN_FOLDER}/${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endfunction()

# Installs the client library glark-NAME with its header, glark-NAME.pc, and the targets glark::NAME (shared) and glark::NAME_static
# of the CMake package. Our own programs link to the static library glark-NAME. REQUIRES: other client libraries that it calls.
# PRIVATE: packages that only the static library needs from a program; PRIVATE_LIBRARIES: those without a .pc file. OBJECTS: objects of others that are part of the library.
function(glark_install_client name)
  cmake_parse_arguments(CLIENT "" "DESCRIPTION" "REQUIRES;PRIVATE;PRIVATE_LIBRARIES;OBJECTS" ${ARGN})
  set(library glark-${name})
  set(shared ${library}-shared)
  set(exports ${PROJECT_SOURCE_DIR}/glark/clients/exports.map)
  add_library(${shared} SHARED $<TARGET_OBJECTS:${library}> ${CLIENT_OBJECTS})
  set_target_properties(${shared} PROPERTIES OUTPUT_NAME ${library} EXPORT_NAME ${name} SOVERSION ${GLARK_SOVERSION}
    LINKER_LANGUAGE CXX LINK_DEPENDS ${exports}
    INSTALL_RPATH "\$ORIGIN")  # one client library finds another one
  target_link_options(${shared} PRIVATE -Wl,--version-script=${exports} -Wl,-z,now
    $<$<NOT:$<BOOL:${GLARK_SANITIZE}>>:-Wl,--no-undefined>)
  target_link_libraries(${shared} PRIVATE glark_options)
  foreach(needed IN LISTS CLIENT_PRIVATE)
    if(needed STREQUAL tbb)
      target_link_libraries(${shared} PRIVATE TBB::tbb)
    elseif(needed STREQUAL libzstd)
      target_link_libraries(${shared} PRIVATE PkgConfig::zstd)
    elseif(needed STREQUAL libpng)
      target_link_libraries(${shared} PRIVATE PNG::PNG)
    elseif(needed STREQUAL tinygltf)
      target_link_libraries(${shared} PRIVATE TinyGLTF::TinyGLTF)
    endif()
  endforeach()
  foreach(needed IN LISTS CLIENT_PRIVATE_LIBRARIES)
    target_link_libraries(${shared} PRIVATE ${needed}::${needed})
  endforeach()
  foreach(needed IN LISTS CLIENT_REQUIRES)
    target_link_libraries(${shared} PUBLIC ${needed}-shared)
  endforeach()
  set_target_properties(${library} PROPERTIES EXPORT_NAME ${name}_static)
  foreach(target ${library} ${shared})
    target_compile_features(${target} INTERFACE cxx_std_20)
  endforeach()
  install(TARGETS ${library} ${shared} EXPORT ${library} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  install(FILES ${PROJECT_SOURCE_DIR}/include/glark/${name}.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/glark)
  install(FILES ${PROJECT_SOURCE_DIR}/include/glark/c/${name}.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/glark/c)
  install(EXPORT ${library} NAMESPACE glark:: DESTINATION ${GLARK_PACKAGE_FOLDER} FILE glark-${name}.cmake)
  glark_install_pkg_config(${library} DESCRIPTION "${CLIENT_DESCRIPTION}" LIBS -l${library} REQUIRES ${CLIENT_REQUIRES}
    PRIVATE ${CLIENT_PRIVATE} PRIVATE_LIBRARIES ${CLIENT_PRIVATE_LIBRARIES})
endfunction()

# Installs libGLARK.so, glark.pc and the target glark::GLARK.
function(glark_install_preloaded_library)
  # Without this flag, the linker drops the library if the program calls none of its functions by name.
  target_link_options(GLARK INTERFACE $<INSTALL_INTERFACE:-Wl,--no-as-needed>)
  install(TARGETS GLARK EXPORT glark-GLARK LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
    INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  install(EXPORT glark-GLARK NAMESPACE glark:: DESTINATION ${GLARK_PACKAGE_FOLDER} FILE glark-GLARK.cmake)
  glark_install_pkg_config(glark DESCRIPTION "OpenGL extension GL_ARK_adaptive_refinement" LIBS "-Wl,--no-as-needed -lGLARK")
endfunction()
