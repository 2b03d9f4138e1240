#include <sunder/base/interruption.h>
#include <sunder/polytope/hull/quickhull.h>

#include <algorithm>
#include <string>
#include <unordered_map>
#include <utility>

namespace sunder::polytope {

namespace {

constexpr std::uint32_t none = 0xffffffffu;

struct Facet {
  SimplexCorners corners{}, across{};
  RoundedPlane plane;
  std::uint32_t outside = none;  // the first of the points that are beyond it, and beyond no other's list
  double height = 0;             // of that one: the greatest of them, as floating point has it
  std::uint32_t seen = 0;        // the turn in which it was looked at
  bool is_visible = false;       // then; and so taken away after it
};

class Quickhull {
 public:
  Quickhull(const PlanePoints& points, std::uint64_t most, QuickhullCost& cost)
      : points_(points), d_(points.dimension()), most_(most), cost_(cost), next_(points.size(), none) {}

  std::vector<BoundarySimplex> build(std::span<const std::uint32_t> indices, std::span<const std::uint32_t> first) {
    begin(first);
    for (const std::uint32_t k : indices) {
      if (std::find(first.begin(), first.end(), k) == first.end()) give_home(k, fresh_);
    }
    queue(fresh_);
    for (std::size_t at = 0; at < waiting_.size(); ++at) {
      while (facets_[waiting_[at]].outside != none) {
        if (cost_.gives_up && cost_.is_degenerate()) return {};
        add(waiting_[at]);
      }
    }
    return boundary();
  }

 private:
  std::uint32_t new_facet(const SimplexCorners& corners) {
    std::uint32_t f = 0;
    if (free_.empty()) {
      if (facets_.size() >= most_) {
        throw Error(ErrorCode::bad_shape, "a hull of more than " + std::to_string(most_) +
                                              " simplices at once, the limit; give fewer points, or fewer columns");
      }
      f = static_cast<std::uint32_t>(facets_.size());
      facets_.emplace_back();
    } else {
      f = free_.back();
      free_.pop_back();
      facets_[f] = {};
    }
    facets_[f].corners = corners;
    facets_[f].plane = points_.rounded_plane(corners);
    return f;
  }

  bool is_beyond(std::uint32_t f, std::uint32_t k) { return side(f, k) == Sign::positive; }

  Sign side(std::uint32_t f, std::uint32_t k) {
    ++cost_.side_tests;
    const Guess guess = points_.rounded_side(facets_[f].plane, k);
    return is_sure(guess) ? to_sign(guess) : closer_side(f, k);
  }

  Sign closer_side(std::uint32_t f, std::uint32_t k) {
    const SimplexCorners& corners = facets_[f].corners;
    const auto end = corners.begin() + static_cast<std::ptrdiff_t>(d_);
    if (std::find(corners.begin(), end, k) != end) return Sign::zero;
    const Guess guess = points_.closer_side(corners, k);
    if (is_sure(guess)) return to_sign(guess);
    ++cost_.exact_tests;
    auto [plane, is_new] = exact_.try_emplace(f);
    if (is_new) plane->second = points_.exact_plane(corners);
    const Sign sign = points_.exact_side(plane->second, k);
    if (sign == Sign::zero) ++cost_.zeros;
    return sign;
  }

  double height(std::uint32_t f, std::uint32_t k) const {
    const RoundedPlane& plane = facets_[f].plane;
    const double* const p = points_.rounded(k);
    double sum = -plane.offset;
    for (std::size_t c = 0; c < d_; ++c) sum += plane.normal[c] * p[c];
    return sum;
  }

  void begin(std::span<const std::uint32_t> first) {
    for (std::size_t without = 0; without <= d_; ++without) {
      SimplexCorners corners{};
      for (std::size_t k = 0, i = 0; k <= d_; ++k) {
        if (k != without) corners[i++] = first[k];
      }
      std::uint32_t f = new_facet(corners);
      if (is_beyond(f, first[without])) {
        std::swap(corners[0], corners[1]);
        facets_[f].corners = corners;
        facets_[f].plane = points_.rounded_plane(corners);
        exact_.erase(f);
      }
      fresh_.push_back(f);
    }
    for (const std::uint32_t f : fresh_) {
      for (std::size_t i = 0; i < d_; ++i) {
        const auto other = std::find(first.begin(), first.end(), facets_[f].corners[i]) - first.begin();
        facets_[f].across[i] = fresh_[static_cast<std::size_t>(other)];
      }
    }
  }

  // The point goes to the first of these that it is beyond. The one that is furthest stands first there.
  void give_home(std::uint32_t k, const std::vector<std::uint32_t>& facets) {
    for (const std::uint32_t f : facets) {
      if (!is_beyond(f, k)) continue;
      Facet& facet = facets_[f];
      const double high = height(f, k);
      if (facet.outside == none || high > facet.height) {
        next_[k] = facet.outside;
        facet.outside = k;
        facet.height = high;
      } else {
        next_[k] = next_[facet.outside];
        next_[facet.outside] = k;
      }
      return;
    }
  }

  void queue(const std::vector<std::uint32_t>& facets) {
    for (const std::uint32_t f : facets) {
      if (facets_[f].outside != none) waiting_.push_back(f);
    }
  }

  // Adds the first point outside of a facet.
  void add(std::uint32_t from) {
    const std::uint32_t apex = facets_[from].outside;
    facets_[from].outside = next_[apex];
    ++turn_;
    visible_.assign(1, from);
    facets_[from].seen = turn_;
    facets_[from].is_visible = true;
    horizon_.clear();
    for (std::size_t at = 0; at < visible_.size(); ++at) {
      const std::uint32_t f = visible_[at];
      for (std::size_t i = 0; i < d_; ++i) {
        const std::uint32_t other = facets_[f].across[i];
        if (facets_[other].seen != turn_) {
          facets_[other].seen = turn_;
          facets_[other].is_visible = is_beyond(other, apex);
          if (facets_[other].is_visible) visible_.push_back(other);
        }
        if (!facets_[other].is_visible) horizon_.push_back({f, i});
      }
    }
    may_be_interrupted(static_cast<std::uint32_t>(10 * (visible_.size() + horizon_.size())));
    fresh_.clear();
    for (const auto& [f, i] : horizon_) {  // the same order of corners, so the same side is out
      const std::uint32_t other = facets_[f].across[i];
      SimplexCorners corners = facets_[f].corners;
      corners[i] = apex;
      const std::uint32_t g = new_facet(corners);
      fresh_.push_back(g);
      facets_[g].across[i] = other;
      facets_[other].across[slot_across(other, f)] = g;
      facets_[f].across[i] = g;
      facets_[g].seen = turn_;
    }
    for (std::size_t k = 0; k < horizon_.size(); ++k) join(horizon_[k].first, horizon_[k].second, fresh_[k]);
    for (const std::uint32_t f : visible_) {
      for (std::uint32_t k = facets_[f].outside; k != none;) {
        const std::uint32_t after = next_[k];
        give_home(k, fresh_);
        k = after;
      }
    }
    for (const std::uint32_t f : visible_) {
      facets_[f].outside = none;
      exact_.erase(f);
      free_.push_back(f);
    }
    queue(fresh_);
  }

  std::size_t slot_across(std::uint32_t f, std::uint32_t other) const {
    const SimplexCorners& across = facets_[f].across;
    return static_cast<std::size_t>(std::find(across.begin(), across.end(), other) - across.begin());
  }

  std::size_t slot_of(std::uint32_t f, std::uint32_t corner) const {
    const SimplexCorners& corners = facets_[f].corners;
    return static_cast<std::size_t>(std::find(corners.begin(), corners.end(), corner) - corners.begin());
  }

  // The new facet g has replaced corner i of the visible f. Its other neighbours: around each face of f without corners
  // i and j, through the visible facets, to the next ridge of the horizon.
  void join(std::uint32_t f, std::size_t i, std::uint32_t g) {
    for (std::size_t j = 0; j < d_; ++j) {
      if (j == i) continue;
      std::uint32_t at = f, to = f;  // at: visible
      std::size_t out = j, entered = i;
      while (true) {
        to = facets_[at].across[out];
        if (!facets_[to].is_visible) break;
        // The ridge that is left has all corners of `at` but `out`; in `to` all but `entered` are of it.
        const std::uint32_t kept = facets_[at].corners[entered];
        entered = slot_across(to, at);
        out = slot_of(to, kept);
        at = to;
      }
      facets_[g].across[j] = to;
    }
  }

  std::vector<BoundarySimplex> boundary() {
    std::vector<bool> is_free(facets_.size());
    for (const std::uint32_t f : free_) is_free[f] = true;
    std::vector<std::uint32_t> number(facets_.size(), none);
    std::uint32_t count = 0;
    for (std::uint32_t f = 0; f < facets_.size(); ++f) {
      if (!is_free[f]) number[f] = count++;
    }
    std::vector<BoundarySimplex> result;
    result.reserve(count);
    for (std::uint32_t f = 0; f < facets_.size(); ++f) {
      if (is_free[f]) continue;
      BoundarySimplex simplex{facets_[f].corners, {}};
      for (std::size_t i = 0; i < d_; ++i) simplex.across[i] = number[facets_[f].across[i]];
      result.push_back(simplex);
    }
    return result;
  }

  const PlanePoints& points_;
  std::size_t d_;
  std::uint64_t most_;
  QuickhullCost& cost_;
  std::vector<std::uint32_t> next_;  // after each point in the list that it is in
  std::vector<Facet> facets_;
  std::vector<std::uint32_t> free_, waiting_, visible_, fresh_;
  std::vector<std::pair<std::uint32_t, std::size_t>> horizon_;  // a visible facet, and the corner not on the ridge
  std::unordered_map<std::uint32_t, std::vector<Dyadic>> exact_;
  std::uint32_t turn_ = 0;
};

}  // namespace

std::vector<BoundarySimplex> quickhull(const PlanePoints& points, std::span<const std::uint32_t> indices,
                                       std::span<const std::uint32_t> first, std::uint64_t most, QuickhullCost& cost) {
  return Quickhull(points, most, cost).build(indices, first);
}

}  // namespace sunder::polytope
