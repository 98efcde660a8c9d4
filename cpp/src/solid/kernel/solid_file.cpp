// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/kernel/solid_file.h"

#include <APIHeaderSection_MakeHeader.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <IFSelect_ReturnStatus.hxx>
#include <Interface_HArray1OfHAsciiString.hxx>
#include <STEPControl_Reader.hxx>
#include <STEPControl_Writer.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <ShapeFix_Shape.hxx>
#include <ShapeFix_ShapeTolerance.hxx>
#include <StepBasic_Product.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepBasic_ProductDefinitionFormation.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_FormatVersion.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Face.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <cerrno>
#include <fstream>
#include <system_error>
#include <typeinfo>

#include "solid/kernel/shape_check.h"
#include "swept/types.h"

namespace swept::step {
namespace {

[[noreturn]] void fail(const char* code, const std::string& what, const KernelSession* kernel) {
  const std::string messages = kernel != nullptr ? kernel->messages() : std::string();
  throw Error(Status::ExportFailed, code,
              messages.empty() ? what : what + " (OpenCASCADE: " + messages + ")");
}

std::string systemReason(int error) {
  return error != 0 ? ": " + std::system_category().message(error) : std::string();
}

Handle(TCollection_HAsciiString) text(const std::string& utf8) {
  return new TCollection_HAsciiString(utf8.c_str());
}

// Ends the input when the run is cancelled. Cancelling in the kernel would print to the console.
class CancellableInput : public std::filebuf {
 public:
  explicit CancellableInput(RunContext& run) : run_(run) {}

 private:
  int underflow() override {
    return run_.isCancelled() ? traits_type::eof() : std::filebuf::underflow();
  }
  RunContext& run_;
};

void throwIfCancelled(RunContext& run) { run.checkpoint(Phase::Export); }

void fillHeader(STEPControl_Writer& writer, const std::string& targetName,
                const SolidOptions& options) {
  APIHeaderSection_MakeHeader header(writer.Model());
  header.SetName(text(targetName));
  header.SetAuthorValue(1, text(options.author));
  header.SetOrganizationValue(1, text(options.organization));
  header.SetOriginatingSystem(text("Swept Volume for FreeCAD"));
  header.SetAuthorisation(text(""));
  header.SetDescriptionValue(1, text("Envelope of a moving body: " + options.productName));
  // The kernel appends a number to product names. This restores the given name.
  const Handle(StepData_StepModel) model = writer.Model();
  for (Standard_Integer i = 1; i <= model->NbEntities(); ++i) {
    const Handle(StepBasic_Product) product = Handle(StepBasic_Product)::DownCast(model->Value(i));
    if (product.IsNull()) continue;
    product->SetId(text(options.productName));
    product->SetName(text(options.productName));
  }
}

TopoDS_Shape shapeOf(STEPControl_Reader& reader, const KernelSession& kernel, RunContext& run) {
  throwIfCancelled(run);
  const Handle(KernelProgress) progress = new KernelProgress(run, 0.55, 0.8);
  reader.TransferRoots(progress->Start());
  throwIfCancelled(run);
  const TopoDS_Shape shape = reader.OneShape();
  if (shape.IsNull()) fail("RereadFailed", "the file contains no shape", &kernel);
  return shape;
}

ProductNames productNames(const STEPControl_Reader& reader) {
  ProductNames names;
  // For each solid: number of solids in the smallest product found so far that contains it.
  std::unordered_map<const TopoDS_TShape*, int> sizes;
  const Handle(StepData_StepModel) model = reader.StepModel();
  const Handle(Transfer_TransientProcess) transfers =
      reader.WS()->TransferReader()->TransientProcess();
  for (Standard_Integer i = 1; i <= model->NbEntities(); ++i) {
    const auto product = Handle(StepBasic_ProductDefinition)::DownCast(model->Value(i));
    if (product.IsNull() || product->Formation().IsNull()) continue;
    const Handle(StepBasic_Product) of = product->Formation()->OfProduct();
    if (of.IsNull() || of->Name().IsNull()) continue;
    const TopoDS_Shape shape = TransferBRep::ShapeResult(transfers, product);
    if (shape.IsNull()) continue;
    TopTools_IndexedMapOfShape solids;
    TopExp::MapShapes(shape, TopAbs_SOLID, solids);
    for (Standard_Integer k = 1; k <= solids.Extent(); ++k) {
      const TopoDS_TShape* solid = solids(k).TShape().get();
      const auto [size, isNew] = sizes.try_emplace(solid, solids.Extent());
      if (!isNew && size->second <= solids.Extent()) continue;
      size->second = solids.Extent();
      names[solid] = of->Name()->ToCString();
    }
  }
  return names;
}

}  // namespace

void writeStepFile(const TopoDS_Shape& shape, std::ostream& out, const std::string& targetName,
                   const SolidOptions& options, KernelSession& kernel, RunContext& run) {
  kernel.set("write.step.schema", options.schema == StepSchema::Ap214 ? "AP214IS" : "AP242DIS");
  kernel.set("write.step.unit", "MM");
  kernel.set("xstep.cascade.unit", "MM");
  kernel.set("write.step.assembly", "0");
  kernel.set("write.surfacecurve.mode", "1");
  kernel.set("write.precision.mode", "0");
  STEPControl_Writer writer;
  // Starts a new model, because the kernel reads the schema setting only when it makes a model.
  writer.Model(Standard_True);
  const Handle(KernelProgress) progress = new KernelProgress(run, 0.3, 0.45);
  const IFSelect_ReturnStatus transferred =
      writer.Transfer(shape, STEPControl_AsIs, Standard_True, progress->Start());
  throwIfCancelled(run);
  if (transferred != IFSelect_RetDone) {
    fail("KernelFailure",
         "OpenCASCADE could not translate the solid to STEP; change the tolerance, or export a "
         "mesh file",
         &kernel);
  }
  fillHeader(writer, targetName, options);
  StepData_StepWriter text(writer.Model());
  text.SendModel(Handle(StepData_Protocol)::DownCast(writer.WS()->Protocol()));
  errno = 0;
  if (!text.Print(out) || !out.flush())
    fail("WriteFailed",
         (targetName.empty() ? "the solid could not be written as STEP text"
                             : "the STEP file '" + targetName + "' could not be written") +
             systemReason(errno) + "; check the free space, or choose another folder",
         &kernel);
  throwIfCancelled(run);
}

TopoDS_Shape readStepFile(const std::string& path, KernelSession& kernel, RunContext& run,
                          ProductNames* names) {
  kernel.set("xstep.cascade.unit", "MM");
  STEPControl_Reader reader;
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone) {
    fail("RereadFailed", "OpenCASCADE does not accept the file", &kernel);
  }
  TopoDS_Shape shape = shapeOf(reader, kernel, run);
  if (names != nullptr) *names = productNames(reader);
  return shape;
}

TopoDS_Shape readStepText(std::istream& text, KernelSession& kernel, RunContext& run) {
  kernel.set("xstep.cascade.unit", "MM");
  STEPControl_Reader reader;
  if (reader.ReadStream("text", text) != IFSelect_RetDone) {
    fail("RereadFailed",
         "OpenCASCADE cannot read the faces of the solid back; change the tolerance, or export a "
         "mesh file",
         &kernel);
  }
  return shapeOf(reader, kernel, run);
}

TopoDS_Shape readFlatStepFile(const std::string& path, double tolerance, KernelSession& kernel,
                              RunContext& run) {
  kernel.setHealing(false);
  const TopoDS_Shape shape = readStepFile(path, kernel, run);
  ShapeFix_ShapeTolerance().LimitTolerance(shape, tolerance);
  kernel.setHealing(true);
  return shape;
}

TopoDS_Shape readMostlyFlatStepFile(const std::string& path, KernelSession& kernel,
                                    RunContext& run) {
  kernel.setHealing(false);
  const TopoDS_Shape shape = readStepFile(path, kernel, run);
  kernel.setHealing(true);
  TopoDS_Compound others;
  const BRep_Builder builder;
  builder.MakeCompound(others);
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) {
    if (!isPlaneTriangle(TopoDS::Face(it.Current()))) builder.Add(others, it.Current());
  }
  const Handle(ShapeFix_Shape) mender = new ShapeFix_Shape(others);
  const Handle(KernelProgress) progress = new KernelProgress(run, 0.8, 0.85);
  mender->Perform(progress->Start());
  throwIfCancelled(run);
  return mender->Context()->Apply(shape);
}

void writeBrep(const TopoDS_Shape& shape, std::ostream& out, RunContext& run) {
  const Handle(KernelProgress) progress = new KernelProgress(run, 0.3, 0.45);
  try {
    BRepTools::Write(shape, out, Standard_False, Standard_False, TopTools_FormatVersion_VERSION_1,
                     progress->Start());
  } catch (const std::bad_cast&) {
    // The kernel throws this if the stream fails because the disk is full.
    out.setstate(std::ios::badbit);
  }
  throwIfCancelled(run);
}

TopoDS_Shape readBrepFile(const std::string& path, RunContext& run) {
  CancellableInput buffer(run);
  TopoDS_Shape shape;
  const BRep_Builder builder;
  if (buffer.open(path, std::ios::in | std::ios::binary) != nullptr) {
    std::istream stream(&buffer);
    BRepTools::Read(shape, stream, builder);
  }
  throwIfCancelled(run);
  if (shape.IsNull()) fail("RereadFailed", "OpenCASCADE does not accept the file", nullptr);
  return shape;
}

}  // namespace swept::step
