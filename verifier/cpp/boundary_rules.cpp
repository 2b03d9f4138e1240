// The rule about convex hulls of points of R^d, as facets: docs/claims.md, "Boundaries".
#include <verifier/cpp/linear.h>
#include <verifier/cpp/rules.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace sunder_verifier {
namespace {

// Nothing of rows that are not independent, as the first columns tell.
std::optional<Elimination> eliminated(const std::vector<Integers>& rows, std::size_t columns) {
  Elimination result(columns);
  for (const Integers& row : rows) {
    if (!result.take(row)) return std::nullopt;
  }
  return result;
}

struct Plane {
  Integers normal;
  Integer height;        // positive
  bool is_even = false;  // on which side of it the mean is, by the order of the corners
};

class Boundary {
 public:
  Boundary(const Indices& homes, const HullBody& body, const std::vector<IndexLists>& facets) : homes_(homes) {
    for (std::size_t f = 0; f < facets.size(); ++f) {
      held_.emplace_back();
      for (const Indices& simplex : facets[f]) {
        simplices_.push_back(simplex);
        facet_of_.push_back(f);
        held_[f].insert(simplex.begin(), simplex.end());
      }
      corners_.insert(held_[f].begin(), held_[f].end());
    }
    k_ = simplices_[0].size();
    const Integer count = corners_.size();
    const std::size_t size = k_ * (body.given->bits + bits(count) + 1) / 2;
    take_steps((body.rows().size() + simplices_.size()) * k_ * k_ * k_, size, size);
    Integers mean(body.dimension());
    for (const std::size_t v : corners_) {
      for (std::size_t c = 0; c < mean.size(); ++c) mean[c] += body.rows()[v][c];
    }
    for (const Integers& row : body.rows()) {
      points_.emplace_back();
      for (std::size_t c = 0; c < mean.size(); ++c) points_.back().push_back(count * row[c] - mean[c]);
    }
  }

  void check() {
    look_at_flat();
    for (std::size_t s = 0; s < simplices_.size(); ++s) take_simplex(s);
    look_at_ridges();
    look_through_first();
    look_at_corners();
    for (std::size_t q = 0; q < homes_.size(); ++q) look_at_home(q);
  }

 private:
  std::vector<Integers> corners_of(const Indices& simplex) const {
    std::vector<Integers> result;
    for (const std::size_t v : simplex) result.push_back(points_[v]);
    return result;
  }

  // All points are in the flat of the first simplex and the mean; then those columns are left that tell the others.
  void look_at_flat() {
    const std::size_t d = points_[0].size();
    const auto found = eliminated(corners_of(simplices_[0]), d);
    require(found.has_value(), "boundary", "the corners of the first simplex and the mean of all are in a flat");
    Indices columns = found->columns();
    std::sort(columns.begin(), columns.end());
    for (std::size_t q = 0; q < points_.size(); ++q) {
      for (std::size_t c = 0; c < d; ++c) {
        if (std::binary_search(columns.begin(), columns.end(), c)) continue;
        Integer rest = found->unit() * points_[q][c];
        for (std::size_t r = 0; r < k_; ++r) rest -= points_[q][found->columns()[r]] * found->row(r)[c];
        require(rest == 0, "boundary", "point " + std::to_string(q) + " is not in the flat of the first simplex");
      }
    }
    for (Integers& point : points_) {
      Integers left;
      for (const std::size_t c : columns) left.push_back(point[c]);
      point = std::move(left);
    }
  }

  std::optional<Plane> plane_of(const Indices& simplex) const {
    std::vector<Integers> rows = corners_of(simplex);
    for (Integers& row : rows) row.emplace_back(1);
    const auto found = eliminated(rows, k_);
    if (!found) return std::nullopt;
    const bool is_positive = found->unit() > 0;
    Plane plane{Integers(k_), abs(found->unit()), is_odd(found->columns()) == is_positive};
    for (std::size_t r = 0; r < k_; ++r) {
      plane.normal[found->columns()[r]] = is_positive ? found->row(r)[k_] : Integer(-found->row(r)[k_]);
    }
    return plane;
  }

  void take_simplex(std::size_t s) {
    auto plane = plane_of(simplices_[s]);
    require(plane && (planes_.empty() || plane->is_even == planes_[0].is_even), "boundary",
            "simplex " + std::to_string(s) + " is not seen from the mean as the first one is");
    planes_.push_back(std::move(*plane));
    const std::size_t f = facet_of_[s];
    if (s == 0 || facet_of_[s - 1] < f) {
      for (const std::size_t v : held_[f]) {
        require(dot(planes_[s].normal, points_[v]) == planes_[s].height, "boundary",
                "facet " + std::to_string(f) + " is not in one plane");
      }
    }
    for (std::size_t i = 0; i < k_; ++i) {
      const bool is_new = ridges_.take(ridge_of(simplices_[s], i), {s, simplices_[s][i]});
      require(is_new, "boundary", "two simplices are on one side of a ridge of simplex " + std::to_string(s));
    }
  }

  void look_at_ridges() const {
    for (std::size_t s = 0; s < simplices_.size(); ++s) {
      for (std::size_t i = 0; i < k_; ++i) {
        const auto* const twin = ridges_.beyond(ridge_of(simplices_[s], i));
        require(twin != nullptr, "boundary", "only one simplex contains a ridge of simplex " + std::to_string(s));
        const auto [t, w] = *twin;
        require(facet_of_[s] == facet_of_[t] || dot(planes_[s].normal, points_[w]) < planes_[s].height, "boundary",
                "facets " + std::to_string(facet_of_[s]) + " and " + std::to_string(facet_of_[t]) +
                    " are not convex at a ridge");
      }
    }
  }

  // Is the point a combination of the corners, with no number less than zero?
  bool is_in_cone(const Indices& simplex, const Integers& point) const {
    std::vector<Integers> rows(k_);
    for (std::size_t c = 0; c < k_; ++c) {
      for (const std::size_t v : simplex) rows[c].push_back(points_[v][c]);
      rows[c].push_back(point[c]);
    }
    const auto found = eliminated(rows, k_);
    bool is_in = found.has_value();
    for (std::size_t r = 0; is_in && r < k_; ++r) is_in = found->row(r)[k_] * found->unit() >= 0;
    return is_in;
  }

  // No other simplex is met on the way through the middle of the first.
  void look_through_first() const {
    Integers middle(k_);
    for (const std::size_t v : simplices_[0]) {
      for (std::size_t c = 0; c < k_; ++c) middle[c] += points_[v][c];
    }
    std::size_t axis = 0;
    for (std::size_t c = 1; c < k_; ++c) {
      if (abs(middle[c]) > abs(middle[axis])) axis = c;
    }
    std::map<std::size_t, std::vector<int>> signs;  // of products that are zero of the middle
    for (const std::size_t v : corners_) {
      for (std::size_t c = 0; c < k_; ++c) {
        if (c != axis) signs[v].push_back(Integer(points_[v][c] * middle[axis] - points_[v][axis] * middle[c]).sign());
      }
    }
    for (std::size_t s = 1; s < simplices_.size(); ++s) {
      bool is_beside = false;
      for (std::size_t i = 0; i + 1 < k_ && !is_beside; ++i) {
        const int first = signs.at(simplices_[s][0])[i];
        is_beside = first != 0 && std::all_of(simplices_[s].begin(), simplices_[s].end(),
                                              [&](std::size_t v) { return signs.at(v)[i] == first; });
      }
      require(is_beside || !is_in_cone(simplices_[s], middle), "boundary",
              "simplex " + std::to_string(s) + " is in the way of the first");
    }
  }

  // The facets at a corner have no other one in common.
  void look_at_corners() const {
    std::map<std::size_t, Indices> facets_at;
    for (std::size_t f = 0; f < held_.size(); ++f) {
      for (const std::size_t v : held_[f]) facets_at[v].push_back(f);
    }
    for (const auto& [v, facets] : facets_at) {
      const std::size_t least = *std::min_element(facets.begin(), facets.end(), [&](std::size_t f, std::size_t g) {
        return held_[f].size() < held_[g].size();
      });
      take_steps(facets.size() * held_[least].size(), 0, 0);
      for (const std::size_t w : held_[least]) {
        const bool is_common = w != v && std::all_of(facets.begin(), facets.end(),
                                                     [&, at = w](std::size_t f) { return held_[f].contains(at); });
        require(!is_common, "boundary", "point " + std::to_string(v) + " is between others");
      }
    }
  }

  void look_at_home(std::size_t q) const {
    const std::size_t home = homes_[q];
    if (home == no_index) {
      require(corners_.contains(q), "boundary", "point " + std::to_string(q) + " has no home");
      return;
    }
    const bool is_below = dot(planes_[home].normal, points_[q]) <= planes_[home].height;
    require(is_below && is_in_cone(simplices_[home], points_[q]), "boundary",
            "point " + std::to_string(q) + " is not in its home");
  }

  const Indices& homes_;
  IndexLists simplices_;
  Indices facet_of_;                         // of each simplex
  std::vector<std::set<std::size_t>> held_;  // of each facet its corners
  std::set<std::size_t> corners_;
  std::size_t k_ = 0;
  std::vector<Integers> points_;  // seen from the mean
  std::vector<Plane> planes_;     // of simplices
  Ridges<IndexPair> ridges_;      // their owners: a simplex, and its corner that is not of the ridge
};

void check_boundary(const Indices& simplices, const HullBody& body, const std::vector<IndexLists>& facets) {
  Boundary(simplices, body, facets).check();
}

}  // namespace

const ClaimRows claims_of_boundaries{
    {"boundary", "simplices: simplices of subject", rule<check_boundary>},
};

}  // namespace sunder_verifier
