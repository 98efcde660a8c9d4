// SPDX-License-Identifier: LGPL-2.1-or-later
#include "arrays.h"

#include <limits>

#include "base/number_text.h"
#include "swept/io.h"

namespace swept::python {
namespace {

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Integers = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;

std::string shapeText(const py::array& array) {
  return py::str(py::object(array.attr("shape"))).cast<std::string>();
}

// Throws an error if the array has another shape. -1 in `expected` stands for any length.
void checkShape(const py::array& array, const char* name, const std::vector<py::ssize_t>& expected,
                const char* wanted) {
  bool fits = static_cast<std::size_t>(array.ndim()) == expected.size();
  for (std::size_t i = 0; fits && i < expected.size(); ++i) {
    fits = expected[i] < 0 || array.shape(static_cast<py::ssize_t>(i)) == expected[i];
  }
  if (fits) return;
  throw py::value_error(std::string(name) + " has shape " + shapeText(array) + "; expected " +
                        wanted);
}

/// Refuses masked arrays, because the conversion would ignore their mask.
void refuseMasked(const py::object& object, const char* name) {
  if (!py::isinstance(object, py::module_::import("numpy").attr("ma").attr("MaskedArray"))) return;
  throw py::type_error(std::string(name) +
                       " is a masked array: fill or remove the masked entries first");
}

Doubles doublesFrom(const py::object& object, const char* name) {
  refuseMasked(object, name);
  const py::array any = py::array::ensure(object);
  const char kind = any ? any.dtype().kind() : 'O';
  if (kind != 'f' && kind != 'i' && kind != 'u') {
    PyErr_Clear();
    throw py::type_error(std::string(name) + " must be an array of numbers");
  }
  Doubles array = Doubles::ensure(any);
  if (!array) throw py::error_already_set();
  return array;
}

Pose poseAt(const double* quaternion, const double* translation, double time) {
  Pose pose;
  pose.timeSeconds = time;
  pose.rotation = Eigen::Quaterniond(quaternion[3], quaternion[0], quaternion[1], quaternion[2]);
  pose.translation = Eigen::Vector3d(translation[0], translation[1], translation[2]);
  return pose;
}

std::vector<Pose> posesFromMatrices(const py::object& object, const double* times) {
  const Doubles matrices = doublesFrom(object, "matrices");
  checkShape(matrices, "matrices", {-1, 4, 4}, "(K, 4, 4)");
  std::vector<Pose> poses;
  poses.reserve(static_cast<std::size_t>(matrices.shape(0)));
  for (py::ssize_t k = 0; k < matrices.shape(0); ++k) {
    const double time = times != nullptr ? times[k] : static_cast<double>(k);
    poses.push_back(poseFromMatrix(matrices.data() + 16 * k, time, k));
  }
  return poses;
}

/// Fills in the triangles of a mesh that already has its vertices.
template <class Index>
void fillTriangles(const Index* indices, TriMesh& mesh) {
  const auto vertices = static_cast<std::int64_t>(mesh.vertices.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int64_t index = indices[3 * t + k];
      if (index < 0 || index >= vertices || index > std::numeric_limits<std::int32_t>::max()) {
        throw Error(Status::InvalidInput, "BadIndex",
                    "triangle " + std::to_string(t) + " refers to vertex " + std::to_string(index) +
                        ", but the mesh has " + counted(vertices, "vertex", "vertices") +
                        " (triangles and vertices are counted from 0); correct the triangles of "
                        "the mesh");
      }
      mesh.triangles[t][k] = static_cast<std::int32_t>(index);
    }
  }
}

}  // namespace

TriMesh meshFromArrays(const py::object& vertices, const py::object& triangles) {
  const Doubles points = doublesFrom(vertices, "vertices");
  checkShape(points, "vertices", {-1, 3}, "(N, 3)");
  refuseMasked(triangles, "triangles");
  const py::array any = py::array::ensure(triangles);
  const char kind = any ? any.dtype().kind() : 'O';
  // numpy converts an empty list to floats. All other input must have an integer type.
  if (kind != 'i' && kind != 'u' && !(any && any.size() == 0)) {
    PyErr_Clear();
    throw py::type_error("triangles must be an array of integers");
  }
  checkShape(any, "triangles", {-1, 3}, "(M, 3)");
  // Contiguous int32 arrays, such as those that the core has returned, are read without a copy.
  const bool plain = py::isinstance<py::array_t<std::int32_t, py::array::c_style>>(any);
  const Integers wide = plain ? Integers() : Integers::ensure(any);
  if (!wide) throw py::error_already_set();

  TriMesh mesh;
  mesh.vertices.resize(static_cast<std::size_t>(points.shape(0)));
  std::copy_n(points.data(), points.size(), reinterpret_cast<double*>(mesh.vertices.data()));
  mesh.triangles.resize(static_cast<std::size_t>(any.shape(0)));
  if (plain) {
    fillTriangles(static_cast<const std::int32_t*>(any.data()), mesh);
  } else {
    fillTriangles(wide.data(), mesh);
  }
  return mesh;
}

std::vector<std::int32_t> facesFromArray(const py::object& faces) {
  refuseMasked(faces, "faces");
  const py::array any = py::array::ensure(faces);
  const char kind = any ? any.dtype().kind() : 'O';
  if (kind != 'i' && kind != 'u') {
    PyErr_Clear();
    throw py::type_error("faces must be an array of integers");
  }
  checkShape(any, "faces", {-1}, "(M,), one for each triangle");
  const Integers wide = Integers::ensure(any);
  if (!wide) throw py::error_already_set();
  std::vector<std::int32_t> numbers(static_cast<std::size_t>(wide.size()));
  for (std::size_t n = 0; n < numbers.size(); ++n) {
    const std::int64_t number = wide.data()[n];
    if (number < 0 || number > std::numeric_limits<std::int32_t>::max()) {
      throw Error(Status::InvalidInput, "BadFaces",
                  "triangle " + std::to_string(n) + " is said to belong to face " +
                      std::to_string(number) +
                      " (triangles are counted from 0); faces are numbered from 0 to 2147483647");
    }
    numbers[n] = static_cast<std::int32_t>(number);
  }
  return numbers;
}

Trajectory trajectoryFromObject(const py::object& motion, const std::string& interpolation) {
  Trajectory trajectory;
  trajectory.interpolation = parseInterpolation(interpolation);
  const bool isSequence = py::isinstance<py::tuple>(motion) || py::isinstance<py::list>(motion);
  const auto parts = isSequence ? py::len(motion) : 0;
  if (isSequence && (parts < 2 || parts > 4)) {
    throw py::value_error(
        "motion must be (times, quaternions, translations), (times, quaternions, translations, "
        "pivot), (times, matrices) or an array (K, 4, 4)");
  }
  if (!isSequence) {
    trajectory.poses = posesFromMatrices(motion, nullptr);
    return trajectory;
  }
  const py::sequence sequence(motion);
  const Doubles times = doublesFrom(sequence[0], "times");
  checkShape(times, "times", {-1}, "(K,)");
  const py::ssize_t count = times.shape(0);
  if (parts == 2) {
    const py::array matrices = py::array::ensure(sequence[1]);
    if (!matrices) throw py::error_already_set();
    checkShape(matrices, "matrices", {count, 4, 4}, "(K, 4, 4), with one matrix for each time");
    trajectory.poses = posesFromMatrices(matrices, times.data());
    return trajectory;
  }
  const Doubles quaternions = doublesFrom(sequence[1], "quaternions");
  const Doubles translations = doublesFrom(sequence[2], "translations");
  checkShape(quaternions, "quaternions", {count, 4}, "(K, 4), order x, y, z, w");
  checkShape(translations, "translations", {count, 3}, "(K, 3), mm");
  if (parts == 4) {
    const Doubles pivot = doublesFrom(sequence[3], "pivot");
    checkShape(pivot, "pivot", {3}, "(3,), mm");
    trajectory.pivot = {pivot.data()[0], pivot.data()[1], pivot.data()[2]};
  }
  trajectory.poses.reserve(static_cast<std::size_t>(count));
  for (py::ssize_t k = 0; k < count; ++k) {
    trajectory.poses.push_back(
        poseAt(quaternions.data() + 4 * k, translations.data() + 3 * k, times.data()[k]));
  }
  return trajectory;
}

py::tuple trajectoryToArrays(const Trajectory& trajectory) {
  const auto count = static_cast<py::ssize_t>(trajectory.poses.size());
  py::array_t<double> times(count);
  py::array_t<double> quaternions({count, py::ssize_t{4}});
  py::array_t<double> translations({count, py::ssize_t{3}});
  for (py::ssize_t k = 0; k < count; ++k) {
    const Pose& pose = trajectory.poses[static_cast<std::size_t>(k)];
    times.mutable_at(k) = pose.timeSeconds;
    // Eigen stores x, y, z, w.
    std::copy_n(pose.rotation.coeffs().data(), 4, quaternions.mutable_data(k, 0));
    std::copy_n(pose.translation.data(), 3, translations.mutable_data(k, 0));
  }
  return py::make_tuple(times, quaternions, translations);
}

std::string pathFromObject(const py::object& path) {
  const py::module_ os = py::module_::import("os");
  const py::object text = os.attr("fsdecode")(os.attr("fspath")(path));
  return py::bytes(text.attr("encode")("utf-8", "surrogateescape")).cast<std::string>();
}

py::tuple tupleOf(const py::handle& item, std::size_t size, const char* what) {
  const auto found = py::reinterpret_borrow<py::object>(item).cast<py::tuple>();
  if (found.size() != size) throw py::value_error(what);
  return found;
}

py::object parseJson(const std::string& text) {
  return py::module_::import("json").attr("loads")(text);
}

}  // namespace swept::python
