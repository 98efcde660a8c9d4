// SPDX-License-Identifier: LGPL-2.1-or-later
#ifdef HAVE_SWEPT_SOLID
#include "solid_options.h"

#include <cstdio>

namespace swept::cli {

const char* const kSolidOptionsHelp =
    R"(  --solid-tolerance MM    the solid may leave the mesh by this: surfaces are recognised, the rest is
                          simplified (default 0: only flat regions are merged, unless a limit asks
                          for more)
  --max-faces N           at most this many faces (default 20000)
  --max-megabytes N       at most this much in the file
                          without --solid-tolerance the solid is simplified as far as the limits ask
  --schema S              ap214, ap242 or ap242-tessellated: the mesh as it is, for STEP readers
                          that know tessellated geometry (default ap214)
  --exact                 never leave the mesh: above a limit refuse instead of simplifying
  --facets                plane faces only, no other surfaces
  --author, --organization, --product TEXT
)";

void addSolidOptions(Arguments& arguments, StepOptions& options) {
  arguments.with("--schema", [&](const std::string& t) { options.schema = parseStepSchema(t); });
  arguments.number("--solid-tolerance", options.tolerance);
  arguments.integer("--max-faces", options.maxFaces, 4, std::int64_t{1} << 31U);
  arguments.number("--max-megabytes", options.maxMegabytes);
  arguments.flag("--exact", options.exact);
  arguments.flag("--facets", options.recognise, false);
  arguments.text("--author", options.author);
  arguments.text("--organization", options.organization);
  arguments.text("--product", options.productName);
}

void writeSolidFields(const StepReport& solid, JsonWriter& json) {
  json.key("solid").beginObject();
  json.field("solids", solid.solids);
  json.field("faces", solid.faces);
  json.field("edges", solid.edges);
  json.key("faces_by_kind").beginObject();
  for (const auto& [kind, count] : solid.facesByKind) json.field(kind.c_str(), count);
  json.endObject();
  json.field("valid", solid.valid);
  json.field("tolerance", solid.tolerance);
  json.field("deviation", solid.deviation);
  json.field("volume", solid.volume);
  json.field("mesh_volume", solid.meshVolume);
  json.field("file_bytes", solid.fileBytes);
  json.field("seconds_build", solid.secondsBuild);
  json.field("seconds_write", solid.secondsWrite);
  json.field("seconds_reread", solid.secondsReread);
  json.field("note", solid.note);
  json.endObject();
}

void printSolid(const StepReport& solid, const std::string& path) {
  std::string kinds;
  for (const auto& [kind, count] : solid.facesByKind) {
    kinds += (kinds.empty() ? "" : ", ") + std::to_string(count) + " " + kind;
  }
  std::printf("%s: %lld solid(s), %lld faces (%s), %.3g MB, deviation %.3g mm, %.1f s\n",
              path.c_str(), static_cast<long long>(solid.solids),
              static_cast<long long>(solid.faces), kinds.c_str(),
              static_cast<double>(solid.fileBytes) / 1e6, solid.deviation,
              solid.secondsBuild + solid.secondsWrite + solid.secondsReread);
  if (!solid.note.empty()) std::fprintf(stderr, "swept: note: %s\n", solid.note.c_str());
}

}  // namespace swept::cli
#endif
