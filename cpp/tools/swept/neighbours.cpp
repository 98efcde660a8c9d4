// SPDX-License-Identifier: LGPL-2.1-or-later
#ifdef HAVE_SWEPT_CLEARANCE
#include "neighbours.h"

#include <filesystem>
#include <map>
#include <system_error>

#include "files.h"
#include "io/line_source.h"
#include "swept/body.h"
#include "swept/io.h"

namespace swept::cli {

CLI::Option* addNeighbourOptions(CLI::App& app, NeighbourFiles& files) {
  CLI::Option* option =
      app.add_option("NEIGHBOUR", files.paths,
                     "parts that stand still: files of type ply, stl, obj, off, step, stp, brep or "
                     "brp. Each solid of a file is a neighbour");
  option->type_name("FILE")->required();
  addUnit(app, "--neighbour-unit", files.millimetresPerUnit,
          "unit of the numbers in neighbours that are meshes (default mm)");
  addNumber(app, "--neighbour-chord", "MM", files.chordError,
            "how far the triangles of neighbours that are meshes deviate from their exact surfaces "
            "(default 0)");
  addNumber(app, "--deflection", "MM", files.deflection,
            "how far the triangles of solids (neighbours and moving parts) may deviate from their "
            "surfaces (default 0.05)");
  return option;
}

void addRuleOptions(CLI::App& app, NeighbourFiles& files) {
  app.add_option_function<std::vector<std::string>>(
         "--rule",
         [&files](const std::vector<std::string>& list) {
           for (const std::string& text : list) files.rules.push_back(parseNamedRule(text));
         },
         "rule for the neighbours with this name, in place of the required distance: a distance in "
         "mm, contact, contact:MM (the parts may overlap by at most MM mm) or ignore. In NAME, * "
         "stands for any characters and ? for one. Repeat the option for more rules")
      ->type_name("NAME=RULE")
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  addText(app, "--rules", "FILE", files.rulesPath,
          "text file with one rule NAME=RULE on each line; lines that begin with # are comments");
}

void checkNeighbourOptions(const NeighbourFiles& files, const std::string& moving) {
  if (!(files.deflection > 0)) badOption("--deflection must be greater than 0 mm");
  if (moving.empty() || isStream(moving)) return;
  for (const std::string& path : files.paths) {
    std::error_code failed;  // ignored: reading the file will report that it is missing
    if (isStream(path) ||
        !std::filesystem::equivalent(pathFromUtf8(path), pathFromUtf8(moving), failed))
      continue;
    badOption("'" + path +
              "' is both the moving part and a neighbour; leave it out of the neighbours. For a "
              "second copy that stands still, use a copy of the file");
  }
}

namespace {

std::vector<NamedRule> rulesIn(const std::string& file, const std::string& path) {
  std::vector<NamedRule> rules;
  LineSource lines(file);
  for (std::string line; lines.next(line);) {
    const auto first = line.find_first_not_of(" \t");
    if (first == std::string::npos || line[first] == '#') continue;
    try {
      rules.push_back(parseNamedRule(line));
    } catch (const Error& error) {
      throw Error(error.status(), error.code(),
                  "'" + path + "', line " + std::to_string(lines.number()) + ": " + error.what());
    }
  }
  return rules;
}

void giveRules(const NeighbourFiles& files, std::vector<ClearanceNeighbour>& list) {
  std::vector<NamedRule> rules = files.rules;
  if (!files.rulesPath.empty())
    readRepeatably(files.rulesPath, [&](const std::string& file) {
      for (const NamedRule& rule : rulesIn(file, files.rulesPath)) rules.push_back(rule);
    });
  std::vector<std::string> names;
  for (const ClearanceNeighbour& part : list) names.push_back(part.name);
  const std::vector<NeighbourRule> found = rulesFor(names, rules);
  for (std::size_t i = 0; i < list.size(); ++i) list[i].rule = found[i];
}

}  // namespace

std::vector<ClearanceNeighbour> readNeighbours(const NeighbourFiles& files, RunContext& run) {
  const PartFileOptions options{files.millimetresPerUnit, files.chordError, files.deflection};
  std::vector<ClearanceNeighbour> list;
  for (const std::string& path : files.paths) {
    readRepeatably(path, [&](const std::string& file) {
      if (!isSolidIn(file, path, "")) {
        list.push_back({utf8FromPath(pathFromUtf8(path).stem()),
                        meshFrom(file, path, "", files.millimetresPerUnit), files.chordError});
        return;
      }
      for (NamedPart& part : readParts(file, options, run))
        list.push_back({part.name, std::move(part.mesh), part.chordError});
    });
  }
  giveRules(files, list);
  return list;
}

void makeNamesUnique(std::vector<ClearanceNeighbour>& parts) {
  std::map<std::string, int> seen;
  for (ClearanceNeighbour& part : parts)
    if (const int count = ++seen[part.name]; count > 1) part.name += " " + std::to_string(count);
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

}  // namespace swept::cli
#endif  // HAVE_SWEPT_CLEARANCE
