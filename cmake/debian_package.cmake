# SPDX-License-Identifier: LGPL-2.1-or-later
# Settings for `cpack -G DEB` in the build folder: makes a package with /usr/bin/swept and
# /usr/share/freecad/Mod/SweptVolume. CPack reads from the programs on which libraries the package depends. FreeCAD is
# only recommended.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME swept-volume)
set(CPACK_PACKAGE_CONTACT "The Swept Volume maintainers")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Swept volumes of moving parts: workbench for FreeCAD and program")
set(CPACK_PACKAGING_INSTALL_PREFIX /)
set(CPACK_INSTALL_CMAKE_PROJECTS
  "${CMAKE_BINARY_DIR};SweptVolume;workbench;/usr/share/freecad;${CMAKE_BINARY_DIR};SweptVolume;program;/usr")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "python3-numpy")
if(Python3_VERSION_MINOR)  # the module only works with the version it was built for
  math(EXPR next_minor "${Python3_VERSION_MINOR} + 1")
  string(APPEND CPACK_DEBIAN_PACKAGE_DEPENDS
    ", python3 (>= 3.${Python3_VERSION_MINOR}), python3 (<< 3.${next_minor})")
endif()
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "freecad, qt6-svg-plugins")
set(CPACK_STRIP_FILES ON)
include(CPack)
