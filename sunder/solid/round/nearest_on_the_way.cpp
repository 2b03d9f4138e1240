#include <sunder/number/exact_vector.h>
#include <sunder/predicate/coordinates.h>
#include <sunder/predicate/point/along.h>
#include <sunder/solid/exact/exact_gjk.h>
#include <sunder/solid/round/nearest_on_the_way.h>
#include <sunder/solid/search/extreme_vertex.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace sunder::solid {

namespace {

using Exact = Vector3<Dyadic>;

// The search for the nearest difference to the origin.
class SearchOnTheWay {
 public:
  SearchOnTheWay(const Placed& a, const Placed& b, const Exact& begin, const Exact& end, Cost& cost, StageTally& tally)
      : a_(a), b_(b), begin_(begin), end_(end), path_(end - begin), cost_(cost), tally_(tally) {}

  std::optional<NearestOnTheWay> run() {
    ExactNearest nearest = ExactNearest::to_origin();
    corners_.push_back(corner(0, 0, false));
    join(nearest, {0, 0});
    if (!exact_gjk(*this, nearest, tally_.exact)) return std::nullopt;
    const auto& [features, way, weights] = nearest.closest;
    NearestOnTheWay found{way, {{}, way.denominator}, {{}, way.denominator}, {}};
    for (std::size_t k = 0; k < features.count_b; ++k) {
      const Corner& corner = corners_[features.of_b(k)];
      const Dyadic& weight = weights[k + 1];
      found.of_a.add(corner.a, weight);
      found.of_b.add(corner.b, weight);
      if (corner.at_end) found.at_end = found.at_end + weight;
    }
    return found;
  }

  // As its support, from the newest corner on.
  std::array<std::uint32_t, 2> extreme(const ExactNearest& nearest) {
    ++cost_.iterations;
    ++tally_.exact;
    const auto& [features, way, weights] = nearest.closest;
    const WorldDirection direction(times(Dyadic(-1.0), way.way));
    Along along_a(direction, a_.pose, a_.tame), along_b(direction, b_.pose, b_.tame);
    const Corner& from = corners_[features.of_b(features.count_b - 1U)];
    const std::uint32_t of_a = extreme_vertex_from(a_, along_a, End::greatest, from.a, cost_, tally_);
    const std::uint32_t of_b = extreme_vertex_from(b_, along_b, End::least, from.b, cost_, tally_);
    Corner next = corner(of_a, of_b, dot(way.way, path_).sign() == Sign::negative);
    if ((dot(way.way, next.at) - way.reach).sign() != Sign::negative) return {0, nearest.of_b()};
    corners_.push_back(std::move(next));
    return {0, static_cast<std::uint32_t>(corners_.size() - 1)};
  }
  void join(ExactNearest& nearest, const std::array<std::uint32_t, 2>& next) const {
    nearest.b.add(next[1], corners_[next[1]].at);
  }

 private:
  struct Corner {
    std::uint32_t a = 0, b = 0;
    bool at_end = false;
    Exact at;  // A's less B's, with what A goes as seen from B
  };

  Corner corner(std::uint32_t a, std::uint32_t b, bool at_end) const {
    const Exact apart = coordinates<Dyadic>(a_[a]) - coordinates<Dyadic>(b_[b]);
    return {a, b, at_end, sum(apart, at_end ? end_ : begin_)};
  }

  const Placed& a_;
  const Placed& b_;
  const Exact &begin_, &end_;
  const Exact path_;
  Cost& cost_;
  StageTally& tally_;
  std::vector<Corner> corners_;
};

}  // namespace

std::optional<NearestOnTheWay> nearest_on_the_way(const Placed& a, const Placed& b, const Exact& begin,
                                                  const Exact& end, Cost& cost, StageTally& tally) {
  return SearchOnTheWay(a, b, begin, end, cost, tally).run();
}

}  // namespace sunder::solid
