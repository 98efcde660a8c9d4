// Connects OpenMesh's readers to the project's plain lists of polygons. OpenMesh's own mesh classes
// refuse non-manifold faces; ListImporter keeps every face unchanged.
// In:   faces with any number of corners.
// Out:  vertices and corner lists in file order. Nothing is welded, dropped or reversed.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <OpenMesh/Core/IO/importer/BaseImporter.hh>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "io/polygon_list.h"
#include "swept/types.h"

namespace swept {

/// Collects the vertices and faces that a reader finds. Ignores normals, colours and texture.
class ListImporter final : public OpenMesh::IO::BaseImporter {
 public:
  /// A file of `bytes` bytes with more than `maxVertices` vertices or `maxCorners` face corners
  /// must be damaged. The importer then throws Error(InvalidInput, "BadFile") with `path` in the
  /// message.
  ListImporter(std::string path, std::uint64_t bytes, std::uint64_t maxVertices,
               std::uint64_t maxCorners)
      : path_(std::move(path)), bytes_(bytes), maxVertices_(maxVertices), maxCorners_(maxCorners) {}

  PolygonList list;

  OpenMesh::VertexHandle add_vertex(const OpenMesh::Vec3f& point) override;
  OpenMesh::VertexHandle add_vertex(const OpenMesh::Vec3d& point) override;
  OpenMesh::VertexHandle add_vertex() override;
  OpenMesh::FaceHandle add_face(const VHandles& handles) override;
  void set_point(OpenMesh::VertexHandle vertex, const OpenMesh::Vec3f& point) override;
  void reserve(unsigned int nV, unsigned int nE, unsigned int nF) override;
  size_t n_vertices() const override { return list.vertices.size(); }
  size_t n_faces() const override { return list.faces(); }
  size_t n_edges() const override { return 0; }

  OpenMesh::HalfedgeHandle add_edge(OpenMesh::VertexHandle, OpenMesh::VertexHandle) override {
    return OpenMesh::HalfedgeHandle();
  }
  OpenMesh::FaceHandle add_face(OpenMesh::HalfedgeHandle) override {
    return OpenMesh::FaceHandle();
  }
  void add_face_texcoords(OpenMesh::FaceHandle, OpenMesh::VertexHandle,
                          const std::vector<OpenMesh::Vec2f>&) override {}
  void add_face_texcoords(OpenMesh::FaceHandle, OpenMesh::VertexHandle,
                          const std::vector<OpenMesh::Vec3f>&) override {}
  void set_face_texindex(OpenMesh::FaceHandle, int) override {}
  void set_halfedge(OpenMesh::VertexHandle, OpenMesh::HalfedgeHandle) override {}
  void set_normal(OpenMesh::VertexHandle, const OpenMesh::Vec3f&) override {}
  void set_normal(OpenMesh::VertexHandle, const OpenMesh::Vec3d&) override {}
  void set_normal(OpenMesh::FaceHandle, const OpenMesh::Vec3f&) override {}
  void set_normal(OpenMesh::FaceHandle, const OpenMesh::Vec3d&) override {}
  void set_color(OpenMesh::VertexHandle, const OpenMesh::Vec3uc&) override {}
  void set_color(OpenMesh::VertexHandle, const OpenMesh::Vec4uc&) override {}
  void set_color(OpenMesh::VertexHandle, const OpenMesh::Vec3f&) override {}
  void set_color(OpenMesh::VertexHandle, const OpenMesh::Vec4f&) override {}
  void set_color(OpenMesh::EdgeHandle, const OpenMesh::Vec3uc&) override {}
  void set_color(OpenMesh::EdgeHandle, const OpenMesh::Vec4uc&) override {}
  void set_color(OpenMesh::EdgeHandle, const OpenMesh::Vec3f&) override {}
  void set_color(OpenMesh::EdgeHandle, const OpenMesh::Vec4f&) override {}
  void set_color(OpenMesh::FaceHandle, const OpenMesh::Vec3uc&) override {}
  void set_color(OpenMesh::FaceHandle, const OpenMesh::Vec4uc&) override {}
  void set_color(OpenMesh::FaceHandle, const OpenMesh::Vec3f&) override {}
  void set_color(OpenMesh::FaceHandle, const OpenMesh::Vec4f&) override {}
  void set_texcoord(OpenMesh::VertexHandle, const OpenMesh::Vec2f&) override {}
  void set_texcoord(OpenMesh::VertexHandle, const OpenMesh::Vec3f&) override {}
  void set_texcoord(OpenMesh::HalfedgeHandle, const OpenMesh::Vec2f&) override {}
  void set_texcoord(OpenMesh::HalfedgeHandle, const OpenMesh::Vec3f&) override {}
  void set_status(OpenMesh::VertexHandle, const OpenMesh::Attributes::StatusInfo&) override {}
  void set_status(OpenMesh::HalfedgeHandle, const OpenMesh::Attributes::StatusInfo&) override {}
  void set_status(OpenMesh::EdgeHandle, const OpenMesh::Attributes::StatusInfo&) override {}
  void set_status(OpenMesh::FaceHandle, const OpenMesh::Attributes::StatusInfo&) override {}
  void set_next(OpenMesh::HalfedgeHandle, OpenMesh::HalfedgeHandle) override {}
  void set_face(OpenMesh::HalfedgeHandle, OpenMesh::FaceHandle) override {}
  void request_face_texcoords2D() override {}
  void add_texture_information(int, std::string) override {}

 private:
  [[noreturn]] void refuseMore(const char* what) const;

  std::string path_;
  std::uint64_t bytes_;
  std::uint64_t maxVertices_;
  std::uint64_t maxCorners_;
};

}  // namespace swept
