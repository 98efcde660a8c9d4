// SPDX-License-Identifier: LGPL-2.1-or-later
#include "swept/solid.h"

#include <cmath>
#include <string>

#include "base/checkpoint_hook.h"
#include "fuzz/inputs.h"
#include "fuzz/promise.h"
#include "fuzz/targets.h"
#include "support/temporary_folder.h"
#include "swept/compute.h"

namespace swept::fuzz {
namespace {

constexpr std::int64_t kMaxFaces = 400;  // under a fuzzer, the kernel takes milliseconds a face

SolidOptions stepOptions(ByteSource& bytes) {
  SolidOptions options;
  options.maxFaces = bytes.chance(16) ? bytes.byte() - 3 : kMaxFaces;
  options.mergeCoplanar = bytes.chance(230);
  if (bytes.chance(128)) options.tolerance = std::abs(bytes.number()) / 16;
  if (bytes.chance(32)) options.planarTolerance = bytes.number() / 800;
  if (bytes.chance(16)) options.maxMegabytes = bytes.number();
  options.exact = bytes.chance(32);
  options.recognise = bytes.chance(220);
  constexpr StepSchema kSchemas[] = {StepSchema::Ap214, StepSchema::Ap242,
                                     StepSchema::Ap242Tessellated};
  options.schema = kSchemas[bytes.below(3)];
  if (bytes.chance(32)) options.productName = std::string(1 + bytes.below(4), bytes.byte());
  if (bytes.chance(8)) options.colour[bytes.below(3)] = bytes.number();
  return options;
}

/// Returns an envelope if there is one, otherwise the body. The writer accepts any mesh.
TriMesh surface(ByteSource& bytes, RunContext& run) {
  const TriMesh mesh = body(bytes);
  if (bytes.chance(64)) return mesh;
  Options options;
  options.backend = Backend::Cpu;
  options.resolution = 4 + bytes.below(12);
  if (bytes.chance(64)) options.tolerance = std::abs(bytes.even()) / 8;
  if (bytes.chance(32)) options.offset = std::abs(bytes.even()) / 4;
  options.keepCavities = bytes.chance(128);
  const Result result = compute(mesh, motion(bytes), options, run);
  return result.report.status == Status::Ok ? result.mesh : mesh;
}

void requireSolid(const WrittenSolid& report, const SolidOptions& options,
                  const test::TemporaryFolder& folder) {
  const auto require = [&](bool holds, const char* what) {
    if (!holds) throw BrokenPromise(what);
  };
  require(folder.count() == 1, "a solid without a file, or with more than one");
  require(report.valid && report.solids > 0 && report.faces > 0, "a solid that is none");
  require(std::isfinite(report.volume) && std::isfinite(report.deviation), "no volume");
  require(report.fileBytes > 0, "an empty file");
  require(report.deviation <= report.tolerance * (1 + 1e-9) ||
              report.deviation <= options.planarTolerance * (1 + 1e-9),
          "the solid leaves the mesh by more than its tolerance");
  require(options.tolerance <= 0 || report.tolerance <= options.tolerance * (1 + 1e-9),
          "another tolerance than the one given");
}

}  // namespace

void solid(const std::uint8_t* data, std::size_t size) {
  ByteSource bytes(data, size);
  SolidOptions chosen = stepOptions(bytes);
  const bool brep = bytes.chance(64);
  RunContext run, exporting;
  limit(run);
  limit(exporting);
  if (bytes.chance(16)) CheckpointHook::cancelAt(exporting, bytes.byte());
  const TriMesh mesh = surface(bytes, run);
  const test::TemporaryFolder folder;
  try {
    const WrittenSolid report =
        writeSolid(mesh, folder.file(brep ? "a.brep" : "a.step"), chosen, exporting);
    if (chosen.schema != StepSchema::Ap242Tessellated) requireSolid(report, chosen, folder);
  } catch (const Error& error) {
    requireNamed("a solid", error,
                 {Status::ExportFailed, Status::Cancelled, Status::ResourceLimit});
    if (folder.count() != 0) throw BrokenPromise("a refused solid left a file");
  }
}

}  // namespace swept::fuzz
