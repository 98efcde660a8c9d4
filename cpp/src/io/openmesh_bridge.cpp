// SPDX-License-Identifier: LGPL-2.1-or-later
#include "io/openmesh_bridge.h"

#include <algorithm>
#include <string>

namespace swept {
namespace {

using OpenMesh::FaceHandle;
using OpenMesh::VertexHandle;

}  // namespace

void ListImporter::refuseMore(const char* what) const {
  throw Error(Status::InvalidInput, "BadFile",
              "'" + path_ + "' states more " + what + " than fit into its " +
                  std::to_string(bytes_) + " bytes; it is damaged or truncated: export it again");
}

VertexHandle ListImporter::add_vertex(const OpenMesh::Vec3d& point) {
  if (list.vertices.size() >= maxVertices_) refuseMore("vertices");
  list.vertices.emplace_back(point[0], point[1], point[2]);
  return VertexHandle(static_cast<int>(list.vertices.size() - 1));
}

VertexHandle ListImporter::add_vertex(const OpenMesh::Vec3f& point) {
  return add_vertex(OpenMesh::Vec3d(point[0], point[1], point[2]));
}

VertexHandle ListImporter::add_vertex() { return add_vertex(OpenMesh::Vec3d(0.0)); }

FaceHandle ListImporter::add_face(const VHandles& handles) {
  if (list.corners.size() + handles.size() > maxCorners_) refuseMore("face corners");
  for (const VertexHandle& handle : handles) list.corners.push_back(handle.idx());
  list.faceStart.push_back(list.corners.size());
  return FaceHandle(static_cast<int>(list.faceStart.size() - 2));
}

void ListImporter::set_point(VertexHandle vertex, const OpenMesh::Vec3f& point) {
  const int index = vertex.idx();
  if (index < 0 || static_cast<std::size_t>(index) >= list.vertices.size()) return;
  list.vertices[static_cast<std::size_t>(index)] = Eigen::Vector3d(point[0], point[1], point[2]);
}

void ListImporter::reserve(unsigned int nV, unsigned int /*nE*/, unsigned int nF) {
  // The counts come from the file. Trust them only as far as the length of the file allows.
  list.vertices.reserve(std::min<std::uint64_t>(nV, maxVertices_));
  list.faceStart.reserve(std::min<std::uint64_t>(nF, maxCorners_ / 3) + 1);
  list.corners.reserve(std::min<std::uint64_t>(3 * static_cast<std::uint64_t>(nF), maxCorners_));
}

}  // namespace swept
