// What parts the section of the body from the polygon (section_against.h) is a side of the section, which is in a facet
// of the body, and then the facet's plane does; or a side of the polygon at a vertex of the section, which is on an
// edge of the body: then the plane along both does (Lemma 12, its first case).
#include <sunder/predicate/coordinates.h>
#include <sunder/solid/pair/polyhedron_polygon.h>
#include <sunder/solid/pair/polyhedron_polyhedron_answer.h>
#include <sunder/solid/represent/drums.h>
#include <sunder/solid/represent/of.h>
#include <sunder/solid/section/section_against.h>

#include <algorithm>
#include <array>
#include <optional>

namespace sunder::solid {

namespace {

template <class Real>
class PolygonByDrums {
 public:
  PolygonByDrums(const Placed& body, const Placed& polygon, Cost& cost)
      : body_(body),
        polygon_(polygon),
        cost_(cost),
        drums_(represent::of<Drums>(body.body)),
        search_(drums_, body.body.vertices(), cost),
        frame_(body.pose, drums_.shrink()),
        thirds_(thirds_of(polygon.body.facet(0))),
        proposals_(body) {
    const auto image = rounded_image(polygon[thirds_[0]]);
    from_ = {image.x, image.y, image.z};
    const auto way = [&](std::uint32_t v) {
      return frame_.way_to_image<Real>(from_, polygon.pose, polygon.graph.vertices[v]);
    };
    point_ = way(thirds_[0]);
    normal_ = scaled_to_one(cross_of<Real>(minus(way(thirds_[1]), point_), minus(way(thirds_[2]), point_)));
  }

  bool propose(const Holds& holds) const {
    const auto base = frame_.way_to_image<Real>(from_, search_.vertex(drums_.vertex_of(0)));
    const SectionAgainst<Real> against(search_, frame_, base, normal_, point_, cost_);
    const FlatSequence<Real> r(polygon_, frame_, from_, against.axes()[0], against.axes()[1], frame_.reflects(), cost_);
    return against.run(r, Found{*this, r, holds});
  }

 private:
  struct Found {
    const PolygonByDrums& search;
    const FlatSequence<Real>& r;
    const Holds& holds;

    bool beside(std::uint32_t v, bool is_above) const { return holds(search.beside(v, is_above)); }

    template <class Sequence>
    bool meet(const Sequence& q, const CommonVertices& found) const {
      return propose_common_point<Real>(search.body_, q, search.polygon_, r, found, holds);
    }

    bool parted(const PocketSequence<Real>& q, const Separation& found) const {
      if (propose_touch<Real>(search.body_, q, search.polygon_, r, found, holds)) return true;
      const std::uint32_t n = q.size(), near = r.vertex(found.extreme_b);
      const auto by_side = [&](std::uint32_t k) {
        const std::optional<std::uint32_t> facet = q.facet_behind(k);
        return facet && holds(search.proposals_.beyond_facet(*facet, near));
      };
      if (found.direction.kind == Direction::Kind::side_of_a) return by_side(found.direction.index[0]);
      const std::uint32_t k = found.extreme_a, j = found.direction.index[0];
      if (found.direction.kind == Direction::Kind::side_of_b) {
        const std::optional<std::array<std::uint32_t, 2>> e = q.edge_at(k);
        const std::array<std::uint32_t, 2> side{r.vertex(j), r.vertex(j + 1 < r.size() ? j + 1 : 0)};
        if (e && holds(search.proposals_.beyond_edge(*e, side, side[0]))) return true;
      }
      return by_side(k) || by_side(k > 0 ? k - 1 : n - 1) || holds(apart_at_vertices(vertex_near(q, k), near));
    }

    static std::uint32_t vertex_near(const PocketSequence<Real>& q, std::uint32_t k) {
      std::uint32_t near = 0;
      q.add_parts(k, [&](std::uint32_t v, const Real& w) { near = w > Real(0.5) ? v : near; });
      return near;
    }
  };

  // All of the body is on one side of T.
  Proposal beside(std::uint32_t v, bool is_above) const {
    Proposal p{Proposal::Claim::apart_along_normal_of_b, 0, 3, {}, v, thirds_[0], {}, {}};
    std::copy(thirds_.begin(), thirds_.end(), p.vertices.begin());
    p.direction = frame_.in_world_as_normal(rounded(is_above ? negated(normal_) : normal_));
    return p;
  }

  const Placed &body_, &polygon_;
  Cost& cost_;
  const Drums& drums_;
  DrumSearch search_;
  ScaledPose frame_;
  std::array<std::uint32_t, 3> thirds_;
  SectionProposals proposals_;
  Point3 from_;
  VectorOf<Real> point_{}, normal_{};
};

}  // namespace

PairAnswer polyhedron_polygon_by_drums(const ConvexPolyhedron& body, const Pose& pose,  //
                                       const ConvexPolyhedron& polygon, const Pose& pose_of_polygon) {
  const Placed a(body, pose), b(polygon, pose_of_polygon);
  if (body.dimension() < 3 || polygon.dimension() != 2) {
    return answer_by(a, b, [](const Holds&, Cost&) { return false; });
  }
  return answer_by(a, b, [&](const Holds& holds, Cost& cost) {
    return PolygonByDrums<double>(a, b, cost).propose(holds) || PolygonByDrums<DoubleDouble>(a, b, cost).propose(holds);
  });
}

}  // namespace sunder::solid
