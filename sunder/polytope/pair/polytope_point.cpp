#include <sunder/number/rounded_elimination_internal.h>
#include <sunder/polytope/pair/polytope_point.h>
#include <sunder/polytope/pair/support.h>
#include <sunder/predicate/point/simplex_origin.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace sunder::polytope {

namespace {

constexpr std::size_t most_known = 64;

// The last ones that were of use, the very last first.
template <class Item>
class Recent {
 public:
  // The first one that serves, if any; it goes to the front.
  template <class Serves>
  const Item* find(const Serves& serves) {
    const auto found = std::find_if(items_.begin(), items_.end(), serves);
    if (found == items_.end()) return nullptr;
    std::rotate(items_.begin(), found, found + 1);
    return &items_.front();
  }
  void add(Item item) {
    if (items_.size() == most_known) items_.pop_back();
    items_.insert(items_.begin(), std::move(item));
  }

 private:
  std::vector<Item> items_;
};

// A direction with the greatest product of the polytope; a simplex of d + 1 of its points, and a matrix that makes of a
// point less the first of these the weights of the others, about.
struct KnownDirection {
  Vector direction{};
  BoundedProduct reach;
};
struct KnownSimplex {
  CommonPoints points;
  std::array<double, most_dimension * most_dimension> inverse{};
};

class ManyPoints {
 public:
  explicit ManyPoints(const Polytope& polytope) : polytope_(polytope), pose_(polytope.dimension()) {}

  PolytopeAnswer answer(std::span<const double> point) {
    PolytopeAnswer known;
    if (const KnownDirection* const d = directions_.find([&](const KnownDirection& k) { return parts(k, point); })) {
      std::copy_n(d->direction.begin(), point.size(), known.evidence.emplace<PartingDirection>().direction.begin());
      known.cost.proposals = 1;
      return known;
    }
    if (const KnownSimplex* const s = simplices_.find([&](const KnownSimplex& k) { return holds(k, point); })) {
      known.evidence = s->points;
      known.cost.proposals = 1;
      return known;
    }
    const Polytope one = Polytope::from_points(polytope_.dimension(), {point.begin(), point.end()});
    PolytopeAnswer answer = polytope_polytope(polytope_, pose_, one, pose_);
    if (polytope_.is_of_points()) remember(answer);
    return answer;
  }

 private:
  bool parts(const KnownDirection& known, std::span<const double> point) const {
    double product = 0, size = 0;
    for (std::size_t c = 0; c < point.size(); ++c) {
      const double part = known.direction[c] * point[c];
      product += part;
      size += std::fabs(part);
    }
    // Of d <= 6 products: 6 roundings, and two for the bound; what underflows.
    return compare(known.reach, {product, 10 * 0x1p-53 * size + 0x1p-1060}) == Guess::positive;
  }

  bool holds(const KnownSimplex& known, std::span<const double> point) const {
    const std::size_t d = point.size();
    const std::span<const double> first = polytope_.row(known.points.of_a[0]);
    double rest = 1;
    for (std::size_t r = 0; r < d; ++r) {
      double weight = 0;
      for (std::size_t c = 0; c < d; ++c) weight += known.inverse[r * d + c] * (point[c] - first[c]);
      if (!(weight > 0)) return false;  // it is not worth a try
      rest -= weight;
    }
    if (!(rest > 0)) return false;
    std::array<Interval, most_dimension*(most_dimension + 1)> points;
    for (std::size_t k = 0; k <= d; ++k) {
      const std::span<const double> row = polytope_.row(known.points.of_a[k]);
      for (std::size_t c = 0; c < d; ++c) points[k * d + c] = Interval(row[c]) - Interval(point[c]);
    }
    return least_weight_of_origin(std::span<const Interval>(points).first(d * (d + 1)), d) == Guess::positive;
  }

  void remember(const PolytopeAnswer& answer) {
    const std::size_t d = polytope_.dimension();
    if (const auto* apart = std::get_if<PartingDirection>(&answer.evidence)) {
      Vector direction{};
      std::copy_n(apart->direction.begin(), d, direction.begin());
      const Support far = support(polytope_, pose_, direction, 1);
      directions_.add({direction, far.product});
      return;
    }
    const auto* points = std::get_if<CommonPoints>(&answer.evidence);
    if (points == nullptr || points->count_a != d + 1) return;
    KnownSimplex known{.points = *points};
    if (invert(known)) simplices_.add(known);
  }

  // Of the matrix of edges; false where floating point finds none.
  bool invert(KnownSimplex& known) const {
    const std::size_t d = polytope_.dimension();
    const std::span<const double> first = polytope_.row(known.points.of_a[0]);
    std::array<double, most_dimension * most_dimension> edges;
    for (std::size_t r = 0; r < d; ++r) {
      for (std::size_t c = 0; c < d; ++c) edges[r * d + c] = polytope_.row(known.points.of_a[c + 1])[r] - first[r];
    }
    return rounded_inverse(d, std::span(edges).first(d * d), std::span(known.inverse).first(d * d));
  }

  const Polytope& polytope_;
  Pose pose_;
  Recent<KnownDirection> directions_;
  Recent<KnownSimplex> simplices_;
};

void require_finite(std::span<const double> numbers, std::size_t d) {
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    if (!std::isfinite(numbers[k])) {
      throw Error(ErrorCode::bad_value, "a number that is not finite; give finite doubles",
                  "point " + std::to_string(k / d));
    }
  }
}

}  // namespace

PolytopeAnswer polytope_point(const Polytope& polytope, std::span<const double> point) {
  const std::size_t d = polytope.dimension();
  if (point.size() != d) {
    throw Error(ErrorCode::bad_shape,
                "a point of " + std::to_string(point.size()) + " numbers; give " + std::to_string(d));
  }
  require_finite(point, d);
  return ManyPoints(polytope).answer(point);
}

std::vector<PolytopeAnswer> polytope_points(const Polytope& polytope, std::span<const double> points) {
  const std::size_t d = polytope.dimension();
  if (points.size() % d != 0) {
    throw Error(ErrorCode::bad_shape, std::to_string(points.size()) + " numbers are no whole number of points; give " +
                                          std::to_string(d) + " each");
  }
  require_finite(points, d);
  ManyPoints many(polytope);
  std::vector<PolytopeAnswer> answers;
  answers.reserve(points.size() / d);
  for (std::size_t k = 0; k < points.size(); k += d) answers.push_back(many.answer(points.subspan(k, d)));
  return answers;
}

}  // namespace sunder::polytope
