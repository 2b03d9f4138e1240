#include <sunder/base/contract.h>
#include <sunder/near/box_sweep.h>
#include <sunder/number/interval.h>
#include <sunder/scene/clearance.h>
#include <sunder/scene/members.h>
#include <sunder/scene/part_questions.h>
#include <sunder/solid/pair/contact_evidence.h>
#include <sunder/solid/pair/polyhedron_polyhedron_distance.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

namespace sunder::scene {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// The same for every rounding: a double below, or above.
double below(double x) { return std::nextafter(x, -infinity); }
double above(double x) { return std::nextafter(x, infinity); }

// No points of the boxes are closer than this along axis k; not positive where they overlap there.
double gap_along(const Box3& a, const Box3& b, std::size_t k) {
  const double gap = std::max(a.low[k] - b.high[k], b.low[k] - a.high[k]);
  return std::isnan(gap) ? -infinity : below(gap);
}

// The square of what no points of the boxes are closer than, rounded down.
double squared_gap(const Box3& a, const Box3& b) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double gap = std::max(0.0, gap_along(a, b, k));
    sum = std::max(0.0, below(sum + std::max(0.0, below(gap * gap))));
  }
  return sum;
}

// Of hulls: the cores are apart, and so far apart as their distance is; encloses what is left between the parts.
Interval between(const PartDistance& pair) {
  const Interval cores = pair.closest->distance();
  if (pair.radius_a == 0 && pair.radius_b == 0) return cores;
  const Interval left = cores - (Interval(pair.radius_a) + Interval(pair.radius_b));
  return {std::max(left.low, 0.0), left.high};
}

// Are the parts further apart than `least` (positive), exactly so far (zero), or closer? Requires cores that are apart.
Sign compared(const PartDistance& pair, double least) {
  const Interval all = Interval(pair.radius_a) + Interval(pair.radius_b) + Interval(least),
                 cores = pair.closest->distance();
  if (cores.low > all.high) return Sign::positive;
  if (cores.high < all.low) return Sign::negative;
  const Dyadic sum = Dyadic(pair.radius_a) + Dyadic(pair.radius_b) + Dyadic(least);
  const auto [square, over] = pair.closest->squared();
  return (square - sum * sum * over).sign();
}

void require_hull(const Body& body, std::uint32_t part) {
  if (!body.parts[part].shape.is_curved()) return;
  throw Error(ErrorCode::bad_shape,
              "a cylinder, a cone or an ellipsoid is asked only whether it meets, not how far apart it is",
              part_name(body, part));
}

PartDistance distance_of(const Members& members, std::span<const Body> bodies, std::uint32_t i, std::uint32_t j) {
  const PartPair pair = members.pair(i, j);
  const Part &a = members.part(bodies, i), &b = members.part(bodies, j);
  require_hull(bodies[pair.body_a], pair.part_a);
  require_hull(bodies[pair.body_b], pair.part_b);
  PartDistance found{pair.body_a, pair.body_b, pair.part_a, pair.part_b};
  found.radius_a = a.shape.radius();
  found.radius_b = b.shape.radius();
  found.closest = polyhedron_polyhedron_distance(a.shape.core(), a.pose, b.shape.core(), b.pose).closest;
  const bool is_round = found.radius_a > 0 || found.radius_b > 0;
  if (found.closest && is_round && compared(found, 0) != Sign::positive) found.closest.reset();
  if (found.closest) found.distance = between(found);
  return found;
}

bool comes_first(const PartDistance& p, const PartDistance& q) {
  return std::tie(p.body_a, p.body_b, p.part_a, p.part_b) < std::tie(q.body_a, q.body_b, q.part_a, q.part_b);
}

[[maybe_unused]] bool is_margin(double x) { return x >= 0 && x <= std::numeric_limits<double>::max(); }

// By pairs of bodies, the lower first.
class Margins {
 public:
  explicit Margins(const ClearanceQuestion& question) : least_(question.least), greatest_(question.least) {
    SUNDER_REQUIRE(is_margin(question.least));
    for (const auto& [a, b, least] : question.margins) {
      SUNDER_REQUIRE(is_margin(least));
      own_[std::minmax(a, b)] = least;
      greatest_ = std::max(greatest_, least);
    }
  }

  double of(std::uint32_t body_a, std::uint32_t body_b) const {
    const auto own = own_.find({body_a, body_b});
    return own == own_.end() ? least_ : own->second;
  }
  double greatest() const { return greatest_; }

 private:
  double least_, greatest_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> own_;
};

// sqrt(n / d) - r for hulls whose cores are sqrt(n / d) apart, and whose radii sum to r.
struct ExactDistance {
  explicit ExactDistance(const PartDistance& pair)
      : square(pair.closest->squared()), radii(Dyadic(pair.radius_a) + Dyadic(pair.radius_b)) {}
  std::array<Dyadic, 2> square;
  Dyadic radii;
};

// Is sqrt(n / d) less than sqrt(m / e) + t? Requires t >= 0: then it is iff n / d - m / e - t^2 < 2 t sqrt(m / e).
bool is_less(const std::array<Dyadic, 2>& x, const std::array<Dyadic, 2>& y, const Dyadic& t) {
  const auto& [n, d] = x;
  const auto& [m, e] = y;
  const Dyadic left = n * e - m * d - t * t * d * e, right = (t * t * m * e * d * d).scaled(2);
  if (left.sign() == Sign::negative) return true;
  return (left * left - right).sign() == Sign::negative;
}

// Is `one` nearer? Exactly.
bool is_nearer(const PartDistance& one, const PartDistance& other) {
  if (one.meet() || other.meet()) return one.meet() && !other.meet();
  const Interval &p = one.distance, &q = other.distance;
  if (p.high < q.low || q.high < p.low) return p.high < q.low;
  const ExactDistance x(one), y(other);
  const Dyadic t = x.radii - y.radii;  // is sqrt(x) < sqrt(y) + t?
  if (t.sign() != Sign::negative) return is_less(x.square, y.square, t);
  // No: iff sqrt(y) - t <= sqrt(x).
  const auto& [n, d] = x.square;
  const auto& [m, e] = y.square;
  const Dyadic left = m * d - n * e - t * t * d * e;  // is it greater than -2 t sqrt(x), over d e?
  return left.sign() == Sign::positive && (left * left - (t * t * n * d * e * e).scaled(2)).sign() == Sign::positive;
}

}  // namespace

ClearanceAnswer closer_pairs(std::span<const Body> bodies, const ClearanceQuestion& question) {
  const Members members(bodies, question.allowed);
  const Margins margins(question);
  std::vector<WorldBox> boxes;
  std::vector<Box3> wide;
  for (std::uint32_t i = 0; i < members.size(); ++i) {
    const Box3& box = wide.emplace_back(boxes.emplace_back(box_of(members.part(bodies, i))));
    for (std::size_t k = 0; k < 3; ++k) {
      wide.back().low[k] = below(box.low[k] - margins.greatest() / 2);
      wide.back().high[k] = above(box.high[k] + margins.greatest() / 2);
    }
  }
  ClearanceAnswer answer;
  for (const auto& [i, j] : meeting_boxes(std::span<const Box3>(wide))) {
    if (!members.are_asked_about(i, j)) continue;
    const double least = margins.of(members.body(i), members.body(j));
    if (least == 0 || apart_by_boxes(boxes[i], boxes[j], least)) continue;
    ++answer.by_method;
    PartDistance found = distance_of(members, bodies, i, j);
    if (!found.meet() && compared(found, least) != Sign::negative) continue;
    found.least = least;
    answer.closer.push_back(std::move(found));
  }
  std::sort(answer.closer.begin(), answer.closer.end(), comes_first);
  Counts counts;
  counts.by_method = answer.by_method;
  members.complete(counts);
  answer.pairs = counts.pairs;
  answer.allowed = counts.allowed;
  answer.by_boxes = counts.by_boxes;
  return answer;
}

std::optional<PartDistance> nearest_parts(std::span<const Body> bodies,
                                          std::vector<std::array<std::uint32_t, 2>> allowed) {
  const Members members(bodies, std::move(allowed));
  std::vector<WorldBox> boxes;
  for (std::uint32_t i = 0; i < members.size(); ++i) boxes.push_back(box_of(members.part(bodies, i)));
  const auto for_each_pair = [&](const auto& of_pair) {
    for (std::uint32_t i = 0; i < members.size(); ++i) {
      for (std::uint32_t j = i + 1; j < members.size(); ++j) {
        if (members.are_asked_about(i, j)) of_pair(i, j, squared_gap(boxes[i], boxes[j]));
      }
    }
  };
  struct Candidate {
    double squared = infinity;
    std::uint32_t i = 0, j = 0;
  };
  std::optional<Candidate> first;  // whose boxes are nearest
  for_each_pair([&](std::uint32_t i, std::uint32_t j, double squared) {
    if (!first || squared < first->squared) first = Candidate{squared, i, j};
  });
  if (!first) return std::nullopt;
  PartDistance nearest = distance_of(members, bodies, first->i, first->j);
  const auto bound = [&] {  // of the square, rounded up
    const double high = nearest.distance.high;
    return high == 0 ? 0.0 : above(high * high);
  };
  std::vector<Candidate> candidates;
  for_each_pair([&, most = bound()](std::uint32_t i, std::uint32_t j, double squared) {
    if (squared <= most && (i != first->i || j != first->j)) candidates.push_back({squared, i, j});
  });
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& p, const Candidate& q) {
    return std::tie(p.squared, p.i, p.j) < std::tie(q.squared, q.i, q.j);
  });
  for (const auto& [squared, i, j] : candidates) {
    if (squared > bound()) break;
    PartDistance found = distance_of(members, bodies, i, j);
    const bool is_first = comes_first(found, nearest);
    if (is_nearer(found, nearest) || (is_first && !is_nearer(nearest, found))) {
      nearest = std::move(found);
    }
  }
  return nearest;
}

std::optional<AxisApart> apart_by_boxes(const Box3& a, const Box3& b, double least) {
  SUNDER_REQUIRE(least > 0);
  for (std::size_t k = 0; k < 3; ++k) {
    if (gap_along(a, b, k) >= least) return AxisApart{k, a.high[k] < b.low[k]};
  }
  return std::nullopt;
}

std::optional<NearestPoints> rounded_nearest_points(const PartDistance& distance) {
  if (distance.meet()) return std::nullopt;
  const solid::ClosestPoints exact = closest_points(*distance.closest);
  const auto rounded = [](const PointOf& p) {
    const auto at = [&](std::size_t k) { return nearest_ratio(p.coordinates[k], p.denominator); };
    return Point3{at(0), at(1), at(2)};
  };
  NearestPoints points{rounded(exact.of_a), rounded(exact.of_b)};
  if (distance.radius_a == 0 && distance.radius_b == 0) return points;
  const double cores = distance.closest->distance().high;
  for (std::size_t k = 0; k < 3; ++k) {
    const double way = (points.of_b[k] - points.of_a[k]) / cores;
    points.of_a[k] += way * distance.radius_a;
    points.of_b[k] -= way * distance.radius_b;
  }
  return points;
}

}  // namespace sunder::scene
