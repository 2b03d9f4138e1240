// CGAL, header only: its intersection of boxes, its sweep, its Boolean operations.
#include <bench/peers/set_peer.h>

#include <CGAL/Arr_circle_segment_traits_2.h>
#include <CGAL/Arr_non_caching_segment_traits_2.h>
#include <CGAL/Bbox_2.h>
#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Surface_sweep_2_algorithms.h>
#include <CGAL/box_intersection_d.h>

#include <cmath>
#include <iterator>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace bench {
namespace {

using Constructing = CGAL::Exact_predicates_exact_constructions_kernel;
using Deciding = CGAL::Exact_predicates_inexact_constructions_kernel;
using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 2, std::uint32_t>;

// --- Pairs of boxes --------------------------------------------------------------------------------------------------

// Sorted: boxes themselves, or pointers to them. meet(i, j) decides.
template <class Sorted, class Meet>
Asked by_boxes(const SetInput& input, SetQuestion question, Meet meet) {
  struct Prepared {
    std::vector<Box> boxes;
    std::vector<Sorted> list;
    Meet meet;
  };
  auto prepared = std::make_shared<Prepared>(Prepared{{}, {}, std::move(meet)});
  for (const Frame& f : frames_of(input)) {
    prepared->boxes.emplace_back(CGAL::Bbox_2(f.low.x, f.low.y, f.high.x, f.high.y),
                                 static_cast<std::uint32_t>(prepared->boxes.size()));
  }
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
    const auto number = [](const Sorted& s) {
      if constexpr (std::is_pointer_v<Sorted>) {
        return s->info();
      } else {
        return s.info();
      }
    };
    const auto decide = [&](const Sorted& a, const Sorted& b) {
      const std::uint32_t i = number(a), j = number(b);
      if (prepared->meet(i, j) && !sink.take(i, j)) throw Found{};
    };
    try {
      CGAL::box_self_intersection_d(list.begin(), list.end(), decide);
    } catch (const Found&) {
    }
    return sink.count();
  };
}

bool discs_meet(const Disc& a, const Disc& b) {
  const double dx = a.center.x - b.center.x, dy = a.center.y - b.center.y, reach = a.radius + b.radius;
  const double square = dx * dx + dy * dy, value = square - reach * reach;
  if (std::fabs(value) > 1e-14 * (square + reach * reach)) return value < 0;
  using Exact = CGAL::Exact_rational;
  const Exact x = Exact(a.center.x) - Exact(b.center.x), y = Exact(a.center.y) - Exact(b.center.y);
  const Exact r = Exact(a.radius) + Exact(b.radius);
  return x * x + y * y <= r * r;
}

template <class Sorted>
Asked discs_by_boxes(const SetInput& input, SetQuestion question) {
  if (input.discs.empty()) return {};
  return by_boxes<Sorted>(input, question, [&discs = input.discs](std::uint32_t i, std::uint32_t j) {
    return discs_meet(discs[i], discs[j]);
  });
}

struct Shape {
  std::vector<Deciding::Point_2> points;
  CGAL::Bbox_2 box;

  bool holds(const Deciding::Point_2& p) const {
    return CGAL::do_overlap(p.bbox(), box) &&
           CGAL::bounded_side_2(points.begin(), points.end(), p, Deciding()) != CGAL::ON_UNBOUNDED_SIDE;
  }
  // Those whose boxes meet this one.
  void edges_in(const CGAL::Bbox_2& part, std::vector<Deciding::Segment_2>& edges) const {
    edges.clear();
    for (std::size_t i = 0, before = points.size() - 1; i < points.size(); before = i++) {
      if (CGAL::do_overlap(points[before].bbox() + points[i].bbox(), part))
        edges.emplace_back(points[before], points[i]);
    }
  }
};

Asked polygons_by_edges(const SetInput& input, SetQuestion question) {
  if (input.rings.empty()) return {};
  std::vector<Shape> shapes;
  for (const Ring& ring : input.rings) {
    Shape& shape = shapes.emplace_back();
    for (const Xy& p : ring) shape.points.emplace_back(p.x, p.y);
    shape.box = CGAL::bbox_2(shape.points.begin(), shape.points.end());
  }
  std::vector<Deciding::Segment_2> of_a, of_b;
  const auto meet = [shapes = std::move(shapes), of_a, of_b](std::uint32_t i, std::uint32_t j) mutable {
    const Shape &a = shapes[i], &b = shapes[j];
    a.edges_in(b.box, of_a);
    b.edges_in(a.box, of_b);
    for (const auto& edge : of_a) {
      for (const auto& other : of_b) {
        if (CGAL::do_overlap(edge.bbox(), other.bbox()) && CGAL::do_intersect(edge, other)) return true;
      }
    }
    return a.holds(b.points.front()) || b.holds(a.points.front());
  };
  return by_boxes<Box*>(input, question, meet);
}

Asked polygons_by_operations(const SetInput& input, SetQuestion question) {
  if (input.rings.empty()) return {};
  std::vector<CGAL::Polygon_2<Constructing>> shapes;
  for (const Ring& ring : input.rings) {
    CGAL::Polygon_2<Constructing>& shape = shapes.emplace_back();
    for (const Xy& p : ring) shape.push_back({p.x, p.y});
  }
  return by_boxes<Box*>(input, question, [shapes = std::move(shapes)](std::uint32_t i, std::uint32_t j) {
    return CGAL::do_intersect(shapes[i], shapes[j]);
  });
}

// --- Sweeps of all boundaries ----------------------------------------------------------------------------------------

Asked edges_by_sweep(const SetInput& input, SetQuestion question) {
  if (input.rings.empty() || question != SetQuestion::any) return {};
  using Traits = CGAL::Arr_non_caching_segment_traits_2<Deciding>;
  std::vector<Traits::Curve_2> curves;
  for (const Ring& ring : input.rings) {
    for (std::size_t i = 0, before = ring.size() - 1; i < ring.size(); before = i++) {
      curves.emplace_back(Deciding::Point_2(ring[before].x, ring[before].y), Deciding::Point_2(ring[i].x, ring[i].y));
    }
  }
  return [curves = std::move(curves)]() -> std::uint64_t {
    Traits traits;
    return CGAL::do_curves_intersect(curves.begin(), curves.end(), traits) ? 1 : 0;
  };
}

Asked circles_by_sweep(const SetInput& input, SetQuestion question) {
  if (input.discs.empty()) return {};
  using Traits = CGAL::Arr_circle_segment_traits_2<Constructing>;
  std::vector<Traits::Curve_2> curves;
  for (const Disc& d : input.discs) {
    const Constructing::FT radius(d.radius);
    curves.emplace_back(Constructing::Circle_2({d.center.x, d.center.y}, radius * radius));
  }
  return [curves = std::move(curves), question]() -> std::uint64_t {
    Traits traits;
    if (question == SetQuestion::any) {
      return CGAL::do_curves_intersect(curves.begin(), curves.end(), traits) ? 1 : 0;
    }
    std::vector<Traits::Point_2> points;
    CGAL::compute_intersection_points(curves.begin(), curves.end(), std::back_inserter(points), false, traits);
    return points.size() / 2;
  };
}

}  // namespace

std::vector<SetWay> cgal_set_ways() {
  return {{"cgal", "box_self_intersection_d", discs_by_boxes<Box>},
          {"cgal", "box_self_intersection_d, pointers", discs_by_boxes<Box*>},
          {"cgal", "sweep of arcs", circles_by_sweep},
          {"cgal", "box_self_intersection_d, edges", polygons_by_edges},
          {"cgal", "box_self_intersection_d, do_intersect", polygons_by_operations},
          {"cgal", "do_curves_intersect of edges", edges_by_sweep}};
}

}  // namespace bench
