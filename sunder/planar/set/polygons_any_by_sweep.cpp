// Shamos & Hoey 1976, Theorem 7, with the details that the paper leaves to the implementor.
//
// The sweep is that of segments_any_by_sweep.cpp. Contacts of edges of one polygon are allowed, and are touches only;
// all others count. So the argument there holds: of the edges that hold the first point that counts, in their row, some
// two neighbours are of different polygons; ends of different polygons at one point are looked for among equal events.
//
// UP and DOWN of an edge are its polygon and nothing, or the other way round, known from the direction of its ring. A
// polygon lies in another one, without a contact of edges, only if its first vertex does: when all edges that begin
// there have entered, the lowest one has an edge of the other polygon below it, with the inside of that above.
//
// All that is for transcripts. Else PolygonSweep decides. Where contacts are allowed, a transcript is written once it
// has told that none counts, by a sweep without tests: along a common border run one edge that ends a polygon and one
// that begins another, at most; the former is put below the latter.
#include <sunder/planar/set/ends_in_order.h>
#include <sunder/planar/set/first_that_counts.h>
#include <sunder/planar/set/polygon_sweep.h>
#include <sunder/planar/set/polygons_any.h>
#include <sunder/planar/set/sweep_status.h>
#include <sunder/predicate/orient.h>

#include <algorithm>
#include <vector>

namespace sunder::planar {

namespace {

struct InStatus {
  Segment segment;
  std::uint32_t edge = 0;
};

class Sweep {
 public:
  // Testing: do contacts of edges of different polygons count? Else they are allowed, and are no crossings.
  Sweep(PolygonEdges& edges, bool testing, const PolygonsOptions& options, PolygonsAnswer& answer)
      : edges_(edges), testing_(testing), options_(options), keys_(keys_of(edges)), status_(keys_), answer_(answer) {}

  void run() {
    const std::span<const Segment> all = edges_.edges().all();
    const std::vector<std::uint32_t> ends = ends_in_order(all);
    for (std::size_t k = 0, begin = 0; k < ends.size() && !answer_.meet(); ++k) {
      if (options_.progress && k % 65536 == 0) {
        options_.progress(static_cast<double>(k) / static_cast<double>(ends.size()));
      }
      ends[k] % 2 == 0 ? enter(ends[k] / 2) : leave(ends[k] / 2);
      const bool more_here = k + 1 < ends.size() && end_point(all, ends[k]) == end_point(all, ends[k + 1]);
      if (more_here) {
        if (testing_) test(ends[k] / 2, ends[k + 1] / 2);
        continue;
      }
      for (; begin <= k; ++begin) {
        if (ends[begin] % 2 == 0) look_below(ends[begin] / 2);
      }
    }
    if (answer_.meet()) {
      answer_.transcript = {};
    } else if (options_.transcript) {
      answer_.transcript.events = ends;
    }
  }

 private:
  static constexpr std::uint32_t none = no_segment;
  static_assert(SweepStatus<InStatus>::none == no_segment);

  static std::vector<InStatus> keys_of(const PolygonEdges& edges) {
    std::vector<InStatus> keys;
    keys.reserve(edges.edges().size());
    for (std::uint32_t e = 0; e < edges.edges().size(); ++e) keys.push_back({edges.edges()[e], e});
    return keys;
  }

  void enter(std::uint32_t e) {
    const auto around = status_.insert(e, [&](const InStatus& other) { return is_above(e, other); });
    if (options_.transcript) answer_.transcript.below.push_back(around.below);
    test_neighbours(around.below, e);
    test_neighbours(e, around.above);
  }

  void leave(std::uint32_t e) {
    const auto around = status_.erase(e);
    test_neighbours(around.below, around.above);
  }

  bool is_above(std::uint32_t e, const InStatus& other) {
    ++answer_.cost.probes;
    const Segment &s = keys_[e].segment, &t = other.segment;
    const Sign begins = orient_2d(t.a, t.b, s.a);
    if (begins != Sign::zero) return begins == Sign::positive;
    const Sign goes = orient_2d(t.a, t.b, s.b);
    if (goes != Sign::zero || testing_) return goes != Sign::negative;
    return edges_.inside_is_above(e);
  }

  void test_neighbours(std::uint32_t lower, std::uint32_t upper) {
    if (testing_ && lower != none && upper != none) test(lower, upper);
  }

  void test(std::uint32_t e, std::uint32_t f) {
    const std::uint32_t p = edges_.polygon_of(e), q = edges_.polygon_of(f);
    if (p == q || answer_.meet()) return;
    ++answer_.cost.probes;
    const ContactKind kind = segment_segment(keys_[e].segment, keys_[f].segment);
    if (kind == ContactKind::none) return;
    const Contact contact = kind == ContactKind::crossing ? Contact::overlapping : Contact::touching;
    const std::uint32_t first = p < q ? e : f, second = p < q ? f : e;
    answer_.found = {
        contact, kind, false, std::min(p, q), std::max(p, q), edges_.in_polygon(first), edges_.in_polygon(second)};
  }

  // Does the edge, which has entered at this point, begin inside of another polygon?
  void look_below(std::uint32_t e) {
    if (answer_.meet() || !status_.holds(e)) return;
    const std::uint32_t below = status_.neighbours_of(e).below;
    if (below == none || !edges_.inside_is_above(below)) return;
    const std::uint32_t p = edges_.polygon_of(e), q = edges_.polygon_of(below);
    if (p == q) return;
    const std::uint32_t edge = edges_.in_polygon(e);
    const Polygon& polygon = edges_.polygon(p);
    const std::uint32_t vertex = polygon.vertices()[edge] == keys_[e].segment.a ? edge : polygon.next(edge);
    answer_.found = {Contact::overlapping, ContactKind::none, p < q, std::min(p, q), std::max(p, q),
                     p < q ? vertex : 0,   p < q ? 0 : vertex};
  }

  PolygonEdges& edges_;
  const bool testing_;
  const PolygonsOptions& options_;
  const std::vector<InStatus> keys_;
  SweepStatus<InStatus> status_;
  PolygonsAnswer& answer_;
};

}  // namespace

PolygonsAnswer polygons_any_by_sweep(std::span<const Polygon> polygons, const PolygonsOptions& options) {
  PolygonEdges edges(pointers_to(polygons));
  PolygonsAnswer answer;
  const bool is_written = options.transcript && options.groups.empty();
  if (is_written && options.allowed == Allowed::nothing) {
    Sweep(edges, true, options, answer).run();
  } else {
    PolygonSweep sweep(edges, options, first_that_counts(answer, options.allowed));
    const bool none_counts = sweep.run();
    answer.cost = sweep.cost;
    if (none_counts && is_written) Sweep(edges, false, options, answer).run();
  }
  classify(polygons, answer);
  return answer;
}

}  // namespace sunder::planar
