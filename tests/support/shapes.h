// Closed bodies for tests. All are oriented outward; units mm.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "swept/types.h"

namespace swept::test {

/// Returns an axis-parallel box: 8 vertices, 12 triangles.
TriMesh makeBox(const Eigen::Vector3d& low, const Eigen::Vector3d& high);
/// Returns a ball as a subdivided icosahedron: 20 * 4^levels triangles with their corners on the
/// sphere.
TriMesh makeBall(const Eigen::Vector3d& centre, double radius, int levels);
/// Returns a prism that approximates a cylinder round the z axis, from z0 to z1.
TriMesh makeCylinder(double radius, double z0, double z1, int sides);
/// Returns a square ring: outer half width `outer`, inner half width `inner`, from z0 to z1.
TriMesh makeSquareRing(double outer, double inner, double z0, double z1);
/// Returns a torus round the z axis, with around x across vertices.
TriMesh makeTorus(double ringRadius, double tubeRadius, int around, int across);

void append(TriMesh& mesh, const TriMesh& other);
TriMesh inverted(TriMesh mesh);
TriMesh transformed(TriMesh mesh, const Eigen::Isometry3d& placement);
/// Returns the mesh with separate corners for every triangle, as in an STL file.
TriMesh soup(const TriMesh& mesh);
double signedVolume(const TriMesh& mesh);
double surfaceArea(const TriMesh& mesh);

/// Returns a placement from an axis (any length), an angle in degrees and a translation.
Eigen::Isometry3d placement(const Eigen::Vector3d& axis, double degrees,
                            const Eigen::Vector3d& translation);
Pose poseOf(double timeSeconds, const Eigen::Isometry3d& placement);

}  // namespace swept::test
