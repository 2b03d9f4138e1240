// The sweep line is thought of as tilted a little, as in segments_any_by_sweep.cpp. No two edges cross, so their order
// on it is fixed. At a point at most one edge passes that does not end there, as two would cross or overlap; in the
// list it stands next to those that end or begin there.
#include <sunder/base/error.h>
#include <sunder/planar/set/ring_points.h>
#include <sunder/planar/sweep/ends_in_order.h>
#include <sunder/planar/sweep/sweep_status.h>
#include <sunder/predicate/orient.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace sunder::planar {

void RingSet::add(std::uint32_t part, std::uint32_t number, std::span<const Point2> vertices) {
  const auto fail = [&](ErrorCode code, const char* what, std::size_t vertex) {
    throw Error(
        code, what,
        "part " + std::to_string(part) + ", ring " + std::to_string(number) + ", vertex " + std::to_string(vertex));
  };
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    if (std::isfinite(vertices[k].x) && std::isfinite(vertices[k].y)) continue;
    fail(ErrorCode::bad_value, "a coordinate is not finite; every number must be: repair the data", k);
  }
  if (vertices.size() > 1 && vertices.front() == vertices.back()) vertices = vertices.first(vertices.size() - 1);
  if (vertices_.size() + vertices.size() >= std::size_t{1} << 31) {
    fail(ErrorCode::bad_shape, "there are 2^31 vertices or more; ask of fewer", vertices.size());
  }
  const std::uint32_t begin = size();
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const bool is_repeated = vertices[k] == vertices[k + 1 == vertices.size() ? 0 : k + 1];
    if (is_repeated && (k + 1 < vertices.size() || size() > begin)) continue;
    vertices_.push_back(vertices[k]);
    given_.push_back(static_cast<std::uint32_t>(k));
  }
  ring_of_.resize(vertices_.size(), static_cast<std::uint32_t>(rings_.size()));
  rings_.push_back({part, number, static_cast<std::uint32_t>(vertices.size()), begin, size()});
}

RingSet RingSet::only(const std::vector<bool>& keep) const {
  RingSet some;
  for (std::size_t r = 0; r < rings_.size(); ++r) {
    if (!keep[r]) continue;
    const Ring& ring = rings_[r];
    const std::uint32_t begin = some.size();
    for (std::uint32_t k = ring.begin; k < ring.end; ++k) {
      some.vertices_.push_back(vertices_[k]);
      some.given_.push_back(given_[k]);
    }
    some.ring_of_.resize(some.vertices_.size(), static_cast<std::uint32_t>(some.rings_.size()));
    some.rings_.push_back({ring.part, ring.number, ring.given, begin, some.size()});
  }
  return some;
}

namespace {

class Sweep {
 public:
  explicit Sweep(const RingSet& rings) : rings_(rings), edges_(edges_of(rings)), status_(edges_) {}

  RingPoints run() {
    const std::vector<std::uint32_t> ends = ends_in_order(edges_);
    for (std::size_t k = 0, last; k < ends.size(); k = last) {
      for (last = k + 1; last < ends.size() && end_point(edges_, ends[last]) == end_point(edges_, ends[k]);) ++last;
      pass(end_point(edges_, ends[k]), {ends.data() + k, last - k});
    }
    return std::move(found_);
  }

 private:
  static constexpr std::uint32_t none = RingPoints::no_edge;
  static_assert(SweepStatus<Segment>::none == none);

  static std::vector<Segment> edges_of(const RingSet& rings) {
    std::vector<Segment> edges;
    edges.reserve(rings.size());
    for (std::uint32_t k = 0; k < rings.size(); ++k) edges.push_back(rings.edge(k));
    return edges;
  }

  void pass(const Point2& p, std::span<const std::uint32_t> ends) {
    std::uint32_t through = none;
    std::size_t begun = 0;
    for (std::size_t k = 0; k < ends.size(); ++k) {
      const bool ends_here = ends[k] % 2 == 1;
      const auto around = ends_here ? status_.erase(ends[k] / 2) : insert(ends[k] / 2);
      const bool is_last_to_end = ends_here && (k + 1 == ends.size() || ends[k + 1] % 2 == 0);
      if (is_last_to_end || (!ends_here && k == 0)) through = edge_through(p, around);
      begun += ends_here ? 0 : 1;
    }
    if (ends.size() > 2 || begun == 2 || through != none) add_point(p, ends, through);
  }

  SweepStatus<Segment>::Neighbours insert(std::uint32_t e) {
    return status_.insert(e, [&](const Segment& other) {
      ++found_.cost.probes;
      const Sign begins = orient_2d(other.a, other.b, edges_[e].a);
      return (begins == Sign::zero ? orient_2d(other.a, other.b, edges_[e].b) : begins) == Sign::positive;
    });
  }

  std::uint32_t edge_through(const Point2& p, const SweepStatus<Segment>::Neighbours& around) {
    for (const std::uint32_t e : {around.below, around.above}) {
      if (e == none) continue;
      ++found_.cost.probes;
      if (orient_2d(edges_[e].a, edges_[e].b, p) == Sign::zero) return e;
    }
    return none;
  }

  void add_point(const Point2& p, std::span<const std::uint32_t> ends, std::uint32_t through) {
    const std::uint32_t first = static_cast<std::uint32_t>(found_.ways.size());
    for (const std::uint32_t end : ends) {
      const std::uint32_t e = end / 2;
      const bool forward = rings_.increases(e) == (end % 2 == 0);
      found_.ways.push_back({e, forward, forward ? e : rings_.next(e)});
    }
    if (through != none) {
      for (const bool forward : {false, true}) found_.ways.push_back({through, forward, rings_.size() + through});
    }
    const auto goes_right = [&](const RingWay& w) { return rings_.increases(w.edge) == w.forward; };
    const auto end_of = [&](const RingWay& w) { return rings_.vertex(w.forward ? rings_.next(w.edge) : w.edge); };
    const auto begin = found_.ways.begin() + first;
    std::sort(begin, found_.ways.end(), [&](const RingWay& v, const RingWay& w) {
      if (goes_right(v) != goes_right(w)) return goes_right(v);
      return orient_2d(p, end_of(v), end_of(w)) == Sign::positive;
    });
    const auto right = static_cast<std::uint32_t>(std::count_if(begin, found_.ways.end(), goes_right));
    const std::uint32_t below = right > 0 ? status_.neighbours_of(found_.ways[first].edge).below : none;
    found_.points.push_back({p, first, static_cast<std::uint32_t>(found_.ways.size()) - first, right, below});
  }

  const RingSet& rings_;
  const std::vector<Segment> edges_;
  SweepStatus<Segment> status_;
  RingPoints found_;
};

}  // namespace

RingPoints ring_points(const RingSet& rings) { return Sweep(rings).run(); }

}  // namespace sunder::planar
