# SPDX-License-Identifier: Apache-2.0
# Headers of the system and of libraries, parsed once for everything compiled here: they take more than half of the time
# of a file. None of ours is among them, so a change never compiles them again. What a file forgets to include the
# builds no longer see: `./dev includes` looks at every file by itself.
#
# GCC loads all of such a header for every file, clang what a file asks for: GCC gets what nearly every file needs.
set(headers <algorithm> <array> <cstdint> <functional> <memory> <optional> <string> <string_view> <utility> <vector>
  <boost/multiprecision/gmp.hpp>)
set(headers_of_programs <fmt/format.h> <iostream> <map>)
set(headers_of_tests <gtest/gtest.h>)
if(CMAKE_CXX_COMPILER_ID STREQUAL Clang)
  list(APPEND headers <charconv> <chrono> <cmath> <filesystem> <fstream> <iostream> <limits> <map> <random> <regex> <set>
    <span> <sstream> <thread> <variant> <fmt/format.h> <nlohmann/json.hpp>)
  list(APPEND headers_of_tests <rapidcheck.h>)
endif()

# Code of libraries and of programs differs in its relocations (-fPIC, -fPIE), that of tests by what GoogleTest defines,
# that which is lightly optimized by that: each kind has its own.
function(toolcomp_precompiled owner)
  file(WRITE ${PROJECT_BINARY_DIR}/precompiled.cpp "int main() {}\n")
  if(owner MATCHES "library|light")
    add_library(${owner} OBJECT ${PROJECT_BINARY_DIR}/precompiled.cpp)
  else()
    add_executable(${owner} ${PROJECT_BINARY_DIR}/precompiled.cpp)
  endif()
  target_link_libraries(${owner} PRIVATE toolcomp_options ${ARGN})
  if(CMAKE_CXX_COMPILER_ID STREQUAL Clang)
    target_link_libraries(${owner} PRIVATE fmt::fmt nlohmann_json::nlohmann_json)
    target_compile_options(${owner} PRIVATE "SHELL:-Xclang -fno-pch-timestamp")
  endif()
  set_target_properties(${owner} PROPERTIES CXX_COMPILER_LAUNCHER ${PROJECT_SOURCE_DIR}/cmake/with_checksum)
endfunction()
toolcomp_precompiled(toolcomp_precompiled_library)
target_precompile_headers(toolcomp_precompiled_library PRIVATE ${headers})
if(TARGET toolcomp_light)
  toolcomp_precompiled(toolcomp_precompiled_light toolcomp_light)
  target_precompile_headers(toolcomp_precompiled_light PRIVATE ${headers})
endif()
toolcomp_precompiled(toolcomp_precompiled_program fmt::fmt)
target_precompile_headers(toolcomp_precompiled_program PRIVATE ${headers} ${headers_of_programs})
if(TOOLCOMP_TESTS)
  find_package(GTest REQUIRED)
  toolcomp_precompiled(toolcomp_precompiled_test fmt::fmt GTest::gtest)
  target_compile_options(toolcomp_precompiled_test PRIVATE -O0)
  target_precompile_headers(toolcomp_precompiled_test PRIVATE ${headers} ${headers_of_programs} ${headers_of_tests})
endif()

if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  # ccache has to find the header in what the preprocessor makes. Behind it GCC 12 no longer knows that the code of
  # std::string is not ours, and warns of bounds that are kept; clang and its sanitizers watch ours.
  target_compile_options(toolcomp_options INTERFACE $<BUILD_INTERFACE:-fpch-preprocess;-Wno-array-bounds;-Wno-stringop-overflow>)
endif()

function(toolcomp_precompile folder)
  get_property(folders DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
  foreach(below ${folders})
    toolcomp_precompile(${below})
  endforeach()
  get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target ${targets})
    get_target_property(type ${target} TYPE)
    get_target_property(sources ${target} SOURCES)
    get_target_property(libraries ${target} LINK_LIBRARIES)
    get_target_property(alone ${target} DISABLE_PRECOMPILE_HEADERS)
    if(alone OR target MATCHES "^toolcomp_precompiled" OR target STREQUAL toolcomp_clauses OR target STREQUAL toolcomp_parameters OR target STREQUAL toolcomp_embed OR "${sources}" MATCHES "\\.c(;|$)")
      continue()
    elseif(type STREQUAL EXECUTABLE)
      # Whoever gets the header has to define what it was made with, also where fmt is not used.
      target_compile_definitions(${target} PRIVATE $<TARGET_PROPERTY:fmt::fmt,INTERFACE_COMPILE_DEFINITIONS>)
      if("${libraries}" MATCHES "GTest::")
        target_precompile_headers(${target} REUSE_FROM toolcomp_precompiled_test)
      else()
        target_precompile_headers(${target} REUSE_FROM toolcomp_precompiled_program)
      endif()
    elseif("${libraries}" MATCHES "toolcomp_light")
      target_precompile_headers(${target} REUSE_FROM toolcomp_precompiled_light)
    elseif(type STREQUAL STATIC_LIBRARY OR type STREQUAL OBJECT_LIBRARY)
      target_precompile_headers(${target} REUSE_FROM toolcomp_precompiled_library)
    endif()
  endforeach()
endfunction()
toolcomp_precompile(${PROJECT_SOURCE_DIR})
