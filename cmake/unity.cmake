# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
#
# glark_compile_by_folder(TARGET): with GLARK_UNITY, the C++ files of a folder are compiled as one. Most of the compiler's time goes
# to headers, so the whole takes a third of the time. Names without linkage must then differ within a folder. Builds without
# GLARK_UNITY find headers that a file uses but does not include.
function(glark_compile_by_folder target)
  if(NOT GLARK_UNITY)
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    if(source MATCHES "\\.cpp$")
      get_filename_component(folder ${source} DIRECTORY)
      string(MAKE_C_IDENTIFIER "folder_${folder}" group)
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group})
    endif()
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()
