# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
#
# Flags of every target of ours: link to glark_options.
add_library(glark_options INTERFACE)
target_include_directories(glark_options INTERFACE ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/generated)
target_compile_options(glark_options INTERFACE
  $<$<COMPILE_LANGUAGE:CXX>:-Wall -Wextra -Wpedantic $<IF:$<BOOL:${GLARK_UNITY}>,$<$<CXX_COMPILER_ID:GNU>:-Wshadow=local>,-Wshadow> -Wconversion -Wno-sign-conversion>
  $<$<AND:$<COMPILE_LANGUAGE:CXX>,$<BOOL:${GLARK_WERROR}>>:-Werror>)
# GCC 12 warns of overlaps that are not there in "literal" + std::to_string(x) (GCC bug 105329).
target_compile_options(glark_options INTERFACE $<$<AND:$<COMPILE_LANGUAGE:CXX>,$<CXX_COMPILER_ID:GNU>>:-Wno-restrict>)
# std::stable_sort of GCC 12's library uses what that library calls deprecated, and Clang 15 and later say so.
target_compile_options(glark_options INTERFACE
  $<$<AND:$<COMPILE_LANGUAGE:CXX>,$<CXX_COMPILER_ID:Clang>,$<VERSION_GREATER_EQUAL:$<CXX_COMPILER_VERSION>,15>>:-Wno-deprecated-declarations>)
# The checks that sanitizers add make GCC warn of values that are always set (GCC's manual, -fsanitize=address).
if(GLARK_SANITIZE)
  target_compile_options(glark_options INTERFACE
    $<$<AND:$<COMPILE_LANGUAGE:CXX>,$<CXX_COMPILER_ID:GNU>>:-Wno-maybe-uninitialized>)
endif()
# Bits are compared across machines and builds: no contraction of a*b+c on the CPU side.
target_compile_options(glark_options INTERFACE -ffp-contract=off)
# On i386, GCC computes with 80 bits unless it is told otherwise, and believes that its callers align the stack. Programs
# from before 2004 do not. Every processor that drives OpenGL 4.3 has SSE2.
if(CMAKE_SIZEOF_VOID_P EQUAL 4 AND CMAKE_SYSTEM_PROCESSOR MATCHES "^(i[3-6]86|x86|x86_64|AMD64)$")
  target_compile_options(glark_options INTERFACE -msse2 -mfpmath=sse -mstackrealign)
endif()
if(NOT CMAKE_SIZEOF_VOID_P EQUAL 8)  # files of more than 2 GB
  target_compile_definitions(glark_options INTERFACE _FILE_OFFSET_BITS=64)
endif()
if(GLARK_SANITIZE)
  target_compile_options(glark_options INTERFACE -fsanitize=${GLARK_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=undefined)
  target_link_options(glark_options INTERFACE -fsanitize=${GLARK_SANITIZE})
endif()
if(GLARK_FUZZ)  # libraries count what they cover too; only the targets of tests/fuzz have libFuzzer's main
  target_compile_options(glark_options INTERFACE -fsanitize=fuzzer-no-link,undefined -fno-sanitize-recover=undefined)
  target_link_options(glark_options INTERFACE -fsanitize=undefined)
endif()
