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

Returns one self-contained HTML file that presents a report (the JSON text from clearance() or mechanism()).
inputs: list of (role, name, detail, sha256). parts, for the 3D view: list of (name, vertices, triangles, motion,
interpolation, moves, translucent), with motion as in compute() or None. pictures: list of (caption, media
type, bytes). Lengths are in mm. Raises InvalidInput (code BadReport, BadTemplate or BadOption), Cancelled.)";

PageInput inputFrom(const py::handle& item) {
  const py::tuple found = tupleOf(item, 4, "an input must be (role, name, detail, sha256)");
  return {found[0].cast<std::string>(), found[1].cast<std::string>(), found[2].cast<std::string>(),
          found[3].cast<std::string>()};
}

PagePart partFrom(const py::handle& item) {
  const py::tuple found = tupleOf(
      item, 7,
      "a part must be (name, vertices, triangles, motion, interpolation, moves, translucent)");
  const py::object motion = found[3];
  return {
      found[0].cast<std::string>(), meshFromArrays(found[1], found[2]),
      motion.is_none() ? Trajectory{} : trajectoryFromObject(motion, found[4].cast<std::string>()),
      found[5].cast<bool>(), found[6].cast<bool>()};
}

PagePicture pictureFrom(const py::handle& item) {
  const py::tuple found = tupleOf(item, 3, "a picture must be (caption, media type, bytes)");
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
             "page_template(name='page') -> str\n\nReturns a built-in template: 'page' (HTML) or "
             "'print' (PDF).",
             py::arg("name") = "page");
  module.def("check_page_template", &checkPageTemplate,
             "check_page_template(template)\n\nRaises InvalidInput (code BadTemplate) if "
             "report_page() would refuse the template.",
             py::arg("template"));
  module.def("page_has_view", &pageHasView,
             "page_has_view() -> bool\n\nReturns False if the module was built without three.js; "
             "then pages have no 3D view.");
}

}  // namespace swept::python
