# SPDX-License-Identifier: Apache-2.0
# How everything of ours is compiled: toolcomp_options is linked by every target.
add_library(toolcomp_options INTERFACE)
target_include_directories(toolcomp_options INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/generated>
  $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/toolcomp>)
target_compile_features(toolcomp_options INTERFACE cxx_std_20)
# Our functions are never replaced from outside: in code for shared libraries too a call within a file may be inlined;
# and nobody reads errno after a root.
target_compile_options(toolcomp_options INTERFACE $<BUILD_INTERFACE:-fno-semantic-interposition;-fno-math-errno>)
# Products and sums are rounded as written, on every compiler (the error bounds rest on it).
target_compile_options(toolcomp_options INTERFACE $<BUILD_INTERFACE:-Wall;-Wextra;-Wpedantic;-Wshadow;-Wconversion;-ffp-contract=off>)
if(TOOLCOMP_WERROR)
  target_compile_options(toolcomp_options INTERFACE $<BUILD_INTERFACE:-Werror>)
endif()

# What reads, reports and waits for engines is linked with toolcomp_light: GCC optimizes it lightly, in four fifths of
# the time. Where time is spent (exact numbers, engines, generators, readers) nothing is.
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_BUILD_TYPE STREQUAL Release)
  add_library(toolcomp_light INTERFACE)
  target_compile_options(toolcomp_light INTERFACE -O1)
endif()
function(toolcomp_lightly_optimized target)
  if(TARGET toolcomp_light)
    target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:toolcomp_light>)
  endif()
endfunction()

find_package(Threads REQUIRED)
find_package(Eigen3 REQUIRED NO_MODULE)
find_package(nlohmann_json REQUIRED)
find_package(fmt REQUIRED)
find_package(tomlplusplus REQUIRED)
if(NOT TOOLCOMP_FUZZERS)
  find_package(CLI11 REQUIRED)
  find_package(LibArchive REQUIRED)
  find_library(TOOLCOMP_NETTLE nettle REQUIRED)
endif()
find_library(TOOLCOMP_GMP gmp REQUIRED)
find_library(TOOLCOMP_MPFR mpfr REQUIRED)
find_library(TOOLCOMP_MPFI mpfi REQUIRED)
find_library(TOOLCOMP_ARB flint-arb REQUIRED)
find_library(TOOLCOMP_FLINT flint REQUIRED)

# Library headers are not ours to warn about.
function(toolcomp_system_headers target)
  get_target_property(directories ${target} INTERFACE_INCLUDE_DIRECTORIES)
  if(directories)
    set_target_properties(${target} PROPERTIES INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "${directories}")
  endif()
endfunction()
toolcomp_system_headers(Eigen3::Eigen)

# toolcomp_library(NAME DEPENDENCIES…): a static library of the .cpp files in and below the current folder.
function(toolcomp_library name)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS *.cpp)
  add_library(${name} STATIC ${sources})
  target_link_libraries(${name} PUBLIC toolcomp_options ${ARGN})
  toolcomp_unity(${name})
endfunction()
