// Makes the findings about a solid, and the JSON of its report and of its estimate.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/number_text.h"
#include "base/report_json.h"
#include "solid/solid_findings.h"
#include "swept/solid.h"

namespace swept {

std::vector<Finding> solidFindings(const WrittenSolid& solid, const SolidOptions& options) {
  std::vector<Finding> findings;
  if (options.tolerance <= 0 && solid.tolerance > 0) {
    const double percent =
        solid.meshVolume != 0 ? 100 * (solid.volume / solid.meshVolume - 1) : 0.0;
    findings.push_back(
        {"SolidSimplified",
         1,
         {},
         "to stay within the limits (" + std::to_string(options.maxFaces) +
             " faces), the solid was simplified: the solid deviates from the mesh by up to " +
             numberText(solid.deviation, 3) +
             " mm, and its volume differs from that of the mesh by " + numberText(percent, 2) +
             " %; set a tolerance, raise the limit of faces, or ask for an exact "
             "solid"});
  }
  if (!solid.note.empty()) findings.push_back({"SolidNote", 1, {}, solid.note});
  if (options.tolerance > 0 && solid.deviation > options.tolerance) {
    findings.push_back({"SolidInaccurate",
                        1,
                        {},
                        "the solid deviates from the mesh by " + numberText(solid.deviation, 3) +
                            " mm, more than the tolerance of " + numberText(options.tolerance, 3) +
                            " mm; a smaller tolerance, such as " +
                            numberText(0.5 * options.tolerance, 3) +
                            " mm, or a smaller cell may reduce the deviation"});
  }
  return findings;
}

std::string toJson(const WrittenSolid& solid) {
  Json kinds = Json::object();
  for (const auto& [kind, count] : solid.facesByKind) kinds[kind] = count;
  const Json json{{"solids", solid.solids},
                  {"faces", solid.faces},
                  {"edges", solid.edges},
                  {"faces_by_kind", kinds},
                  {"valid", solid.valid},
                  {"closed", solid.valid},
                  {"tolerance", solid.tolerance},
                  {"deviation", solid.deviation},
                  {"edge_tolerance", solid.edgeTolerance},
                  {"volume", solid.volume},
                  {"mesh_volume", solid.meshVolume},
                  {"file_bytes", solid.fileBytes},
                  {"seconds",
                   {{"build", solid.secondsBuild},
                    {"write", solid.secondsWrite},
                    {"reread", solid.secondsReread}}},
                  {"note", solid.note}};
  return jsonText(json);
}

std::string toJson(const SolidEstimate& estimate) {
  return jsonText({{"triangles", estimate.triangles},
                   {"faces", estimate.faces},
                   {"megabytes", estimate.megabytes},
                   {"seconds", estimate.seconds},
                   {"trial_seconds", estimate.trialSeconds},
                   {"tolerance", estimate.tolerance},
                   {"deviation", estimate.deviation},
                   {"tried", estimate.tried}});
}

}  // namespace swept
