// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid_file.h"

#include <APIHeaderSection_MakeHeader.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <IFSelect_ReturnStatus.hxx>
#include <Interface_HArray1OfHAsciiString.hxx>
#include <STEPControl_Reader.hxx>
#include <STEPControl_Writer.hxx>
#include <StepBasic_Product.hxx>
#include <StepData_StepModel.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopTools_FormatVersion.hxx>
#include <cerrno>
#include <cstdio>
#include <fstream>
#include <ostream>
#include <streambuf>
#include <system_error>

namespace swept::step {
namespace {

[[noreturn]] void fail(const char* code, const std::string& what, const KernelSession* kernel) {
  const std::string said = kernel != nullptr ? kernel->messages() : std::string();
  throw Error(Status::ExportFailed, code, said.empty() ? what : what + " (kernel: " + said + ")");
}

std::string systemReason(int error) {
  return error != 0 ? ": " + std::system_category().message(error) : std::string();
}

Handle(TCollection_HAsciiString) text(const std::string& utf8) {
  return new TCollection_HAsciiString(utf8.c_str());
}

// Plain C file output under a stream: the library's own file buffer throws from close() when the
// disk is full, and hides the reason.
class FileBuffer : public std::streambuf {
 public:
  FileBuffer(const std::string& path, RunContext& run)
      : run_(run), file_(std::fopen(path.c_str(), "wb")), error_(errno) {}
  ~FileBuffer() override { close(); }
  FileBuffer(const FileBuffer&) = delete;
  FileBuffer& operator=(const FileBuffer&) = delete;
  bool isGood() const { return file_ != nullptr && !failed_; }
  /// False if anything since opening has failed; error() says why.
  bool close() {
    if (file_ == nullptr) return false;
    if (std::fclose(file_) != 0) note();
    file_ = nullptr;
    return !failed_;
  }
  int error() const { return error_; }

 private:
  int overflow(int c) override {
    if (c != traits_type::eof() && std::fputc(c, file_) == EOF) return note();
    return traits_type::not_eof(c);
  }
  std::streamsize xsputn(const char* data, std::streamsize count) override {
    if (run_.isCancelled()) return note();
    const auto written = std::fwrite(data, 1, static_cast<std::size_t>(count), file_);
    if (written != static_cast<std::size_t>(count)) note();
    return static_cast<std::streamsize>(written);
  }
  int note() {
    if (!failed_) error_ = errno;
    failed_ = true;
    return traits_type::eof();
  }
  RunContext& run_;
  std::FILE* file_;
  int error_;
  bool failed_ = false;
};

// Ends early when the run is cancelled. (The kernel's own way prints to the console then.)
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
                const StepOptions& options) {
  APIHeaderSection_MakeHeader header(writer.Model());
  header.SetName(text(targetName));
  header.SetAuthorValue(1, text(options.author));
  header.SetOrganizationValue(1, text(options.organization));
  header.SetOriginatingSystem(text("Swept Volume for FreeCAD"));
  header.SetAuthorisation(text(""));
  header.SetDescriptionValue(1, text("Envelope of a moving body: " + options.productName));
  // The kernel numbers its product names; ours is the whole name.
  const Handle(StepData_StepModel) model = writer.Model();
  for (Standard_Integer i = 1; i <= model->NbEntities(); ++i) {
    const Handle(StepBasic_Product) product = Handle(StepBasic_Product)::DownCast(model->Value(i));
    if (product.IsNull()) continue;
    product->SetId(text(options.productName));
    product->SetName(text(options.productName));
  }
}

}  // namespace

void writeStepFile(const TopoDS_Shape& shape, const std::string& path,
                   const std::string& targetName, const StepOptions& options, KernelSession& kernel,
                   RunContext& run) {
  kernel.set("write.step.schema", options.schema);
  kernel.set("write.step.unit", "MM");
  kernel.set("xstep.cascade.unit", "MM");
  kernel.set("write.step.assembly", "0");
  kernel.set("write.surfacecurve.mode", "1");
  kernel.set("write.precision.mode", "0");
  STEPControl_Writer writer;
  // A fresh model: the schema is read when it is made.
  writer.Model(Standard_True);
  const Handle(KernelProgress) progress = new KernelProgress(run, 0.3, 0.45);
  const IFSelect_ReturnStatus transferred =
      writer.Transfer(shape, STEPControl_AsIs, Standard_True, progress->Start());
  throwIfCancelled(run);
  if (transferred != IFSelect_RetDone) {
    fail("KernelFailure", "the kernel could not translate the solid to STEP", &kernel);
  }
  fillHeader(writer, targetName, options);
  errno = 0;
  const IFSelect_ReturnStatus written = writer.Write(path.c_str());
  if (written != IFSelect_RetDone) {
    fail("WriteFailed", "writing the STEP file failed" + systemReason(errno), &kernel);
  }
  throwIfCancelled(run);
}

TopoDS_Shape readStepFile(const std::string& path, KernelSession& kernel, RunContext& run) {
  kernel.set("xstep.cascade.unit", "MM");
  STEPControl_Reader reader;
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone) {
    fail("RereadFailed", "the file just written cannot be read back", &kernel);
  }
  throwIfCancelled(run);
  const Handle(KernelProgress) progress = new KernelProgress(run, 0.55, 0.8);
  reader.TransferRoots(progress->Start());
  throwIfCancelled(run);
  const TopoDS_Shape shape = reader.OneShape();
  if (shape.IsNull()) fail("RereadFailed", "the file just written holds no shape", &kernel);
  return shape;
}

void writeBrepFile(const TopoDS_Shape& shape, const std::string& path, RunContext& run) {
  errno = 0;
  FileBuffer buffer(path, run);
  if (buffer.isGood()) {
    std::ostream stream(&buffer);
    BRepTools::Write(shape, stream, Standard_False, Standard_False,
                     TopTools_FormatVersion_VERSION_1);
  }
  const bool good = buffer.close();
  throwIfCancelled(run);
  if (!good)
    fail("WriteFailed", "writing the BREP file failed" + systemReason(buffer.error()), nullptr);
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
  if (shape.IsNull()) fail("RereadFailed", "the file just written cannot be read back", nullptr);
  return shape;
}

}  // namespace swept::step
