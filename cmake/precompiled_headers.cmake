# Headers that many sources include, compiled once for each library and program (SWEPT_PRECOMPILED_HEADERS).
# The preset `release` uses them, the others do not, because with them a source compiles even if it forgets an
# #include.
# SPDX-License-Identifier: LGPL-2.1-or-later
set(headers algorithm array atomic bit charconv cmath cstdint exception functional limits map memory mutex numeric
  optional set span sstream string string_view tuple unordered_map unordered_set utility vector
  Eigen/Core Eigen/Geometry tbb/blocked_range.h tbb/parallel_for.h)
list(TRANSFORM headers REPLACE "(.+)" "<\\1>")
function(swept_precompile target)
  if(TARGET ${target})
    target_precompile_headers(${target} PRIVATE ${headers} ${ARGN})
    if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")  # leave out the date, so that a compiler cache can reuse them
      target_compile_options(${target} PRIVATE "SHELL:-Xclang -fno-pch-timestamp")
    endif()
  endif()
endfunction()
foreach(target gl io test_support fuzz)
  swept_precompile(swept_${target})
endforeach()
foreach(target swept_core swept_clearance swept_path swept_page swept_solid swept_model swept)
  swept_precompile(${target} <nlohmann/json.hpp>)
endforeach()
swept_precompile(_swept <pybind11/numpy.h> <pybind11/stl.h>)
swept_precompile(swept_tests <gtest/gtest.h> <nlohmann/json.hpp>)
