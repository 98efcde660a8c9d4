// SPDX-License-Identifier: LGPL-2.1-or-later
#include "page_bindings.h"

#include <pybind11/stl.h>

#include "arrays.h"
#include "job.h"
#include "swept/page.h"
#include "values.h"

namespace swept::python {
namespace {

constexpr const char* kPageDoc =
    R"(report_page(report, title='', language='en', version='', date='', template='', inputs=(), parts=(),
            pictures=(), view_triangles=50000, run=None) -> str

One self-contained HTML file that tells what a report (JSON text of clearance() or mechanism()) says.
inputs: (role, name, detail, sha256); parts, for the 3D view: (name, vertices, triangles, motion,
interpolation, moves, translucent), motion as in compute() or None; pictures: (caption, media type, bytes).
Lengths in mm. Raises InvalidInput (BadReport, BadTemplate, BadOption), Cancelled.)";

py::tuple tupleOf(const py::handle& item, std::size_t size, const char* what) {
  const auto found = py::reinterpret_borrow<py::object>(item).cast<py::tuple>();
  if (found.size() != size) throw py::value_error(what);
  return found;
}

PageInput inputFrom(const py::handle& item) {
  const py::tuple found = tupleOf(item, 4, "an input is (role, name, detail, sha256)");
  return {found[0].cast<std::string>(), found[1].cast<std::string>(), found[2].cast<std::string>(),
          found[3].cast<std::string>()};
}

PagePart partFrom(const py::handle& item) {
  const py::tuple found = tupleOf(item, 7,
                                  "a part is (name, vertices, triangles, motion, interpolation, "
                                  "moves, translucent)");
  const py::object motion = found[3];
  return {
      found[0].cast<std::string>(), meshFromArrays(found[1], found[2]),
      motion.is_none() ? Trajectory{} : trajectoryFromObject(motion, found[4].cast<std::string>()),
      found[5].cast<bool>(), found[6].cast<bool>()};
}

PagePicture pictureFrom(const py::handle& item) {
  const py::tuple found = tupleOf(item, 3, "a picture is (caption, media type, bytes)");
  return {found[0].cast<std::string>(), found[1].cast<std::string>(),
          std::string(found[2].cast<py::bytes>())};
}

std::string pyReportPage(const std::string& report, const std::string& title,
                         const std::string& language, const std::string& version,
                         const std::string& date, const std::string& layout,
                         const py::iterable& inputs, const py::iterable& parts,
                         const py::iterable& pictures, std::size_t viewTriangles,
                         const py::object& run) {
  const RunPointer context = runFromObject(run);
  PageOptions options;
  options.title = title;
  options.language = language;
  options.version = version;
  options.date = date;
  options.layout = layout;
  options.viewTriangles = viewTriangles;
  for (const py::handle& item : inputs) options.inputs.push_back(inputFrom(item));
  for (const py::handle& item : parts) options.parts.push_back(partFrom(item));
  for (const py::handle& item : pictures) options.pictures.push_back(pictureFrom(item));
  return runWithoutLock(*context, [&] { return reportPage(report, options, *context); });
}

}  // namespace

void bindPage(py::module_& module) {
  module.def("report_page", &pyReportPage, kPageDoc, py::arg("report"), py::arg("title") = "",
             py::arg("language") = "en", py::arg("version") = "", py::arg("date") = "",
             py::arg("template") = "", py::arg("inputs") = py::tuple(),
             py::arg("parts") = py::tuple(), py::arg("pictures") = py::tuple(),
             py::arg("view_triangles") = 50000, py::arg("run") = py::none());
  module.def("page_template", &pageTemplate,
             "page_template(name='page') -> str\n\nA template of the program: 'page' or 'print'.",
             py::arg("name") = "page");
  module.def("check_page_template", &checkPageTemplate,
             "check_page_template(template)\n\nRaises InvalidInput (BadTemplate) where "
             "report_page() would.",
             py::arg("template"));
  module.def("page_has_view", &pageHasView,
             "page_has_view() -> bool\n\nFalse where the module was built without three.js: pages "
             "have no 3D view then.");
}

}  // namespace swept::python
