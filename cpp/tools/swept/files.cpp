// SPDX-License-Identifier: LGPL-2.1-or-later
#include "files.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <system_error>

#include "base/system.h"
#include "io/input_file.h"
#include "swept/io.h"

namespace swept::cli {
namespace {

namespace fs = std::filesystem;

// Returns the real path of a file. Follows links, also a link to a file that does not exist yet.
fs::path resolved(const std::string& path) {
  fs::path name = pathFromUtf8(path);
  std::error_code code;
  constexpr int kMaxLinks = 40;  // the limit of Linux
  for (int i = 0; i < kMaxLinks && fs::is_symlink(fs::symlink_status(name, code)); ++i) {
    const fs::path target = fs::read_symlink(name, code);
    if (code) break;
    name = target.is_absolute() ? target : name.parent_path() / target;
  }
  const fs::path real = fs::weakly_canonical(fs::absolute(name, code), code);
  return code ? name : real;
}

// Returns a name under which an input can be opened, also standard input; empty if standard input
// has no name.
std::string inputPath(const std::string& path) {
  return path == "-" ? os::standardInputName() : path;
}

std::string outputPath(const std::string& path) {
  return path == "-" ? os::standardOutputName() : path;
}

bool areSame(const std::string& a, const std::string& b) {
  std::error_code code;
  const fs::file_status status = fs::status(pathFromUtf8(a), code);
  // Terminals, /dev/null and sockets store no data that could be lost.
  if (fs::is_character_file(status) || fs::is_socket(status)) return false;
  if (fs::equivalent(pathFromUtf8(a), pathFromUtf8(b), code) && !code) return true;
  return resolved(a) == resolved(b);
}

[[noreturn]] void failedOutput() {
  const std::string reason = std::system_category().message(errno);
  // Discards buffered output, so that no later flush fails and reports the error again.
  if (std::freopen(os::nullDeviceName().c_str(), "w", stdout) == nullptr) std::clearerr(stdout);
  throw Error(Status::ExportFailed, "WriteFailed", "writing to standard output failed: " + reason);
}

void put(const char* bytes, std::size_t count) {
  errno = 0;
  if (std::fwrite(bytes, 1, count, stdout) != count) failedOutput();
}

/// Returns the copies that keepStreams() has made, by their given names.
std::map<std::string, std::shared_ptr<const RepeatableInput>>& keptStreams() {
  static std::map<std::string, std::shared_ptr<const RepeatableInput>> kept;
  return kept;
}

void copyTo(os::ScratchFile& file, std::istream& stream) {
  std::array<char, 1 << 16> block{};
  while (stream.read(block.data(), block.size()) || stream.gcount() > 0)
    file.write(block.data(), static_cast<std::size_t>(stream.gcount()));
}

}  // namespace

void checkIdentity(const std::vector<RoledFile>& inputs, const std::vector<RoledFile>& outputs,
                   bool noClobber) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    if (outputs[i].path.empty()) continue;
    const std::string name = outputPath(outputs[i].path);
    for (const RoledFile& input : inputs) {
      if (input.path.empty() || !areSame(name, inputPath(input.path))) continue;
      throw Error(Status::InvalidInput, "SameFile",
                  outputs[i].role + " '" + outputs[i].path + "' is " + input.role + " '" +
                      input.path + "', which would be overwritten; choose another name");
    }
    for (std::size_t k = 0; k < i; ++k) {
      if (outputs[k].path.empty()) continue;
      const bool both = outputs[i].path == "-" && outputs[k].path == "-";
      if (!both && !areSame(name, outputPath(outputs[k].path))) continue;
      throw Error(Status::InvalidInput, "SameFile",
                  outputs[i].role + " '" + outputs[i].path + "' is also the file of " +
                      outputs[k].role + "; choose another name for one of them");
    }
  }
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (inputs[i].path == "-" && inputs[k].path == "-")
        throw Error(Status::InvalidInput, "SameFile",
                    "standard input can be " + inputs[k].role + " or " + inputs[i].role +
                        ", not both; name a file for one of them");
    }
  }
  if (!noClobber) return;
  for (const RoledFile& output : outputs) {
    if (!output.path.empty() && output.path != "-") requireAbsent(output.role, output.path);
  }
}

void checkAccess(const std::vector<RoledFile>& inputs, const std::vector<RoledFile>& outputs) {
  for (const RoledFile& output : outputs) {
    if (!output.path.empty() && output.path != "-") checkTarget(output.path);
  }
  for (const RoledFile& input : inputs) {
    if (input.path == "-") continue;
    const fs::path name = pathFromUtf8(input.path);
    std::error_code code;
    if (!fs::exists(name, code)) badFile("'" + input.path + "' does not exist");
    if (fs::is_directory(name, code)) badFile("'" + input.path + "' is a folder, not a file");
    if (!os::mayRead(name))
      badFile("'" + input.path +
              "' cannot be opened for reading: " + std::system_category().message(errno));
  }
}

bool isStream(const std::string& path) {
  if (inputPath(path).empty()) return true;
  std::error_code code;
  const fs::file_status status = fs::status(pathFromUtf8(inputPath(path)), code);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

RepeatableInput::RepeatableInput(const std::string& path) : given_(path), path_(inputPath(path)) {
  if (!isStream(path)) return;
  std::ifstream file;
  if (!path_.empty()) {
    file.open(pathFromUtf8(path_), std::ios::binary);
    if (!file) badFile("'" + path + "' cannot be opened; check its name and its permissions");
  }
  try {
    copy_ = std::make_unique<os::ScratchFile>();
    copyTo(*copy_, path_.empty() ? std::cin : file);
    path_ = copy_->finish();
  } catch (const std::system_error& error) {
    throw Error(Status::ExportFailed, "WriteFailed",
                "'" + path +
                    "' is no ordinary file but a pipe or a device, and copying its data to a "
                    "temporary file failed: " +
                    error.what() + "; free disk space, or give the name of a file");
  }
}

RepeatableInput::~RepeatableInput() = default;

void keepStreams(const std::vector<RoledFile>& inputs) {
  for (const RoledFile& input : inputs)
    if (!input.path.empty() && isStream(input.path))
      keptStreams()[input.path] = std::make_shared<const RepeatableInput>(input.path);
}

std::shared_ptr<const RepeatableInput> repeatable(const std::string& path) {
  const auto kept = keptStreams().find(path);
  return kept != keptStreams().end() ? kept->second : std::make_shared<RepeatableInput>(path);
}

Error RepeatableInput::named(const Error& error) const {
  std::string text = error.what();
  for (std::size_t at = text.find(path_); path_ != given_ && at != std::string::npos;
       at = text.find(path_, at + given_.size())) {
    text.replace(at, path_.size(), given_);
  }
  return {error.status(), error.code(), text};
}

bool isSolidIn(const std::string& file, const std::string& path, const std::string& format) {
  if (!isSolidSuffix(format)) return format.empty() && isSolidFile(file);
  if (!isSolidFile(file))
    badFile("'" + path +
            "' does not begin like a STEP or BREP file; check the file and its format");
  return true;
}

TriMesh meshFrom(const std::string& file, const std::string& path, const std::string& format,
                 double unit) {
  const std::string suffix = format.empty() ? suffixOf(path) : format;
  // Standard input can be a regular file, for which isStream() is false.
  const bool unnamed = path == "-" || isStream(path) || os::isDeviceName(path);
  if (!suffix.empty() || !unnamed) return readMesh(file, unit, suffix);
  try {
    return readMesh(file, unit, "ply");
  } catch (const Error& error) {
    throw Error(error.status(), error.code(),
                std::string(error.what()) +
                    "; the input has no file extension, so it was read as ply: give its format");
  }
}

Body readInputBody(const std::string& path, const std::string& format,
                   const BodyFileOptions& options, RunContext& run) {
  return readRepeatably(path, [&](const std::string& file) -> Body {
    if (isSolidIn(file, path, format)) return readBody(file, options, run);
    return {meshFrom(file, path, format, options.millimetresPerUnit), 0, {}};
  });
}

Trajectory readInputMotion(const std::string& path, double unit, Interpolation interpolation,
                           const Eigen::Vector3d& pivot) {
  Trajectory motion = readRepeatably(
      path, [&](const std::string& file) { return readTrajectoryCsv(file, unit, interpolation); });
  motion.pivot = pivot;
  return motion;
}

bool isSolidSuffix(const std::string& suffix) {
  return suffix == "step" || suffix == "stp" || suffix == "brep" || suffix == "brp";
}

bool isMeshSuffix(const std::string& suffix) {
  return suffix == "ply" || suffix == "stl" || suffix == "obj" || suffix == "off" ||
         suffix == "3mf";
}

void writeOutputFile(const std::string& path, const std::string& format,
                     const std::function<void(const std::string& file)>& write) {
  if (path != "-") return write(path);
  TemporaryName temporary;
  try {
    temporary.path = os::newTemporaryFile("." + format);  // the suffix selects the format
  } catch (const std::system_error& error) {
    throw Error(Status::ExportFailed, "ReadOnly",
                std::string("cannot create a temporary file: ") + error.what());
  }
  try {
    write(utf8FromPath(temporary.path));
  } catch (const Error& error) {
    throw Error(error.status(), error.code(),
                std::string("temporary file for standard output: ") + error.what());
  }
  std::ifstream file(temporary.path, std::ios::binary);
  std::array<char, 1 << 16> block{};
  while (file.read(block.data(), block.size()) || file.gcount() > 0)
    put(block.data(), static_cast<std::size_t>(file.gcount()));
  flushStandardOutput();
}

void checkStreamFormat(const std::string& option, const std::string& format,
                       const std::string& path) {
  const auto inFull = [](const std::string& suffix) {
    return suffix == "stp" ? "step" : suffix == "brp" ? "brep" : suffix;
  };
  if (path == "-" || path.empty() || inFull(suffixOf(path)) == format) return;
  throw Error(Status::InvalidInput, "BadOption",
              option + " " + format + " is for standard output, but '" + path +
                  "' is a file, whose format follows from its extension; leave out " + option +
                  ", or change the extension");
}

void writeText(const std::string& text, const std::string& path) {
  if (path == "-") {
    put(text.data(), text.size());
    flushStandardOutput();
    return;
  }
  SafeFile file(path);
  file.stream() << text;
  file.commit();
}

void writeTexts(const std::vector<std::pair<std::string, std::string>>& texts) {
  std::vector<std::unique_ptr<SafeFile>> files;
  for (const auto& [text, path] : texts) {
    files.push_back(std::make_unique<SafeFile>(path));
    files.back()->stream() << text;
    files.back()->close();
  }
  for (const auto& file : files) file->commit();
}

void writeReport(const Json& report, const std::string& path) {
  if (!path.empty()) writeText(jsonText(report), path);
}

void flushStandardOutput() {
  errno = 0;
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) failedOutput();
}

}  // namespace swept::cli
