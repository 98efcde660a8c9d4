// The commands of the program. Each takes the words behind its name and gives the exit status.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace swept::cli {

int envelopeCommand(const std::vector<std::string>& words);
int checkCommand(const std::vector<std::string>& words);
int clearanceCommand(const std::vector<std::string>& words);
int solidCommand(const std::vector<std::string>& words);

extern const char* const kEnvelopeHelp;
extern const char* const kCheckHelp;
extern const char* const kClearanceHelp;
extern const char* const kSolidHelp;

}  // namespace swept::cli
