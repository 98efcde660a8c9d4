// Names of enumerations and units, as they stand on the command line, in Python and in reports.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <array>
#include <utility>

#include "swept/run_context.h"
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

const char* statusName(Status status) {
  switch (status) {
    case Status::Ok:
      return "Ok";
    case Status::InvalidInput:
      return "InvalidInput";
    case Status::ResourceLimit:
      return "ResourceLimit";
    case Status::OutOfMemory:
      return "OutOfMemory";
    case Status::Cancelled:
      return "Cancelled";
    case Status::DeviceUnavailable:
      return "DeviceUnavailable";
    case Status::DeviceLost:
      return "DeviceLost";
    case Status::ExportFailed:
      return "ExportFailed";
    case Status::InternalError:
      return "InternalError";
  }
  return "?";
}

const char* phaseName(Phase phase) {
  switch (phase) {
    case Phase::Input:
      return "input";
    case Phase::Motion:
      return "motion";
    case Phase::Sampling:
      return "sampling";
    case Phase::Signs:
      return "signs";
    case Phase::Contour:
      return "contour";
    case Phase::Simplify:
      return "simplify";
    case Phase::Check:
      return "check";
    case Phase::Export:
      return "export";
    case Phase::Straight:
      return "straight moves";
    case Phase::Shifts:
      return "moves without turns";
    case Phase::Turns:
      return "moves with turns";
    case Phase::Polish:
      return "polish";
    case Phase::Done:
      return "done";
  }
  return "?";
}

const char* interpolationName(Interpolation value) { return nameOf(kInterpolations, value); }
const char* componentMethodName(ComponentMethod value) { return nameOf(kComponentMethods, value); }
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
