// SPDX-License-Identifier: LGPL-2.1-or-later
#include "files.h"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <system_error>

#include "swept/io.h"

namespace swept::cli {
namespace {

namespace fs = std::filesystem;

// Where a file would come to stand: links followed, also a link to what does not exist yet.
fs::path resolved(const std::string& path) {
  fs::path name = pathFromUtf8(path);
  std::error_code code;
  constexpr int kMaxLinks = 40;  // as Linux follows
  for (int i = 0; i < kMaxLinks && fs::is_symlink(fs::symlink_status(name, code)); ++i) {
    const fs::path target = fs::read_symlink(name, code);
    if (code) break;
    name = target.is_absolute() ? target : name.parent_path() / target;
  }
  const fs::path real = fs::weakly_canonical(fs::absolute(name, code), code);
  return code ? name : real;
}

bool areSame(const std::string& a, const std::string& b) {
  if (a == "-" || b == "-") return a == b;
  std::error_code code;
  if (fs::equivalent(pathFromUtf8(a), pathFromUtf8(b), code) && !code) return true;
  return resolved(a) == resolved(b);
}

[[noreturn]] void badFile(const std::string& text) {
  throw Error(Status::InvalidInput, "BadFile", text);
}

[[noreturn]] void failedOutput() {
  throw Error(Status::ExportFailed, "WriteFailed",
              "writing to standard output failed: " + std::system_category().message(errno));
}

void put(const char* bytes, std::size_t count) {
  errno = 0;
  if (std::fwrite(bytes, 1, count, stdout) != count) failedOutput();
}

}  // namespace

void checkIdentity(const std::vector<RoledFile>& inputs, const std::vector<RoledFile>& outputs,
                   bool noClobber) {
  const auto same = [](const RoledFile& a, const RoledFile& b) {
    return !a.path.empty() && !b.path.empty() && areSame(a.path, b.path);
  };
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    for (const RoledFile& input : inputs) {
      if (outputs[i].path == "-" || !same(outputs[i], input)) continue;
      throw Error(Status::InvalidInput, "SameFile",
                  outputs[i].role + " '" + outputs[i].path + "' is " + input.role + " '" +
                      input.path + "', which would be lost; choose another name");
    }
    for (std::size_t k = 0; k < i; ++k) {
      if (!same(outputs[i], outputs[k])) continue;
      throw Error(Status::InvalidInput, "SameFile",
                  outputs[i].role + " '" + outputs[i].path + "' is the file of " + outputs[k].role +
                      " too; choose another name for one of them");
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
    if (::access(name.c_str(), R_OK) != 0)
      badFile("'" + input.path +
              "' cannot be opened for reading: " + std::system_category().message(errno));
  }
}

std::string inputPath(const std::string& path) { return path == "-" ? "/dev/stdin" : path; }

bool isStream(const std::string& path) {
  std::error_code code;
  const fs::file_status status = fs::status(pathFromUtf8(inputPath(path)), code);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

TriMesh readInputMesh(const std::string& path, const std::string& format, double unit) {
  return readMesh(inputPath(path), unit, format);
}

Body readInputBody(const std::string& path, const std::string& format,
                   const BodyFileOptions& options, RunContext& run) {
  if (format.empty() && !isStream(path)) return readBody(path, options, run);
  Body body;
  body.mesh = readInputMesh(path, format, options.millimetresPerUnit);
  return body;
}

Trajectory readInputMotion(const std::string& path, double unit, Interpolation interpolation,
                           const Eigen::Vector3d& pivot) {
  Trajectory motion = readTrajectoryCsv(inputPath(path), unit, interpolation);
  motion.pivot = pivot;
  return motion;
}

bool isSolidSuffix(const std::string& suffix) {
  return suffix == "step" || suffix == "stp" || suffix == "brep" || suffix == "brp";
}

Output::Output(const std::string& path, const std::string& format) : path_(path) {
  if (path != "-") return;
  std::string name = (fs::temp_directory_path() / "swept-XXXXXX").string();
  const int handle = ::mkstemp(name.data());
  if (handle < 0)
    throw Error(Status::ExportFailed, "ReadOnly",
                "cannot make '" + name + "': " + std::system_category().message(errno));
  ::close(handle);
  // The suffix says the format; the name without it is the one that mkstemp() made unique.
  temporary_.path = name + "." + format;
  fs::rename(name, temporary_.path);
  path_ = temporary_.path.string();
}

void Output::deliver() const {
  if (temporary_.path.empty()) return;
  std::ifstream file(temporary_.path, std::ios::binary);
  std::array<char, 1 << 16> block{};
  while (file.read(block.data(), block.size()) || file.gcount() > 0)
    put(block.data(), static_cast<std::size_t>(file.gcount()));
  flushStandardOutput();
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

void writeReport(const Json& report, const std::string& path) {
  if (!path.empty()) writeText(jsonText(report), path);
}

void flushStandardOutput() {
  errno = 0;
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) failedOutput();
}

}  // namespace swept::cli
