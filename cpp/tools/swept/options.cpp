// SPDX-License-Identifier: LGPL-2.1-or-later
#include "options.h"

#include <charconv>
#include <cmath>
#include <sstream>
#include <vector>

#include "base/limits.h"
#include "swept/types.h"

namespace swept::cli {
namespace {

template <class T>
bool parseWhole(const std::string& text, T& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size();
}

}  // namespace

void addWords(CLI::App& app, const std::string& name, int count, const std::string& kind,
              std::vector<std::string>& words, const std::string& about) {
  app.add_option(name, words, about)->type_size(count)->type_name(kind)->allow_extra_args(false);
}

double numberOf(const std::string& name, const std::string& text) {
  double number = 0;
  if (!parseWhole(text, number) || !std::isfinite(number))
    badOption(name + " is '" + text + "'; expected a number such as 0.25");
  return number;
}

std::vector<double> numbersOf(const std::string& name, const std::string& text) {
  std::vector<double> numbers;
  std::istringstream fields(text);
  for (std::string field; std::getline(fields, field, ',');)
    numbers.push_back(numberOf(name, field));
  return numbers;
}

void badOption(const std::string& text) { throw Error(Status::InvalidInput, "BadOption", text); }

CLI::Option* addConverted(CLI::App& app, const std::string& names, const std::string& kind,
                          std::function<void(const std::string&)> take, const std::string& about) {
  return app.add_option_function<std::string>(names, take, about)->type_name(kind);
}

void keepEarlierName(CLI::App& app, const std::string& earlier, const std::string& name) {
  CLI::Option* option = app.get_option(name);
  app.add_option_function<std::string>(earlier,
                                       [option](const std::string& value) {
                                         option->add_result(value);
                                         option->run_callback();
                                       })
      ->group("");
}

void keepGeneratorNames(CLI::App& app, const std::string& prefix,
                        std::initializer_list<const char*> rests) {
  for (const char* rest : rests)
    keepEarlierName(app, std::string("--generator-") + rest, prefix + rest);
}

CLI::Option* addText(CLI::App& app, const std::string& names, const std::string& kind,
                     std::string& target, const std::string& about) {
  const std::string name = names.substr(names.rfind(',') + 1);
  return addConverted(
      app, names, kind,
      [name, &target](const std::string& value) {
        if (value.empty()) badOption(name + " needs a value, but the value is empty");
        target = value;
      },
      about);
}

CLI::Option* addNumber(CLI::App& app, const std::string& names, const std::string& kind,
                       double& target, const std::string& about) {
  const std::string name = names.substr(names.rfind(',') + 1);
  return addConverted(
      app, names, kind,
      [name, &target](const std::string& value) { target = numberOf(name, value); }, about);
}

CLI::Option* addNumber(CLI::App& app, const std::string& names, const std::string& kind,
                       std::optional<double>& target, const std::string& about) {
  const std::string name = names.substr(names.rfind(',') + 1);
  return addConverted(
      app, names, kind,
      [name, &target](const std::string& value) {
        target = unlessZero(std::optional(numberOf(name, value)));
      },
      about);
}

std::int64_t wholeNumberOf(const std::string& name, const std::string& text, std::int64_t least,
                           std::int64_t most) {
  std::int64_t number = 0;
  if (!parseWhole(text, number) || number < least || number > most)
    badOption(name + " is '" + text + "'; expected a whole number from " + std::to_string(least) +
              " to " + std::to_string(most));
  return number;
}

CLI::Option* addInteger(CLI::App& app, const std::string& names, std::int64_t& target,
                        std::int64_t least, std::int64_t most, const std::string& about) {
  const std::string name = names.substr(names.rfind(',') + 1);
  return addConverted(
      app, names, "N",
      [name, &target, least, most](const std::string& value) {
        target = wholeNumberOf(name, value, least, most);
      },
      about);
}

CLI::Option* addPoint(CLI::App& app, const std::string& names, Eigen::Vector3d& target,
                      const std::string& about) {
  return addConverted(
      app, names, "X,Y,Z",
      [names, &target](const std::string& text) {
        const std::vector<double> numbers = numbersOf(names, text);
        if (numbers.size() != 3)
          badOption(names + " is '" + text + "'; expected three numbers in mm, such as 10,0,2.5");
        target = {numbers[0], numbers[1], numbers[2]};
      },
      about);
}

CLI::Option* addUnit(CLI::App& app, const std::string& names, double& target,
                     const std::string& about) {
  return addConverted(
      app, names, "mm|cm|m|in",
      [names, &target](const std::string& text) {
        try {
          target = parseLengthUnit(text);
        } catch (const Error& e) {  // several options of a command have units
          badOption(names + ": " + e.what());
        }
      },
      about);
}

void addCommonOptions(CLI::App& app, CommonOptions& options) {
  addText(app, "--report", "FILE", options.report,
          "write a report as JSON, also if the run fails, or - for standard output");
  addInteger(app, "--threads", options.threads, 0, kMaxThreads,
             "number of threads (default 0: one for each processor core)");
  app.add_flag("--strict", options.strict,
               "treat a finding that reduces the accuracy as a failure");
  app.add_flag("--no-clobber", options.noClobber,
               "refuse the run if a file that it would write already exists");
  app.add_flag("-q,--quiet", options.quiet, "print no progress bar and no summary");
  app.add_flag("-v,--verbose", options.verbose,
               "print the duration of each stage, and more details");
}

}  // namespace swept::cli
