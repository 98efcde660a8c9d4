// SPDX-License-Identifier: LGPL-2.1-or-later
#include "report_file.h"

#include <cstdio>

#include "base/report_json.h"
#include "base/safe_file.h"

namespace swept::cli {

void checkReportTarget(const std::string& path) {
  if (!path.empty() && path != "-") checkTarget(path);
}

void writeReport(const Report& report, const std::string& path,
                 const std::function<void(JsonWriter&)>& extra) {
  if (path.empty()) return;
  JsonWriter json;
  json.beginObject();
  writeReportFields(report, json);
  if (extra) extra(json);
  json.endObject();
  const std::string text = json.text() + "\n";
  if (path == "-") {
    std::fwrite(text.data(), 1, text.size(), stdout);
    std::fflush(stdout);
    return;
  }
  SafeFile file(path);
  file.stream() << text;
  file.commit();
}

}  // namespace swept::cli
