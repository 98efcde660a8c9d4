// Pages: what a check of clearance or of a mechanism found, or all runs of a study, as one HTML
// file that needs nothing but itself: no other file, no network.
//
// In:    the report as JSON text (toJson()), meshes and motions for the 3D view, pictures, inputs,
//        a template. Units: mm, s.
// Out:   UTF-8 text: verdicts, graph of the distances (SVG), 3D view, pictures, rules, inputs,
//        findings; the same bytes for the same input. Nothing that a report says can become markup.
// Cost:  milliseconds, and 0.2 s for a million triangles, which are thinned for the view.
// Described in docs/report.md, "Pages".
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {

/// A file or a part that the check was made of.
struct PageInput {
  std::string role;  ///< "body", "motion", "neighbour", "rules": translated; anything else as it is
  std::string name;
  std::string detail;  ///< free text, such as a size
  std::string sha256;  ///< hexadecimal; empty: not known, which the page says
};

/// What is drawn in the 3D view.
struct PagePart {
  std::string name;  ///< as in the report; with the same name, rows of the report colour it
  TriMesh mesh;
  /// Of a part that moves (mesh in its own coordinates); no poses: stands where its mesh has it.
  /// The body of a clearance report without a motion is shown at the poses of the report only.
  Trajectory motion = {};
  bool moves = false;
  bool translucent = false;  ///< an envelope, seen through
};

struct PagePicture {
  std::string caption;
  std::string mediaType;  ///< "image/png", "image/jpeg" or "image/svg+xml"
  std::string bytes;      ///< of the file
};

struct PageOptions {
  std::string title;            ///< empty: a title in the page's language
  std::string language = "en";  ///< en or de
  std::string version;          ///< of the program
  std::string date;             ///< free text; empty: none
  std::string layout;           ///< text of a template; empty: pageTemplate()
  std::vector<PageInput> inputs;
  std::vector<PagePart> parts;  ///< empty: no 3D view
  std::vector<PagePicture> pictures;
  std::size_t viewTriangles = 50000;  ///< about so many are shown; about 30 bytes of the page each
};

/// Throws Error(InvalidInput): "BadReport" for what is no report of a study, or of a check or
/// mechanism that ended well, "BadTemplate" for a template with an unknown {{placeholder}},
/// "BadOption" for an unknown language or type of picture, "BadIndex", "NonFiniteVertex",
/// "OutOfRange" or "BadPose" for a part that cannot be drawn; Error(Cancelled).
std::string reportPage(const std::string& report, const PageOptions& options, RunContext& run);

/// Templates of the program: "page" (for browsers, used where none is given) or "print" (the little
/// HTML that Qt's text documents know; no 3D view). Throws Error(InvalidInput, "BadOption").
std::string pageTemplate(const std::string& name = "page");

/// Throws Error(InvalidInput, "BadTemplate") where reportPage() would, without a report.
void checkPageTemplate(const std::string& layout);

/// False where the core was built without three.js: pages have no 3D view then, and say so.
bool pageHasView();

}  // namespace swept
