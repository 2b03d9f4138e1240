// The sweep line is thought of as tilted a little, as in segments_any_by_sweep.cpp. No two edges cross, so their order
// on it is fixed. At a point at most one edge passes that does not end there, as two would cross or overlap; in the
// list it stands next to those that end or begin there.
#include <sunder/base/error.h>
#include <sunder/planar/polygons/ring_points.h>
#include <sunder/planar/sweep/ends_in_order.h>
#include <sunder/planar/sweep/sweep_status.h>
#include <sunder/predicate/point/orient.h>

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

std::vector<Segment> RingSet::edges() const {
  std::vector<Segment> edges;
  edges.reserve(size());
  for (std::uint32_t k = 0; k < size(); ++k) edges.push_back(edge(k));
  return edges;
}

namespace {

class Sweep {
 public:
  Sweep(const RingSet& rings, std::span<const Segment> edges) : rings_(rings), edges_(edges), status_(edges) {}

  RingPoints run(std::span<const std::uint32_t> ends) {
    found_.ways.reserve(ends.size());
    for (std::size_t k = 0, last; k < ends.size(); k = last) {
      for (last = k + 1; last < ends.size() && end_point(edges_, ends[last]) == end_point(edges_, ends[k]);) ++last;
      pass(end_point(edges_, ends[k]), {ends.data() + k, last - k});
    }
    return std::move(found_);
  }

 private:
  static constexpr std::uint32_t none = RingPoints::no_edge;
  static_assert(SweepStatus<Segment>::none == none);

  // Ends come in their order: edges that end here before those that begin.
  void pass(const Point2& p, std::span<const std::uint32_t> ends) {
    const auto first_to_begin = std::partition_point(ends.begin(), ends.end(), [](auto end) { return end % 2 == 1; });
    const std::span<const std::uint32_t> ended(ends.begin(), first_to_begin), begun(first_to_begin, ends.end());
    SweepStatus<Segment>::Neighbours around;
    for (const std::uint32_t end : ended) around = status_.erase(end / 2);
    begun_.assign(begun.begin(), begun.end());
    for (std::uint32_t& e : begun_) e /= 2;
    std::sort(begun_.begin(), begun_.end(), [&](std::uint32_t e, std::uint32_t f) {
      ++found_.cost.probes;
      return orient_2d(p, edges_[e].b, edges_[f].b) == Sign::positive;
    });
    if (!begun_.empty()) {
      const auto of_first = insert(begun_[0]);
      if (ended.empty()) around = of_first;
    }
    const std::uint32_t through = edge_through(p, around);
    for (std::size_t k = 1; k < begun_.size(); ++k) {  // nothing is between them but an edge through the point
      if (through == none) {
        status_.insert_above(begun_[k - 1], begun_[k]);
      } else {
        insert(begun_[k]);
      }
    }
    if (ends.size() > 2 || begun.size() == 2 || through != none) add_point(p, ended, through);
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

  // Those that begin are in begun_, in their order.
  void add_point(const Point2& p, std::span<const std::uint32_t> ended, std::uint32_t through) {
    std::vector<RingWay>& ways = found_.ways;
    const std::size_t first = ways.size();
    const auto add_way = [&](std::uint32_t e, bool goes_right) {
      const bool forward = rings_.increases(e) == goes_right;
      const std::uint32_t pass = e == through ? rings_.size() + e : forward ? e : rings_.next(e);
      ways.push_back({e, forward, pass});
    };
    const auto put_in_order = [&](std::size_t from) {
      const auto end_of = [&](const RingWay& w) { return rings_.vertex(w.forward ? rings_.next(w.edge) : w.edge); };
      std::sort(ways.begin() + static_cast<std::ptrdiff_t>(from), ways.end(), [&](const RingWay& v, const RingWay& w) {
        ++found_.cost.probes;
        return orient_2d(p, end_of(v), end_of(w)) == Sign::positive;
      });
    };
    for (const std::uint32_t e : begun_) add_way(e, true);
    if (through != none) {
      add_way(through, true);
      put_in_order(first);
    }
    const std::size_t left = ways.size();
    for (const std::uint32_t end : ended) add_way(end / 2, false);
    if (through != none) add_way(through, false);
    put_in_order(left);
    const auto right = static_cast<std::uint32_t>(left - first);
    const std::uint32_t below = right > 0 ? status_.neighbours_of(ways[first].edge).below : none;
    found_.points.push_back(
        {p, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(ways.size() - first), right, below});
  }

  const RingSet& rings_;
  const std::span<const Segment> edges_;
  SweepStatus<Segment> status_;
  std::vector<std::uint32_t> begun_;  // of the present point: those that begin, from the lowest
  RingPoints found_;
};

}  // namespace

RingPoints ring_points(const RingSet& rings) {
  const std::vector<Segment> edges = rings.edges();
  return ring_points(rings, edges, ends_in_order(edges));
}

RingPoints ring_points(const RingSet& rings, std::span<const Segment> edges, std::span<const std::uint32_t> ends) {
  return Sweep(rings, edges).run(ends);
}

}  // namespace sunder::planar
