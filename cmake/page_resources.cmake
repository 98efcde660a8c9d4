# Writes templates, style and 3D view of pages into a C++ file. esbuild bundles the view (resources/page/view.js)
# with three.js. Both are Debian packages (libjs-three, esbuild), or packages of npm in node_modules (`npm install
# three esbuild`). Without them, pages have no 3D view and say so. Nothing is downloaded here.
# SPDX-License-Identifier: LGPL-2.1-or-later
option(SWEPT_PAGE_VIEW "3D view in pages, with three.js" ON)
set(page_folder ${CMAKE_SOURCE_DIR}/resources/page)
set(page_view ${CMAKE_BINARY_DIR}/generated/page_view.js)
find_path(SWEPT_THREE build/three.module.js
  PATHS ${CMAKE_SOURCE_DIR}/node_modules/three /usr/share/javascript/three /usr/share/nodejs/three
  NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH DOC "Folder of three.js")
find_program(SWEPT_ESBUILD esbuild HINTS ${CMAKE_SOURCE_DIR}/node_modules/.bin
  DOC "Bundles the 3D view of pages")
mark_as_advanced(SWEPT_THREE SWEPT_ESBUILD)
if(SWEPT_PAGE_VIEW AND SWEPT_THREE AND SWEPT_ESBUILD
    AND EXISTS ${SWEPT_THREE}/examples/jsm/controls/OrbitControls.js)
  add_custom_command(OUTPUT ${page_view}
    COMMAND ${SWEPT_ESBUILD} ${page_folder}/view.js --bundle --minify --charset=ascii
      --log-level=warning --legal-comments=inline --target=es2018
      --alias:three=${SWEPT_THREE}/build/three.module.js
      --alias:three-controls=${SWEPT_THREE}/examples/jsm/controls/OrbitControls.js
      --outfile=${page_view}
    DEPENDS ${page_folder}/view.js ${SWEPT_THREE}/build/three.module.js VERBATIM)
else()
  message(STATUS "No three.js with esbuild: pages have no 3D view")
  file(CONFIGURE OUTPUT ${page_view} CONTENT "")
endif()
set(page_names page.html print.html page.css)
list(TRANSFORM page_names PREPEND ${page_folder}/ OUTPUT_VARIABLE page_files)
list(APPEND page_names view)
list(APPEND page_files ${page_view})
set(page_text ${CMAKE_BINARY_DIR}/generated/page_resources.cpp)
add_custom_command(OUTPUT ${page_text}
  COMMAND ${CMAKE_COMMAND} "-DOUTPUT=${page_text}" -DHEADER=page/resources.h
    -DFUNCTION=swept::page::resourceText "-DNAMES=${page_names}" "-DFILES=${page_files}"
    -P ${CMAKE_SOURCE_DIR}/cmake/embed_texts.cmake
  DEPENDS ${page_files} cmake/embed_texts.cmake VERBATIM)
