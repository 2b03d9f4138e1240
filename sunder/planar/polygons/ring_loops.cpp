#include <sunder/planar/polygons/ring_loops.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>

namespace sunder::planar {

namespace {

constexpr std::uint32_t none = RingLoop::none;

// Where a ring comes to a point that it visits more than once. Of places on one edge the rank grows along the ring.
struct Visit {
  std::uint32_t edge;
  std::int64_t rank;
  std::uint32_t point;
};
bool operator<(const Visit& u, const Visit& v) { return std::tie(u.edge, u.rank) < std::tie(v.edge, v.rank); }

class Cut {
 public:
  Cut(const RingSet& rings, const RingPoints& points) : rings_(rings), points_(points) {
    collect_visits();
    std::sort(visits_.begin(), visits_.end());
    first_of_edge_.resize(rings.size() + std::size_t{1});
    for (const Visit& visit : visits_) ++first_of_edge_[visit.edge + std::size_t{1}];
    std::partial_sum(first_of_edge_.begin(), first_of_edge_.end(), first_of_edge_.begin());
    piece_.resize(visits_.size());
    visited_.resize(points.points.size(), none);
    for (std::uint32_t r = 0; r < rings.rings().size(); ++r) cut_ring(r);
    number_.resize(loops_.size(), none);
  }

  RingLoops run() {
    RingLoops result;
    for (std::uint32_t p = 0; p < points_.points.size(); ++p) {
      const RingPoint& point = points_.points[p];
      std::uint32_t below = none;  // the loop next below, at first that of the edge below
      bool below_increases = false;
      if (point.below != RingPoints::no_edge) {
        below_increases = rings_.increases(point.below);
        below = number_[loop_at(point.below, p, below_increases)];
      }
      for (std::uint32_t w = point.first; w < point.first + point.count; ++w) {
        const RingWay& way = points_.ways[w];
        const std::uint32_t loop = loop_at(way.edge, p, way.forward);
        if (number_[loop] == none) begin_loop(loop, w, below, below_increases, result);
        result.of_ways.push_back(number_[loop]);
        below = number_[loop];
        below_increases = way.forward;
      }
    }
    return result;
  }

 private:
  // Along the edge points come in their order, or against it.
  std::int64_t rank_at(std::uint32_t edge, std::uint32_t point) const {
    const std::int64_t rank = std::int64_t{point} + 1;
    return rings_.increases(edge) ? rank : -rank;
  }

  void collect_visits() {
    std::vector<RingWay> passes;  // of a point: each has one way forward
    for (std::uint32_t p = 0; p < points_.points.size(); ++p) {
      passes.clear();
      for (const RingWay& way : points_.ways_at(points_.points[p])) {
        if (way.forward) passes.push_back(way);
      }
      if (passes.size() < 2) continue;
      const auto ring_of = [&](const RingWay& way) { return rings_.ring_of(way.edge); };
      if (rings_.rings().size() > 1) {
        std::sort(passes.begin(), passes.end(),
                  [&](const RingWay& v, const RingWay& w) { return ring_of(v) < ring_of(w); });
      }
      for (std::size_t k = 0; k < passes.size(); ++k) {
        const bool again = (k > 0 && ring_of(passes[k - 1]) == ring_of(passes[k])) ||
                           (k + 1 < passes.size() && ring_of(passes[k + 1]) == ring_of(passes[k]));
        if (!again) continue;
        const bool is_vertex = passes[k].pass < rings_.size();
        visits_.push_back(
            {passes[k].edge, is_vertex ? std::numeric_limits<std::int64_t>::min() : rank_at(passes[k].edge, p), p});
      }
    }
  }

  // Pieces of the ring go from a visit to the next. When a point is visited again, those since are a loop.
  void cut_ring(std::uint32_t r) {
    const auto begin = first_visit_of(rings_.rings()[r].begin), end = first_visit_of(rings_.rings()[r].end);
    whole_.push_back(none);
    path_.clear();
    const auto take_since = [&](std::size_t depth) {
      for (std::size_t k = depth; k < path_.size(); ++k) {
        piece_[path_[k]] = static_cast<std::uint32_t>(loops_.size()) - 1;
        if (k > depth) visited_[visits_[path_[k]].point] = none;
      }
      path_.resize(depth);
    };
    for (auto visit = begin; visit != end; ++visit) {
      std::uint32_t& depth = visited_[visit->point];
      if (depth == none) {
        depth = static_cast<std::uint32_t>(path_.size());
      } else {
        loops_.push_back({r, visit->point, none, none});
        take_since(depth);
      }
      path_.push_back(static_cast<std::uint32_t>(visit - visits_.begin()));
    }
    if (begin == end) whole_.back() = static_cast<std::uint32_t>(loops_.size());
    loops_.push_back({r, none, none, none});
    take_since(0);
    if (begin != end) visited_[begin->point] = none;
  }

  // The first visit on the edge, or else the first one after it.
  std::vector<Visit>::const_iterator first_visit_of(std::uint32_t edge) const {
    return visits_.begin() + first_of_edge_[edge];
  }

  // The loop of what follows on the edge after the point, in the direction of its ring; or of what comes before.
  std::uint32_t loop_at(std::uint32_t edge, std::uint32_t point, bool after) const {
    const std::uint32_t ring = rings_.ring_of(edge);
    if (whole_[ring] != none) return whole_[ring];
    const Visit here{edge, rank_at(edge, point), point};
    const auto first = first_visit_of(edge), last = first_visit_of(edge + 1);
    const auto next = after ? std::upper_bound(first, last, here) : std::lower_bound(first, last, here);
    const bool is_first_of_ring = next == first_visit_of(rings_.rings()[ring].begin);
    const auto before = is_first_of_ring ? first_visit_of(rings_.rings()[ring].end) : next;
    return piece_[static_cast<std::size_t>(before - visits_.begin()) - 1];
  }

  // A loop is met at its first point, by the lower one of its two ways there. It runs counter-clockwise iff this one
  // leaves the point in the direction of its ring. Then its inside is to the left, which is above an edge that
  // increases.
  void begin_loop(std::uint32_t loop, std::uint32_t way, std::uint32_t below, bool below_increases, RingLoops& result) {
    number_[loop] = static_cast<std::uint32_t>(result.loops.size());
    loops_[loop].first = way;
    if (below != none) {
      const RingLoop& other = result.loops[below];
      const bool is_inside = points_.ways[other.first].forward == below_increases;
      loops_[loop].parent = is_inside ? below : other.parent;
    }
    result.loops.push_back(loops_[loop]);
  }

  const RingSet& rings_;
  const RingPoints& points_;
  std::vector<Visit> visits_;                 // along each ring
  std::vector<std::uint32_t> first_of_edge_;  // the first visit on the edge, or else the first one after it
  std::vector<std::uint32_t> whole_;          // of each ring: its only loop, where it is not cut
  std::vector<std::uint32_t> piece_;          // of each visit: the loop of the piece that follows
  std::vector<std::uint32_t> visited_;        // of each point: the place in the path of the piece since, or none
  std::vector<std::uint32_t> path_;           // of pieces of the ring, not yet of a loop
  std::vector<RingLoop> loops_;               // as they are cut
  std::vector<std::uint32_t> number_;         // of these, in the order of their first points
};

}  // namespace

RingLoops ring_loops(const RingSet& rings, const RingPoints& points) { return Cut(rings, points).run(); }

}  // namespace sunder::planar
