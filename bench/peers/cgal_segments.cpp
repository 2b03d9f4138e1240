// CGAL, header only: its sweep (Surface_sweep_2), its intersection of boxes, its test for simple polygons.
#include <bench/peers/segment_peer.h>

#include <CGAL/Arr_non_caching_segment_traits_2.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Bbox_2.h>
#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Surface_sweep_2_algorithms.h>
#include <CGAL/box_intersection_d.h>

#include <iterator>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace bench {
namespace {

using Constructing = CGAL::Exact_predicates_exact_constructions_kernel;
using Deciding = CGAL::Exact_predicates_inexact_constructions_kernel;

template <class Kernel>
std::vector<typename Kernel::Segment_2> segments_of(const SegmentInput& input) {
  using Point = typename Kernel::Point_2;
  std::vector<typename Kernel::Segment_2> segments;
  segments.reserve(input.lines.size());
  for (const Line& l : input.lines) segments.emplace_back(Point(l.a.x, l.a.y), Point(l.b.x, l.b.y));
  return segments;
}

template <class Traits>
std::vector<typename Traits::Curve_2> curves_of(const SegmentInput& input) {
  using Point = typename Traits::Point_2;
  std::vector<typename Traits::Curve_2> curves;
  curves.reserve(input.lines.size());
  for (const Line& l : input.lines) curves.emplace_back(Point(l.a.x, l.a.y), Point(l.b.x, l.b.y));
  return curves;
}

template <class Traits>
Asked any_by_sweep(const SegmentInput& input, SegmentQuestion question) {
  if (question != SegmentQuestion::any) return {};
  return [curves = curves_of<Traits>(input)]() -> std::uint64_t {
    Traits traits;
    return CGAL::do_curves_intersect(curves.begin(), curves.end(), traits) ? 1 : 0;
  };
}

Asked points_by_sweep(const SegmentInput& input, SegmentQuestion question) {
  if (question != SegmentQuestion::all && question != SegmentQuestion::count) return {};
  using Traits = CGAL::Arr_segment_traits_2<Constructing>;
  return [curves = curves_of<Traits>(input)]() -> std::uint64_t {
    Traits traits;
    std::vector<Traits::Point_2> points;
    CGAL::compute_intersection_points(curves.begin(), curves.end(), std::back_inserter(points), false, traits);
    return points.size();
  };
}

using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 2, std::uint32_t>;

// Sorted: boxes themselves, or pointers to them.
template <class Sorted>
Asked by_boxes(const SegmentInput& input, SegmentQuestion question) {
  if (question == SegmentQuestion::simple) return {};
  struct Prepared {
    const SegmentInput& input;
    std::vector<Deciding::Segment_2> segments;
    std::vector<Box> boxes;
    std::vector<Sorted> list;
  };
  auto prepared = std::make_shared<Prepared>(Prepared{input, segments_of<Deciding>(input), {}, {}});
  for (std::uint32_t i = 0; i < input.lines.size(); ++i) prepared->boxes.emplace_back(prepared->segments[i].bbox(), i);
  for (Box& box : prepared->boxes) {
    if constexpr (std::is_pointer_v<Sorted>) {
      prepared->list.push_back(&box);
    } else {
      prepared->list.push_back(box);
    }
  }
  return [prepared, question]() -> std::uint64_t {
    std::vector<Sorted> list = prepared->list;  // the call sorts it
    PairSink sink(question);
    const auto point = [](const Xy& p) { return Deciding::Point_2(p.x, p.y); };
    const auto turn = [&](const Xy& p, const Xy& q, const Xy& r) {
      return static_cast<int>(CGAL::orientation(point(p), point(q), point(r)));
    };
    const auto number = [](const Sorted& s) {
      if constexpr (std::is_pointer_v<Sorted>) {
        return s->info();
      } else {
        return s.info();
      }
    };
    const auto decide = [&](const Sorted& a, const Sorted& b) {
      const std::uint32_t i = number(a), j = number(b);
      const auto meet = [&] { return CGAL::do_intersect(prepared->segments[i], prepared->segments[j]); };
      const std::vector<Line>& lines = prepared->input.lines;
      if (pair_counts(lines[i], lines[j], prepared->input.shared_ends, turn, meet) && !sink.take(i, j)) throw Found{};
    };
    try {
      CGAL::box_self_intersection_d(list.begin(), list.end(), decide);
    } catch (const Found&) {
    }
    return sink.count();
  };
}

Asked simple(const SegmentInput& input, SegmentQuestion question) {
  if (question != SegmentQuestion::simple || input.ring.empty()) return {};
  std::vector<Deciding::Point_2> points;
  for (const Xy& p : input.ring) points.emplace_back(p.x, p.y);
  return [points = std::move(points)]() -> std::uint64_t {
    return CGAL::is_simple_2(points.begin(), points.end(), Deciding()) ? 1 : 0;
  };
}

}  // namespace

std::vector<SegmentWay> cgal_segment_ways() {
  return {{"cgal", "do_curves_intersect, cached", any_by_sweep<CGAL::Arr_segment_traits_2<Constructing>>},
          {"cgal", "do_curves_intersect, predicates", any_by_sweep<CGAL::Arr_non_caching_segment_traits_2<Deciding>>},
          {"cgal", "compute_intersection_points", points_by_sweep},
          {"cgal", "box_self_intersection_d", by_boxes<Box>},
          {"cgal", "box_self_intersection_d, pointers", by_boxes<Box*>},
          {"cgal", "is_simple_2", simple}};
}

}  // namespace bench
