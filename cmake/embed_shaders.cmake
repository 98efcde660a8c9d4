# Writes a C++ file that holds the text of the shaders.
# Use: cmake -DOUTPUT=file.cpp -DSHADERS="a.vert;b.frag" -DFOLDER=dir -P embed_shaders.cmake
# SPDX-License-Identifier: LGPL-2.1-or-later
set(text "// Written by cmake/embed_shaders.cmake.\n#include \"sampling/gl/shader_sources.h\"\n\nnamespace swept::gl {\n\nconst char* shaderSource(const std::string& name) {\n")
foreach(name IN LISTS SHADERS)
  file(READ "${FOLDER}/${name}" source)
  string(APPEND text "  if (name == \"${name}\") return R\"shader(${source})shader\";\n")
endforeach()
string(APPEND text "  return nullptr;\n}\n\n}  // namespace swept::gl\n")
file(WRITE "${OUTPUT}" "${text}")
