// Kernel edges along exact curves, and such curves in the parameters of faces.
// Units:   mm.
// Cost:    about ten evaluations of the exact curve for each pole.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <functional>

#include "solid/carrier/bspline.h"

namespace swept::step {

/// Returns the edge t -> exact(t), t in the range, within kCurveBound. Null if this is not
/// possible.
TopoDS_Edge fittedEdge(const std::function<Eigen::Vector3d(double)>& exact, Range range);

/// Adds the curve t -> on(t) in the parameters of a face to an edge of fittedEdge(). `scale`: mm
/// per unit of these parameters. Returns false if the bound is not reached.
bool addCurveOn(const TopoDS_Face& face, const TopoDS_Edge& edge,
                const std::function<Eigen::Vector2d(double)>& on, const Eigen::Vector2d& scale,
                Range range);

/// Adds the curve of another edge in the parameters of a face to an edge at the same place. `far`:
/// mm, how far the edges may be from each other. Returns false if the other edge has no curve on
/// the face, or if a point of this curve is farther from the edge.
bool addCurveOfTwin(const TopoDS_Face& face, const TopoDS_Edge& edge, const TopoDS_Edge& twin,
                    double far);

}  // namespace swept::step
