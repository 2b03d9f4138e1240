// Which planes through a line support a body, by drums: a search in slices proposes a vertex, and steps of Newton's
// method around the line, each a search in slices for an extreme vertex (Lemmas 6 and 7), go on from there.
//
// Theorem: a half-plane around the line is turned until it leaves a slice, at a corner on lateral edge e. What the body
// has past it is all above the slice where e is past it above, and all below where e is past it below.
// Proof: both facets at e have the body behind them, and what is behind both and past the half-plane is convex, has
// nothing in the slice, and has the rest of e on that side. So the search halves the drums.
#include <sunder/solid/line/line_support_search.h>
#include <sunder/solid/line/polyhedron_line.h>
#include <sunder/solid/represent/drums.h>
#include <sunder/solid/represent/of.h>
#include <sunder/solid/search/drum_search.h>

namespace sunder::solid {

namespace {

struct FurthestByDrums {
  template <class Real>
  static std::uint32_t along(const Placed& body, const VectorOf<Real>& d, std::uint32_t, Cost& cost) {
    const Drums& drums = represent::of<Drums>(body.body);
    const Point3& by = drums.shrink();
    const VectorOf<Real> seen{d.x * Real(1 / by.x), d.y * Real(1 / by.y), d.z * Real(1 / by.z)};
    return DrumSearch(drums, body.body.vertices(), cost).furthest_vertex<Real>(seen, [](std::uint32_t) {
      return false;
    });
  }
};

Point3 each_times(const Point3& p, const Point3& by) { return {p.x * by.x, p.y * by.y, p.z * by.z}; }

// Points are about the middle of the facet graph, in the scale in which drums see the body, and doubles: nothing is
// decided here.
class TangentsOfSlices {
 public:
  // Keeps references.
  TangentsOfSlices(LineSupportSearch& search, Sign side)
      : search_(search),
        side_(side),
        graph_(represent::of<FacetGraph>(search.body().body)),
        slices_(represent::of<Drums>(search.body().body), search.body().body.vertices(), search.cost()) {
    const LineInFrame<double> line(search.body(), graph_, search.line());
    const Point3 &one = graph_.to_one, &by = slices_.drums().shrink();
    const Point3 to_drums{by.x / one.x, by.y / one.y, by.z / one.z};
    nearest_ = each_times(line.nearest, to_drums);
    way_ = each_times(line.way, to_drums);
    rise_ = dot(up(), way_);
    const Sign turn = (rise_ < 0 ? Sign::negative : Sign::positive) * determinant_sign(search.body().pose);
    is_most_left_ = turn == -side;
  }

  // A vertex about furthest past the line's half-planes. Cost: log2 of the number of drums times 4 log2 of the edges in
  // a drum, and some.
  std::uint32_t vertex() {
    const Drums& drums = slices_.drums();
    std::uint32_t low = 0, high = drums.drum_count();
    std::optional<std::uint32_t> best;
    while (low < high) {
      ++search_.cost().iterations;
      const std::uint32_t middle = low + (high - low) / 2;
      const LateralEdge& e = tangent_edge(middle);
      const bool rises = search_.past(e.low, e.high) == -side_;
      const std::uint32_t v = rises ? e.high : e.low;
      if (!best || search_.past(*best, v) == -side_) best = v;
      if (rises) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return *best;
  }

 private:
  // The lateral edge whose corner of the slice half-way up the drum is most to the left, or right, seen from the line.
  const LateralEdge& tangent_edge(std::uint32_t drum) const {
    const Drums& drums = slices_.drums();
    const std::uint32_t n = drums.size(drum);
    const double z = (dot(up(), at(drums.vertex_of(drum))) + dot(up(), at(drums.vertex_of(drum + 1)))) / 2;
    const auto corner = [&](std::uint32_t k) {
      const LateralEdge& e = slices_.edge(drum, k);
      const Point3 p = at(e.low), to = minus(at(e.high), p);
      const double whole = dot(up(), to);
      return along_by(p, to, whole == 0 ? 0.5 : (z - dot(up(), p)) / whole);
    };
    const Point3 p = corner(0), q = corner(n / 3), r = corner(n / 3 * 2);
    const Point3 inside{(p.x + q.x + r.x) / 3, (p.y + q.y + r.y) / 3, (p.z + q.z + r.z) / 3};
    // The side through which a ray from there leaves the slice.
    const auto side_along = [&](const Point3& d) {
      return (first_past(n, up(), d, [&](std::uint32_t k) { return minus(corner(k), inside); }) + n - 1) % n;
    };
    const Point3 out = to_line(inside, z);
    const std::uint32_t near = side_along(out), far = side_along(negated(out));
    const auto is_seen = [&](std::uint32_t side) {
      const LateralEdge& e = slices_.edge(drum, side);
      return dot(drums.normal(e.side), to_line(at(e.low), z)) > 0;
    };
    // Sides that are seen from the line are one run, counter-clockwise from the left to the right.
    const std::uint32_t from = is_most_left_ ? far : near, to = is_most_left_ ? near : far;
    const std::uint32_t steps = planar::first_where(
        1u, (to + n - from) % n, [&](std::uint32_t k) { return is_seen((from + k) % n) == is_most_left_; });
    return slices_.edge(drum, (from + steps) % n);
  }

  // From a point of the slice at height z to the line's, times a positive number; that of a level line is far away.
  Point3 to_line(const Point3& from, double z) const {
    const double along = z - dot(up(), nearest_), by = rise_ < 0 ? -1 : 1;
    const Point3 d = minus(nearest_, from);
    const auto part = [&](std::size_t i) { return by * (d[i] * rise_ + way_[i] * along); };
    return {part(0), part(1), part(2)};
  }
  Point3 at(std::uint32_t v) const {
    return each_times(minus(slices_.vertex(v), graph_.center), slices_.drums().shrink());
  }
  const Point3& up() const { return slices_.drums().up(); }

  LineSupportSearch& search_;
  Sign side_;
  const FacetGraph& graph_;
  DrumSearch slices_;
  Point3 nearest_, way_;  // the line
  double rise_ = 0;
  bool is_most_left_ = false;
};

}  // namespace

LineSupport polyhedron_line_support_by_drums(const ConvexPolyhedron& body, const Pose& pose, const Line& line) {
  return line_support_by(
      body, pose, line, polyhedron_line_by_drums(body, pose, line), FurthestByDrums{},
      [](LineSupportSearch& search, Sign side) { return std::optional(TangentsOfSlices(search, side).vertex()); });
}

}  // namespace sunder::solid
