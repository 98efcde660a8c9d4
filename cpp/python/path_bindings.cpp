// Installation paths for Python. Reports are dicts; motions are arrays.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "path_bindings.h"

#ifdef HAVE_SWEPT_CLEARANCE
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "arrays.h"
#include "clearance_bindings.h"
#include "errors.h"
#include "job.h"
#include "swept/io.h"
#include "swept/live_clearance.h"
#include "swept/path.h"
#include "swept/sequence.h"
#include "values.h"

namespace swept::python {
namespace {

constexpr const char* kFindPathDoc =
    R"(find_path(vertices, triangles, goal, neighbours, start=None, extract=None, via=(), clearance=0.0,
          release=0.0, translation_only=False, max_angle=None, interpolation='linear', tolerance=0.01,
          body_chord=0.0, budget=60.0, seed=1, run=None, watch=None, rules=()) -> (dict, motion or None)

Searches for a motion that brings a part to its goal and keeps the clearance from every neighbour, also between
keys. Lengths are in mm, max_angle in rad, budget in s.
goal, start, via: arrays (4, 4). extract, in place of start: a radius, or a direction (x, y, z).
neighbours and rules: as for clearance(), but rules that allow contact are refused. watch: a PathWatch.
Returns the report (docs/paths.md), and the motion as (times, quaternions, translations), or None if no path
was found. Raises InvalidInput (code GoalBlocked, StartBlocked, ...), Cancelled.)";

constexpr const char* kImproveDoc =
    R"(improve_path(vertices, triangles, motion, neighbours, interpolation='linear', locked=(),
             more_clearance=False, clearance=0.0, release=0.0, translation_only=False, max_angle=None,
             tolerance=0.01, body_chord=0.0, budget=60.0, seed=1, run=None, rules=()) -> (dict, motion or None)

Improves a motion. Sections that come closer to a neighbour than the clearance get another path, if the
search finds one. All other sections become shorter and get fewer keys; with more_clearance=True they stay as
far from the neighbours as possible instead. The ends, and the keys whose indices are in `locked`, do not
change. Sections that cannot be improved, or that lie within `release` of the ends, are left unchanged
("kept_moves" counts them). Other arguments, result and errors are those of find_path(). The key "before" of
the report describes the given motion.)";

constexpr const char* kSequenceDoc =
    R"(find_sequence(parts, still=(), order='given', clearance=0.0, release=0.0, translation_only=False,
              max_angle=None, interpolation='linear', tolerance=0.01, budget=60.0, most_moves=None, seed=1,
              rules=(), run=None, watch=None) -> (dict, list or None)

Searches for motions of parts that are installed one after the other. Each part keeps the clearance from the
parts already installed. parts: list of (name, vertices, triangles, chord_error, goal, start, extract, via,
motion, interpolation). goal, start, extract and via are as for find_path(), or None. If motion is given, it is
checked, and goal, start, extract and via are ignored. still: list of (name, vertices, triangles) or
(name, vertices, triangles, chord_error), parts that do not move. order: 'given', or 'find' to search for an
order by taking the parts out. rules: list of (name, name, rule), with a distance in mm or 'ignore' as rule.
budget (s) is the time limit for the whole sequence. watch: a SequenceWatch. Returns the report (docs/paths.md),
and a list with the motion of each part on the common timeline, in the order of `parts`, or None if a path is
missing. Raises InvalidInput (code NoParts, PartTwice, PartsIntersect, PartsTooNear, ...), Cancelled.)";

constexpr const char* kSequenceWatchDoc =
    R"(SequenceWatch()

Shows the progress of a search while it runs. Pass the object to find_sequence(); any thread may read it.)";

constexpr const char* kPathWatchDoc =
    R"(PathWatch()

Shows the progress of a search while it runs. Pass the object to find_path(); any thread may read it.)";

constexpr const char* kLiveDoc =
    R"(LiveClearance(vertices, triangles, neighbours, run=None)

Measures the distance of a part from its neighbours for one placement after another, quickly enough for
dragging. The constructor prepares the data once. neighbours: as for clearance(), but their chord errors are
ignored. Any thread may call it, but only one call may run at a time. Raises InvalidInput, Cancelled.)";

constexpr const char* kLiveAtDoc =
    R"(at(pose) -> (index, distance, inside, point_on_part, point_on_neighbour)

Finds the nearest neighbour for one placement (4, 4) of the part. Returns its index, the distance (mm) between
the triangles, whether one part lies inside the other, and the two nearest points (x, y, z) in world
coordinates. The distance is 0 if the triangles meet or one part lies inside the other.)";

constexpr const char* kLiveReachedDoc =
    R"(reached(from_pose, to_pose, apart) -> float64 (4, 4)

Moves the part in a straight line from one placement towards another and returns the last placement up to which
it stays at least `apart` mm from all neighbours. If it is closer than that at from_pose, returns to_pose if
the distance is kept there, otherwise from_pose.)";

Pose poseFrom(const py::handle& value, const char* name) {
  const auto array = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(value);
  if (!array || array.ndim() != 2 || array.shape(0) != 4 || array.shape(1) != 4)
    throw py::value_error(std::string(name) + " must be an array of shape (4, 4)");
  return poseFromMatrix(array.data(), 0, 0);
}

Extraction extractionFrom(const py::object& value) {
  Extraction extraction;
  if (py::isinstance<py::float_>(value) || py::isinstance<py::int_>(value)) {
    extraction.radius = value.cast<double>();
    return extraction;
  }
  const auto d = value.cast<std::vector<double>>();
  if (d.size() != 3) throw py::value_error("extract must be a radius or a direction (x, y, z)");
  extraction.direction = Eigen::Vector3d(d[0], d[1], d[2]);
  return extraction;
}

py::array matrixFrom(const Pose& pose) {
  Eigen::Matrix<double, 4, 4, Eigen::RowMajor> m;
  m.setIdentity();
  m.topLeftCorner<3, 3>() = pose.rotation.toRotationMatrix();
  m.topRightCorner<3, 1>() = pose.translation;
  return py::array_t<double>(std::vector<py::ssize_t>{4, 4}, m.data());
}

py::tuple asTuple(const Eigen::Vector3d& v) { return py::make_tuple(v[0], v[1], v[2]); }

std::unique_ptr<LiveClearance> makeLive(const py::object& vertices, const py::object& triangles,
                                        const py::iterable& neighbours, const py::object& run) {
  const RunPointer context = runFromObject(run);
  const TriMesh part = meshFromArrays(vertices, triangles);
  const std::vector<ClearanceNeighbour> parts = neighboursFrom(neighbours, {});
  return runWithoutLock(*context,
                        [&] { return std::make_unique<LiveClearance>(part, parts, *context); });
}

py::tuple pyLiveAt(LiveClearance& live, const py::object& pose) {
  const Pose at = poseFrom(pose, "pose");
  const LiveDistance found = withoutLock([&] { return live.at(at); });
  return py::make_tuple(found.neighbour, found.distance, found.inside, asTuple(found.pointOnPart),
                        asTuple(found.pointOnNeighbour));
}

py::array pyLiveReached(LiveClearance& live, const py::object& from, const py::object& to,
                        double apart) {
  const Pose a = poseFrom(from, "from_pose"), b = poseFrom(to, "to_pose");
  return matrixFrom(withoutLock([&] { return live.reached(a, b, apart); }));
}

py::object pyFarthest(const PathWatch& watch) {
  const std::optional<Pose> pose = watch.farthest();
  return pose ? py::object(matrixFrom(*pose)) : py::none();
}

PathOptions optionsFrom(double clearance, double release, bool translationOnly,
                        const std::optional<double>& maxAngle, double tolerance, double bodyChord,
                        double budget, std::uint64_t seed, Interpolation interpolation) {
  PathOptions options;
  options.clearance = clearance;
  options.tolerance = tolerance;
  options.bodyChordError = bodyChord;
  options.release = release;
  options.translationOnly = translationOnly;
  options.largestTurn = maxAngle;
  options.interpolation = interpolation;
  options.budgetSeconds = budget;
  options.seed = seed;
  return options;
}

py::tuple answerOf(const PathReport& report) {
  const py::object found = foundOf(report);
  if (report.verdict != PathVerdict::Found) return py::make_tuple(found, py::none());
  return py::make_tuple(found, trajectoryToArrays(report.path));
}

py::tuple pyFindPath(const py::object& vertices, const py::object& triangles,
                     const py::object& goal, const py::iterable& neighbours,
                     const py::object& start, const py::object& extract, const py::iterable& via,
                     double clearance, double release, bool translationOnly,
                     const std::optional<double>& maxAngle, const std::string& interpolation,
                     double tolerance, double bodyChord, double budget, std::uint64_t seed,
                     const py::object& run, PathWatch* watch,
                     const std::vector<std::string>& rules) {
  const RunPointer context = runFromObject(run);
  const TriMesh part = meshFromArrays(vertices, triangles);
  PathTask task;
  task.goal = poseFrom(goal, "goal");
  if (!start.is_none()) task.start = poseFrom(start, "start");
  if (!extract.is_none()) task.extraction = extractionFrom(extract);
  for (const py::handle& item : via) task.via.push_back(poseFrom(item, "via"));
  const std::vector<ClearanceNeighbour> parts = neighboursFrom(neighbours, rules);
  const PathOptions options =
      optionsFrom(clearance, release, translationOnly, maxAngle, tolerance, bodyChord, budget, seed,
                  parseInterpolation(interpolation));
  const PathReport report = runWithoutLock(
      *context, [&] { return findPath(part, task, parts, options, *context, watch); });
  return answerOf(report);
}

py::tuple pyImprovePath(const py::object& vertices, const py::object& triangles,
                        const py::object& motion, const py::iterable& neighbours,
                        const std::string& interpolation, const std::vector<std::size_t>& locked,
                        bool moreClearance, double clearance, double release, bool translationOnly,
                        const std::optional<double>& maxAngle, double tolerance, double bodyChord,
                        double budget, std::uint64_t seed, const py::object& run,
                        const std::vector<std::string>& rules) {
  const RunPointer context = runFromObject(run);
  const TriMesh part = meshFromArrays(vertices, triangles);
  const ImproveTask task{trajectoryFromObject(motion, interpolation), locked, moreClearance};
  const std::vector<ClearanceNeighbour> parts = neighboursFrom(neighbours, rules);
  const PathOptions options = optionsFrom(clearance, release, translationOnly, maxAngle, tolerance,
                                          bodyChord, budget, seed, task.motion.interpolation);
  return answerOf(
      runWithoutLock(*context, [&] { return improvePath(part, task, parts, options, *context); }));
}

SequencePart sequencePartFrom(const py::handle& item) {
  const py::tuple given =
      tupleOf(item, 10,
              "a part must be (name, vertices, triangles, chord_error, goal, start, extract, via, "
              "motion, interpolation)");
  SequencePart part{given[0].cast<std::string>(),
                    meshFromArrays(given[1], given[2]),
                    given[3].cast<double>(),
                    {}};
  const py::object goal = given[4], start = given[5], extract = given[6], motion = given[8];
  if (!goal.is_none()) part.task.goal = poseFrom(goal, "goal");
  if (!start.is_none()) part.task.start = poseFrom(start, "start");
  if (!extract.is_none()) part.task.extraction = extractionFrom(extract);
  for (const py::handle& via : given[7]) part.task.via.push_back(poseFrom(via, "via"));
  if (!motion.is_none()) part.motion = trajectoryFromObject(motion, given[9].cast<std::string>());
  return part;
}

py::tuple pyFindSequence(const py::iterable& list, const py::iterable& still,
                         const std::string& order, double clearance, double release,
                         bool translationOnly, const std::optional<double>& maxAngle,
                         const std::string& interpolation, double tolerance, double budget,
                         const std::optional<std::int64_t>& mostMoves, std::uint64_t seed,
                         const std::vector<std::array<std::string, 3>>& rules,
                         const py::object& run, SequenceWatch* watch) {
  if (order != "given" && order != "find")
    throw py::value_error("order is '" + order + "'; allowed: given, find");
  const RunPointer context = runFromObject(run);
  std::vector<SequencePart> parts;
  for (const py::handle& item : list) parts.push_back(sequencePartFrom(item));
  std::vector<StillPart> stillParts;
  for (ClearanceNeighbour& part : neighboursFrom(still, {}))
    stillParts.push_back({std::move(part.name), std::move(part.mesh), part.chordError});
  SequenceOptions options;
  options.path = optionsFrom(clearance, release, translationOnly, maxAngle, tolerance, 0, budget,
                             seed, parseInterpolation(interpolation));
  options.path.mostSteps = unlessZero(mostMoves);
  options.findOrder = order == "find";
  for (const auto& [first, second, text] : rules)
    options.rules.push_back({first, second, parseRule(text)});
  const SequenceReport report = runWithoutLock(
      *context, [&] { return findSequence(parts, stillParts, options, *context, watch); });
  const py::object found = foundOf(report);
  if (report.verdict != SequenceVerdict::Found) return py::make_tuple(found, py::none());
  py::list motions;
  for (const Trajectory& motion : report.timeline) motions.append(trajectoryToArrays(motion));
  return py::make_tuple(found, motions);
}

py::tuple pySeen(const SequenceWatch& watch) {
  const SequenceWatch::Seen seen = watch.seen();
  return py::make_tuple(seen.part, seen.found,
                        seen.farthest ? py::object(matrixFrom(*seen.farthest)) : py::none());
}

}  // namespace

void bindPath(py::module_& module) {
  py::class_<PathWatch, std::shared_ptr<PathWatch>>(module, "PathWatch", kPathWatchDoc)
      .def(py::init<>())
      .def("farthest", &pyFarthest,
           "The placement farthest from the goal that the search has reached so far, float64 (4, "
           "4), or None.");
  module.def("find_path", &pyFindPath, kFindPathDoc, py::arg("vertices"), py::arg("triangles"),
             py::arg("goal"), py::arg("neighbours"), py::arg("start") = py::none(),
             py::arg("extract") = py::none(), py::arg("via") = py::tuple(),
             py::arg("clearance") = 0.0, py::arg("release") = 0.0,
             py::arg("translation_only") = false, py::arg("max_angle") = py::none(),
             py::arg("interpolation") = "linear", py::arg("tolerance") = 0.01,
             py::arg("body_chord") = 0.0, py::arg("budget") = 60.0, py::arg("seed") = 1,
             py::arg("run") = py::none(), py::arg("watch") = nullptr,
             py::arg("rules") = py::tuple());
  module.def("improve_path", &pyImprovePath, kImproveDoc, py::arg("vertices"), py::arg("triangles"),
             py::arg("motion"), py::arg("neighbours"), py::arg("interpolation") = "linear",
             py::arg("locked") = py::tuple(), py::arg("more_clearance") = false,
             py::arg("clearance") = 0.0, py::arg("release") = 0.0,
             py::arg("translation_only") = false, py::arg("max_angle") = py::none(),
             py::arg("tolerance") = 0.01, py::arg("body_chord") = 0.0, py::arg("budget") = 60.0,
             py::arg("seed") = 1, py::arg("run") = py::none(), py::arg("rules") = py::tuple());
  py::class_<SequenceWatch, std::shared_ptr<SequenceWatch>>(module, "SequenceWatch",
                                                            kSequenceWatchDoc)
      .def(py::init<>())
      .def("seen", &pySeen,
           "Returns (index of the part for which the search looks for a path, or None; number of "
           "parts that have a path; the farthest placement of that part, (4, 4), or None).");
  module.def("find_sequence", &pyFindSequence, kSequenceDoc, py::arg("parts"),
             py::arg("still") = py::tuple(), py::arg("order") = "given", py::arg("clearance") = 0.0,
             py::arg("release") = 0.0, py::arg("translation_only") = false,
             py::arg("max_angle") = py::none(), py::arg("interpolation") = "linear",
             py::arg("tolerance") = 0.01, py::arg("budget") = 60.0,
             py::arg("most_moves") = py::none(), py::arg("seed") = 1,
             py::arg("rules") = std::vector<std::array<std::string, 3>>{},
             py::arg("run") = py::none(), py::arg("watch") = nullptr);
  py::class_<LiveClearance>(module, "LiveClearance", kLiveDoc)
      .def(py::init(&makeLive), py::arg("vertices"), py::arg("triangles"), py::arg("neighbours"),
           py::arg("run") = py::none())
      .def("at", &pyLiveAt, kLiveAtDoc, py::arg("pose"))
      .def("reached", &pyLiveReached, kLiveReachedDoc, py::arg("from_pose"), py::arg("to_pose"),
           py::arg("apart"));
}

}  // namespace swept::python
#endif  // HAVE_SWEPT_CLEARANCE
