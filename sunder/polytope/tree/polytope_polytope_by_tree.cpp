#include <sunder/base/contract.h>
#include <sunder/number/rounded_elimination_internal.h>
#include <sunder/polytope/pair/exact_simplex.h>
#include <sunder/polytope/pair/matrix_game.h>
#include <sunder/polytope/pair/placed.h>
#include <sunder/polytope/tree/polytope_polytope_by_tree.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace sunder::polytope {

namespace {

constexpr int most_replies = 200;        // of one round
constexpr double about_tight = 0x1p-30;  // a point so near to the plane of a facet, in its units, may be on it

// The invariants of the paper: a plane has the net of P on one side and the facets of R's net on the other, or a point
// of P's net is within these. Of `neither` floating point does not know.
enum class Invariant : std::uint8_t { separation, inverse_separation, neither, none };

// P's points against R's facets, q . y <= 1 in the numbers of R's trees.
class TreeDescent {
 public:
  TreeDescent(const FaceTrees& p, const Pose& pose_p, const FaceTrees& r, const Pose& pose_r, Cost& cost)
      : p_(p), r_(r), d_(pose_p.dimension()), cost_(cost) {
    is_usable_ = map(pose_p, pose_r);
  }

  // Down both trees, a level of one in each round. `unsure` where the last round did not know.
  Invariant descend(bool& unsure) {
    const FaceTree &faces = *p_.faces(), &polar = *r_.polar();
    if (!is_usable_) return Invariant::none;
    std::uint32_t of_p = 0, of_r = 0;
    for (;;) {
      ++cost_.iterations;
      const FaceTree::Node &node_p = faces.node(of_p), &node_r = polar.node(of_r);
      points_ = faces.vertices(node_p);
      facets_ = polar.vertices(node_r);
      const Invariant found = round();
      if (found == Invariant::none) return found;
      unsure = found == Invariant::neither;
      if (is_separation(found)) {
        keep_plane();
        if (node_p.cones == 0) return Invariant::separation;
        ColumnNumbers along{};
        for (std::size_t c = 0; c < d_; ++c) along[c] = -pulled_back_[c];
        of_p = faces.child_towards(node_p, std::span(along).first(d_), cost_);
      } else {
        if (node_r.cones == 0) return Invariant::inverse_separation;
        of_r = polar.child_towards(node_r, std::span(x_).first(d_), cost_);
      }
    }
  }

  // The same with a point of P that is beyond the last plane.
  Invariant corrected(std::uint32_t point) {
    if (has_column(point)) return Invariant::neither;
    add_column(point);
    const Invariant found = round();
    return found == Invariant::neither || found == Invariant::none ? Invariant::neither : found;
  }

  // A direction of the world along which P is further than the plane, and R is not.
  std::optional<ExactVector> direction() const { return in_world(normal_); }
  const std::vector<ExactVector>& planes() const { return planes_; }

  // Points of P and of R that matter, likely: those with weights, those about on the boundaries, and those of a simplex
  // of R at the point of P.
  void name(std::vector<std::uint32_t>& of_p, std::vector<std::uint32_t>& of_r) const {
    double furthest = 0;
    std::uint32_t behind = FaceTree::none;
    for (std::size_t j = 0; j < columns_.size(); ++j) {
      if (game_->column_weight(j) > 0) of_p.push_back(columns_[j].index);
    }
    for (const std::uint32_t k : points_) {
      if (std::fabs(along_normal(k) - offset_) <= about_tight * std::fabs(offset_)) of_p.push_back(k);
    }
    const auto look_at = [&](std::uint32_t facet, bool has_weight) {
      const std::span<const double> q = r_.polar()->point(facet);
      const double along = dot_of(q, x_);
      if (along > furthest) {
        furthest = along;
        behind = facet;
      }
      if (has_weight || std::fabs(along - 1) <= about_tight) add_corners(facet, along, of_r);
    };
    for (std::size_t i = 0; i < rows_.size(); ++i) look_at(rows_[i].index, game_->row_weight(i) > 0);
    for (const std::uint32_t f : facets_) look_at(f, false);
    if (behind != FaceTree::none) add_corners(behind, furthest, of_r);
    of_r.insert(of_r.end(), r_.center_rows().begin(), r_.center_rows().end());
    for (std::vector<std::uint32_t>* const rows : {&of_p, &of_r}) {
      std::sort(rows->begin(), rows->end());
      rows->erase(std::unique(rows->begin(), rows->end()), rows->end());
    }
  }

 private:
  struct Item {
    std::uint32_t index = 0;
    ColumnNumbers at{};
  };

  double dot_of(std::span<const double> u, std::span<const double> v) const {
    double sum = 0;
    for (std::size_t c = 0; c < d_; ++c) sum += u[c] * v[c];
    return sum;
  }

  // y of R = linear_ y of P + shift_.
  bool map(const Pose& pose_p, const Pose& pose_r) {
    if (!rounded_inverse(d_, pose_r.linear(), std::span(inverse_).first(d_ * d_))) return false;
    ColumnNumbers moved{};
    for (std::size_t c = 0; c < d_; ++c) {
      moved[c] = pose_p.translation()[c] - pose_r.translation()[c];
      for (std::size_t k = 0; k < d_; ++k) moved[c] += pose_p.linear(c, k) * p_.center(k);
    }
    bool is_finite = true;
    for (std::size_t c = 0; c < d_; ++c) {
      double at = -r_.center(c);
      for (std::size_t k = 0; k < d_; ++k) {
        at += inverse_[c * d_ + k] * moved[k];
        double sum = 0;
        for (std::size_t m = 0; m < d_; ++m) sum += inverse_[c * d_ + m] * pose_p.linear(m, k);
        linear_[c * d_ + k] = std::ldexp(sum, p_.unit(k) - r_.unit(c));
        is_finite = is_finite && std::isfinite(linear_[c * d_ + k]);
      }
      shift_[c] = std::ldexp(at, -r_.unit(c));
      is_finite = is_finite && std::isfinite(shift_[c]);
    }
    return is_finite;
  }

  static bool is_separation(Invariant found) { return found == Invariant::separation || found == Invariant::neither; }

  bool has_column(std::uint32_t k) const {
    return std::any_of(columns_.begin(), columns_.end(), [&](const Item& item) { return item.index == k; });
  }
  bool has_row(std::uint32_t k) const {
    return std::any_of(rows_.begin(), rows_.end(), [&](const Item& item) { return item.index == k; });
  }

  Item column(std::uint32_t k) const {
    Item item{k, shift_};
    const std::span<const double> y = p_.faces()->point(k);
    for (std::size_t c = 0; c < d_; ++c) item.at[c] += dot_of(std::span(linear_).subspan(c * d_, d_), y);
    return item;
  }
  Item row(std::uint32_t k) const {
    Item item{k, {}};
    std::copy_n(r_.polar()->point(k).begin(), d_, item.at.begin());
    return item;
  }
  double payoff(const Item& of_row, const Item& of_column) const { return dot_of(of_row.at, of_column.at) - 1; }

  void add_column(std::uint32_t k) {
    if (columns_.size() == MatrixGame::most) keep_weighted();
    columns_.push_back(column(k));
    game_->add_column([&](std::size_t i) { return payoff(rows_[i], columns_.back()); });
  }
  void add_row(std::uint32_t k) {
    if (rows_.size() == MatrixGame::most) keep_weighted();
    rows_.push_back(row(k));
    game_->add_row([&](std::size_t j) { return payoff(rows_.back(), columns_[j]); });
  }

  // A game of only those that have a weight.
  void keep_weighted() {
    std::vector<Item> columns, rows;
    for (std::size_t j = 0; j < columns_.size(); ++j) {
      if (game_->column_weight(j) > 0) columns.push_back(columns_[j]);
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (game_->row_weight(i) > 0) rows.push_back(rows_[i]);
    }
    columns_ = std::move(columns);
    rows_ = std::move(rows);
    game_ = std::make_unique<MatrixGame>();
    for (std::size_t j = 0; j < columns_.size(); ++j) game_->add_column([](std::size_t) { return 0.0; });
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      game_->add_row([&](std::size_t j) { return payoff(rows_[i], columns_[j]); });
    }
  }

  // The product of the normal with the image of a point of P.
  double along_normal(std::uint32_t k) const { return dot_of(p_.faces()->point(k), pulled_back_) + shifted_; }

  // By best replies, until the sign is known.
  Invariant round() {
    if (columns_.empty()) {
      add_column(points_.front());
      x_ = columns_[0].at;
      add_row(most_broken().first);
    }
    for (int reply = 0; reply < most_replies; ++reply) {
      if (!game_->solve()) return Invariant::none;
      set_mixture();
      const auto [facet, broken] = most_broken();
      const auto [point, least] = least_far();
      double of_rows = broken, of_columns = least;
      for (const Item& item : rows_) of_rows = std::max(of_rows, dot_of(item.at, x_) - 1);
      for (const Item& item : columns_) of_columns = std::min(of_columns, dot_of(item.at, normal_) - offset_);
      if (!std::isfinite(of_rows) || !std::isfinite(of_columns)) return Invariant::none;
      if (of_columns > about_zero()) return Invariant::separation;
      if (of_rows < -0x1p-44) return Invariant::inverse_separation;
      const bool new_row = facet != FaceTree::none && !has_row(facet);
      const bool new_column = point != FaceTree::none && !has_column(point);
      if (!new_row && !new_column) return Invariant::neither;
      if (new_column) add_column(point);
      if (new_row) add_row(facet);
    }
    return Invariant::neither;
  }

  double about_zero() const { return 0x1p-44 * std::fabs(offset_); }

  void set_mixture() {
    x_ = normal_ = {};
    offset_ = 0;
    double total = 0;
    for (std::size_t j = 0; j < columns_.size(); ++j) {
      const double weight = game_->column_weight(j);
      total += weight;
      for (std::size_t c = 0; c < d_; ++c) x_[c] += weight * columns_[j].at[c];
    }
    for (std::size_t c = 0; c < d_; ++c) x_[c] /= total;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const double weight = game_->row_weight(i);
      offset_ += weight;
      for (std::size_t c = 0; c < d_; ++c) normal_[c] += weight * rows_[i].at[c];
    }
    pulled_back_ = {};
    for (std::size_t c = 0; c < d_; ++c) {
      for (std::size_t k = 0; k < d_; ++k) pulled_back_[k] += normal_[c] * linear_[c * d_ + k];
    }
    shifted_ = dot_of(normal_, shift_);
  }

  // The facet of R's node that x breaks most, and by how much.
  std::pair<std::uint32_t, double> most_broken() {
    cost_.probes += facets_.size();
    std::pair<std::uint32_t, double> best{FaceTree::none, -1};  // the origin
    for (const std::uint32_t f : facets_) {
      const double broken = dot_of(r_.polar()->point(f), x_) - 1;
      if (broken > best.second || best.first == FaceTree::none) best = {f, broken};
    }
    return best;
  }

  // The point of P's node that is least far along the normal, and by how much it is beyond the plane.
  std::pair<std::uint32_t, double> least_far() {
    cost_.probes += points_.size();
    std::pair<std::uint32_t, double> best{FaceTree::none, std::numeric_limits<double>::infinity()};
    for (const std::uint32_t k : points_) {
      const double beyond = along_normal(k) - offset_;
      if (beyond < best.second) best = {k, beyond};
    }
    return best;
  }

  void add_corners(std::uint32_t facet, double along, std::vector<std::uint32_t>& rows) const {
    const std::span<const std::uint32_t> all = r_.corners_of(facet);
    if (all.size() <= 2 * d_) {
      rows.insert(rows.end(), all.begin(), all.end());
      return;
    }
    ColumnNumbers at = x_;
    for (std::size_t c = 0; c < d_; ++c) at[c] /= along;
    r_.add_simplex_of(facet, std::span(at).first(d_), rows);
  }

  void keep_plane() {
    if (std::optional<ExactVector> plane = in_world(normal_)) planes_.push_back(std::move(*plane));
  }

  std::optional<ExactVector> in_world(const ColumnNumbers& normal) const {
    int least = std::numeric_limits<int>::max();
    for (std::size_t c = 0; c < d_; ++c) least = std::min(least, r_.unit(c));
    ExactVector result;
    bool is_zero = true;
    for (std::size_t k = 0; k < d_; ++k) {
      double sum = 0;
      for (std::size_t c = 0; c < d_; ++c) sum += std::ldexp(normal[c], least - r_.unit(c)) * inverse_[c * d_ + k];
      if (!std::isfinite(sum)) return std::nullopt;
      is_zero = is_zero && !(std::fabs(sum) > 0);
      result.emplace_back(-sum);
    }
    if (is_zero) return std::nullopt;
    return result;
  }

  const FaceTrees &p_, &r_;
  std::size_t d_;
  Cost& cost_;
  bool is_usable_ = false;
  std::array<double, most_dimension * most_dimension> inverse_{}, linear_{};
  ColumnNumbers shift_{};
  std::vector<Item> rows_, columns_;
  std::unique_ptr<MatrixGame> game_ = std::make_unique<MatrixGame>();
  std::span<const std::uint32_t> points_, facets_;  // of the nodes
  ColumnNumbers x_{}, normal_{}, pulled_back_{};
  double offset_ = 0, shifted_ = 0;
  std::vector<ExactVector> planes_;
};

// By the simplex method over both bodies; what it takes are no rounds.
ExactDecision finished(const FaceTrees& a, const Pose& pose_a, const FaceTrees& b, const Pose& pose_b,
                       std::span<const std::uint32_t> of_a, std::span<const std::uint32_t> of_b, Cost& cost) {
  Cost own;
  ExactDecision decision = decide_exactly({a.walks(), pose_a}, {b.walks(), pose_b}, of_a, of_b, own);
  cost.probes += own.probes;
  cost.exact += own.exact;
  cost.proposals += own.iterations;
  return decision;
}

// P against R; R is full.
ExactDecision decide_by_descent(const FaceTrees& p, const Pose& pose_p, const FaceTrees& r, const Pose& pose_r,
                                PolytopeAnswer& answer) {
  const std::size_t d = pose_p.dimension();
  const auto most_corrections = static_cast<std::uint32_t>(2 * d + 2);
  Placed at_p(p.walks(), pose_p), at_r(r.walks(), pose_r);
  for (Placed* const body : {&at_p, &at_r}) {
    while (body->deepen()) continue;
  }
  const auto is_whole = [&] { return at_p.scans() + at_r.scans() == 0; };
  TreeDescent descent(p, pose_p, r, pose_r, answer.cost);
  bool unsure = false;
  Invariant found = descent.descend(unsure);
  const Verdict said = found == Invariant::separation ? Verdict::apart : Verdict::meet;
  std::uint32_t corrections = 0;
  while (found == Invariant::separation && corrections <= most_corrections) {
    std::optional<ExactVector> along = descent.direction();
    if (!along) break;
    ++answer.cost.proposals;
    const ExactFurthest of_p = at_p.furthest(*along, answer.cost), of_r = at_r.furthest(negated(*along), answer.cost);
    if ((of_p.product + of_r.product).sign() == Sign::negative) {
      answer.decided_by = is_whole() ? DecidedBy::evidence : DecidedBy::finishing;
      return proved(Verdict::apart, ExactEvidence{.numbers = std::move(*along)});
    }
    ++corrections;
    found = descent.corrected(of_p.index);
  }
  std::vector<std::uint32_t> of_p, of_r;
  if (found != Invariant::none) {
    descent.name(of_p, of_r);
    ++answer.cost.proposals;
    if (auto decision = decide_by_few(at_p, at_r, of_p, of_r, most_corrections, answer.cost)) {
      const bool is_as_said = unsure || decision->verdict == said;
      answer.decided_by = is_whole() && is_as_said ? DecidedBy::evidence : DecidedBy::finishing;
      return *decision;
    }
  }
  answer.decided_by = DecidedBy::finishing;
  return finished(p, pose_p, r, pose_r, of_p, of_r, answer.cost);
}

// The planes of the descent's rounds, each moved to the end of R: half-spaces that hold R, the greatest double for an
// offset; and multipliers of them, so that their combination holds no point of P.
std::optional<HyperplaneEvidence> planes_of_descent(const FaceTrees& p, const Pose& pose_p, const FaceTrees& r,
                                                    const Pose& pose_r) {
  const std::size_t d = pose_p.dimension();
  Cost cost;
  TreeDescent descent(p, pose_p, r, pose_r, cost);
  bool unsure = false;
  if (descent.descend(unsure) != Invariant::separation) return std::nullopt;
  Placed at_p(p.walks(), pose_p), at_r(r.walks(), pose_r);
  for (Placed* const body : {&at_p, &at_r}) {
    while (body->deepen()) continue;
  }
  std::vector<double> rows;
  HyperplaneEvidence result;
  for (const ExactVector& plane : descent.planes()) {
    const ExactVector normal = negated(plane);
    double offset = at_r.furthest(normal, cost).product.nearest();
    offset = std::nextafter(offset, std::numeric_limits<double>::infinity());
    if (!std::isfinite(offset)) return std::nullopt;
    for (const Dyadic& x : normal) rows.push_back(x.nearest());
    rows.push_back(offset);
    ExactVector in_frame = pulled(pose_r, normal);
    in_frame.push_back(Dyadic(offset) - dot(normal, pose_r.translation()));
    result.b.planes.push_back(std::move(in_frame));
  }
  const Polytope around = Polytope::from_half_spaces(d, std::move(rows));
  const Pose here(d);
  ExactDecision decision = decide_exactly({around, here}, {p.walks(), pose_p}, {}, {}, cost);
  if (decision.verdict == Verdict::meet) return std::nullopt;
  result.b.multipliers = decision.evidence->of_a;
  result.direction = negated(decision.evidence->numbers);
  const ExactFurthest end = at_p.furthest(result.direction, cost);
  ExactVector tangent = pulled(pose_p, result.direction);
  tangent.push_back(end.product - dot(result.direction, pose_p.translation()));
  result.a.planes.push_back(std::move(tangent));
  result.a.multipliers.parts.push_back({0, Dyadic(1.0)});
  result.a.are_shells = result.b.are_shells = false;
  return result;
}

}  // namespace

std::optional<HyperplaneEvidence> hyperplanes_by_tree(const FaceTrees& a, const Pose& pose_a, const FaceTrees& b,
                                                      const Pose& pose_b) {
  if (a.faces() && b.polar()) return planes_of_descent(a, pose_a, b, pose_b);
  if (!b.faces() || !a.polar()) return std::nullopt;
  std::optional<HyperplaneEvidence> found = planes_of_descent(b, pose_b, a, pose_a);
  if (!found) return found;
  found->direction = negated(std::move(found->direction));
  std::swap(found->a, found->b);
  return found;
}

PolytopeAnswer polytope_polytope_by_tree(const FaceTrees& a, const Pose& pose_a, const FaceTrees& b,
                                         const Pose& pose_b) {
  SUNDER_REQUIRE(a.body().dimension() == b.body().dimension());
  SUNDER_REQUIRE(pose_a.dimension() == a.body().dimension());
  SUNDER_REQUIRE(pose_b.dimension() == a.body().dimension());
  PolytopeAnswer answer;
  ExactDecision decision;
  if (a.faces() && b.polar()) {
    decision = decide_by_descent(a, pose_a, b, pose_b, answer);
  } else if (b.faces() && a.polar()) {
    decision = exchanged(decide_by_descent(b, pose_b, a, pose_a, answer));
  } else {
    decision = finished(a, pose_a, b, pose_b, {}, {}, answer.cost);
    answer.decided_by = DecidedBy::finishing;
  }
  answer.evidence = evidence_of(decision.verdict, std::move(decision.evidence));
  return answer;
}

}  // namespace sunder::polytope
