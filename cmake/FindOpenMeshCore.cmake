# SPDX-License-Identifier: LGPL-2.1-or-later
# Defines the target OpenMesh::Core, because Debian's package of OpenMesh has no CMake files. This file is installed
# with the library: programs that link to a static library must also find the libraries that it uses.
find_library(OpenMeshCore_LIBRARY NAMES OpenMeshCore openmesh)
mark_as_advanced(OpenMeshCore_LIBRARY)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenMeshCore REQUIRED_VARS OpenMeshCore_LIBRARY)
if(OpenMeshCore_FOUND AND NOT TARGET OpenMesh::Core)
  add_library(OpenMesh::Core UNKNOWN IMPORTED)
  set_target_properties(OpenMesh::Core PROPERTIES IMPORTED_LOCATION "${OpenMeshCore_LIBRARY}")
endif()
