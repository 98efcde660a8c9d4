// Judges whether a solid can be used: what FreeCAD's *Check geometry* finds with its BOP test, the
// largest tolerances, and whether the solid can be cut out of a block.
// In: a STEP or BREP file, or a shape of the kernel. Out: faults by kind. Units: mm. Cost: the BOP
// test compares all faces with one another, some milliseconds a face.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <map>
#include <string>
#include <vector>

namespace swept::test {

struct JudgedSolid {
  bool valid = false;  ///< result of BRepCheck_Analyzer
  int solids = 0, faces = 0, edges = 0;
  /// Number of shapes with faults that the BOP test finds, by kind: "SelfIntersect",
  /// "InvalidCurveOnSurface", "TooSmallEdge", ... Empty: no faults.
  std::map<std::string, int> faults;
  /// The first faults as text: kind, shapes with their surface or curve, middle of their box.
  std::vector<std::string> details;
  double edgeTolerance = 0, vertexTolerance = 0;  ///< mm: the largest ones
  double volume = 0;                              ///< mm^3
  /// A block that contains half of the solid is cut by the solid and intersected with it. This is
  /// the relative difference between the volume of the block and the sum of both results' volumes.
  /// Negative: the kernel gave no result.
  double blockError = -1;
};

/// Throws std::runtime_error if the file cannot be read.
TopoDS_Shape readShape(const std::string& path);

/// Writes a cylinder about the z axis, from z = 0, as a BREP file.
void writeRod(double radius, double length, const std::string& path);

/// Does the same, with chamfers around both ends.
void writeRodWithChamfers(double radius, double length, double chamfer, const std::string& path);

/// Writes a cone about the z axis, from z = 0, as a BREP file.
void writeCone(double bottomRadius, double topRadius, double length, const std::string& path);

/// Writes a cylinder with a chamfer around the bottom and a fillet around the top, as a BREP file.
void writeRodWithChamferAndFillet(double radius, double length, const std::string& path);

/// Writes a cylinder with an ellipse as its base, as a BREP file.
void writeEllipticRod(double majorRadius, double minorRadius, double length,
                      const std::string& path);

/// Writes a block of 30 x 20 x 10 with a hole and rounded edges, which are tangent to its faces, as
/// a BREP file.
void writeRoundedBlock(const std::string& path);

/// Writes a ball around the origin, or a ring around the z-axis, as a BREP file.
void writeBall(double radius, const std::string& path);
/// Half of a ball, above its plane face.
void writeHalfBall(double radius, const std::string& path);
/// A block with this size in x, y and z, whose top edges are round.
void writeBlockWithRoundTop(double length, double width, double height, double radius,
                            const std::string& path);
void writeRing(double radius, double tube, const std::string& path);
/// A rod, as long as it is thick, on a round flange whose height is a third of its radius.
void writeSteppedRod(double flange, double radius, const std::string& path);
/// A quarter of a ring.
void writeElbow(double radius, double tube, const std::string& path);

/// detailCount: largest number of faults that are described. withBlock: also computes blockError
/// (takes longer).
JudgedSolid judgeSolid(const TopoDS_Shape& shape, std::size_t detailCount, bool withBlock);

}  // namespace swept::test
