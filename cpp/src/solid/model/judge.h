// The judge: an interface to a geometry kernel for making a solid. It decides whether the kernel
// accepts the faces of a model, and whether it reads a file back as it was written. The kernel
// changes nothing: the text of the file is made from the model alone. So the solid is the same with
// every kernel that gives the same answers.
// In:      a Model. Out: indices into Model::faces and Model::edges.
// Units:   mm.
// Throws Error(ExportFailed, "KernelFailure" | "RereadFailed"), Error(Cancelled).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "solid/model/model.h"
#include "solid/model/split_edges.h"
#include "swept/run_context.h"
#include "swept/solid.h"

namespace swept::step {

/// A solid that the kernel made from the faces and edges of the moving body.
struct Assembly {
  std::map<std::string, std::int64_t> facesByKind;
  SolidCheck check;      ///< of the STEP file, read back
  double deviation = 0;  ///< mm, from the swept volume (assemble/sweep_deviation.h)
  double meshError = 0;  ///< mm, of most of the mesh: how far it lies off the solid
};

class Judge {
 public:
  virtual ~Judge() = default;

  /// Sets the model to which the next four functions refer. Returns the faces that the kernel
  /// cannot make.
  virtual std::vector<std::int32_t> setModel(const Model& model, RunContext& run) = 0;
  /// Returns edges of curved faces that are farther from one of their faces than a reader of the
  /// file would assume. Each entry has the curve parameter at which the distance is largest.
  virtual std::vector<EdgeCut> findEdgesOffFaces(const Model& model) = 0;
  /// Returns faces that are not valid. `from` and `to`: progress of the export (0 to 1).
  virtual std::vector<std::int32_t> findBadFaces(RunContext& run, double from, double to) = 0;
  /// Returns curved faces that are not valid after the text of the file was read back.
  virtual std::vector<std::int32_t> findUnreadable(const Model& model, const SolidOptions& options,
                                                   RunContext& run) = 0;
  /// Returns faces that intersect or touch where they share no vertex or edge.
  virtual std::vector<std::int32_t> findInterfering(const Model& model, RunContext& run) = 0;

  /// Makes the solid from SolidOptions::origin. Returns nothing if the judge has no kernel or if
  /// there is no such solid with about the volume (mm^3) of the mesh.
  virtual std::optional<Assembly> assemble(const SolidOptions& options, const HalfEdgeMesh& mesh,
                                           RunContext& run);
  /// Fills what the last assemble() has missed with triangles of the mesh. Returns nothing if there
  /// is no such solid with at most so many faces.
  virtual std::optional<Assembly> fill(const SolidOptions& options, std::int64_t mostFaces,
                                       const HalfEdgeMesh& mesh, RunContext& run);
  /// Writes the solid of the last assemble() or fill().
  virtual void writeAssembled(std::ostream& out, const std::string& name,
                              const SolidOptions& options, SolidFormat format, RunContext& run);

  /// Writes the model of the last setModel() as a BREP file.
  virtual void writeBrep(std::ostream& out, RunContext& run) = 0;
  /// Reads a finished file back and checks it. If the file cannot be read correctly, may replace it
  /// by one from the kernel's own writer. `name`: final name of the file, for its header. `model`
  /// has no faces if the file contains the solid of assemble() or fill().
  virtual SolidCheck readBack(const Model& model, const std::string& file, const std::string& name,
                              const SolidOptions& options, SolidFormat format, RunContext& run) = 0;
  /// Calls work(), and converts failures of the kernel to an Error.
  virtual void guard(const std::function<void()>& work, RunContext& run) = 0;
};

/// Returns the judge of this build. With a kernel, only one thread at a time can have a judge.
/// Throws Error(ExportFailed, "NoKernel") if the program was built without a kernel.
std::unique_ptr<Judge> openJudge();

}  // namespace swept::step
