#include <sunder/number/exact_vector.h>
#include <sunder/predicate/coordinates.h>
#include <sunder/predicate/point/along.h>
#include <sunder/solid/round/nearest_on_the_way.h>
#include <sunder/solid/search/extreme_vertex.h>

#include <cstddef>
#include <utility>

namespace sunder::solid {

namespace {

using Exact = Vector3<Dyadic>;

// A fraction; the denominator is positive.
struct Ratio {
  Dyadic over_one, denominator{1.0};

  bool is_less(const Ratio& other) const {
    return (over_one * other.denominator - other.over_one * denominator).sign() == Sign::negative;
  }
};

// Weights of the point of the corners' affine hull that is nearest to the origin; their sum is positive. Requires
// corners that are affinely independent, up to four.
std::vector<Dyadic> weights_of_nearest(const std::vector<WayCorner>& corners) {
  const auto p = [&](std::size_t k) -> const Exact& { return corners[k].at; };
  switch (corners.size()) {
    case 1: return {Dyadic(1.0)};
    case 2: {
      const Exact way = p(1) - p(0);
      return {dot(p(1), way), -dot(p(0), way)};
    }
    case 3: {
      const Exact normal = cross(p(1) - p(0), p(2) - p(0));
      return {dot(cross(p(1), p(2)), normal), dot(cross(p(2), p(0)), normal), dot(cross(p(0), p(1)), normal)};
    }
    default: break;
  }
  const auto volume = [&](std::size_t i, std::size_t j, std::size_t k) { return dot(p(i), cross(p(j), p(k))); };
  std::vector<Dyadic> weights{volume(1, 2, 3), -volume(0, 2, 3), volume(0, 1, 3), -volume(0, 1, 2)};
  const Dyadic total = weights[0] + weights[1] + weights[2] + weights[3];
  if (total.sign() == Sign::negative) {
    for (Dyadic& w : weights) w = -w;
  }
  return weights;
}

Dyadic total_of(const std::vector<Dyadic>& weights) {
  Dyadic total(0.0);
  for (const Dyadic& w : weights) total = total + w;
  return total;
}

class Search {
 public:
  Search(const Placed& a, const Placed& b, const Exact& begin, const Exact& end, Cost& cost, StageTally& tally)
      : a_(a), b_(b), begin_(begin), end_(end), path_(end - begin), cost_(cost), tally_(tally) {}

  std::optional<NearestOnTheWay> run() {
    corners_ = {corner(0, 0, false)};
    while (true) {
      ++cost_.iterations;
      ++tally_.exact;
      NearestOnTheWay found = nearest();
      const Dyadic square = dot(found.way, found.way);
      if (square.sign() == Sign::zero) return std::nullopt;
      WayCorner next = furthest_along(times(Dyadic(-1.0), found.way));
      if ((dot(found.way, next.at) * found.weight - square).sign() != Sign::negative) return found;
      corners_.push_back(std::move(next));
      if (!reduce()) return std::nullopt;
    }
  }

 private:
  WayCorner corner(std::uint32_t a, std::uint32_t b, bool at_end) const {
    const Exact apart = coordinates<Dyadic>(a_[a]) - coordinates<Dyadic>(b_[b]);
    return {a, b, at_end, sum(apart, at_end ? end_ : begin_), Dyadic(0.0)};
  }

  NearestOnTheWay nearest() const {
    NearestOnTheWay found{corners_, {}, Dyadic(0.0)};
    for (const WayCorner& corner : corners_) {
      found.way = sum(found.way, times(corner.weight, corner.at));
      found.weight = found.weight + corner.weight;
    }
    if (corners_.size() > 1) return found;
    found.corners[0].weight = found.weight = Dyadic(1.0);
    found.way = corners_[0].at;
    return found;
  }

  WayCorner furthest_along(const Exact& d) {
    const WorldDirection direction(d);
    Along along_a(direction, a_.pose, a_.tame), along_b(direction, b_.pose, b_.tame);
    const WayCorner& from = corners_.back();
    const std::uint32_t of_a = extreme_vertex_from(a_, along_a, End::greatest, from.a, cost_, tally_);
    const std::uint32_t of_b = extreme_vertex_from(b_, along_b, End::least, from.b, cost_, tally_);
    return corner(of_a, of_b, dot(d, path_).sign() == Sign::positive);
  }

  // From the weights so far, the last corner's zero, on the way to those of the nearest point of the affine hull, as
  // far as none is negative; corners that come to zero leave. False: the corners hold the origin.
  bool reduce() {
    if (corners_.size() == 2) corners_[0].weight = Dyadic(1.0);
    while (true) {
      const std::vector<Dyadic> wanted = weights_of_nearest(corners_);
      const Dyadic all_wanted = total_of(wanted);
      std::vector<Dyadic> have;
      for (const WayCorner& corner : corners_) have.push_back(corner.weight);
      const Dyadic all = total_of(have);
      std::optional<Ratio> part;  // of the way
      std::size_t leaves = 0;
      for (std::size_t k = 0; k < corners_.size(); ++k) {
        if (wanted[k].sign() == Sign::positive) continue;
        const Dyadic from = have[k] * all_wanted;
        const Ratio here{from, from - wanted[k] * all};
        if (here.denominator.sign() == Sign::zero) {  // zero, and to stay zero
          part = Ratio{Dyadic(0.0), Dyadic(1.0)};
          leaves = k;
          break;
        }
        if (part && !here.is_less(*part)) continue;
        part = here;
        leaves = k;
      }
      if (!part) {
        for (std::size_t k = 0; k < corners_.size(); ++k) corners_[k].weight = wanted[k];
        return corners_.size() < 4;
      }
      const Dyadic rest = part->denominator - part->over_one;
      std::vector<WayCorner> kept;
      for (std::size_t k = 0; k < corners_.size(); ++k) {
        if (k == leaves) continue;
        corners_[k].weight = rest * have[k] * all_wanted + part->over_one * wanted[k] * all;
        kept.push_back(std::move(corners_[k]));
      }
      corners_ = std::move(kept);
    }
  }

  const Placed& a_;
  const Placed& b_;
  const Exact &begin_, &end_;
  const Exact path_;
  Cost& cost_;
  StageTally& tally_;
  std::vector<WayCorner> corners_;
};

}  // namespace

std::optional<NearestOnTheWay> nearest_on_the_way(const Placed& a, const Placed& b, const Exact& begin,
                                                  const Exact& end, Cost& cost, StageTally& tally) {
  return Search(a, b, begin, end, cost, tally).run();
}

}  // namespace sunder::solid
