# Headers of the system and of libraries, parsed once for everything compiled here (presets sanitize and fuzz): they take
# more than half of clang's time on a file. None of ours is among them, so a change never compiles them again. The
# release build does without, so a file that forgets an include fails there.
set(headers <algorithm> <array> <charconv> <chrono> <cmath> <filesystem> <fstream> <functional> <iostream> <limits> <map>
  <memory> <optional> <random> <regex> <set> <span> <sstream> <string> <string_view> <thread> <utility> <variant> <vector>
  <boost/multiprecision/gmp.hpp> <fmt/format.h> <nlohmann/json.hpp>)

# Code of libraries and of programs differs in its relocations (-fPIC, -fPIE): each kind has its own.
file(WRITE ${PROJECT_BINARY_DIR}/precompiled.cpp "int main() {}\n")
add_library(toolcomp_precompiled OBJECT ${PROJECT_BINARY_DIR}/precompiled.cpp)
add_executable(toolcomp_precompiled_program ${PROJECT_BINARY_DIR}/precompiled.cpp)
foreach(owner toolcomp_precompiled toolcomp_precompiled_program)
  target_link_libraries(${owner} PRIVATE toolcomp_options fmt::fmt nlohmann_json::nlohmann_json)
  target_precompile_headers(${owner} PRIVATE ${headers})
  # The same bytes from the same headers, so that ccache knows them again; but never out of ccache itself: they hold the
  # path of the build folder.
  target_compile_options(${owner} PRIVATE "SHELL:-Xclang -fno-pch-timestamp")
  set_target_properties(${owner} PROPERTIES CXX_COMPILER_LAUNCHER "")
endforeach()

if(TOOLCOMP_TESTS)
  find_package(GTest REQUIRED)
  target_link_libraries(toolcomp_precompiled_program PRIVATE GTest::gtest)
  target_precompile_headers(toolcomp_precompiled_program PRIVATE <gtest/gtest.h> <rapidcheck.h>)
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
    if(target MATCHES "^toolcomp_precompiled" OR target STREQUAL toolcomp_clauses OR target STREQUAL toolcomp_parameters OR "${sources}" MATCHES "\\.c(;|$)")
      continue()
    elseif(type STREQUAL EXECUTABLE)
      target_precompile_headers(${target} REUSE_FROM toolcomp_precompiled_program)
    elseif(type STREQUAL STATIC_LIBRARY OR type STREQUAL OBJECT_LIBRARY)
      target_precompile_headers(${target} REUSE_FROM toolcomp_precompiled)
    endif()
  endforeach()
endfunction()
toolcomp_precompile(${PROJECT_SOURCE_DIR})
