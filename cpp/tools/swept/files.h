// The input and output files of one command. Makes sure that no file is overwritten by mistake.
// "-" is standard input or standard output.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/report_json.h"
#include "base/safe_file.h"
#include "swept/body.h"
#include "swept/types.h"

namespace swept::cli {

/// A file and its role in the command ("the motion", "--report"). Empty path: no such file.
struct RoledFile {
  std::string role;
  std::string path;
};

/// Refuses an output that is also an input or another output; files are compared by identity, so
/// links and other spellings are found. Also refuses two inputs from standard input and, with
/// noClobber, outputs that exist. Throws Error(InvalidInput, "SameFile"), Error(ExportFailed,
/// "Exists").
void checkIdentity(const std::vector<RoledFile>& inputs, const std::vector<RoledFile>& outputs,
                   bool noClobber);
/// Refuses outputs that cannot be written and inputs that cannot be read, before a long computation
/// starts. Throws Error(ExportFailed), Error(InvalidInput, "BadFile").
void checkAccess(const std::vector<RoledFile>& inputs, const std::vector<RoledFile>& outputs);

/// Returns true for files that can be read only once: standard input, pipes, devices.
bool isStream(const std::string& path);
/// Reads and keeps the inputs that can be read only once; later reads get the kept data. Call it
/// before runWatched(): an interrupt then still ends the program at once, even if nobody writes
/// into the pipe.
void keepStreams(const std::vector<RoledFile>& inputs);
/// An input under a name that can be read repeatedly. A stream is copied to a temporary file, which
/// exists as long as this object.
class RepeatableInput {
 public:
  explicit RepeatableInput(const std::string& path);
  ~RepeatableInput();
  RepeatableInput(const RepeatableInput&) = delete;
  RepeatableInput& operator=(const RepeatableInput&) = delete;
  const std::string& path() const { return path_; }
  /// Returns the same error with the name that the user gave.
  Error named(const Error& error) const;

 private:
  std::string given_, path_;
  int handle_ = -1;
};
/// Returns the input that keepStreams() has made, or a new one.
std::shared_ptr<const RepeatableInput> repeatable(const std::string& path);
/// Calls read(name) with a name that can be read repeatedly. Errors show the name that the user
/// gave.
template <class Read>
auto readRepeatably(const std::string& path, const Read& read) {
  const std::shared_ptr<const RepeatableInput> input = repeatable(path);
  try {
    return read(input->path());
  } catch (const Error& error) {
    throw input->named(error);
  }
}

/// `file`: the name of an input that can be read repeatedly; `path`: the name that the user gave.
/// `format`, if not empty, replaces the suffix. A stream without suffix and format is recognised by
/// its first bytes; otherwise it counts as a PLY file.
bool isSolidIn(const std::string& file, const std::string& path, const std::string& format);
TriMesh meshFrom(const std::string& file, const std::string& path, const std::string& format,
                 double unit);
/// Reads a mesh, or tessellates the solids of a STEP or BREP file.
Body readInputBody(const std::string& path, const std::string& format,
                   const BodyFileOptions& options, RunContext& run);

/// Reads poses from a file or from standard input. pivot: mm.
Trajectory readInputMotion(const std::string& path, double unit, Interpolation interpolation,
                           const Eigen::Vector3d& pivot);

bool isSolidSuffix(const std::string& suffix);  ///< step, stp, brep, brp
/// Returns whether a mesh can be written with this suffix.
bool isMeshSuffix(const std::string& suffix);

/// The file to which an output is written: its own path or, for "-", a temporary file that
/// deliver() copies to standard output.
class Output {
 public:
  /// `format` is the suffix if the path is "-".
  Output(const std::string& path, const std::string& format);
  const std::string& path() const { return path_; }
  void deliver() const;

 private:
  std::string path_;
  TemporaryName temporary_;
};

/// Writes to a file, or to standard output for "-". Throws Error(ExportFailed).
void writeText(const std::string& text, const std::string& path);
/// Writes several texts to files of the given names. Replaces old files only after all new files
/// are complete.
void writeTexts(const std::vector<std::pair<std::string, std::string>>& texts);
/// Does nothing if the path is empty.
void writeReport(const Json& report, const std::string& path);
/// Flushes the buffer of standard output. Throws Error(ExportFailed, "WriteFailed").
void flushStandardOutput();

}  // namespace swept::cli
