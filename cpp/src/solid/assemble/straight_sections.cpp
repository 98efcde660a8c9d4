// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/straight_sections.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <IntCurvesFace_Intersector.hxx>
#include <Precision.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <deque>
#include <gp_Lin.hxx>
#include <gp_Trsf.hxx>
#include <map>
#include <memory>

#include "solid/assemble/face_section.h"
#include "solid/assemble/profile.h"

namespace swept::step {
namespace {

/// mm: shorter lines are left out.
constexpr double kShortestLine = 1e-6;
/// mm: what an edge of a face sweeps may intersect the face elsewhere, but not nearer to the edge.
constexpr double kTouch = 1e-3;

using Crossings = std::map<int, std::vector<Crossing>>;  // by profile

// A face of the body, seen along the move.
struct SeenFace {
  const CapFace* cap;
  TopTools_IndexedMapOfShape edges;
  std::vector<int> border;  // profiles
  ProfileBox box;
  std::unique_ptr<IntCurvesFace_Intersector> hits;
};

class Sections {
 public:
  Sections(const std::vector<CapFace>& caps, const std::vector<TopoDS_Edge>& sweeping,
           const std::vector<TopoDS_Edge>& borders, const gp_Vec& shift, const Sides& sides)
      : shift_(shift), projection_(shift), sides_(sides) {
    for (const TopoDS_Edge& edge : borders) {
      if (index_.Add(edge) > static_cast<int>(profiles_.size()))
        profiles_.emplace_back(edge, projection_);
    }
    for (const TopoDS_Edge& edge : sweeping) sweeping_.push_back(index_.FindIndex(edge) - 1);
    place_.assign(profiles_.size(), -1);
    for (std::size_t i = 0; i < sweeping_.size(); ++i) place_[sweeping_[i]] = static_cast<int>(i);
    for (const CapFace& cap : caps) {
      SeenFace& face = faces_.emplace_back();
      face.cap = &cap;
      TopExp::MapShapes(cap.face, TopAbs_EDGE, face.edges);
      for (int k = 1; k <= face.edges.Extent(); ++k) {
        const int e = index_.FindIndex(face.edges(k)) - 1;
        if (e < 0) continue;  // degenerated
        face.border.push_back(e);
        face.box.add(profiles_[e].box);
      }
      face.hits = std::make_unique<IntCurvesFace_Intersector>(cap.face, Precision::Confusion());
    }
  }

  std::vector<StraightSection> find() {
    findCrossings();
    for (std::size_t i = 0; i < sweeping_.size(); ++i) {
      for (const auto& [e, crossings] : crossings_[i]) {
        if (place_[e] <= static_cast<int>(i)) continue;
        for (const Crossing& crossing : crossings)
          addLines(static_cast<int>(i), place_[e], crossing);
      }
      for (std::size_t f = 0; f < faces_.size(); ++f)
        addFaceSections(static_cast<int>(i), static_cast<int>(f));
    }
    return std::move(found_);
  }

 private:
  void findCrossings() {
    crossings_.resize(sweeping_.size());
    for (std::size_t i = 0; i < sweeping_.size(); ++i) {
      const int own = sweeping_[i];
      for (int e = 0; e < static_cast<int>(profiles_.size()); ++e) {
        // Both of two sweeping edges must have the same crossings, to the last bit.
        if (e == own || (place_[e] >= 0 && place_[e] < static_cast<int>(i))) continue;
        std::vector<Crossing> crossings = crossingsOf(profiles_[own], profiles_[e], projection_);
        if (crossings.empty()) continue;
        if (place_[e] >= 0) {
          for (const Crossing& c : crossings) crossings_[place_[e]][own].push_back({c.b, c.a});
        }
        crossings_[i][e] = std::move(crossings);
      }
    }
  }

  double alongOf(const gp_Vec& v) const { return v.Dot(shift_) / shift_.SquareMagnitude(); }

  bool hitsAt(const SeenFace& face, const gp_Pnt& p) const {
    constexpr double kFar = 1e6;  // mm
    face.hits->Perform(gp_Lin(p, projection_.direction()), -kFar, kFar);
    return face.hits->IsDone();
  }

  // Adds the parts of the line in which what two edges sweep intersects. Faces of the body at both
  // ends of the move divide the line.
  void addLines(int i, int j, const Crossing& at) {
    const PlaneProfile &a = profiles_[sweeping_[i]], &b = profiles_[sweeping_[j]];
    gp_Pnt p, q;
    gp_Vec alongA, alongB;
    a.curve.D1(at.a, p, alongA);
    b.curve.D1(at.b, q, alongB);
    // At a common vertex, the line is a common edge already.
    if (p.Distance(q) < Precision::Confusion() && a.isEnd(at.a) && b.isEnd(at.b)) return;
    const double between = alongOf(gp_Vec(p, q));
    const double from = std::max(0.0, between), until = std::min(1.0, 1 + between);
    std::vector<double> ends{from, until};
    ProfileBox place;
    place.add(projection_.of(p));
    for (const SeenFace& face : faces_) {
      if (!face.box.overlaps(place) || !hitsAt(face, p)) continue;
      for (int h = 1; h <= face.hits->NbPnt(); ++h) {
        const double along = face.hits->WParameter(h) / shift_.Magnitude();
        for (const double hit : {along, along + 1}) {
          if (hit > from && hit < until) ends.push_back(hit);
        }
      }
    }
    std::sort(ends.begin(), ends.end());
    const double least = kShortestLine / shift_.Magnitude();
    std::size_t k = 0;
    for (std::size_t next = 1; next < ends.size(); ++next) {
      if (ends[next] - ends[k] < least) continue;
      const gp_Pnt middle = p.Translated(shift_ * ((ends[k] + ends[next]) / 2));
      if (sides_.isEdge(middle, projection_.across(alongA), projection_.across(alongB))) {
        BRepBuilderAPI_MakeEdge maker(p.Translated(shift_ * ends[k]),
                                      p.Translated(shift_ * ends[next]));
        if (maker.IsDone()) found_.push_back({maker.Edge(), i, j});
      }
      k = next;
    }
  }

  // Returns where sections of the face with what an edge sweeps may end, by increasing parameter of
  // the edge.
  std::vector<FaceSection::End> endsOf(int i, const SeenFace& face) const {
    const int own = sweeping_[i];
    const PlaneProfile& profile = profiles_[own];
    const TopoDS_Face& cap = face.cap->face;
    std::vector<FaceSection::End> ends;
    for (const double t : {profile.from(), profile.to()}) {
      FaceSection::End& end = ends.emplace_back();
      end.t = t;
      for (TopExp_Explorer v(cap, TopAbs_VERTEX); v.More() && end.border.empty(); v.Next()) {
        const TopoDS_Vertex& vertex = TopoDS::Vertex(v.Current());
        const gp_Pnt at = BRep_Tool::Pnt(vertex);
        if (at.Distance(profile.pointAt(t)) > Precision::Confusion()) continue;
        ShapeAnalysis_Surface surface(BRep_Tool::Surface(cap));
        end.border.push_back(
            {at, surface.ValueOfUV(at, Precision::Confusion()), BRep_Tool::Tolerance(vertex)});
      }
    }
    for (const auto& [e, crossings] : crossings_[i]) {
      if (place_[e] < 0) continue;
      for (const Crossing& crossing : crossings) {
        FaceSection::End& end = ends.emplace_back();
        end.t = crossing.a;
        if (place_[e] < i) end.other = {&profiles_[e], crossing.b};
      }
    }
    for (const int e : face.border) {
      const auto it = crossings_[i].find(e);
      double first, last;
      const Handle(Geom2d_Curve) on =
          BRep_Tool::CurveOnSurface(profiles_[e].edge, cap, first, last);
      if (it == crossings_[i].end() || on.IsNull()) continue;
      const double tolerance = BRep_Tool::Tolerance(profiles_[e].edge);
      for (const Crossing& crossing : it->second) {
        FaceSection::End& end = ends.emplace_back();
        end.t = crossing.a;
        end.border.push_back({profiles_[e].pointAt(crossing.b), on->Value(crossing.b), tolerance});
      }
    }
    return joined(std::move(ends), 1e-8 * (profile.to() - profile.from()));
  }

  // Joins ends at one parameter.
  static std::vector<FaceSection::End> joined(std::vector<FaceSection::End> ends, double least) {
    std::stable_sort(ends.begin(), ends.end(),
                     [](const auto& a, const auto& b) { return a.t < b.t; });
    std::vector<FaceSection::End> apart;
    for (const FaceSection::End& end : ends) {
      if (apart.empty() || end.t - apart.back().t >= least) {
        apart.push_back(end);
        continue;
      }
      auto& border = apart.back().border;
      border.insert(border.end(), end.border.begin(), end.border.end());
      if (end.other.first != nullptr) apart.back().other = end.other;
    }
    return apart;
  }

  void addFaceSections(int i, int f) {
    const SeenFace& face = faces_[f];
    const PlaneProfile& profile = profiles_[sweeping_[i]];
    if (!profile.box.overlaps(face.box)) return;
    const bool isBorder = face.edges.Contains(profile.edge);
    const std::vector<FaceSection::End> ends = endsOf(i, face);
    const FaceSection section(profile, face.cap->face, projection_);
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
      const double t = (ends[k].t + ends[k + 1].t) / 2;
      if (!hitsAt(face, profile.curve.Value(t))) continue;
      for (int h = 1; h <= face.hits->NbPnt(); ++h) {
        if (face.hits->State(h) != TopAbs_IN) continue;
        FaceSection::State middle{t, face.hits->UParameter(h), face.hits->VParameter(h),
                                  face.hits->WParameter(h)};
        // What an edge of the face sweeps touches the face there.
        if (isBorder && std::abs(middle.along) < kTouch) continue;
        if (section.solve(middle, t)) addSection(i, f, section, ends[k], ends[k + 1], middle);
      }
    }
  }

  void addSection(int i, int f, const FaceSection& section, const FaceSection::End& from,
                  const FaceSection::End& to, const FaceSection::State& middle) {
    const CapFace& cap = *faces_[f].cap;
    const bool atStart = cap.atStart && middle.along >= 0 && isEdge(section, from, to, middle, {});
    const bool atEnd = cap.atEnd && middle.along <= 0 && isEdge(section, from, to, middle, shift_);
    if (!atStart && !atEnd) return;
    const auto edge = section.between(from, to, middle);
    if (!edge) return;
    if (atStart) found_.push_back({*edge, i, -1, f, false});
    if (!atEnd) return;
    gp_Trsf move;
    move.SetTranslation(shift_);
    found_.push_back({TopoDS::Edge(edge->Moved(TopLoc_Location(move))), i, -1, f, true});
  }

  // Returns whether a part of the section, moved, is an edge of the swept volume.
  bool isEdge(const FaceSection& section, const FaceSection::End& from, const FaceSection::End& to,
              const FaceSection::State& middle, const gp_Vec& move) const {
    constexpr double kParts[] = {0.5,  0.005, 0.02, 0.07, 0.15, 0.25, 0.35, 0.45,
                                 0.55, 0.65,  0.75, 0.85, 0.93, 0.98, 0.995};
    return std::any_of(std::begin(kParts), std::end(kParts), [&](double part) {
      FaceSection::State at = middle;
      if (!section.solve(at, from.t + part * (to.t - from.t))) return false;
      const gp_Vec tangent = section.tangentAt(at);
      return sides_.isEdge(section.pointAt(at).Translated(move),
                           section.normalOfFace(at).Crossed(tangent),
                           section.normalOfSwept(at).Crossed(tangent));
    });
  }

  const gp_Vec shift_;
  const Projection projection_;
  const Sides& sides_;
  TopTools_IndexedMapOfShape index_;  // of the edges, from 1
  std::deque<PlaneProfile> profiles_;
  std::vector<int> sweeping_;  // profiles
  std::vector<int> place_;     // by profile: its place among the sweeping ones, or -1
  std::deque<SeenFace> faces_;
  std::vector<Crossings> crossings_;  // by sweeping edge
  std::vector<StraightSection> found_;
};

}  // namespace

std::vector<StraightSection> straightSections(const std::vector<CapFace>& caps,
                                              const std::vector<TopoDS_Edge>& sweeping,
                                              const std::vector<TopoDS_Edge>& borders,
                                              const gp_Vec& shift, const Sides& sides) {
  return Sections(caps, sweeping, borders, shift, sides).find();
}

}  // namespace swept::step
