// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/kernel/kernel.h"

#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <STEPControl_Controller.hxx>
#include <Standard_Version.hxx>
#include <TopoDS_Shape.hxx>
#if OCC_VERSION_HEX < 0x070900
#include <ShapeBuild_ReShape.hxx>
#include <XSAlgo.hxx>
#include <XSAlgo_AlgoContainer.hxx>
#endif
#include <functional>
#include <map>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace swept::step {
namespace {

std::mutex& kernelMutex() {
  static std::mutex mutex;
  return mutex;
}

// Collects the messages of kernel calls in the thread of its creation. Passes on the messages of
// other threads.
class Collector : public Message_Printer {
 public:
  explicit Collector(Message_SequenceOfPrinters others)
      : owner_(std::this_thread::get_id()), others_(std::move(others)) {
    SetTraceLevel(Message_Trace);
  }
  const std::string& text() const { return text_; }

 private:
  void send(const TCollection_AsciiString& text, const Message_Gravity gravity) const override {
    if (std::this_thread::get_id() != owner_) {
      for (Message_SequenceOfPrinters::Iterator it(others_); it.More(); it.Next()) {
        it.Value()->Send(text, gravity);
      }
      return;
    }
    if (gravity < Message_Warning || text_.size() > 500) return;
    std::string line(text.ToCString());
    for (char& c : line) {
      if (c == '\n' || c == '\r' || c == '\t') c = ' ';
    }
    if (!text_.empty()) text_ += "; ";
    text_ += line.substr(0, 200);
  }
  std::thread::id owner_;
  Message_SequenceOfPrinters others_;
  mutable std::string text_;
};

#if OCC_VERSION_HEX < 0x070900
// Switches healing off for shapes that the thread of its creation reads. The kernel still heals
// what other threads read. The template passes on all arguments after the shape, because their
// number depends on the version of the kernel.
class NoHealing : public XSAlgo_AlgoContainer {
  using Base = XSAlgo_AlgoContainer;
  using Real = Standard_Real;
  using Text = Standard_CString;

 public:
  bool active = true;
#if OCC_VERSION_HEX < 0x070800
  TopoDS_Shape ProcessShape(const TopoDS_Shape& shape, const Real precision, const Real largest,
                            const Text resource, const Text sequence,
                            Handle(Standard_Transient) & info,
                            const Message_ProgressRange& progress,
                            const Standard_Boolean nonManifold) const override {
    return process(shape, precision, largest, resource, sequence, info, progress, nonManifold);
  }
#else
  TopoDS_Shape ProcessShape(const TopoDS_Shape& shape, const Real precision, const Real largest,
                            const Text resource, const Text sequence,
                            Handle(Standard_Transient) & info,
                            const Message_ProgressRange& progress,
                            const Standard_Boolean nonManifold,
                            const TopAbs_ShapeEnum detail) const override {
    return process(shape, precision, largest, resource, sequence, info, progress, nonManifold,
                   detail);
  }
  TopoDS_Shape ProcessShape(const TopoDS_Shape& shape, const Real precision, const Real largest,
                            const Text resource, const Text sequence,
                            Handle(Standard_Transient) & info,
                            const Handle(ShapeBuild_ReShape) & changes,
                            const Message_ProgressRange& progress,
                            const Standard_Boolean nonManifold,
                            const TopAbs_ShapeEnum detail) const override {
    return process(shape, precision, largest, resource, sequence, info, changes, progress,
                   nonManifold, detail);
  }
#endif

 private:
  template <class... Rest>
  TopoDS_Shape process(const TopoDS_Shape& shape, Rest&&... rest) const {
    if (active && std::this_thread::get_id() == owner_) return shape;
    return Base::ProcessShape(shape, std::forward<Rest>(rest)...);
  }
  std::thread::id owner_ = std::this_thread::get_id();
};
#endif

}  // namespace

struct KernelSession::State {
  std::unique_lock<std::mutex> lock{kernelMutex()};
  Message_SequenceOfPrinters printers;
  Handle(Collector) collector;
#if OCC_VERSION_HEX < 0x070900
  Handle(NoHealing) noHealing;
#endif
  std::vector<std::function<void()>> undo;
};

KernelSession::KernelSession() : state_(std::make_unique<State>()) {
  STEPControl_Controller::Init();
  const Handle(Message_Messenger)& messenger = Message::DefaultMessenger();
  state_->printers = messenger->Printers();
  state_->collector = new Collector(state_->printers);
  messenger->ChangePrinters().Clear();
  messenger->AddPrinter(state_->collector);
}

KernelSession::~KernelSession() {
  for (auto it = state_->undo.rbegin(); it != state_->undo.rend(); ++it) (*it)();
  Message::DefaultMessenger()->ChangePrinters() = state_->printers;
}

void KernelSession::set(const char* name, const std::string& value) {
  const char* before = Interface_Static::CVal(name);
  if (before != nullptr) {
    state_->undo.push_back(
        [name, old = std::string(before)] { Interface_Static::SetCVal(name, old.c_str()); });
  }
  Interface_Static::SetCVal(name, value.c_str());
}

void KernelSession::setHealing([[maybe_unused]] bool on) {
#if OCC_VERSION_HEX < 0x070900
  if (!state_->noHealing) {
    state_->undo.push_back([old = XSAlgo::AlgoContainer()] { XSAlgo::SetAlgoContainer(old); });
    state_->noHealing = new NoHealing;
    XSAlgo::SetAlgoContainer(state_->noHealing);
  }
  state_->noHealing->active = !on;
#endif
}

std::string KernelSession::messages() const { return state_->collector->text(); }

void KernelProgress::Show(const Message_ProgressScope&, Standard_Boolean) {
  try {
    constexpr double kScale = 1e6;
    run_.checkpoint(Phase::Export,
                    static_cast<std::uint64_t>(kScale * (from_ + (to_ - from_) * GetPosition())),
                    static_cast<std::uint64_t>(kScale));
  } catch (...) {
    // If the run is cancelled, the kernel next calls UserBreak() and stops by itself. No exception
    // may pass through functions of the kernel.
  }
}

}  // namespace swept::step
