// Python functions that read solids in place of the module's own OpenCASCADE. A run calls them in
// its thread, and holds the interpreter lock during the call.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <string>
#include <utility>
#include <vector>

#include "arrays.h"
#include "swept/solid.h"

namespace swept::python {

/// A reader of STEP files in Python: a function that takes the text (bytes) of a file and returns a
/// dictionary with the members of SolidCheck and "bad_faces" (kWriteSolidDoc in docstrings.h).
class PythonStepReader : public StepReader {
 public:
  explicit PythonStepReader(py::function read) : read_(std::move(read)) {}
  Answer read(const std::string& text) override {
    const py::gil_scoped_acquire acquire;
    const py::dict values = read_(py::bytes(text));
    Answer answer;
    answer.badFaces = py::cast<std::vector<std::int32_t>>(values["bad_faces"]);
    answer.check.solids = py::cast<std::int64_t>(values["solids"]);
    answer.check.shells = py::cast<std::int64_t>(values["shells"]);
    answer.check.faces = py::cast<std::int64_t>(values["faces"]);
    answer.check.edges = py::cast<std::int64_t>(values["edges"]);
    answer.check.valid = py::cast<bool>(values["valid"]);
    answer.check.complaint = py::cast<std::string>(values["complaint"]);
    answer.check.volume = py::cast<double>(values["volume"]);
    answer.check.edgeTolerance = py::cast<double>(values["edge_tolerance"]);
    for (const std::int32_t face : answer.badFaces) {
      if (face < 0 || face >= answer.check.faces)
        throw py::value_error("bad_faces of the reader names face " + std::to_string(face) +
                              " of " + std::to_string(answer.check.faces));
    }
    return answer;
  }

 private:
  py::function read_;
};

/// A function that takes the path of a STEP or BREP file, a linear (mm) and an angular deflection
/// (rad), and returns (name, vertices, triangles, faces or None) for each solid.
class PythonSolidReader : public SolidReader {
 public:
  explicit PythonSolidReader(py::function read) : read_(std::move(read)) {}
  std::vector<ImportedSolid> read(const std::string& path, double linearDeflection,
                                  double angularDeflection) override {
    const py::gil_scoped_acquire acquire;
    std::vector<ImportedSolid> solids;
    const py::object native = py::module_::import("os").attr("fsdecode")(py::bytes(path));
    for (const py::handle& item : read_(native, linearDeflection, angularDeflection))
      solids.push_back(solidFrom(py::cast<py::tuple>(item)));
    return solids;
  }

 private:
  static ImportedSolid solidFrom(const py::tuple& item) {
    if (item.size() != 4)
      throw py::value_error(
          "the reader must return (name, vertices, triangles, faces) for each solid");
    ImportedSolid solid{py::cast<std::string>(item[0]), meshFromArrays(item[1], item[2])};
    if (item[3].is_none()) return solid;
    solid.mesh.faceOf = facesFromArray(item[3]);
    if (solid.mesh.faceOf.size() != solid.mesh.triangles.size())
      throw py::value_error("the reader gives " + std::to_string(solid.mesh.faceOf.size()) +
                            " faces for " + std::to_string(solid.mesh.triangles.size()) +
                            " triangles of '" + solid.name + "'");
    return solid;
  }

  py::function read_;
};

}  // namespace swept::python
