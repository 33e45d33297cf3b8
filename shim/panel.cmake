# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
#
# The panel of --overlay, and keys. Dear ImGui is linked statically; libxcb and libwayland-client are found in the
# program's process at run time, so only their headers are needed.
option(GLARK_PANEL "Build the panel that glark run --overlay shows" ON)

# Sets GLARK_IMGUI_FOLDER and GLARK_IMGUI_LIBRARIES, if Dear ImGui can be linked statically into a shared library.
function(glark_find_imgui)
  find_path(GLARK_IMGUI_FOLDER imgui.h PATH_SUFFIXES imgui DOC "Header of Dear ImGui (Debian package libimgui-dev)")
  find_library(GLARK_IMGUI_LIBRARY libimgui.a)
  find_library(GLARK_STB_LIBRARY libstb.a)
  mark_as_advanced(GLARK_IMGUI_FOLDER GLARK_IMGUI_LIBRARY GLARK_STB_LIBRARY)
  if(NOT GLARK_IMGUI_FOLDER OR NOT GLARK_IMGUI_LIBRARY)
    return()
  endif()
  set(libraries ${GLARK_IMGUI_LIBRARY})
  if(GLARK_STB_LIBRARY)
    list(APPEND libraries ${GLARK_STB_LIBRARY})
  endif()
  set(GLARK_IMGUI_LIBRARIES ${libraries} m PARENT_SCOPE)
endfunction()

function(glark_add_panel target)
  set_target_properties(${target} PROPERTIES GLARK_HAS_PANEL OFF)
  if(GLARK_PANEL)
    glark_find_imgui()
    find_path(GLARK_XCB_FOLDER xcb/xcb.h DOC "Headers of XCB (Debian package libxcb1-dev)")
    find_path(GLARK_WAYLAND_FOLDER wayland-client-core.h DOC "Headers of Wayland (Debian package libwayland-dev)")
    mark_as_advanced(GLARK_XCB_FOLDER GLARK_WAYLAND_FOLDER)
  endif()
  if(NOT GLARK_IMGUI_LIBRARIES OR NOT GLARK_XCB_FOLDER OR NOT GLARK_WAYLAND_FOLDER)
    message(STATUS "The panel is not built: it needs libimgui-dev, libxcb1-dev and libwayland-dev")
    target_compile_definitions(${target} PRIVATE GLARK_PANEL=0)
    return()
  endif()
  target_sources(${target} PRIVATE
    input/wayland_functions.cpp
    input/wayland_input.cpp
    input/x11_input.cpp
    input/x11_keymap.cpp
    input/xcb_functions.cpp
    panel/view/assertions.cpp
    panel/view/draw_list_view.cpp
    panel/view/draw_switch.cpp
    panel/egl_context.cpp
    panel/glx_context.cpp
    panel/overlay.cpp
    panel/panel.cpp
    panel/view/kept_lists.cpp
    panel/view/panel_input.cpp
    panel/view/panel_view.cpp
    panel/view/picture.cpp
    panel/view/renderer.cpp)
  set_target_properties(${target} PROPERTIES GLARK_HAS_PANEL ON)
  target_compile_definitions(${target} PRIVATE GLARK_PANEL=1)
  target_include_directories(${target} SYSTEM PRIVATE ${GLARK_IMGUI_FOLDER} ${GLARK_XCB_FOLDER} ${GLARK_WAYLAND_FOLDER})
  target_link_libraries(${target} PRIVATE ${GLARK_IMGUI_LIBRARIES})
  target_link_options(${target} PRIVATE LINKER:--wrap=__assert_fail)  # panel/view/assertions.h
endfunction()
