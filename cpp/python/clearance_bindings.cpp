// Clearance checks for Python. Reports are dicts; distances are arrays.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "clearance_bindings.h"

#ifdef HAVE_SWEPT_CLEARANCE
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <array>
#include <optional>

#include "arrays.h"
#include "errors.h"
#include "job.h"
#include "swept/clearance.h"
#include "swept/mechanism.h"
#include "swept/overlap.h"
#include "values.h"

namespace swept::python {
namespace {

NeighbourRule ruleFrom(const py::handle& value) {
  NeighbourRule rule;
  if (value.is_none()) return rule;
  if (py::isinstance<py::str>(value)) return parseRule(value.cast<std::string>());
  rule.required = value.cast<double>();
  return rule;
}

ClearanceNeighbour neighbourFrom(const py::handle& item) {
  const py::tuple parts = py::reinterpret_borrow<py::object>(item).cast<py::tuple>();
  if (parts.size() < 3 || parts.size() > 5)
    throw py::value_error(
        "a neighbour must be (name, vertices, triangles), (name, vertices, triangles, chord_error) "
        "or (name, vertices, triangles, chord_error, rule)");
  ClearanceNeighbour neighbour{parts[0].cast<std::string>(), meshFromArrays(parts[1], parts[2])};
  if (parts.size() > 3) neighbour.chordError = parts[3].cast<double>();
  if (parts.size() > 4) neighbour.rule = ruleFrom(parts[4]);
  return neighbour;
}

constexpr const char* kClearanceDoc =
    R"(clearance(vertices, triangles, motion, neighbours, interpolation='linear', required=0.0,
          tolerance=0.01, body_chord=0.0, interval_tolerance=None, curve=200, penetration=True,
          run=None, rules=()) -> dict

Measures the smallest distance of a moving body to each neighbour over the whole motion. No approach between
two poses is missed. Lengths are in mm; motion is as in compute().
neighbours: list of (name, vertices, triangles), (name, vertices, triangles, chord_error) or
(name, vertices, triangles, chord_error, rule). A rule is a required distance, 'contact', 'contact:MM',
'ignore' or None. rules: texts 'NAME=RULE' for the neighbours without a rule of their own; NAME may contain
* and ?. Returns the report (docs/clearance.md): summary, and neighbours, each with verdict (clear, below,
contact or clash), rule, meets_rule, distance, guaranteed, time_seconds, pose, points, penetration, the time
intervals below and contact, and curve. Raises InvalidInput, Cancelled.)";

constexpr const char* kFirstContactsDoc =
    R"(first_contacts(vertices, triangles, motion, neighbours, interpolation='linear', tolerance=0.01,
               body_chord=0.0, run=None) -> list of str

Returns, for each neighbour, the rule that would allow its contact with the body at the first pose of the
motion: 'contact' if they touch, 'contact:MM' if they overlap by MM mm, or '' if they do not touch.
Arguments and errors are those of clearance().)";

constexpr const char* kMechanismDoc =
    R"(mechanism(parts, required=0.0, tolerance=0.01, range=None, interval_tolerance=None, curve=200,
          penetration=True, rules=(), run=None) -> dict

Measures the smallest distances between parts that move at the same time. No approach between two poses is
missed. Lengths are in mm, times in s.
parts: list of (name, vertices, triangles, motion, interpolation, chord_error). motion is as in compute(), or
None for a part that stands still where its mesh is. rules: list of (name, name, rule) for pairs of
parts, with rules as in clearance(). Returns the report (docs/clearance.md): summary, far_pairs, joined, and
pairs, each with first, second and what clearance() returns for a neighbour; first takes the place of the
body. Raises InvalidInput, Cancelled.)";

constexpr const char* kOverlapDoc =
    R"(overlap(parts, required=0.0, tolerance=0.01, shared=True, run=None) -> (dict, list)

Compares all pairs of parts that stand still: measures their smallest distance, or the depth of their overlap
and the solid that they share. Lengths are in mm.
parts: list of (name, vertices, triangles) or (name, vertices, triangles, chord_error).
Returns the report (docs/overlap.md): summary, and pairs, each with first, second, volume in mm^3 (if known)
and what clearance() returns for a neighbour; first takes the place of the body. Also returns, for each pair,
the shared solid as (vertices float64 (N, 3), triangles int32 (M, 3)); N = M = 0 if there is none. Raises
InvalidInput (code NoParts or PartTwice), Cancelled.)";

constexpr const char* kDistanceDoc =
    R"(distance_to_mesh(points, vertices, triangles, run=None) -> float64 (N,)

Returns the distance (mm) of each point (N, 3) from a mesh, negative for points inside a closed mesh.)";

py::object pyClearance(const py::object& vertices, const py::object& triangles,
                       const py::object& motion, const py::iterable& neighbours,
                       const std::string& interpolation, double required, double tolerance,
                       double bodyChord, const std::optional<double>& intervalTolerance, int curve,
                       bool penetration, const py::object& run,
                       const std::vector<std::string>& rules) {
  const RunPointer context = runFromObject(run);
  const TriMesh body = meshFromArrays(vertices, triangles);
  const Trajectory trajectory = trajectoryFromObject(motion, interpolation);
  const std::vector<ClearanceNeighbour> parts = neighboursFrom(neighbours, rules);
  ClearanceOptions options;
  options.required = required;
  options.tolerance = tolerance;
  options.bodyChordError = bodyChord;
  options.intervalTolerance = unlessZero(intervalTolerance);
  options.curveSamples = curve;
  options.penetration = penetration;
  const ClearanceReport report = runWithoutLock(
      *context, [&] { return checkClearance(body, trajectory, parts, options, *context); });
  return foundOf(report);
}

std::vector<std::string> pyFirstContacts(const py::object& vertices, const py::object& triangles,
                                         const py::object& motion, const py::iterable& neighbours,
                                         const std::string& interpolation, double tolerance,
                                         double bodyChord, const py::object& run) {
  const RunPointer context = runFromObject(run);
  const TriMesh body = meshFromArrays(vertices, triangles);
  const Trajectory trajectory = trajectoryFromObject(motion, interpolation);
  const std::vector<ClearanceNeighbour> parts = neighboursFrom(neighbours, {});
  ClearanceOptions options;
  options.tolerance = tolerance;
  options.bodyChordError = bodyChord;
  const ClearanceReport report = runWithoutLock(
      *context, [&] { return firstContacts(body, trajectory, parts, options, *context); });
  foundOf(report);
  std::vector<std::string> rules;
  for (const NeighbourClearance& row : report.neighbours) rules.push_back(ruleText(row.rule));
  return rules;
}

std::vector<std::string> pyRulesFor(const std::vector<std::string>& rules,
                                    const std::optional<std::vector<std::string>>& names) {
  std::vector<NamedRule> read;
  for (const std::string& rule : rules) read.push_back(parseNamedRule(rule));
  std::vector<std::string> found;
  if (names)
    for (const NeighbourRule& rule : rulesFor(*names, read)) found.push_back(ruleText(rule));
  return found;
}

MechanismPart mechanismPartFrom(const py::handle& item) {
  const py::tuple part = tupleOf(
      item, 6, "a part must be (name, vertices, triangles, motion, interpolation, chord_error)");
  const py::object motion = part[3];
  return {part[0].cast<std::string>(), meshFromArrays(part[1], part[2]),
          motion.is_none() ? Trajectory{{Pose{}}}
                           : trajectoryFromObject(motion, part[4].cast<std::string>()),
          part[5].cast<double>()};
}

py::object pyMechanism(const py::iterable& list, double required, double tolerance,
                       const std::optional<double>& range,
                       const std::optional<double>& intervalTolerance, int curve, bool penetration,
                       const std::vector<std::array<std::string, 3>>& rules,
                       const py::object& run) {
  const RunPointer context = runFromObject(run);
  std::vector<MechanismPart> parts;
  for (const py::handle& item : list) parts.push_back(mechanismPartFrom(item));
  MechanismOptions options;
  options.required = required;
  options.tolerance = tolerance;
  options.range = unlessZero(range);
  options.intervalTolerance = unlessZero(intervalTolerance);
  options.curveSamples = curve;
  options.penetration = penetration;
  for (const auto& [first, second, text] : rules)
    options.rules.push_back({first, second, parseRule(text)});
  const MechanismReport report =
      runWithoutLock(*context, [&] { return checkMechanism(parts, options, *context); });
  return foundOf(report);
}

OverlapPart overlapPartFrom(const py::handle& item) {
  const py::tuple part = py::reinterpret_borrow<py::object>(item).cast<py::tuple>();
  if (part.size() != 3 && part.size() != 4)
    throw py::value_error(
        "a part must be (name, vertices, triangles) or (name, vertices, triangles, chord_error)");
  return {part[0].cast<std::string>(), meshFromArrays(part[1], part[2]),
          part.size() > 3 ? part[3].cast<double>() : 0.0};
}

py::tuple arraysOf(TriMesh mesh) {
  const Mesh kept{std::make_shared<const TriMesh>(std::move(mesh))};
  return py::make_tuple(kept.vertices(), kept.triangles());
}

py::tuple pyOverlap(const py::iterable& list, double required, double tolerance, bool shared,
                    const py::object& run) {
  const RunPointer context = runFromObject(run);
  std::vector<OverlapPart> parts;
  for (const py::handle& item : list) parts.push_back(overlapPartFrom(item));
  const OverlapOptions options{required, tolerance, shared};
  OverlapReport report =
      runWithoutLock(*context, [&] { return checkOverlaps(parts, options, *context); });
  const py::object found = foundOf(report);
  py::list meshes;
  for (PairOverlap& pair : report.pairs) meshes.append(arraysOf(std::move(pair.shared)));
  return py::make_tuple(found, meshes);
}

py::array pyDistanceToMesh(const py::object& points, const py::object& vertices,
                           const py::object& triangles, const py::object& run) {
  const RunPointer context = runFromObject(run);
  const auto array = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(points);
  if (!array || array.ndim() != 2 || array.shape(1) != 3)
    throw py::value_error("points must be an array of shape (N, 3)");
  std::vector<Eigen::Vector3d> list(static_cast<std::size_t>(array.shape(0)));
  for (py::ssize_t i = 0; i < array.shape(0); ++i)
    list[i] = {array.at(i, 0), array.at(i, 1), array.at(i, 2)};
  const TriMesh mesh = meshFromArrays(vertices, triangles);
  const std::vector<double> distances =
      runWithoutLock(*context, [&] { return distanceToMesh(list, mesh, *context); });
  return py::array_t<double>(static_cast<py::ssize_t>(distances.size()), distances.data());
}

}  // namespace

std::vector<ClearanceNeighbour> neighboursFrom(const py::iterable& items,
                                               const std::vector<std::string>& rules) {
  std::vector<ClearanceNeighbour> list;
  std::vector<std::string> names;
  for (const py::handle& item : items) {
    list.push_back(neighbourFrom(item));
    names.push_back(list.back().name);
  }
  std::vector<NamedRule> named;
  for (const std::string& text : rules) named.push_back(parseNamedRule(text));
  const std::vector<NeighbourRule> found = rulesFor(names, named);
  for (std::size_t i = 0; i < list.size(); ++i)
    if (ruleText(list[i].rule).empty()) list[i].rule = found[i];
  return list;
}

void bindClearance(py::module_& module) {
  module.def("clearance", &pyClearance, kClearanceDoc, py::arg("vertices"), py::arg("triangles"),
             py::arg("motion"), py::arg("neighbours"), py::arg("interpolation") = "linear",
             py::arg("required") = 0.0, py::arg("tolerance") = 0.01, py::arg("body_chord") = 0.0,
             py::arg("interval_tolerance") = py::none(), py::arg("curve") = 200,
             py::arg("penetration") = true, py::arg("run") = py::none(),
             py::arg("rules") = py::tuple());
  module.def("rules_for", &pyRulesFor,
             "rules_for(rules, names=None) -> list of str\n\nReturns the rule that the texts "
             "'NAME=RULE' give to each neighbour in names, or '' if no text applies to it. With "
             "names=None, the texts are only checked. Raises InvalidInput (code BadRule).",
             py::arg("rules"), py::arg("names") = py::none());
  module.def("first_contacts", &pyFirstContacts, kFirstContactsDoc, py::arg("vertices"),
             py::arg("triangles"), py::arg("motion"), py::arg("neighbours"),
             py::arg("interpolation") = "linear", py::arg("tolerance") = 0.01,
             py::arg("body_chord") = 0.0, py::arg("run") = py::none());
  module.def("mechanism", &pyMechanism, kMechanismDoc, py::arg("parts"), py::arg("required") = 0.0,
             py::arg("tolerance") = 0.01, py::arg("range") = py::none(),
             py::arg("interval_tolerance") = py::none(), py::arg("curve") = 200,
             py::arg("penetration") = true,
             py::arg("rules") = std::vector<std::array<std::string, 3>>{},
             py::arg("run") = py::none());
  module.def("overlap", &pyOverlap, kOverlapDoc, py::arg("parts"), py::arg("required") = 0.0,
             py::arg("tolerance") = 0.01, py::arg("shared") = true, py::arg("run") = py::none());
  module.def("distance_to_mesh", &pyDistanceToMesh, kDistanceDoc, py::arg("points"),
             py::arg("vertices"), py::arg("triangles"), py::arg("run") = py::none());
}

}  // namespace swept::python
#endif  // HAVE_SWEPT_CLEARANCE
