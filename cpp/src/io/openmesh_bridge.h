// The two classes through which OpenMesh's readers and writers see our plain triangle lists.
// OpenMesh's own mesh classes refuse non-manifold faces; these keep every face as it stands.
// In:   faces with any number of corners (import), a TriMesh (export).
// Out:  vertices and corner lists in file order; nothing is welded, dropped or turned.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <OpenMesh/Core/IO/exporter/BaseExporter.hh>
#include <OpenMesh/Core/IO/importer/BaseImporter.hh>
#include <cstdint>
#include <vector>

#include "io/polygon_list.h"
#include "swept/types.h"

namespace swept {

/// Collects what a reader finds. Attributes (normals, colours, texture) are ignored.
class ListImporter final : public OpenMesh::IO::BaseImporter {
 public:
  /// Above these counts a file cannot be honest; the importer throws Error(InvalidInput,
  /// "BadFile").
  ListImporter(std::uint64_t maxVertices, std::uint64_t maxCorners)
      : maxVertices_(maxVertices), maxCorners_(maxCorners) {}

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
  std::uint64_t maxVertices_;
  std::uint64_t maxCorners_;
};

/// Shows a TriMesh to a writer, positions in double.
class ListExporter final : public OpenMesh::IO::BaseExporter {
 public:
  explicit ListExporter(const TriMesh& mesh) : mesh_(mesh) {}

  OpenMesh::Vec3f point(OpenMesh::VertexHandle vertex) const override;
  OpenMesh::Vec3d pointd(OpenMesh::VertexHandle vertex) const override;
  bool is_point_double() const override { return true; }
  unsigned int get_vhandles(OpenMesh::FaceHandle face,
                            std::vector<OpenMesh::VertexHandle>& handles) const override;
  OpenMesh::Vec3f normal(OpenMesh::FaceHandle face) const override;
  OpenMesh::Vec3d normald(OpenMesh::FaceHandle face) const override;
  bool is_normal_double() const override { return true; }
  size_t n_vertices() const override { return mesh_.vertices.size(); }
  size_t n_faces() const override { return mesh_.triangles.size(); }
  size_t n_edges() const override { return 0; }
  bool is_triangle_mesh() const override { return true; }
  /// Empty, but asked for by the PLY writer, which looks for custom properties there.
  const OpenMesh::BaseKernel* kernel() override { return &kernel_; }

  OpenMesh::Vec3f normal(OpenMesh::VertexHandle) const override { return OpenMesh::Vec3f(0.0F); }
  OpenMesh::Vec3d normald(OpenMesh::VertexHandle) const override { return OpenMesh::Vec3d(0.0); }
  OpenMesh::Vec3uc color(OpenMesh::VertexHandle) const override { return OpenMesh::Vec3uc(0); }
  OpenMesh::Vec4uc colorA(OpenMesh::VertexHandle) const override { return OpenMesh::Vec4uc(0); }
  OpenMesh::Vec3ui colori(OpenMesh::VertexHandle) const override { return OpenMesh::Vec3ui(0); }
  OpenMesh::Vec4ui colorAi(OpenMesh::VertexHandle) const override { return OpenMesh::Vec4ui(0); }
  OpenMesh::Vec3f colorf(OpenMesh::VertexHandle) const override { return OpenMesh::Vec3f(0); }
  OpenMesh::Vec4f colorAf(OpenMesh::VertexHandle) const override { return OpenMesh::Vec4f(0); }
  OpenMesh::Vec2f texcoord(OpenMesh::VertexHandle) const override { return OpenMesh::Vec2f(0); }
  OpenMesh::Vec2f texcoord(OpenMesh::HalfedgeHandle) const override { return OpenMesh::Vec2f(0); }
  OpenMesh::Attributes::StatusInfo status(OpenMesh::VertexHandle) const override { return {}; }
  OpenMesh::HalfedgeHandle getHeh(OpenMesh::FaceHandle, OpenMesh::VertexHandle) const override {
    return OpenMesh::HalfedgeHandle();
  }
  unsigned int get_face_texcoords(std::vector<OpenMesh::Vec2f>&) const override { return 0; }
  OpenMesh::Vec3uc color(OpenMesh::FaceHandle) const override { return OpenMesh::Vec3uc(0); }
  OpenMesh::Vec4uc colorA(OpenMesh::FaceHandle) const override { return OpenMesh::Vec4uc(0); }
  OpenMesh::Vec3ui colori(OpenMesh::FaceHandle) const override { return OpenMesh::Vec3ui(0); }
  OpenMesh::Vec4ui colorAi(OpenMesh::FaceHandle) const override { return OpenMesh::Vec4ui(0); }
  OpenMesh::Vec3f colorf(OpenMesh::FaceHandle) const override { return OpenMesh::Vec3f(0); }
  OpenMesh::Vec4f colorAf(OpenMesh::FaceHandle) const override { return OpenMesh::Vec4f(0); }
  OpenMesh::Attributes::StatusInfo status(OpenMesh::FaceHandle) const override { return {}; }
  OpenMesh::Vec3uc color(OpenMesh::EdgeHandle) const override { return OpenMesh::Vec3uc(0); }
  OpenMesh::Vec4uc colorA(OpenMesh::EdgeHandle) const override { return OpenMesh::Vec4uc(0); }
  OpenMesh::Vec3ui colori(OpenMesh::EdgeHandle) const override { return OpenMesh::Vec3ui(0); }
  OpenMesh::Vec4ui colorAi(OpenMesh::EdgeHandle) const override { return OpenMesh::Vec4ui(0); }
  OpenMesh::Vec3f colorf(OpenMesh::EdgeHandle) const override { return OpenMesh::Vec3f(0); }
  OpenMesh::Vec4f colorAf(OpenMesh::EdgeHandle) const override { return OpenMesh::Vec4f(0); }
  OpenMesh::Attributes::StatusInfo status(OpenMesh::EdgeHandle) const override { return {}; }
  int get_halfedge_id(OpenMesh::VertexHandle) override { return -1; }
  int get_halfedge_id(OpenMesh::FaceHandle) override { return -1; }
  int get_next_halfedge_id(OpenMesh::HalfedgeHandle) override { return -1; }
  int get_to_vertex_id(OpenMesh::HalfedgeHandle) override { return -1; }
  int get_face_id(OpenMesh::HalfedgeHandle) override { return -1; }
  OpenMesh::Attributes::StatusInfo status(OpenMesh::HalfedgeHandle) const override { return {}; }

 private:
  const TriMesh& mesh_;
  OpenMesh::BaseKernel kernel_;
};

}  // namespace swept
