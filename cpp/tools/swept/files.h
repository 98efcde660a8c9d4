// The files of one command: what is read, what is written, and that nothing is lost.
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

/// A file and what it is to the command ("the motion", "--report"). Empty path: not asked for.
struct RoledFile {
  std::string role;
  std::string path;
};

/// Refuses an output that is an input or another output, by identity of the file (links, other
/// spellings), two inputs from standard input, and, with noClobber, outputs that exist.
/// Throws Error(InvalidInput, "SameFile"), Error(ExportFailed, "Exists").
void checkIdentity(const std::vector<RoledFile>& inputs, const std::vector<RoledFile>& outputs,
                   bool noClobber);
/// Refuses outputs that cannot be written and inputs that cannot be read, before anything long
/// starts. Throws Error(ExportFailed), Error(InvalidInput, "BadFile").
void checkAccess(const std::vector<RoledFile>& inputs, const std::vector<RoledFile>& outputs);

/// True of what can be read only once: standard input, pipes, devices.
bool isStream(const std::string& path);
/// Reads the inputs that can be read only once; whoever reads them afterwards gets what was kept.
/// To be called before a run is watched: there an interrupt ends the program at once, though nobody
/// writes into the pipe.
void keepStreams(const std::vector<RoledFile>& inputs);
/// An input under a name that can be read again and again: a stream is copied to a file without a
/// name, which goes with this object.
class RepeatableInput {
 public:
  explicit RepeatableInput(const std::string& path);
  ~RepeatableInput();
  RepeatableInput(const RepeatableInput&) = delete;
  RepeatableInput& operator=(const RepeatableInput&) = delete;
  const std::string& path() const { return path_; }
  /// The same error, about the name that was given.
  Error named(const Error& error) const;

 private:
  std::string given_, path_;
  int handle_ = -1;
};
/// The one that keepStreams() has made, or a new one.
std::shared_ptr<const RepeatableInput> repeatable(const std::string& path);
/// read(name): with a name that can be read again and again, and errors that say the given one.
template <class Read>
auto readRepeatably(const std::string& path, const Read& read) {
  const std::shared_ptr<const RepeatableInput> input = repeatable(path);
  try {
    return read(input->path());
  } catch (const Error& error) {
    throw input->named(error);
  }
}

/// `file`: an input's repeatable name, `path`: the name that was given. `format` in place of the
/// suffix where it is not empty; a stream without both is known by how it begins, or a ply file.
bool isSolidIn(const std::string& file, const std::string& path, const std::string& format);
TriMesh meshFrom(const std::string& file, const std::string& path, const std::string& format,
                 double unit);
/// A mesh, or solids (STEP, BREP) that are tessellated.
Body readInputBody(const std::string& path, const std::string& format,
                   const BodyFileOptions& options, RunContext& run);

/// Poses from a file or standard input; pivot: mm.
Trajectory readInputMotion(const std::string& path, double unit, Interpolation interpolation,
                           const Eigen::Vector3d& pivot);

bool isSolidSuffix(const std::string& suffix);  ///< step, stp, brep, brp
bool isMeshSuffix(const std::string& suffix);   ///< what meshes can be written as

/// Where an output is made: its own path, or for "-" a file beside nobody's that deliver() copies
/// to standard output.
class Output {
 public:
  /// `format` stands for the suffix of "-".
  Output(const std::string& path, const std::string& format);
  const std::string& path() const { return path_; }
  void deliver() const;

 private:
  std::string path_;
  TemporaryName temporary_;
};

/// To a file, or to standard output for "-". Throws Error(ExportFailed).
void writeText(const std::string& text, const std::string& path);
/// Texts and the names of their files: old files are replaced when all new ones are whole.
void writeTexts(const std::vector<std::pair<std::string, std::string>>& texts);
/// Nothing where the path is empty.
void writeReport(const Json& report, const std::string& path);
/// What printing left in memory reaches its reader. Throws Error(ExportFailed, "WriteFailed").
void flushStandardOutput();

}  // namespace swept::cli
