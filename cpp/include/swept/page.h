// Writes the results of a clearance check, of a mechanism check or of all runs of a study as one
// HTML page. The page is self-contained: it needs no other file and no network.
// In:    the report as JSON text (toJson()), meshes and motions for the 3D view, pictures, inputs,
//        a template. Units: mm, s.
// Out:   UTF-8 text with verdicts, graph of the distances (SVG), 3D view, pictures, rules, inputs
//        and findings. The same input gives the same bytes. All texts of the report are escaped, so
//        they cannot become markup.
// Cost:  milliseconds, and 0.2 s for a million triangles, which are simplified for the view.
// See docs/report.md, "Pages".
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {

/// A file or a part that was an input of the check.
struct PageInput {
  /// "body", "motion", "neighbour" and "rules" are translated; other texts are shown unchanged.
  std::string role;
  std::string name;
  std::string detail;  ///< free text, such as a size
  std::string sha256;  ///< hexadecimal; empty: not known, and the page says so
};

/// A part that the 3D view shows.
struct PagePart {
  std::string name;  ///< the name in the report; the verdict for this name colours the part
  TriMesh mesh;
  /// Motion of a part that moves; its mesh is then in its own coordinates. Without poses, the part
  /// stands still where its mesh is. If a clearance report has no motion of its body, the view
  /// shows the body only at the poses of the report.
  Trajectory motion = {};
  bool moves = false;
  bool translucent = false;  ///< true for an envelope
};

struct PagePicture {
  std::string caption;
  std::string mediaType;  ///< "image/png", "image/jpeg" or "image/svg+xml"
  std::string bytes;      ///< content of the file
};

struct PageOptions {
  std::string title;            ///< empty: a default title in the language of the page
  std::string language = "en";  ///< en or de
  std::string version;          ///< version of the program
  std::string date;             ///< free text; empty: none
  std::string layout;           ///< text of a template; empty: pageTemplate()
  std::vector<PageInput> inputs;
  std::vector<PagePart> parts;  ///< empty: no 3D view
  std::vector<PagePicture> pictures;
  /// Approximate number of triangles shown; each adds about 30 bytes to the page.
  std::size_t viewTriangles = 50000;
};

/// Returns the page. Throws Error(Cancelled), or Error(InvalidInput) with one of these codes.
/// "BadReport": the text is no report of a study, or of a check that succeeded. "BadTemplate": the
/// template has an unknown {{placeholder}}. "BadOption": unknown language or type of picture.
/// "BadIndex", "NonFiniteVertex", "OutOfRange" or "BadPose": a part cannot be drawn.
std::string reportPage(const std::string& report, const PageOptions& options, RunContext& run);

/// Returns a built-in template: "page" (for browsers, the default) or "print" (uses only the HTML
/// subset of Qt's text documents; no 3D view). Throws Error(InvalidInput, "BadOption").
std::string pageTemplate(const std::string& name = "page");

/// Throws Error(InvalidInput, "BadTemplate") if reportPage() would refuse the template. Needs no
/// report.
void checkPageTemplate(const std::string& layout);

/// Returns false if the core was built without three.js. Then pages have no 3D view, and say so.
bool pageHasView();

}  // namespace swept
