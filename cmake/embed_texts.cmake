# Writes a C++ file with a function that returns the text of a file by its name, and null for any other name.
# Use: cmake -DOUTPUT=file.cpp -DHEADER=declares/it.h -DFUNCTION=swept::gl::shaderSource
#        -DNAMES="a.vert;b.frag" -DFILES="dir/a.vert;dir/b.frag" -P embed_texts.cmake
# SPDX-License-Identifier: LGPL-2.1-or-later
set(text "// Written by cmake/embed_texts.cmake.\n#include \"${HEADER}\"\n\nconst char* ${FUNCTION}(const std::string& name) {\n")
foreach(name file IN ZIP_LISTS NAMES FILES)
  file(READ "${file}" source)
  string(FIND "${source}" ")swept_text\"" clash)
  if(NOT clash EQUAL -1)
    message(FATAL_ERROR "${file} holds what ends a raw string here")
  endif()
  string(APPEND text "  if (name == \"${name}\") return R\"swept_text(${source})swept_text\";\n")
endforeach()
string(APPEND text "  return nullptr;\n}\n")
file(WRITE "${OUTPUT}" "${text}")
