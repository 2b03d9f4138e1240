#include <sunder/base/lanes.h>
#include <sunder/solid/search/caratheodory.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace sunder::solid {

namespace {

// Of the vertices that make a tetrahedron which holds the origin, five that are enough (Caratheodory's theorem), in
// floating point. This is what a search for deep bodies ends with; so there are no branches, and no stores of single
// numbers into rows that are read whole.
//
// The four difference vertices w_k = a_k - b_k have weights m_k > 0 with sum m_k w_k = 0. Moving weight from a_0 to a_k
// is made good by weight on the w_m: with sum y_m w_m = a_0 - a_k and sum y_m = 0, the weights may move along
//   1 at a_k, -1 at a_0, and y_m at both a_m and b_m
// until the first one vanishes. The three moves, k = 1, 2, 3, are independent; after each, the others are combined with
// it so that they leave alone what has vanished. Five columns without a dependency are left, so no vertex twice.
class TetrahedronReduction {
 public:
  // The weights: of the origin in the tetrahedron, up to a factor, all positive.
  TetrahedronReduction(const Placed& a, const DifferenceSimplex& tetrahedron, const std::array<double, 4>& weights)
      : vertex_(tetrahedron.vertex) {
    const Point3 w0 = vertex_[0].at, a0 = a.turned(vertex_[0].a, tetrahedron.scale);
    const Point3 e1 = minus(vertex_[1].at, w0), e2 = minus(vertex_[2].at, w0), e3 = minus(vertex_[3].at, w0);
    const Point3 n1 = cross(e2, e3), n2 = cross(e3, e1), n3 = cross(e1, e2);
    const double scale = 1 / dot(e1, n1);
    const auto move = [&](std::size_t k, double to1, double to2, double to3) {
      const Point3 back = minus(a0, a.turned(vertex_[k].a, tetrahedron.scale));
      const double y1 = dot(n1, back) * scale, y2 = dot(n2, back) * scale, y3 = dot(n3, back) * scale;
      const double y0 = -(y1 + y2 + y3);
      return Row{Lanes{y0 - 1, y1 + to1}, Lanes{y2 + to2, y3 + to3}, Lanes{y0, y1}, Lanes{y2, y3}};
    };
    moves_ = {move(1, 1, 0, 0), move(2, 0, 1, 0), move(3, 0, 0, 1)};
    const Lanes w01{weights[0], weights[1]}, w23{weights[2], weights[3]};
    weight_ = {w01, w23, w01, w23};
  }

  // Names the five vertices. False where rounding has left no move, or vertices of one body only.
  bool reduce(Proposal& proposal) {
    std::uint32_t held = 255;  // a bit for each place
    for (std::size_t k = 0; k < 3; ++k) {
      const Row& move = moves_[k];
      Row speed;
      for (std::size_t i = 0; i < 4; ++i) speed[i] = move[i] / weight_[i];
      const std::uint32_t leaver = first_of_greatest(speed.data(), 4);
      if (!(at(speed, leaver) > 0)) return false;
      held &= ~(1u << leaver);
      const Row& others = others_than[leaver];
      const double step = 1 / at(speed, leaver), part = 1 / at(move, leaver);
      for (std::size_t next = k + 1; next < 3; ++next) {
        Row& changed = moves_[next];
        const double factor = at(changed, leaver) * part;
        for (std::size_t i = 0; i < 4; ++i) changed[i] = (changed[i] - factor * move[i]) * others[i];
      }
      // What has vanished counts as 1 from here on; no move touches it.
      for (std::size_t i = 0; i < 4; ++i) weight_[i] = (weight_[i] - step * move[i]) * others[i] + (1 - others[i]);
    }
    proposal.claim = Proposal::Claim::meet;
    std::uint32_t of_a = 0;
    for (std::size_t k = 0; k < 5; ++k) {
      const std::size_t place = static_cast<std::size_t>(std::countr_zero(held)) % places;
      proposal.vertices[k] = place < 4 ? vertex_[place].a : vertex_[place - 4].b;
      of_a += std::uint32_t{place < 4};
      held &= held - 1;
    }
    proposal.count_a = static_cast<std::uint8_t>(of_a);
    proposal.count_b = static_cast<std::uint8_t>(5 - of_a);
    return proposal.count_a > 0 && proposal.count_b > 0;
  }

 private:
  static constexpr std::size_t places = 8;  // a_0 to a_3, then b_0 to b_3
  using Row = std::array<Lanes, places / 2>;

  static double at(const Row& row, std::uint32_t place) { return row[place / 2][place % 2]; }

  // 0 in one place, 1 elsewhere.
  static constexpr std::array<Row, places> others_than{
      Row{Lanes{0, 1}, Lanes{1, 1}, Lanes{1, 1}, Lanes{1, 1}}, Row{Lanes{1, 0}, Lanes{1, 1}, Lanes{1, 1}, Lanes{1, 1}},
      Row{Lanes{1, 1}, Lanes{0, 1}, Lanes{1, 1}, Lanes{1, 1}}, Row{Lanes{1, 1}, Lanes{1, 0}, Lanes{1, 1}, Lanes{1, 1}},
      Row{Lanes{1, 1}, Lanes{1, 1}, Lanes{0, 1}, Lanes{1, 1}}, Row{Lanes{1, 1}, Lanes{1, 1}, Lanes{1, 0}, Lanes{1, 1}},
      Row{Lanes{1, 1}, Lanes{1, 1}, Lanes{1, 1}, Lanes{0, 1}}, Row{Lanes{1, 1}, Lanes{1, 1}, Lanes{1, 1}, Lanes{1, 0}},
  };

  const std::array<DifferenceVertex, 4>& vertex_;
  Row weight_;
  std::array<Row, 3> moves_;
};

// The vertices of both bodies that a simplex is made of, with weights: solutions of
//   sum over A of w_i a_i = sum over B of w_j b_j,  sum over A of w_i = sum over B of w_j.
// Drops vertices, keeping a solution with weights that are not negative, until what is left has only one (up to a
// factor): Caratheodory's theorem, in floating point. The first vertices of A and of B serve as origins; what remains
// are three equations in the edges from them. The first half of the places is A's, the second B's, some of them empty:
// loops over all have no branches.
template <class Real, std::size_t Half>
class Reduction {
 public:
  static constexpr std::size_t places = 2 * Half;
  static constexpr std::size_t first_of_b = Half;
  using Row = std::array<Real, places>;

  Reduction(const Placed& a, const Placed& b, const DifferenceSimplexOf<Real>& simplex,
            const std::array<Real, 4>& weights) {
    weight_.fill(0);
    for (Row& row : edges_) row.fill(0);
    const DifferenceVertexOf<Real>* first = nullptr;
    for (std::size_t i = 0; i < static_cast<std::size_t>(simplex.count); ++i) {
      if (weights[i] == 0) continue;
      const DifferenceVertexOf<Real>& v = simplex.vertex[i];
      if (first == nullptr) first = &v;
      const double scale = simplex.scale;
      add(of_a_, 0, v.a, a.template turned<Real>(first->a, scale), a.template turned<Real>(v.a, scale), weights[i]);
      add(of_b_, first_of_b, v.b, b.template turned<Real>(v.b, scale), b.template turned<Real>(first->b, scale),
          weights[i]);
    }
  }

  Reduction(const Placed& a, const Placed& b, const Mixture<Real>& of_a, const Mixture<Real>& of_b, double scale) {
    weight_.fill(0);
    for (Row& row : edges_) row.fill(0);
    for (std::size_t k = 0; k < of_a.count; ++k) {
      add(of_a_, 0, of_a.vertex[k], a.template turned<Real>(of_a.vertex[0], scale),
          a.template turned<Real>(of_a.vertex[k], scale), of_a.weight[k]);
    }
    for (std::size_t k = 0; k < of_b.count; ++k) {
      add(of_b_, first_of_b, of_b.vertex[k], b.template turned<Real>(of_b.vertex[k], scale),
          b.template turned<Real>(of_b.vertex[0], scale), of_b.weight[k]);
    }
  }

  void reduce() {
    eliminate();
    // Each edge without a pivot is a combination of those with one: a dependency, along which weights can move.
    for (std::size_t j = 0; j < places; ++j) {
      if (!is_free_[j]) continue;
      Row dependency{};
      dependency[j] = -1;
      for (std::size_t i = 0; i < 3; ++i) {
        if (pivot_[i] != none) dependency[pivot_[i]] = edges_[i][j];
      }
      for (std::size_t i = 1; i < first_of_b; ++i) dependency[0] -= dependency[i];
      for (std::size_t i = first_of_b + 1; i < places; ++i) dependency[first_of_b] -= dependency[i];
      for (std::size_t k = 0; k < eliminated_; ++k) {
        // Keeps the weights that vanished before at zero.
        const Real factor = dependency[leaver_[k]] / dependency_[k][leaver_[k]];
        for (std::size_t i = 0; i < places; ++i) dependency[i] -= factor * dependency_[k][i];
        dependency[leaver_[k]] = 0;
      }
      shift_weights(dependency);
    }
  }

  // Drops vertices whose weight is next to nothing: what touching and shared vertices leave behind.
  void drop_negligible() {
    const Real least = *std::max_element(weight_.begin(), weight_.end()) * negligible<Real>;
    for (Real& w : weight_) w = w > least ? w : Real(0);
  }

  // The vertices with positive weights. False where they cannot be a proposal.
  bool write(Proposal& proposal) const {
    std::size_t n = 0;
    proposal.claim = Proposal::Claim::meet;
    proposal.count_a = proposal.count_b = 0;
    for (std::size_t i = 0; i < places; ++i) {
      if (!(weight_[i] > 0)) continue;
      if (n == 5) return false;
      proposal.vertices[n++] = i < first_of_b ? of_a_.vertex[i] : of_b_.vertex[i - first_of_b];
      ++(i < first_of_b ? proposal.count_a : proposal.count_b);
    }
    return proposal.count_a > 0 && proposal.count_b > 0;
  }

 private:
  static constexpr std::size_t none = places;

  // Adds a vertex, with the edge from `from` to `to`, or the weight of one that is there already.
  void add(SupportOf<Half>& support, std::size_t first_place, std::uint32_t vertex, const VectorOf<Real>& from,
           const VectorOf<Real>& to, const Real& weight) {
    const std::size_t count = support.count;
    const std::size_t place = first_place + support.add(vertex);
    weight_[place] += weight;
    if (support.count == count || count == 0) return;
    edges_[0][place] = to.x - from.x;
    edges_[1][place] = to.y - from.y;
    edges_[2][place] = to.z - from.z;
    is_free_[place] = true;
  }

  // Gauss-Jordan elimination, a pivot in each row: its largest entry. One that is next to nothing is taken for none:
  // the outcome is a proposal.
  void eliminate() {
    Real largest = 0;
    for (const Row& row : edges_) {
      for (const Real& x : row) largest = std::max(largest, magnitude(x));
    }
    for (std::size_t r = 0; r < 3; ++r) {
      Real size = largest * (16 * negligible<Real>);
      for (std::size_t j = 0; j < places; ++j) {
        if (is_free_[j] && magnitude(edges_[r][j]) > size) {
          size = magnitude(edges_[r][j]);
          pivot_[r] = j;
        }
      }
      if (pivot_[r] == none) continue;
      is_free_[pivot_[r]] = false;
      const Real scale = Real(1) / edges_[r][pivot_[r]];
      for (Real& x : edges_[r]) x *= scale;
      for (std::size_t i = 0; i < 3; ++i) {
        if (i == r) continue;
        const Real factor = edges_[i][pivot_[r]];
        for (std::size_t j = 0; j < places; ++j) edges_[i][j] -= factor * edges_[r][j];
      }
    }
  }

  // Moves the weights along the dependency until the first one vanishes: one that moves. What is next to nothing in the
  // dependency is there by rounding; where several weights vanish at once, that would choose among them.
  void shift_weights(const Row& dependency) {
    Real largest = 0;
    for (const Real& x : dependency) largest = std::max(largest, magnitude(x));
    const Real least = largest * negligible<Real>;
    std::size_t leaving = none;
    Real step = 0;
    for (std::size_t i = 0; i < places; ++i) {
      if (!(dependency[i] > least)) continue;
      const Real ratio = weight_[i] / dependency[i];
      if (leaving == none || ratio < step) {
        step = ratio;
        leaving = i;
      }
    }
    if (leaving == none) return;
    for (std::size_t i = 0; i < places; ++i) weight_[i] -= step * dependency[i];
    weight_[leaving] = 0;
    dependency_[eliminated_] = dependency;
    leaver_[eliminated_++] = leaving;
  }

  SupportOf<Half> of_a_, of_b_;
  Row weight_;
  std::array<Row, 3> edges_;  // by coordinate; those of B negated
  std::array<bool, places> is_free_{};
  std::array<std::size_t, 3> pivot_{none, none, none};
  std::array<Row, places - 2> dependency_;      // along which weights vanished: the first eliminated_
  std::array<std::size_t, places - 2> leaver_;  // and which weight did
  std::size_t eliminated_ = 0;
};

}  // namespace

bool name_five_of_tetrahedron(const Placed& a, const DifferenceSimplex& tetrahedron,
                              const std::array<double, 4>& weights, Proposal& proposal) {
  return TetrahedronReduction(a, tetrahedron, weights).reduce(proposal);
}

template <class Real>
bool name_at_most_five(const Placed& a, const Placed& b, const DifferenceSimplexOf<Real>& simplex,
                       const std::array<Real, 4>& weights, bool drop_negligible, Proposal& proposal) {
  std::array<Real, 4> used = weights;
  if (drop_negligible) {
    const Real least = *std::max_element(weights.begin(), weights.end()) * negligible<Real>;
    for (Real& w : used) w = w > least ? w : Real(0);
  }
  Reduction<Real, 4> reduction(a, b, simplex, used);
  reduction.reduce();
  if (drop_negligible) reduction.drop_negligible();
  return reduction.write(proposal);
}

template <class Real>
bool name_at_most_five(const Placed& a, const Placed& b, const Mixture<Real>& of_a, const Mixture<Real>& of_b,
                       bool drop_negligible, Proposal& proposal) {
  constexpr std::size_t most = Mixture<Real>::most;
  const auto used = [&](const Mixture<Real>& of) {
    const Real least = *std::max_element(of.weight.begin(), of.weight.end()) * negligible<Real>;
    Mixture<Real> kept;
    for (std::size_t k = 0; k < of.count; ++k) {
      if (of.weight[k] > (drop_negligible ? least : Real(0))) kept.add(of.vertex[k], of.weight[k]);
    }
    return kept;
  };
  Reduction<Real, most> reduction(a, b, used(of_a), used(of_b), scale_to_one(std::max(a.size, b.size)));
  reduction.reduce();
  if (drop_negligible) reduction.drop_negligible();
  return reduction.write(proposal);
}

template bool name_at_most_five(const Placed&, const Placed&, const DifferenceSimplexOf<double>&,
                                const std::array<double, 4>&, bool, Proposal&);
template bool name_at_most_five(const Placed&, const Placed&, const DifferenceSimplexOf<DoubleDouble>&,
                                const std::array<DoubleDouble, 4>&, bool, Proposal&);
template bool name_at_most_five(const Placed&, const Placed&, const Mixture<double>&, const Mixture<double>&, bool,
                                Proposal&);
template bool name_at_most_five(const Placed&, const Placed&, const Mixture<DoubleDouble>&,
                                const Mixture<DoubleDouble>&, bool, Proposal&);

}  // namespace sunder::solid
