# With CMAKE_UNITY_BUILD, as in the preset `release`, all sources of a folder are compiled as one. A whole build is
# much faster that way, because headers and templates are compiled once for each folder.
# SPDX-License-Identifier: LGPL-2.1-or-later
function(swept_unite)
  foreach(target ${ARGN})
    if(TARGET ${target})
      get_target_property(sources ${target} SOURCES)
      list(FILTER sources INCLUDE REGEX "\\.cpp$")
      foreach(source ${sources})
        cmake_path(GET source PARENT_PATH folder)
        cmake_path(ABSOLUTE_PATH folder BASE_DIRECTORY ${CMAKE_SOURCE_DIR})
        cmake_path(RELATIVE_PATH folder BASE_DIRECTORY ${CMAKE_SOURCE_DIR})
        string(MAKE_C_IDENTIFIER "${folder}" group)
        set_source_files_properties(${source} PROPERTIES UNITY_GROUP "${group}")
      endforeach()
      set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
      # GCC warns about types in unnamed namespaces of any file but the compiled one. GCC 14 takes memory that a
      # vector has allocated for memory that must not be freed, if it inlines across many functions.
      if(CMAKE_UNITY_BUILD AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        target_compile_options(${target} PRIVATE -Wno-subobject-linkage -Wno-free-nonheap-object)
      endif()
    endif()
  endforeach()
endfunction()
swept_unite(swept_core swept_gl swept_io swept_clearance swept_path swept_page swept_model swept_solid swept _swept
  swept_test_support swept_fuzz swept_tests)
# Apart, so that only the program gets execv(), which the Python module does not call (tests/python/test_security.py).
set_source_files_properties(cpp/src/base/system_program.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
# Apart, because the header of Windows that it includes has macros with names such as `far`.
set_source_files_properties(tests/support/process.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
