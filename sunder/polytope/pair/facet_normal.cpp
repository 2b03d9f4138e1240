#include <sunder/polytope/pair/candidate_rows.h>
#include <sunder/polytope/pair/facet_normal.h>
#include <sunder/polytope/pair/null_vector_internal.h>
#include <sunder/polytope/pair/orthogonal_complement.h>
#include <sunder/polytope/pair/support.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace sunder::polytope {

namespace {

constexpr int most_normal_steps = 32;     // of the search in a complement
constexpr double part_matters = 0x1p-30;  // a weight that is less does not
constexpr double about = 0x1p-40;         // of the size of a difference: no further than this is not further

class FacetSearch {
 public:
  FacetSearch(const Placed& a, const Placed& b, Cost& cost)
      : a_(a), b_(b), d_(a.dimension()), cost_(cost), complement_(d_) {}

  std::optional<ExactVector> normal(const NearestSimplex& simplex) {
    const bool is_at_origin = simplex.is_at_origin();
    if (simplex.size() < d_ && !is_at_origin) return std::nullopt;
    take(simplex, is_at_origin ? part_matters : -1);
    while (complement_.dimension() > 1 && missing_ == 0) {
      if (!search()) return std::nullopt;
    }
    return exact_normal();
  }

 private:
  DifferencePoint difference(std::uint32_t i, std::uint32_t j) const {
    return rounded_difference(a_.body(), a_.pose(), i, b_.body(), b_.pose(), j);
  }

  // Takes points into the flat whose weight is more than that, those with most weight first.
  void take(const NearestSimplex& simplex, double least) {
    std::array<std::size_t, most_dimension + 1> order{};
    for (std::size_t k = 0; k < simplex.size(); ++k) order[k] = k;
    std::sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(simplex.size()),
              [&](std::size_t i, std::size_t j) { return simplex.weight(i) > simplex.weight(j); });
    for (std::size_t k = 0; k < simplex.size() && complement_.dimension() > 1; ++k) {
      if (!(simplex.weight(order[k]) > least)) continue;
      const DifferencePoint point = difference(simplex[order[k]].a, simplex[order[k]].b);
      if (count_ > 0) {
        Vector edge{};
        for (std::size_t c = 0; c < d_; ++c) edge[c] = point.at[c] - flat_[0].at[c];
        if (!complement_.take_out(edge)) continue;
      }
      flat_[count_++] = point;
    }
  }

  // From the flat on. True where more points are taken, or nothing is missing any more.
  bool search() {
    const std::size_t m = complement_.dimension();
    // From somewhere in the bodies towards the flat.
    const DifferencePoint inner = difference(a_.body().size() / 2, b_.body().size() / 2);
    NearestSimplex simplex(m);
    CandidateRowsOfBoth candidates(a_.body(), b_.body());
    double largest = 0;  // of differences
    bool is_filled = false;
    const auto probe = [&](const Vector& y, DifferencePoint& next) {
      if (simplex.is_at_origin(4 * largest)) return NearestStep::stop;
      const Vector along = complement_.vector(y);
      const FurthestPoint of_a = likely_support(candidates.a, a_.pose(), along, 1, cost_),
                          of_b = likely_support(candidates.b, b_.pose(), along, -1, cost_);
      ++cost_.iterations;
      next = difference(of_a.index, of_b.index);
      double size = 0, product = 0;
      for (std::size_t c = 0; c < d_; ++c) size = std::max(size, std::fabs(next.at[c] - flat_[0].at[c]));
      for (std::size_t c = 0; c < d_; ++c) product += along[c] * (next.at[c] - flat_[0].at[c]);
      if (!(product > about * size)) {  // it supports them
        if (candidates.widen()) return NearestStep::again;
        is_filled = fill_up(along);
        return NearestStep::stop;
      }
      next.at = complement_.coordinates(next.at);
      largest = std::max(largest, size);
      return NearestStep::take;
    };
    simplex.search(complement_.coordinates(inner.at), most_normal_steps, candidates, probe);
    if (is_filled || simplex.is_full() || !simplex.is_at_origin(4 * largest)) return is_filled;
    take(simplex, part_matters);
    return complement_.dimension() < m;
  }

  // The plane is to be orthogonal to this direction.
  bool fill_up(const Vector& along) {
    if (!complement_.take_out(along)) return false;
    for (; missing_ < complement_.dimension(); ++missing_) {
      for (std::size_t c = 0; c < d_; ++c) {
        others_[missing_][c] = std::nearbyint(complement_.base(missing_)[c] * 0x1p40) * 0x1p-40;
      }
    }
    return true;
  }

  std::optional<ExactVector> exact_normal() {
    if (count_ == 0) return std::nullopt;
    std::array<ExactVector, most_vectors> columns;  // one row each of edges from the first difference
    ExactVector first;
    for (std::size_t k = 0; k < count_; ++k) {
      const ExactVector of_a = a_.image(flat_[k].a), of_b = b_.image(flat_[k].b);
      for (std::size_t c = 0; c < d_; ++c) {
        if (k == 0) first.push_back(of_a[c] - of_b[c]);
        if (k > 0) columns[c].push_back(of_a[c] - of_b[c] - first[c]);
      }
    }
    for (std::size_t k = 0; k < missing_; ++k) {
      for (std::size_t c = 0; c < d_; ++c) columns[c].emplace_back(others_[k][c]);
    }
    const auto normal = null_vector(std::span(columns).first(d_));
    if (!normal) return std::nullopt;
    ExactVector y;
    for (std::size_t c = 0; c < d_; ++c) y.push_back(dyadic_of((*normal)[c], 0));
    if (dot(y, first).sign() == Sign::positive) y = negated(std::move(y));  // towards B
    return y;
  }

  const Placed &a_, &b_;
  std::size_t d_;
  Cost& cost_;
  OrthogonalComplement complement_;
  std::array<DifferencePoint, most_dimension> flat_{};
  std::array<Vector, most_dimension> others_{};  // that the plane has the directions of
  std::size_t count_ = 0, missing_ = 0;          // of the flat; of the others, which complete it
};

}  // namespace

std::optional<ExactVector> facet_normal(const Placed& a, const Placed& b, const NearestSimplex& simplex, Cost& cost) {
  return FacetSearch(a, b, cost).normal(simplex);
}

}  // namespace sunder::polytope
