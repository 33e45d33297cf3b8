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

# glark_compile_together(TARGET COUNT): the same for programs whose files lie in many folders, COUNT files at a time.
# glark_compile_apart(sources...): but not these, whose names without linkage other files have, too.
function(glark_compile_together target count)
  if(GLARK_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${count})
    # A fixture without linkage is in one unit all the same.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  endif()
endfunction()
function(glark_compile_apart)
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()
