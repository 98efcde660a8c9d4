// A judge (model/judge.h) for a build without a geometry kernel. It passes texts of STEP files to a
// reader that the application provides, such as FreeCAD.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

#include "solid/model/judge.h"
#include "solid/text/curved_text.h"
#include "swept/solid.h"

namespace swept::step {

/// Checks with the reader whether curved faces are valid after reading, and whether the finished
/// file contains the solid. Cannot find faces that intersect. Finds edges off their faces only in
/// the finished file, at the points at which the reader measures the distance. `reader` must
/// outlive the judge.
class TextJudge : public Judge {
 public:
  explicit TextJudge(StepReader& reader) : reader_(reader) {}

  std::vector<std::int32_t> setModel(const Model& model, RunContext& run) override;
  std::vector<EdgeCut> findEdgesOffFaces(const Model& model) override;
  std::vector<std::int32_t> findBadFaces(RunContext& run, double from, double to) override;
  std::vector<std::int32_t> findUnreadable(const Model& model, const SolidOptions& options,
                                           RunContext& run) override;
  std::vector<std::int32_t> findInterfering(const Model& model, RunContext& run) override;
  void writeBrep(std::ostream& out, RunContext& run) override;
  SolidCheck readBack(const Model& model, const std::string& file, const std::string& name,
                      const SolidOptions& options, SolidFormat format, RunContext& run) override;
  void guard(const std::function<void()>& work, RunContext& run) override;

 private:
  StepReader& reader_;
  CurvedText curved_;
};

}  // namespace swept::step
