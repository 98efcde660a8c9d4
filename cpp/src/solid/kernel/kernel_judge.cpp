// The judge (model/judge.h) of builds with OpenCASCADE.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <Message_ProgressScope.hxx>
#include <Standard_ErrorHandler.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <fstream>
#include <gp_Pnt.hxx>
#include <optional>
#include <sstream>

#include "base/safe_file.h"
#include "solid/assemble/assemble.h"
#include "solid/assemble/body_shape.h"
#include "solid/assemble/exact_sections.h"
#include "solid/assemble/face_samples.h"
#include "solid/assemble/facet_filling.h"
#include "solid/assemble/fine_triangles.h"
#include "solid/assemble/kernel_geometry.h"
#include "solid/assemble/shorten_curves.h"
#include "solid/assemble/sides.h"
#include "solid/assemble/solid_of_faces.h"
#include "solid/assemble/sweep_deviation.h"
#include "solid/assemble/swept_faces.h"
#include "solid/kernel/brep.h"
#include "solid/kernel/interference.h"
#include "solid/kernel/kernel.h"
#include "solid/kernel/read_check.h"
#include "solid/kernel/shape_check.h"
#include "solid/kernel/solid_file.h"
#include "solid/model/judge.h"
#include "solid/text/step_text.h"

namespace swept::step {
namespace {

[[noreturn]] void refuseFailure(const Standard_Failure& failure, const KernelSession& kernel,
                                RunContext& run) {
  // Throws if the run was cancelled, because a cancelled kernel call may end in an exception, too.
  run.checkpoint(Phase::Export);
  const char* text = failure.GetMessageString();
  throw Error(Status::ExportFailed, "KernelFailure",
              std::string("OpenCASCADE could not make the solid (") +
                  failure.DynamicType()->Name() +
                  (text != nullptr && *text != 0 ? std::string(": ") + text : std::string()) +
                  (kernel.messages().empty() ? std::string() : "; " + kernel.messages()) +
                  "); change the tolerance, or export a mesh file");
}

// The kernel reads plane faces without healing them if their vertices and edges lie within this
// distance (mm) of their planes.
constexpr double kExact = 1e-5;

std::string kindOf(const TopoDS_Face& face) {
  switch (BRepAdaptor_Surface(face, Standard_False).GetType()) {
    case GeomAbs_Plane:
      return surfaceKindName(CarrierKind::Plane);
    case GeomAbs_Cylinder:
      return surfaceKindName(CarrierKind::Cylinder);
    case GeomAbs_Cone:
      return surfaceKindName(CarrierKind::Cone);
    case GeomAbs_Sphere:
      return surfaceKindName(CarrierKind::Sphere);
    case GeomAbs_Torus:
      return surfaceKindName(CarrierKind::Torus);
    case GeomAbs_SurfaceOfExtrusion:
      return surfaceKindName(CarrierKind::Extrusion);
    case GeomAbs_SurfaceOfRevolution:
      return surfaceKindName(CarrierKind::Revolution);
    default:
      return kSheetName;
  }
}

// Returns a point in the middle of a face, or on its border if it is too narrow.
gp_Pnt pointOn(const TopoDS_Face& face) {
  constexpr int kSamples = 25;
  const std::vector<FaceSample> samples = samplesOf(face, kSamples);
  if (!samples.empty()) return samples[samples.size() / 2].point;
  return BRep_Tool::Pnt(TopoDS::Vertex(TopExp_Explorer(face, TopAbs_VERTEX).Current()));
}

// Counts some faces of a kind as facets.
void countAsFacets(const std::string& kind, std::int64_t count, Assembly& assembly) {
  if (count == 0) return;
  assembly.facesByKind[surfaceKindName(CarrierKind::Facet)] += count;
  if ((assembly.facesByKind[kind] -= count) == 0) assembly.facesByKind.erase(kind);
}

class KernelJudge : public Judge {
 public:
  std::vector<std::int32_t> setModel(const Model& model, RunContext& run) override {
    brep_ = buildBrep(model, run);
    return brep_.failed;
  }
  std::vector<EdgeCut> findEdgesOffFaces(const Model& model) override {
    return step::findEdgesOffFaces(model, brep_);
  }
  std::vector<std::int32_t> findBadFaces(RunContext& run, double from, double to) override {
    return step::findBadFaces(brep_.faces, run, from, to);
  }
  std::vector<std::int32_t> findUnreadable(const Model& model, const SolidOptions& options,
                                           RunContext& run) override {
    if (!reader_) reader_.emplace(kernel_);
    return reader_->findUnreadable(model, options, run);
  }
  std::vector<std::int32_t> findInterfering(const Model& model, RunContext& run) override {
    return step::findInterfering(model, brep_, run);
  }
  std::optional<Assembly> assemble(const SolidOptions& options, const HalfEdgeMesh& mesh,
                                   RunContext& run) override {
    const SolidOrigin& origin = *options.origin;
    const Handle(KernelProgress) progress = new KernelProgress(run, 0.0, 0.3);
    Message_ProgressScope scope(progress->Start(), "", 7);
    parts_.clear();
    if (!canSweepFaces(*origin.shape, origin.trajectory)) return std::nullopt;
    sides_.emplace(origin.shape->shape, origin.trajectory);
    const SweptFaces faces = sweptFaces(*origin.shape, origin.trajectory, *sides_, scope.Next());
    run.checkpoint(Phase::Export);
    if (faces.faces.empty()) return std::nullopt;
    const double accuracy = mesh.area * farthestMesh(mesh.points, options.tolerance);
    AssembledSweep assembled = assembleSweep(faces, *sides_, mesh.volume, accuracy, scope.Next(4));
    run.checkpoint(Phase::Export);
    parts_ = std::move(assembled.parts);
    if (assembled.shape.IsNull()) return std::nullopt;
    makeSectionsExact(assembled.shape);
    TriMesh triangles;
    Assembly assembly = writeAndRead(assembled.shape, options, triangles, run);
    // The kernel's test takes minutes for faces that are nearly tangent.
    if (!assembled.isCertain && doesIntersectItself(readBack_, scope.Next(2))) return std::nullopt;
    setDeviation(assembly, triangles, mesh, options);
    assembly.deviation = std::max(assembly.deviation, assembled.filled);
    return assembly;
  }
  std::optional<Assembly> fill(const SolidOptions& options, std::int64_t mostFaces,
                               const HalfEdgeMesh& mesh, RunContext& run) override {
    // Some faces are wrong only after they were read back.
    constexpr int kRounds = 3;
    if (parts_.empty()) return std::nullopt;
    FacetFiller filler(parts_, mesh, *sides_, options.tolerance, run);
    std::vector<Eigen::Vector3d> wrong;
    for (int round = 0; round < kRounds; ++round) {
      const FilledSolid filled = filler.fill(wrong);
      if (filled.shape.IsNull() || countOf(filled.shape, TopAbs_FACE) > mostFaces)
        return std::nullopt;
      TriMesh triangles;
      Assembly assembly = writeAndRead(filled.shape, options, triangles, run);
      countAsFacets(surfaceKindName(CarrierKind::Plane), filled.planes, assembly);
      countAsFacets(kSheetName, filled.cones, assembly);
      setDeviation(assembly, triangles, mesh, options);
      wrong = assembly.check.valid ? std::vector<Eigen::Vector3d>() : pointsOnInvalid(run);
      if (wrong.empty() && assembly.deviation <= options.tolerance) return assembly;
      for (const FarFoot& foot : feetBeyond(triangles, mesh.points, sides_->interior(),
                                            sides_->detail(), options.tolerance))
        wrong.push_back(foot.point);
    }
    return std::nullopt;
  }
  void writeAssembled(std::ostream& out, const std::string& name, const SolidOptions& options,
                      SolidFormat format, RunContext& run) override {
    if (format == SolidFormat::Brep) {
      step::writeBrep(readBack_, out, run);
    } else {
      writeStepFile(assembled_, out, name, options, kernel_, run);
    }
  }
  void writeBrep(std::ostream& out, RunContext& run) override {
    step::writeBrep(brep_.shape, out, run);
  }
  SolidCheck readBack(const Model& model, const std::string& file, const std::string& name,
                      const SolidOptions& options, SolidFormat format, RunContext& run) override {
    if (model.faces.empty()) return checkShape(readAssembled(file, format, run), run, 0.8, 1.0);
    SolidCheck check = checkShape(read(model, file, format, run), run, 0.8, 1.0);
    if (!check.valid && format == SolidFormat::Step)
      check = checkShape(readStepFile(file, kernel_, run), run, 0.8, 1.0);
    if (!check.valid && format == SolidFormat::Step && !isFlat(model)) {
      // The kernel reads some curved faces wrongly if the file has no parameter curves. The
      // kernel's own writer adds them.
      std::ofstream out(pathFromUtf8(file), std::ios::binary);
      writeStepFile(brep_.shape, out, name, options, kernel_, run);
      check = checkShape(readStepFile(file, kernel_, run), run, 0.8, 1.0);
    }
    return check;
  }
  void guard(const std::function<void()>& work, RunContext& run) override {
    try {
      OCC_CATCH_SIGNALS
      work();
    } catch (const Standard_Failure& failure) {
      refuseFailure(failure, kernel_, run);
    }
  }

 private:
  // Takes the shape as that of the solid, writes it, and reads it again. `triangles`: of the faces
  // that were read.
  Assembly writeAndRead(const TopoDS_Shape& shape, const SolidOptions& options, TriMesh& triangles,
                        RunContext& run) {
    assembled_ = shape;
    shortenCurves(assembled_);
    std::stringstream text;
    writeStepFile(assembled_, text, "", options, kernel_, run);
    readBack_ = readStepText(text, kernel_, run);
    run.checkpoint(Phase::Export);
    Assembly assembly;
    assembly.check = checkShape(readBack_, run, 0.3, 0.5);
    constexpr double kOfDetail = 0.5, kOfTolerance = 0.01;
    const double deflection =
        std::max(kOfDetail * sides_->detail(), kOfTolerance * options.tolerance);
    triangles = trianglesWithin(readBack_, deflection);
    for (const TopoDS_Face& face : facesIn(readBack_)) ++assembly.facesByKind[kindOf(face)];
    return assembly;
  }
  // `triangles`: of the faces that were read back.
  void setDeviation(Assembly& assembly, const TriMesh& triangles, const HalfEdgeMesh& mesh,
                    const SolidOptions& options) const {
    const SweepDeviation found = sweepDeviation(triangles, mesh.points, sides_->interior(),
                                                sides_->detail(), options.tolerance);
    assembly.deviation = found.largest;
    assembly.meshError = found.meshError;
  }
  // Returns a point on each face that is not valid after it was read back.
  std::vector<Eigen::Vector3d> pointsOnInvalid(RunContext& run) const {
    const std::vector<TopoDS_Face> faces = facesIn(readBack_);
    std::vector<Eigen::Vector3d> points;
    for (const std::int32_t f : step::findBadFaces({faces.begin(), faces.end()}, run, 0.5, 0.6))
      points.push_back(vectorOf(pointOn(faces[f]).XYZ()));
    return points;
  }
  TopoDS_Shape readAssembled(const std::string& file, SolidFormat format, RunContext& run) {
    return format == SolidFormat::Brep ? readBrepFile(file, run) : readStepFile(file, kernel_, run);
  }
  TopoDS_Shape read(const Model& model, const std::string& file, SolidFormat format,
                    RunContext& run) {
    if (format == SolidFormat::Brep) return readBrepFile(file, run);
    const double accuracy = statedAccuracy(model);
    if (isFlat(model) && accuracy <= kExact) return readFlatStepFile(file, accuracy, kernel_, run);
    return readMostlyFlatStepFile(file, kernel_, run);
  }

  KernelSession kernel_;
  Brep brep_;
  // Of the last assemble() or fill():
  TopoDS_Shape assembled_;
  // The same as it was read back. Reading mends parameter curves and tolerances, which a BREP file
  // keeps as they are.
  TopoDS_Shape readBack_;
  // Of the last assemble():
  std::optional<Sides> sides_;
  std::vector<TopoDS_Face> parts_;  // right, but not closed; empty if the solid was made
  std::optional<ReadCheck> reader_;
};

}  // namespace

std::unique_ptr<Judge> openJudge() { return std::make_unique<KernelJudge>(); }

}  // namespace swept::step
