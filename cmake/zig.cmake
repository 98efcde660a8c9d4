# Toolchain file: zig compiles C and C++ for a system that may be older than this one, or a different one.
#   -DCMAKE_TOOLCHAIN_FILE=cmake/zig.cmake -DSWEPT_ZIG_TARGET=x86_64-linux-gnu.2.28
# -DSWEPT_ZIG_PYTHON=...: the Python whose package `ziglang` is used. Both can also be environment variables.
# SPDX-License-Identifier: LGPL-2.1-or-later
foreach(name SWEPT_ZIG_TARGET SWEPT_ZIG_PYTHON)
  if(NOT DEFINED ${name})
    set(${name} $ENV{${name}})
  endif()
  if(NOT ${name})
    message(FATAL_ERROR "${name} is not set")
  endif()
endforeach()
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES SWEPT_ZIG_TARGET SWEPT_ZIG_PYTHON)

# CMake expects a program without arguments for each tool, so each tool gets its own script.
set(tools ${CMAKE_BINARY_DIR}/zig)
foreach(tool cc c++ ar ranlib rc)
  set(words ${tool})
  if(tool MATCHES "^c")
    # Without -g0, zig always writes debugging information.
    string(APPEND words " -target ${SWEPT_ZIG_TARGET} -g0")
  endif()
  if(NOT EXISTS ${tools}/${tool})
    if(NOT zig_version)  # it is written into the scripts, so that a compiler cache notices a new version
      execute_process(COMMAND ${SWEPT_ZIG_PYTHON} -m ziglang version OUTPUT_VARIABLE zig_version
        OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
    endif()
    file(WRITE ${tools}/${tool} "#!/bin/sh\n# zig ${zig_version}\n"
      "exec '${SWEPT_ZIG_PYTHON}' -m ziglang ${words} \"$@\"\n")
    file(CHMOD ${tools}/${tool} PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
  endif()
endforeach()
set(CMAKE_C_COMPILER ${tools}/cc)
set(CMAKE_CXX_COMPILER ${tools}/c++)
set(CMAKE_AR ${tools}/ar)
set(CMAKE_RANLIB ${tools}/ranlib)
set(CMAKE_RC_COMPILER ${tools}/rc)
# Uses a compiler cache, if there is one. It cannot see which compiler the scripts run, so it is told here.
find_program(SWEPT_CCACHE ccache)
if(SWEPT_CCACHE)
  set(words env CCACHE_COMPILERTYPE=clang CCACHE_COMPILERCHECK=content
    CCACHE_SLOPPINESS=pch_defines,time_macros ${SWEPT_CCACHE})
  foreach(language C CXX)
    set(CMAKE_${language}_COMPILER_LAUNCHER "${words}" CACHE STRING "compiler cache")
  endforeach()
endif()

if(SWEPT_ZIG_TARGET MATCHES "windows")
  set(CMAKE_SYSTEM_NAME Windows)
  add_compile_definitions(_USE_MATH_DEFINES)  # M_PI, which FCL and OpenMesh use
  # Without -s, the program contains the checksum of a file of symbols, which depends on the build folder.
  set(CMAKE_EXE_LINKER_FLAGS_INIT -s)
  set(CMAKE_MODULE_LINKER_FLAGS_INIT -s)
elseif(SWEPT_ZIG_TARGET MATCHES "macos")
  set(CMAKE_SYSTEM_NAME Darwin)
  # With zig 0.17.1, a source that includes <cmath> before <cfloat> does not get these two, which libccd uses.
  add_compile_definitions(DBL_MAX=__DBL_MAX__ DBL_EPSILON=__DBL_EPSILON__)
else()
  set(CMAKE_SYSTEM_NAME Linux)
endif()
string(REGEX MATCH "^[^-]+" CMAKE_SYSTEM_PROCESSOR ${SWEPT_ZIG_TARGET})
# Headers and libraries of this system must not be used: they do not fit the target.
set(CMAKE_FIND_ROOT_PATH ${CMAKE_PREFIX_PATH})
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
