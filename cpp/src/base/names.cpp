// Names of enumerations and units, as the command line, Python and reports write them.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <array>
#include <utility>

#include "swept/run_context.h"
#include "swept/sources.h"
#include "swept/types.h"

namespace swept {
namespace {

template <class E, std::size_t N>
using NameTable = std::array<std::pair<const char*, E>, N>;

constexpr NameTable<Interpolation, 3> kInterpolations{{{"none", Interpolation::None},
                                                       {"linear", Interpolation::Linear},
                                                       {"screw", Interpolation::Screw}}};
constexpr NameTable<ComponentMethod, 5> kComponentMethods{
    {{"dc", ComponentMethod::DualContouring},
     {"dmc", ComponentMethod::DualMarchingCubes},
     {"equivalence", ComponentMethod::Equivalence},
     {"greedy", ComponentMethod::Greedy},
     {"consistent", ComponentMethod::Consistent}}};
constexpr NameTable<Backend, 3> kBackends{
    {{"auto", Backend::Auto}, {"cpu", Backend::Cpu}, {"gpu", Backend::Gpu}}};
constexpr NameTable<Status, 9> kStatuses{{{"Ok", Status::Ok},
                                          {"InvalidInput", Status::InvalidInput},
                                          {"ResourceLimit", Status::ResourceLimit},
                                          {"OutOfMemory", Status::OutOfMemory},
                                          {"Cancelled", Status::Cancelled},
                                          {"DeviceUnavailable", Status::DeviceUnavailable},
                                          {"DeviceLost", Status::DeviceLost},
                                          {"ExportFailed", Status::ExportFailed},
                                          {"InternalError", Status::InternalError}}};
constexpr NameTable<Phase, kPhaseCount> kPhases{{{"input", Phase::Input},
                                                 {"motion", Phase::Motion},
                                                 {"sampling", Phase::Sampling},
                                                 {"signs", Phase::Signs},
                                                 {"contour", Phase::Contour},
                                                 {"simplify", Phase::Simplify},
                                                 {"check", Phase::Check},
                                                 {"export", Phase::Export},
                                                 {"straight moves", Phase::Straight},
                                                 {"moves without turns", Phase::Shifts},
                                                 {"moves with turns", Phase::Turns},
                                                 {"polish", Phase::Polish},
                                                 {"done", Phase::Done}}};
constexpr NameTable<SourceKind, 3> kSourceKinds{
    {{"cap", SourceKind::Cap}, {"edge", SourceKind::Edge}, {"graze", SourceKind::Graze}}};
constexpr NameTable<double, 4> kUnits{{{"mm", 1.0}, {"cm", 10.0}, {"m", 1000.0}, {"in", 25.4}}};

template <class E, std::size_t N>
E parse(const NameTable<E, N>& table, const char* option, const std::string& text) {
  std::string allowed;
  for (const auto& [name, value] : table) {
    if (text == name) return value;
    allowed += allowed.empty() ? name : std::string(", ") + name;
  }
  throw Error(Status::InvalidInput, "BadOption",
              std::string(option) + " is '" + text + "'; allowed: " + allowed);
}

template <class E, std::size_t N>
const char* nameOf(const NameTable<E, N>& table, E value) {
  for (const auto& [name, entry] : table) {
    if (entry == value) return name;
  }
  return "?";
}

}  // namespace

const char* statusName(Status status) { return nameOf(kStatuses, status); }
const char* phaseName(Phase phase) { return nameOf(kPhases, phase); }
const char* interpolationName(Interpolation value) { return nameOf(kInterpolations, value); }
const char* componentMethodName(ComponentMethod value) { return nameOf(kComponentMethods, value); }
const char* sourceKindName(SourceKind kind) { return nameOf(kSourceKinds, kind); }
const char* backendName(Backend value) { return nameOf(kBackends, value); }
Interpolation parseInterpolation(const std::string& text) {
  return parse(kInterpolations, "interpolation", text);
}
ComponentMethod parseComponentMethod(const std::string& text) {
  return parse(kComponentMethods, "components", text);
}
Backend parseBackend(const std::string& text) { return parse(kBackends, "backend", text); }
double parseLengthUnit(const std::string& text) { return parse(kUnits, "unit of length", text); }

}  // namespace swept
