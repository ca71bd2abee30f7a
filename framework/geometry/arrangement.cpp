#include "geometry/arrangement.hpp"

#include <CGAL/Arr_consolidated_curve_data_traits_2.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <algorithm>
#include <unordered_map>

#include "geometry/face_point.hpp"
#include "geometry/snap.hpp"

namespace ashlar::geometry {

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Traits = CGAL::Arr_consolidated_curve_data_traits_2<CGAL::Arr_segment_traits_2<Kernel>, Index>;
using Exact = CGAL::Arrangement_2<Traits>;

bool runs_left_to_right(Point a, Point b) {
  return a.x < b.x || (a.x == b.x && a.y < b.y);
}

double rounded(const Kernel::FT& x) {
  x.exact();
  return CGAL::to_double(x);
}

Exact build(std::span<const Piece> pieces) {
  std::vector<Traits::Curve_2> curves;
  curves.reserve(pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Point a = pieces[i].from, b = pieces[i].to;
    const CGAL::Arr_segment_traits_2<Kernel>::Curve_2 curve(Kernel::Point_2(a.x, a.y),
                                                            Kernel::Point_2(b.x, b.y));
    curves.emplace_back(curve, static_cast<Index>(i));
  }
  Exact exact;
  CGAL::insert(exact, curves.begin(), curves.end());
  return exact;
}

// Turns CGAL's half-edge structure into ours; numbers follow its (deterministic) order.
class Reader {
 public:
  Reader(const Exact& exact, std::span<const Piece> pieces) : exact_(exact), pieces_(pieces) {}

  Arrangement read() {
    for (auto v = exact_.vertices_begin(); v != exact_.vertices_end(); ++v) {
      vertices_[&*v] = static_cast<Index>(result_.points.size());
      result_.points.push_back({rounded(v->point().x()), rounded(v->point().y())});
    }
    faces_[&*exact_.unbounded_face()] = 0;
    for (auto f = exact_.faces_begin(); f != exact_.faces_end(); ++f) {
      if (!f->is_unbounded()) faces_.emplace(&*f, static_cast<Index>(faces_.size()));
    }
    for (auto e = exact_.edges_begin(); e != exact_.edges_end(); ++e) add_segment(e);
    result_.faces.resize(faces_.size());
    for (auto f = exact_.faces_begin(); f != exact_.faces_end(); ++f) add_face(f);
    return std::move(result_);
  }

 private:
  void add_segment(Exact::Edge_const_iterator e) {
    Exact::Halfedge_const_handle h = e;
    if (h->direction() != CGAL::ARR_LEFT_TO_RIGHT) h = h->twin();
    const auto number = static_cast<Index>(result_.segments.size());
    segments_[&*h] = number;
    segments_[&*h->twin()] = -1 - number;
    Arrangement::Segment segment;
    segment.from = vertices_.at(&*h->source());
    segment.to = vertices_.at(&*h->target());
    segment.left = faces_.at(&*h->face());
    segment.right = faces_.at(&*h->twin()->face());
    for (auto d = h->curve().data().begin(); d != h->curve().data().end(); ++d) {
      const Piece& piece = pieces_[static_cast<std::size_t>(*d)];
      const bool along = runs_left_to_right(piece.from, piece.to);
      for (const Index source : piece.sources) {
        segment.sources.push_back(along == (source >= 0) ? std::max(source, -1 - source)
                                                         : std::min(source, -1 - source));
      }
    }
    std::sort(segment.sources.begin(), segment.sources.end());
    segment.sources.erase(std::unique(segment.sources.begin(), segment.sources.end()), segment.sources.end());
    result_.segments.push_back(std::move(segment));
  }

  void add_face(Exact::Face_const_iterator f) {
    Arrangement::Face& face = result_.faces[static_cast<std::size_t>(faces_.at(&*f))];
    for (auto c = f->outer_ccbs_begin(); c != f->outer_ccbs_end(); ++c) face.outer = ring(*c);
    for (auto c = f->inner_ccbs_begin(); c != f->inner_ccbs_end(); ++c) face.inner.push_back(ring(*c));
    if (!f->is_unbounded()) face.inside = point_inside(result_, face);
  }

  std::vector<Index> ring(Exact::Ccb_halfedge_const_circulator first) const {
    std::vector<Index> entries;
    auto h = first;
    do entries.push_back(segments_.at(&*h));
    while (++h != first);
    return entries;
  }

  const Exact& exact_;
  std::span<const Piece> pieces_;
  Arrangement result_;
  std::unordered_map<const Exact::Vertex*, Index> vertices_;
  std::unordered_map<const Exact::Halfedge*, Index> segments_;
  std::unordered_map<const Exact::Face*, Index> faces_;
};

std::vector<Piece> pieces_of(const Arrangement& arrangement) {
  std::vector<Piece> pieces;
  for (const auto& s : arrangement.segments) {
    pieces.push_back({arrangement.points[static_cast<std::size_t>(s.from)],
                      arrangement.points[static_cast<std::size_t>(s.to)], s.sources});
  }
  return pieces;
}

}  // namespace

Arrangement arrange(std::span<const InputSegment> segments, double snap) {
  std::vector<Piece> pieces;
  for (const auto& s : segments) {
    if (s.from != s.to) pieces.push_back({s.from, s.to, {s.source}});
  }
  if (snap > 0) snap_pieces(pieces, snap);
  for (int round = 0;; ++round) {
    const Exact exact = build(pieces);
    Arrangement result = Reader(exact, pieces).read();
    // Crossings nearer than `snap` to each other are one point too: merge them and arrange again.
    if (snap <= 0 || round == 4 || !has_close_points(result.points, snap)) return result;
    pieces = pieces_of(result);
    snap_pieces(pieces, snap);
  }
}

}  // namespace ashlar::geometry
