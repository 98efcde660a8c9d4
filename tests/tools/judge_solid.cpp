// Checks solids as the recipient of their files would. Prints a line of JSON for each file.
//   swept_judge_solid FILE.step... [--details N] [--block]
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "judge/solid_judge.h"

int main(int argc, char** argv) {
  std::vector<std::string> files;
  std::size_t details = 0;
  bool block = false;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--details" && i + 1 < argc) {
      details = std::strtoul(argv[++i], nullptr, 10);
    } else if (word == "--block") {
      block = true;
    } else {
      files.push_back(word);
    }
  }
  bool allRead = !files.empty();
  for (const std::string& file : files) {
    nlohmann::json line{{"file", file}};
    try {
      const auto judged = swept::test::judgeSolid(swept::test::readShape(file), details, block);
      line["valid"] = judged.valid;
      line["solids"] = judged.solids;
      line["faces"] = judged.faces;
      line["edges"] = judged.edges;
      line["faults"] = judged.faults;
      line["edge_tolerance"] = judged.edgeTolerance;
      line["vertex_tolerance"] = judged.vertexTolerance;
      line["volume"] = judged.volume;
      if (block) line["block_error"] = judged.blockError;
      if (details > 0) line["details"] = judged.details;
    } catch (const std::exception& error) {
      line["error"] = error.what();
      allRead = false;
    }
    std::printf("%s\n", line.dump(details > 0 ? 1 : -1).c_str());
    std::fflush(stdout);
  }
  return allRead ? 0 : 1;
}
