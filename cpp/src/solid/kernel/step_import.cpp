// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <filesystem>
#include <fstream>
#include <map>

#include "base/safe_file.h"
#include "solid/assemble/body_shape.h"
#include "solid/assemble/shape_triangles.h"
#include "solid/kernel/shape_check.h"
#include "solid/kernel/solid_file.h"
#include "solid/text/step_scan.h"
#include "swept/solid.h"

namespace swept {
namespace {

void checkStructure(const std::filesystem::path& file, const std::string& path) {
  std::ifstream text(file, std::ios::binary);
  if (!text) return;  // the kernel reports the reason
  const std::string complaint = step::stepComplaint(text);
  if (complaint.empty()) return;
  throw Error(Status::InvalidInput, "BadFile",
              "'" + path + "' is not a valid STEP file: " + complaint +
                  "; export the file again from the program that made it");
}

/// Returns whether a file is a BREP file: by its suffix or, if this is unknown, by its first
/// characters.
bool isBrep(const std::filesystem::path& file) {
  const std::string suffix = suffixOf(utf8FromPath(file));
  if (suffix == "brep" || suffix == "brp") return true;
  if (suffix == "step" || suffix == "stp") return false;
  std::string head(256, ' ');
  std::ifstream(file, std::ios::binary)
      .read(head.data(), static_cast<std::streamsize>(head.size()));
  return head.find("ISO-10303-21") == std::string::npos;
}

TopoDS_Shape readShape(const std::string& path, step::KernelSession& kernel, RunContext& run,
                       step::ProductNames& names) {
  if (isBrep(pathFromUtf8(path))) return step::readBrepFile(path, run);
  checkStructure(pathFromUtf8(path), path);
  return step::readStepFile(path, kernel, run, &names);
}

// Names each solid after its product. If all have the same product name (also if there is only one
// solid), or if one has none, names all after the file. Solids with the same name get numbers.
void nameSolids(std::vector<ImportedSolid>& solids, const std::string& stem) {
  std::map<std::string, int> counts;
  for (const ImportedSolid& solid : solids) ++counts[solid.name];
  if (counts.size() == 1 || counts.count("") != 0)
    counts = {{stem, static_cast<int>(solids.size())}};
  const bool fileName = counts.size() == 1;
  std::map<std::string, int> given;
  for (ImportedSolid& solid : solids) {
    if (fileName) solid.name = stem;
    if (counts[solid.name] == 1) continue;
    const int number = ++given[solid.name];
    solid.name.append(" ").append(std::to_string(number));
  }
}

// Calls `read` with the shape in a file and the names of its products. Turns a failure of the
// kernel into an error of the input.
template <class Read>
auto withShape(const std::string& path, RunContext& run, Read read) {
  std::error_code code;
  if (!std::filesystem::exists(pathFromUtf8(path), code))
    throw Error(Status::InvalidInput, "BadFile",
                "'" + path + "' does not exist; check the file name");
  step::KernelSession kernel;
  try {
    step::ProductNames names;
    const TopoDS_Shape shape = readShape(path, kernel, run, names);
    return read(shape, names);
  } catch (const Error& error) {
    if (error.status() != Status::ExportFailed) throw;
    throw Error(Status::InvalidInput, "BadFile",
                "'" + path + "' cannot be read: " + error.what() +
                    "; check that it is a STEP or BREP file");
  } catch (const Standard_Failure& failure) {
    throw Error(Status::InvalidInput, "BadFile",
                "'" + path + "' cannot be read: OpenCASCADE fails with '" +
                    failure.GetMessageString() +
                    "'; export the file again from the program that made it");
  }
}

}  // namespace

std::vector<ImportedSolid> readSolids(const std::string& path, double linearDeflection,
                                      double angularDeflection, RunContext& run,
                                      std::shared_ptr<const BodyShape>* bodyShape) {
  return withShape(path, run, [&](const TopoDS_Shape& shape, step::ProductNames& names) {
    run.checkpoint(Phase::Input);
    const step::ShapeTriangles triangles(shape, linearDeflection, angularDeflection);
    run.checkpoint(Phase::Input);
    std::vector<ImportedSolid> solids;
    for (TopExp_Explorer s(shape, TopAbs_SOLID); s.More(); s.Next()) {
      TriMesh mesh = triangles.of(s.Current());
      if (!mesh.triangles.empty())
        solids.push_back({names[s.Current().TShape().get()], std::move(mesh)});
    }
    if (solids.empty()) solids.push_back({"", triangles.of(shape)});
    if (solids[0].mesh.triangles.empty())
      throw Error(
          Status::InvalidInput, "NoSurface",
          "'" + path + "' contains no face that can be turned into triangles; export a solid");
    if (bodyShape != nullptr) *bodyShape = std::make_shared<const BodyShape>(BodyShape{shape});
    nameSolids(solids, utf8FromPath(pathFromUtf8(path).stem()));
    return solids;
  });
}

std::shared_ptr<const BodyShape> readBodyShape(const std::string& path, RunContext& run) {
  return withShape(path, run, [](const TopoDS_Shape& shape, const step::ProductNames&) {
    return std::make_shared<const BodyShape>(BodyShape{shape});
  });
}

SolidCheck checkSolidFile(const std::string& path, RunContext& run) {
  return withShape(path, run, [&](const TopoDS_Shape& shape, const step::ProductNames&) {
    SolidCheck check = step::checkShape(shape, run, 0.5, 1.0);
    if (check.solids == 0) {
      check.valid = false;
      check.complaint = "it contains no solid, only " + std::to_string(check.faces) + " faces";
    }
    return check;
  });
}

}  // namespace swept
