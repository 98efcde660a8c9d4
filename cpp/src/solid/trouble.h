// Collects the places where labelled faces do not fit together. The ground there is opened, and
// becomes facets in the next round (shape_maker.h).
// In:      a model of labelled faces, and the faces of it that are not sound.
// Out:     places for FaceLabels::open().
// Units:   mm.
// Cost:    O(edges).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "solid/label/label_faces.h"
#include "solid/model/model.h"

namespace swept::step {

class Trouble {
 public:
  /// `labelled`: the patches that the model was made from, on `mesh`. `round`: from 0; ground that
  /// was not opened widely enough is opened more widely in later rounds.
  Trouble(const HalfEdgeMesh& mesh, const Partition& labelled, double tolerance, int round);

  /// Returns the faces with edges off their surfaces: between labelled faces by more than a small
  /// part of the tolerance, beside facets by more than the tolerance.
  std::vector<std::int32_t> findLoose(const Model& model) const;

  /// Notes where the edges of these loose faces are off.
  void noteLoose(const std::vector<std::int32_t>& loose, const Model& model);
  /// Notes what is the most likely cause that the judge refuses these faces: small faces, else
  /// edges with a gap, else edges that nearly touch, else corners that several of the faces share,
  /// else the smallest face.
  void noteRefused(const std::vector<std::int32_t>& bad, const Model& model);

  const std::vector<OpenSpot>& spots() const { return spots_; }

 private:
  bool isLabelled(const ModelFace& face) const;
  void noteSmall(const std::vector<std::int32_t>& bad, const Model& model);
  void noteNarrow(const std::vector<std::int32_t>& bad, const Model& model);
  void noteShared(const std::vector<std::int32_t>& bad, const Model& model);
  void notePatch(std::int32_t patch);
  void noteEdge(const Curve& curve, const Carrier& surface, double gap);
  void noteSpot(const Eigen::Vector3d& at);

  const HalfEdgeMesh& mesh_;
  const Partition& labelled_;
  double tolerance_;
  int round_;
  std::vector<OpenSpot> spots_;
};

}  // namespace swept::step
