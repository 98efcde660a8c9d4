# SPDX-License-Identifier: LGPL-2.1-or-later
# Installs headers, static libraries and the CMake package `swept`. find_package(swept) defines the target
# swept::swept, which links all parts that were built. The libraries are static because the C++ interface promises no
# binary compatibility.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(swept_parts)
foreach(part swept_core swept_io swept_body swept_clearance swept_path swept_page swept_model swept_solid)
  if(TARGET ${part})
    list(APPEND swept_parts ${part})
  endif()
endforeach()
add_library(swept_all INTERFACE)
set_target_properties(swept_all PROPERTIES EXPORT_NAME swept)
target_link_libraries(swept_all INTERFACE ${swept_parts})
target_compile_features(swept_all INTERFACE cxx_std_20)

set(swept_headers accuracy check_text clearance compute drawable body inaccuracy io live_clearance mechanism neighbour_rule overlap page path preview report run_context sequence sources types)
list(APPEND swept_headers solid)
if(TARGET swept_solid)
  set(SWEPT_HAS_SOLIDS ON)
else()
  set(SWEPT_HAS_SOLIDS OFF)
endif()
list(TRANSFORM swept_headers PREPEND ${CMAKE_SOURCE_DIR}/cpp/include/swept/)
list(TRANSFORM swept_headers APPEND .h)
set(swept_package ${CMAKE_INSTALL_LIBDIR}/cmake/swept)

install(FILES ${swept_headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/swept COMPONENT development)
install(TARGETS ${swept_parts} swept_all EXPORT swept-targets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
install(EXPORT swept-targets NAMESPACE swept:: DESTINATION ${swept_package} COMPONENT development)
configure_package_config_file(cmake/swept-config.cmake.in ${CMAKE_BINARY_DIR}/swept-config.cmake
  INSTALL_DESTINATION ${swept_package})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/swept-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/swept-config.cmake ${CMAKE_BINARY_DIR}/swept-config-version.cmake
  cmake/FindOpenMeshCore.cmake DESTINATION ${swept_package} COMPONENT development)
