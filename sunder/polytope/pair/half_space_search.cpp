#include <sunder/polytope/pair/boundary_point.h>
#include <sunder/polytope/pair/candidate_rows.h>
#include <sunder/polytope/pair/half_space_search.h>
#include <sunder/polytope/pair/nearest_search.h>
#include <sunder/polytope/pair/null_vector_internal.h>
#include <sunder/polytope/pair/orthogonal_complement.h>
#include <sunder/polytope/pair/rounded_half_spaces.h>
#include <sunder/polytope/pair/rounded_simplex.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

namespace sunder::polytope {

namespace {

constexpr int most_directions = 64;  // of the search for a direction; it takes some 2 d to 4 d
constexpr double matters = 0x1p-30;  // a weight that is less does not

class HalfSpaceSearch {
 public:
  HalfSpaceSearch(const Polytope& a, const Pose& pose_a, const Polytope& b, const Pose& pose_b, Cost& cost)
      : a_(a, pose_a),
        b_(b, pose_b),
        rounded_a_(a, pose_a),
        rounded_b_(b, pose_b),
        d_(a.dimension()),
        cost_(cost),
        simplex_(d_ + 1) {}

  HalfSpaceProposal propose() {
    HalfSpaceProposal result;
    if (!rounded_a_.is_usable() || !rounded_b_.is_usable()) return result;
    choose_unit();
    result.decision = search();
    if (result.decision) return result;
    for (std::size_t k = 0; k < simplex_.size(); ++k) {
      if (simplex_[k].a == of_a) result.of_a.push_back(simplex_[k].b);
      if (simplex_[k].a == of_b) result.of_b.push_back(simplex_[k].b);
    }
    return result;
  }

 private:
  enum Kind : std::uint32_t { of_a, of_b, height };

  // x is searched as a multiple of a power of two, so that rows (a, -b / unit) are of one size.
  void choose_unit() {
    const double size = std::max(rounded_a_.size(), rounded_b_.size());
    if (size > 0x1p-900 && size < 0x1p900) unit_ = std::ldexp(1.0, std::ilogb(size));
  }

  DifferencePoint point(Kind kind, std::uint32_t k) const {
    DifferencePoint result{kind, k, {}};
    if (kind != height) result.at = (kind == of_a ? rounded_a_ : rounded_b_).row(k);
    result.at[d_] = kind == height ? -1 : -result.at[d_] / unit_;
    return result;
  }

  std::optional<ExactDecision> search() {
    if (!simplex_.add(point(height, 0))) return std::nullopt;
    CandidateRowsOfBoth candidates(a_.body(), b_.body());
    std::optional<ExactDecision> held;
    simplex_.search({}, most_directions, candidates, [&](const ColumnNumbers& y, DifferencePoint& next) {
      if (simplex_.is_at_origin()) return NearestStep::stop;
      ColumnNumbers x{};
      for (std::size_t c = 0; c < d_; ++c) x[c] = y[c] * unit_;
      const double w = y[d_];
      const FurthestPoint from_a = rounded_a_.most_broken(x, w, candidates.a, cost_),
                          from_b = rounded_b_.most_broken(x, w, candidates.b, cost_);
      ++cost_.iterations;
      if (w > 0 && from_a.product < 0 && from_b.product < 0) {
        if (candidates.widen()) return NearestStep::again;
        held = inside(x, w, from_a.product, from_b.product);
        if (held) return NearestStep::stop;
      }
      const bool is_of_a = from_a.product >= from_b.product;
      const FurthestPoint& furthest = is_of_a ? from_a : from_b;
      next = -w * unit_ > furthest.product ? point(height, 0) : point(is_of_a ? of_a : of_b, furthest.index);
      return NearestStep::take;
    });
    if (simplex_.is_full()) return contradiction();
    return !held && simplex_.is_at_origin() ? decide_at_origin() : held;
  }

  // Does the point x / w break no half-space? The greatest numbers of each body's rows were these.
  std::optional<ExactDecision> inside(const ColumnNumbers& x, double w, double greatest_a, double greatest_b) {
    ++cost_.proposals;
    ExactEvidence common{.numbers = {x.begin(), x.begin() + static_cast<std::ptrdiff_t>(d_)}, .denominator = w};
    const auto breaks = [&](Placed& body, const RoundedHalfSpaces& rounded, double greatest) {
      return !rounded.keeps(x, w, greatest) && body.breaks_any(common.numbers, common.denominator, cost_);
    };
    if (breaks(a_, rounded_a_, greatest_a) || breaks(b_, rounded_b_, greatest_b)) return std::nullopt;
    return met_in(std::move(common));
  }

  ExactDecision met_in(ExactEvidence common) {
    common.in_a = a_.in_frame(common.numbers, common.denominator);
    common.in_b = b_.in_frame(common.numbers, common.denominator);
    return proved(Verdict::meet, std::move(common));
  }

  // A row, exactly.
  struct Row {
    Kind kind = of_a;
    std::uint32_t index = 0;
    ExactVector normal{};
    Dyadic side{};
  };

  // Rows of the simplex that are to be in a relation.
  struct Related {
    std::array<Row, most_vectors> rows;
    std::size_t count = 0;
  };

  void add(Related& related, const DifferencePoint& point) {
    Row& row = related.rows[related.count++];
    row.kind = point.a == of_a ? of_a : of_b;
    row.index = point.b;
    row.normal = placed(row.kind).half_space(row.index);
    row.side = std::move(row.normal.back());
    row.normal.pop_back();
  }

  // Are the rows of a full simplex a contradiction? All of them, or those, d + 1 at most, that floating point has in
  // multipliers l >= 0 with sum l a = 0, sum l b < 0.
  std::optional<ExactDecision> contradiction() {
    ++cost_.proposals;
    RoundedProgram program;
    program.rows = d_ + 1;
    Related all;
    for (std::size_t k = 0; k < simplex_.size(); ++k) {
      if (simplex_[k].a == height) continue;
      if (simplex_.has(height, 0)) add(all, simplex_[k]);
      for (std::size_t i = 0; i <= d_; ++i) program.table[i][program.columns] = simplex_[k].at[i];
      ++program.columns;
    }
    if (all.count > 0) {
      const Relation relation = related(all);
      if (relation.decision) return relation.decision;
    }
    const auto basis = program.basis();
    Related some;
    for (std::size_t k = 0, column = 0; k < simplex_.size(); ++k) {
      if (simplex_[k].a != height && basis[column++]) add(some, simplex_[k]);
    }
    return related(some).decision;
  }

  // Multipliers l > 0 of all rows with sum l a = 0: sum l b is negative, and so a contradiction; or zero, and then no
  // common point is off the boundary of any of them.
  struct Relation {
    std::optional<ExactDecision> decision{};
    bool is_tight = false;
  };

  Relation related(const Related& of) {
    if (of.count == 0) return {};
    std::array<ExactVector, most_vectors> normals;
    for (std::size_t k = 0; k < of.count; ++k) normals[k] = of.rows[k].normal;
    auto multipliers = null_vector(std::span(normals).first(of.count));
    if (!multipliers) return {};
    Dyadic side;
    ExactEvidence parting{.numbers = ExactVector(d_)};
    bool is_positive = true;
    for (std::size_t k = 0; k < of.count; ++k) {
      Integer& l = (*multipliers)[k];
      if (l < 0) return {};
      is_positive = is_positive && !l.is_zero();
      if (l.is_zero()) continue;
      const Row& row = of.rows[k];
      const Dyadic weight = dyadic_of(std::move(l), 0);
      side = side + weight * row.side;
      (row.kind == of_a ? parting.of_a : parting.of_b).parts.push_back({row.index, weight * placed(row.kind).scale()});
      if (row.kind == of_a) add_multiple(parting.numbers, weight, row.normal);
    }
    if (side.sign() != Sign::negative) return {{}, is_positive && side.sign() == Sign::zero};
    return {proved(Verdict::apart, std::move(parting))};
  }

  // Where the rows that have weight hold the origin, about, and are fewer than a full simplex: is that a contradiction;
  // or else, is a point on the boundaries of them all in the bodies?
  std::optional<ExactDecision> decide_at_origin() {
    ++cost_.proposals;
    Related of;
    OrthogonalComplement complement(d_ + 1);
    for (std::size_t k = 0; k < simplex_.size(); ++k) {
      if (simplex_[k].a == height || !(simplex_.weight(k) > matters)) continue;
      if (of.count == most_vectors || of.count == d_ + 1) return std::nullopt;
      add(of, simplex_[k]);
      complement.take_out(simplex_[k].at);
    }
    Relation relation = related(of);
    if (relation.decision || !relation.is_tight) return std::move(relation.decision);
    return search_on_boundaries(of, complement);
  }

  // The search for a direction in the complement of these rows: all of them have product zero there.
  std::optional<ExactDecision> search_on_boundaries(const Related& of, const OrthogonalComplement& complement) {
    const auto is_related = [&](Kind kind, std::uint32_t index) {
      return std::any_of(of.rows.begin(), of.rows.begin() + static_cast<std::ptrdiff_t>(of.count),
                         [&](const Row& row) { return row.kind == kind && row.index == index; });
    };
    const auto projected = [&](Kind kind, std::uint32_t index) {
      DifferencePoint result = point(kind, index);
      result.at = complement.coordinates(result.at);
      return result;
    };
    if (complement.dimension() == 0) return std::nullopt;
    NearestSimplex simplex(complement.dimension());
    if (!simplex.add(projected(height, 0))) return std::nullopt;
    CandidateRowsOfBoth candidates(a_.body(), b_.body());
    std::optional<ExactDecision> held;
    simplex.search({}, most_directions, candidates, [&](const ColumnNumbers& direction, DifferencePoint& next) {
      if (simplex.is_at_origin(1)) return NearestStep::stop;
      const ColumnNumbers y = complement.vector(direction);
      ColumnNumbers x{};
      for (std::size_t c = 0; c < d_; ++c) x[c] = y[c] * unit_;
      const double w = y[d_];
      const FurthestPoint from_a = rounded_a_.most_broken(x, w, candidates.a, cost_),
                          from_b = rounded_b_.most_broken(x, w, candidates.b, cost_);
      ++cost_.iterations;
      const bool keeps_a = from_a.product < 0 || is_related(of_a, from_a.index),
                 keeps_b = from_b.product < 0 || is_related(of_b, from_b.index);
      if (w > 0 && keeps_a && keeps_b) {
        held = inside_on_boundaries(of, x, w);
        return !held && candidates.widen() ? NearestStep::again : NearestStep::stop;
      }
      const bool is_of_a = !keeps_a && (keeps_b || from_a.product >= from_b.product);
      next = keeps_a && keeps_b ? projected(height, 0)
             : is_of_a          ? projected(of_a, from_a.index)
                                : projected(of_b, from_b.index);
      return NearestStep::take;
    });
    return held;
  }

  // Does a point on the boundaries of these rows, near x / w, break no half-space?
  std::optional<ExactDecision> inside_on_boundaries(const Related& of, const ColumnNumbers& x, double w) {
    ++cost_.proposals;
    std::array<ExactVector, most_vectors> rows;
    for (std::size_t k = 0; k < of.count; ++k) {
      rows[k] = of.rows[k].normal;
      rows[k].push_back(of.rows[k].side);
    }
    ColumnNumbers near{};
    for (std::size_t c = 0; c < d_; ++c) near[c] = x[c] / w;
    auto point = boundary_point(std::span(rows).first(of.count), near, unit_);
    if (!point) return std::nullopt;
    ExactEvidence common{.numbers = std::move(point->numbers), .denominator = std::move(point->denominator)};
    if (a_.breaks_any(common.numbers, common.denominator, cost_)) return std::nullopt;
    if (b_.breaks_any(common.numbers, common.denominator, cost_)) return std::nullopt;
    return met_in(std::move(common));
  }

  Placed& placed(Kind kind) { return kind == of_a ? a_ : b_; }

  Placed a_, b_;
  RoundedHalfSpaces rounded_a_, rounded_b_;
  std::size_t d_;
  Cost& cost_;
  NearestSimplex simplex_;
  double unit_ = 1;
};

}  // namespace

HalfSpaceProposal search_half_spaces(const Polytope& a, const Pose& pose_a, const Polytope& b, const Pose& pose_b,
                                     Cost& cost) {
  if (!a.is_of_points() && !b.is_of_points()) return HalfSpaceSearch(a, pose_a, b, pose_b, cost).propose();
  if (!a.is_of_points()) return propose_by_game(a, pose_a, b, pose_b, cost);
  HalfSpaceProposal result = propose_by_game(b, pose_b, a, pose_a, cost);
  if (result.decision) result.decision = exchanged(*std::move(result.decision));
  std::swap(result.of_a, result.of_b);
  return result;
}

}  // namespace sunder::polytope
