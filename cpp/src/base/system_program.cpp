// becomeProgram() has its own file. So only programs that call it contain a system call that starts
// another program; the Python module contains none.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/system.h"

#ifndef _WIN32
#include <unistd.h>

#include <cerrno>

namespace swept::os {

int becomeProgram(const std::vector<std::string>& words) {
  std::vector<std::string> copies = words;
  std::vector<char*> arguments;
  for (std::string& word : copies) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  execv(arguments[0], arguments.data());
  return errno;
}

}  // namespace swept::os
#endif
