#include <sunder/base/contract.h>
#include <sunder/near/box_sweep.h>
#include <sunder/number/interval.h>
#include <sunder/scene/clearance.h>
#include <sunder/scene/members.h>
#include <sunder/scene/part_questions.h>

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

PartDistance distance_of(const Members& members, std::span<const Body> bodies, std::uint32_t i, std::uint32_t j) {
  const PartPair pair = members.pair(i, j);
  const Part &a = members.part(bodies, i), &b = members.part(bodies, j);
  SUNDER_REQUIRE(a.shape.is_polyhedron() && b.shape.is_polyhedron());
  return {pair.body_a, pair.body_b,
          pair.part_a, pair.part_b,
          0,           solid::polyhedron_polyhedron_distance(a.shape.core(), a.pose, b.shape.core(), b.pose)};
}

bool comes_first(const PartDistance& p, const PartDistance& q) {
  return std::tie(p.body_a, p.body_b, p.part_a, p.part_b) < std::tie(q.body_a, q.body_b, q.part_a, q.part_b);
}

[[maybe_unused]] bool is_positive(double x) { return x > 0 && x <= std::numeric_limits<double>::max(); }

// By pairs of bodies, the lower first.
class Margins {
 public:
  explicit Margins(const ClearanceQuestion& question) : least_(question.least), greatest_(question.least) {
    SUNDER_REQUIRE(is_positive(question.least));
    for (const auto& [a, b, least] : question.margins) {
      SUNDER_REQUIRE(is_positive(least));
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

// Is `one` nearer? Exactly.
bool is_nearer(const solid::PolyhedronDistance& one, const solid::PolyhedronDistance& other) {
  if (one.meet() || other.meet()) return one.meet() && !other.meet();
  const Interval p = one.distance(), q = other.distance();
  if (p.high < q.low || q.high < p.low) return p.high < q.low;
  const auto [n, d] = one.closest->squared();
  const auto [m, e] = other.closest->squared();
  return (n * e - m * d).sign() == Sign::negative;
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
    bool is_far = false;
    for (std::size_t k = 0; k < 3; ++k) is_far = is_far || gap_along(boxes[i], boxes[j], k) >= least;
    if (is_far) continue;
    ++answer.by_method;
    PartDistance found = distance_of(members, bodies, i, j);
    if (compare_distance(found.distance, least) != Sign::negative) continue;
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
    const double high = nearest.distance.distance().high;
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
    if (is_nearer(found.distance, nearest.distance) || (is_first && !is_nearer(nearest.distance, found.distance))) {
      nearest = std::move(found);
    }
  }
  return nearest;
}

}  // namespace sunder::scene
