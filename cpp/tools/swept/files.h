// Reads and writes the files of a command, and refuses outputs that would destroy data.
// The path "-" means standard input or standard output.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/report_json.h"
#include "base/safe_file.h"
#include "swept/body.h"
#include "swept/types.h"

namespace swept::os {
class ScratchFile;
}

namespace swept::cli {

/// A file and its role in the command ("the motion", "--report"), for messages. Empty path: the
/// option was not given.
struct RoledFile {
  std::string role;
  std::string path;
};

/// Refuses an output that is the same file as an input or another output, also through links or
/// other spellings. Refuses two inputs from standard input and, with noClobber, outputs that exist.
/// Throws Error(InvalidInput, "SameFile"), Error(ExportFailed, "Exists").
void checkIdentity(const std::vector<RoledFile>& inputs, const std::vector<RoledFile>& outputs,
                   bool noClobber);
/// Refuses outputs that cannot be written and inputs that cannot be read. Call this before the
/// computation. Throws Error(ExportFailed), Error(InvalidInput, "BadFile").
void checkAccess(const std::vector<RoledFile>& inputs, const std::vector<RoledFile>& outputs);

/// Returns true for inputs that can be read only once: standard input, pipes, devices.
bool isStream(const std::string& path);
/// Copies the inputs that can be read only once; repeatable() later returns the copies. Call this
/// before runWatched(): until then, an interrupt ends the program at once, even while it waits for
/// data in a pipe.
void keepStreams(const std::vector<RoledFile>& inputs);
/// An input that can be read several times. A stream is copied to a temporary file, which
/// disappears with this object.
class RepeatableInput {
 public:
  explicit RepeatableInput(const std::string& path);
  ~RepeatableInput();
  RepeatableInput(const RepeatableInput&) = delete;
  RepeatableInput& operator=(const RepeatableInput&) = delete;
  const std::string& path() const { return path_; }
  /// Returns the error with the given name in its text instead of path().
  Error named(const Error& error) const;

 private:
  std::string given_, path_;
  std::unique_ptr<os::ScratchFile> copy_;
};
/// Returns the copy that keepStreams() has made, or a new object.
std::shared_ptr<const RepeatableInput> repeatable(const std::string& path);
/// Returns read(name), where `name` is a file that can be read several times. Messages of errors
/// contain `path`.
template <class Read>
auto readRepeatably(const std::string& path, const Read& read) {
  const std::shared_ptr<const RepeatableInput> input = repeatable(path);
  try {
    return read(input->path());
  } catch (const Error& error) {
    throw input->named(error);
  }
}

/// Returns whether an input is a solid file. `file`: a name under which it can be read several
/// times; `path`: the given name. `format`, unless empty, replaces the suffix. An input with
/// neither is recognised as a solid by its first bytes, and otherwise read as PLY.
bool isSolidIn(const std::string& file, const std::string& path, const std::string& format);
TriMesh meshFrom(const std::string& file, const std::string& path, const std::string& format,
                 double unit);
/// Reads a mesh, or solids (STEP, BREP), which are tessellated.
Body readInputBody(const std::string& path, const std::string& format,
                   const BodyFileOptions& options, RunContext& run);

/// Reads poses from a file or standard input. `pivot`: mm.
Trajectory readInputMotion(const std::string& path, double unit, Interpolation interpolation,
                           const Eigen::Vector3d& pivot);

bool isSolidSuffix(const std::string& suffix);  ///< step, stp, brep, brp
bool isMeshSuffix(const std::string& suffix);   ///< formats in which meshes can be written

/// Calls write() with the file to which an output is written: its own path, or for "-" a temporary
/// file, which is then copied to standard output. `format`: the suffix of that temporary file.
void writeOutputFile(const std::string& path, const std::string& format,
                     const std::function<void(const std::string& file)>& write);
/// Throws Error(InvalidInput, "BadOption") if `format` is not the format of the file's suffix.
/// `option`: the option that gives the format of standard output.
void checkStreamFormat(const std::string& option, const std::string& format,
                       const std::string& path);

/// Writes to a file, or to standard output for "-". Throws Error(ExportFailed).
void writeText(const std::string& text, const std::string& path);
/// Writes texts, given with the names of their files. Old files are replaced only when all new ones
/// are complete.
void writeTexts(const std::vector<std::pair<std::string, std::string>>& texts);
/// Writes nothing if the path is empty.
void writeReport(const Json& report, const std::string& path);
/// Flushes standard output. Throws Error(ExportFailed, "WriteFailed").
void flushStandardOutput();

}  // namespace swept::cli
