#include <sunder/solid/round/round_newton.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace sunder::solid::round_quick {

namespace {

constexpr int most_refined = 16, most_changes = 3, most_turns = 6;
constexpr double near_enough2 = 0x1p-40, quite_near2 = 0x1p-48, well_near2 = 0x1p-8, most_turned = 0.5,
                 a_little = 0x1p-30;

V opposite(const V& v) { return {-v.x, -v.y, -v.z}; }

V of_length_one(const V& v) {
  const double over = 1 / length(v);
  return {over * v.x, over * v.y, over * v.z};
}

// Of the plane across a direction.
struct V2 {
  double s, t;
};

V2 unit(const V2& v) {
  const double over = 1 / std::hypot(v.s, v.t);
  return {over * v.s, over * v.t};
}

void turn_to(const Side& side, Pieces& pieces, const V& out) {
  for (std::size_t k = 0; k < pieces.count; ++k) {
    if (!is_vertex(side, pieces.piece[k]))
      pieces.at[k] = sum(pieces.piece[k] == 0 ? side.image.from : side.image.to, 1, out);
  }
}

// From the direction of an axis towards a point that is beyond the rim.
V tilted(const V& d, const Side& own, const V& to) {
  const V& axis = own.image.axis;
  const V way = to - (dot(d, axis) > 0 ? own.image.to : own.image.from), out = sum(way, -dot(way, axis), axis);
  const V turned = sum(d, 0.25 / length(out), out);
  const double over = 1 / length(turned);
  return {over * turned.x, over * turned.y, over * turned.z};
}

bool are_vertices(const Side& side, const Pieces& pieces) {
  return std::all_of(pieces.piece.data(), pieces.piece.data() + pieces.count,
                     [&](std::uint32_t piece) { return is_vertex(side, piece); });
}

double smooth_weight(const Side& side, const Pieces& pieces) {
  double all = 0;
  for (std::size_t k = 0; k < pieces.count; ++k) {
    all += is_vertex(side, pieces.piece[k]) ? 0 : std::clamp(pieces.weight[k], 0.0, 1.0);
  }
  return all;
}

// A piece whose weight is negative does not belong there.
bool drop_least(Pieces& pieces, double below) {
  const std::size_t k = pieces.least();
  if (!(pieces.weight[k] < below)) return false;
  pieces.drop(k);
  return true;
}

void admit(Pieces& pieces, const Far& far, double weight) {
  std::size_t k = 0;
  while (k < pieces.count && pieces.piece[k] != far.piece) ++k;
  if (k == pieces.count) {
    pieces.piece[pieces.count++] = far.piece;
    pieces.at[k] = far.at;
    pieces.weight[k] = 0;
  }
  pieces.weight[k] += weight;
}

// Of four pieces, whose weights their places in the plane of s and t tell: another one takes the place of that whose
// weight is the first to vanish while its own grows. Source: the ratio test of the simplex method, Dantzig 1951.
bool exchange(Pieces& own, const Far& far, Pieces& others, const V& s, const V& t) {
  std::array<double, 2> row_s{}, row_t{}, rate{};
  std::size_t rows = 0;
  const auto demand = [&](const V& more) {
    row_s[rows] = dot(more, s);
    row_t[rows++] = dot(more, t);
  };
  for (std::size_t k = 1; k < own.count; ++k) demand(own.at[k] - own.at[0]);
  for (std::size_t k = 1; k < others.count; ++k) demand(others.at[0] - others.at[k]);
  const V more = far.at - own.at[0];
  const double of_s = dot(more, s), of_t = dot(more, t), det = row_s[0] * row_t[1] - row_s[1] * row_t[0];
  if (det == 0) return false;
  rate = {(of_s * row_t[1] - of_t * row_s[1]) / det, (of_t * row_s[0] - of_s * row_t[0]) / det};
  Pieces* from = nullptr;
  std::size_t leaving = 0, row = 0;
  double grown = HUGE_VAL;
  const auto look = [&](Pieces& pieces, std::size_t k, double falls) {
    const double until = std::max(pieces.weight[k], 0.0) / falls;
    if (!(falls > 0 && until < grown)) return;
    grown = until;
    from = &pieces;
    leaving = k;
  };
  double first_own = 1, first_other = 0;
  for (std::size_t k = 1; k < own.count; ++k, ++row) {
    look(own, k, rate[row]);
    first_own -= rate[row];
  }
  for (std::size_t k = 1; k < others.count; ++k, ++row) {
    look(others, k, rate[row]);
    first_other -= rate[row];
  }
  look(own, 0, first_own);
  if (others.count > 1) look(others, 0, first_other);
  if (from == nullptr) return false;
  from->drop(leaving);
  admit(own, far, grown);
  return true;
}

void share(Pieces& pieces, const std::array<double, 2>& weight, std::size_t from) {
  pieces.weight[0] = 1;
  for (std::size_t k = 1; k < pieces.count; ++k) {
    pieces.weight[k] = weight[from + k - 1];
    pieces.weight[0] -= pieces.weight[k];
  }
}

// What is asked of a step from the direction d, in the plane of s and t across it.
struct Equations {
  V s, t;
  Turn turn_a, turn_b;
  double g_s = 0, g_t = 0, gap = 0;               // the derivative of the gap, and the gap
  std::array<double, 2> row_s{}, row_t{}, off{};  // reaches that have to be equal
  std::size_t rows = 0;

  void demand(const V& more, const V& d) {
    row_s[rows] = dot(more, s);
    row_t[rows] = dot(more, t);
    off[rows++] = dot(more, d);
  }
};

class Newton {
 public:
  Newton(Proposals& pair, const DifferenceSimplex& simplex, const Slots& slots, const V& d)
      : pair_(pair), a_(pair.a), b_(pair.b), d_(d) {
    const std::array<double, 4> weights = weights_of_nearest(simplex);
    for (std::size_t k = 0; k < static_cast<std::size_t>(simplex.count); ++k) {
      const auto& [p, q] = slots[simplex.vertex[k].a];
      admit(of_a_, p, weights[k]);
      admit(of_b_, q, weights[k]);
    }
    // Two may be equal to one another beside the first of each.
    while (of_a_.count + of_b_.count > 4) {
      const std::size_t k = of_a_.least(), l = of_b_.least();
      const bool is_of_a = of_b_.count == 1 || (of_a_.count > 1 && of_a_.weight[k] < of_b_.weight[l]);
      is_of_a ? of_a_.drop(k) : of_b_.drop(l);
    }
  }

  bool run() {
    for (int i = 0; i < most_refined; ++i) {
      const Outcome outcome = advance();
      if (outcome != Outcome::goes_on) return outcome == Outcome::held;
    }
    return false;
  }

 private:
  enum class Outcome : std::uint8_t { held, failed, goes_on };

  Outcome advance() {
    const Equations e = equations();
    V2 y{0, 0};  // the step
    if (!weigh(e, y)) return Outcome::failed;
    if (is_last_) return end(e);
    if (drops()) return Outcome::goes_on;
    if (e.rows == 2) return go(e, y);
    const double smooth_a = smooth_weight(a_, of_a_), smooth_b = smooth_weight(b_, of_b_);
    const bool is_flat_a = smooth_a > 0 && !e.turn_a.has_bend, is_flat_b = smooth_b > 0 && !e.turn_b.has_bend;
    if (is_flat_a || is_flat_b) {
      if (++changes_ > most_changes) return Outcome::failed;
      d_ = is_flat_a ? tilted(d_, a_, of_b_.at[0]) : opposite(tilted(opposite(d_), b_, of_a_.at[0]));
      begin_anew();
      return Outcome::goes_on;
    }
    Bend all;
    all.add(smooth_a, e.turn_a.bend);
    all.add(smooth_b, e.turn_b.bend);
    all.ss += std::max(e.gap, 0.0);
    all.tt += std::max(e.gap, 0.0);
    if (e.rows == 1) return step_along(e, all, y) ? go(e, y) : Outcome::failed;
    const double det = all.ss * all.tt - all.st * all.st, size = all.ss + all.tt;
    if (!(det > 0x1p-40 * size * size)) return turn(e, all, smooth_a > 0, smooth_b > 0);
    y.s = (-e.g_s * all.tt + e.g_t * all.st) / det;
    y.t = (-e.g_t * all.ss + e.g_s * all.st) / det;
    return go(e, y);
  }

  Equations equations() {
    const V d = d_;
    const auto [s, t] = frame_across(d);
    Equations e{s, t, turn_of(a_, d, s, t), turn_of(b_, opposite(d), s, t)};
    turn_to(a_, of_a_, e.turn_a.out);
    turn_to(b_, of_b_, e.turn_b.out);
    const V way = of_a_.at[0] - of_b_.at[0];
    e.g_s = dot(way, s);
    e.g_t = dot(way, t);
    e.gap = -dot(way, d);
    for (std::size_t k = 1; k < of_a_.count; ++k) e.demand(of_a_.at[k] - of_a_.at[0], d);
    for (std::size_t k = 1; k < of_b_.count; ++k) e.demand(of_b_.at[0] - of_b_.at[k], d);
    return e;
  }

  // The weights of pieces; and the step, where these alone tell it.
  bool weigh(const Equations& e, V2& y) {
    std::array<double, 2> weight{};
    if (e.rows == 2) {
      const double det = e.row_s[0] * e.row_t[1] - e.row_s[1] * e.row_t[0];
      if (det == 0) return false;
      y.s = (-e.off[0] * e.row_t[1] + e.off[1] * e.row_t[0]) / det;
      y.t = (-e.row_s[0] * e.off[1] + e.row_s[1] * e.off[0]) / det;
      weight[0] = (-e.g_s * e.row_t[1] + e.g_t * e.row_s[1]) / det;
      weight[1] = (-e.g_t * e.row_s[0] + e.g_s * e.row_t[0]) / det;
    } else if (e.rows == 1) {
      const double size2 = e.row_s[0] * e.row_s[0] + e.row_t[0] * e.row_t[0];
      if (!(size2 > 0)) return false;
      weight[0] = -(e.g_s * e.row_s[0] + e.g_t * e.row_t[0]) / size2;
    }
    share(of_a_, weight, 0);
    share(of_b_, weight, of_a_.count - 1);
    return true;
  }

  // The direction is as good as doubles can make it for these pieces: are they the ones that count?
  Outcome end(const Equations& e) {
    is_last_ = false;
    begin_anew();
    if (++changes_ <= most_changes && (drop_least(of_a_, -0x1p-30) || drop_least(of_b_, -0x1p-30) || admit_beyond(e))) {
      return Outcome::goes_on;
    }
    return concludes() ? Outcome::held : Outcome::failed;
  }

  // A weight that is far below zero will not come back, and with it what bends is not what it would be. The nearer the
  // direction is the less is far.
  bool drops() {
    const double below = last2_ > 0 ? -std::sqrt(std::clamp(last2_, 0x1p-40, 0x1p-8)) : -0x1p-4;
    const bool may_drop = !is_new_ && changes_ < most_changes;
    is_new_ = false;
    if (!may_drop || !(drop_least(of_a_, below) || drop_least(of_b_, below))) return false;
    ++changes_;
    begin_anew();
    return true;
  }

  // One reach has to be equal; along what is left the derivative vanishes.
  static bool step_along(const Equations& e, const Bend& all, V2& y) {
    const double size2 = e.row_s[0] * e.row_s[0] + e.row_t[0] * e.row_t[0], size = std::sqrt(size2);
    const double n_s = -e.row_t[0] / size, n_t = e.row_s[0] / size;
    y.s = -e.off[0] * e.row_s[0] / size2;
    y.t = -e.off[0] * e.row_t[0] / size2;
    const double bent = n_s * n_s * all.ss + 2 * n_s * n_t * all.st + n_t * n_t * all.tt;
    const double rest =
        e.g_s * n_s + e.g_t * n_t + n_s * (all.ss * y.s + all.st * y.t) + n_t * (all.st * y.s + all.tt * y.t);
    if (!(bent > 0)) return rest == 0;
    y.s -= rest / bent * n_s;
    y.t -= rest / bent * n_t;
    return true;
  }

  // One way bends, if rims are there: that by Newton's method. The other, `up`, lies in the plane of d and an axis:
  // there no furthest point turns, until another one reaches as far, or a base or top faces the other.
  Outcome turn(const Equations& e, const Bend& all, bool is_smooth_a, bool is_smooth_b) {
    const double size = all.ss + all.tt;
    const bool bends = size > 0, by_first = all.ss >= all.tt;
    const V2 bent = unit(bends ? (by_first ? V2{all.ss, all.st} : V2{all.st, all.tt}) : V2{e.g_t, -e.g_s});
    const double slope = e.g_t * bent.s - e.g_s * bent.t;
    if (++turns_ > most_turns || !(std::fabs(slope) > 0)) return Outcome::failed;
    const V along = sum(sum({0, 0, 0}, -bent.t, e.s), bent.s, e.t), up = slope > 0 ? opposite(along) : along,
            down = opposite(up), back = opposite(d_);
    const double other = std::min(until_other(a_, d_, up), until_other(b_, back, down));
    const auto told = [](bool held) { return held ? Outcome::held : Outcome::failed; };
    if (is_smooth_a && until_axis(a_, d_, up) < other) return told(pair_.faces(a_, b_, axis_towards(a_, up)));
    if (is_smooth_b && until_axis(b_, back, down) < other) return told(pair_.faces(b_, a_, axis_towards(b_, down)));
    const double step = bends ? -(e.g_s * bent.s + e.g_t * bent.t) / size : 0;
    const double by = std::clamp(step, -most_turned, most_turned);
    d_ = sum(d_, std::tan(std::min(other, most_turned) + a_little), up);
    d_ = of_length_one(sum(sum(d_, by * bent.s, e.s), by * bent.t, e.t));
    is_new_ = admit_beyond(e);
    begin_anew();
    return Outcome::goes_on;
  }

  // By the step, or as far as one may go.
  Outcome go(const Equations& e, const V2& y) {
    const double step2 = y.s * y.s + y.t * y.t;
    if (!(step2 < HUGE_VAL) || (step2 > 1 && ++wild_ > 2)) return Outcome::failed;
    const bool is_far = step2 > most_turned * most_turned;
    const double by = is_far ? most_turned / std::sqrt(step2) : 1;
    const double over = 1 / std::sqrt(1 + (is_far ? most_turned * most_turned : step2));
    const V d = sum(sum(d_, by * y.s, e.s), by * y.t, e.t);
    d_ = {over * d.x, over * d.y, over * d.z};
    if (step2 < quite_near2 && e.gap > a_.radius() + b_.radius() && pair_.parts(d_)) return Outcome::held;
    // Newton's method: what is left is as the square of the step, and so were the steps.
    const auto left2 = [&] { return step2 * step2 * std::max(step2 / (last2_ * last2_), 1.0); };
    is_last_ = step2 <= 0x1p-100 || (e.rows == 2 && !is_far && are_vertices(a_, of_a_) && are_vertices(b_, of_b_)) ||
               (last2_ > 0 && step2 < near_enough2 && (step2 >= last2_ || left2() < 0x1p-104));
    last2_ = step2;
    if (is_last_ || step2 > well_near2 || has_looked_) return Outcome::goes_on;
    has_looked_ = true;
    if (changes_ < most_changes && admit_beyond(e)) {
      ++changes_;
      begin_anew();
      is_new_ = true;
    }
    return Outcome::goes_on;
  }

  // Other pieces: no step before tells anything of them.
  void begin_anew() {
    last2_ = 0;
    has_looked_ = false;
  }

  // A piece that reaches further along the direction than these do.
  bool admit_beyond(const Equations& e) {
    return admit_beyond(a_, of_a_, d_, of_b_, e) || admit_beyond(b_, of_b_, opposite(d_), of_a_, e);
  }
  bool admit_beyond(const Side& side, Pieces& pieces, const V& d, Pieces& others, const Equations& e) {
    const Far far = far_along(side, d);
    if (pieces.has(far.piece) || !(dot(d, far.at - pieces.at[0]) > 0x1p-44 * pair_.size)) return false;
    if (pieces.count + others.count == 4) return exchange(pieces, far, others, e.s, e.t);
    admit(pieces, far, 0);
    return true;
  }

  bool concludes() {
    const Nearest p = made(a_, of_a_), q = made(b_, of_b_);
    const double gap = dot(q.at - p.at, d_), reach = a_.radius() + b_.radius();
    if (gap > reach) return pair_.parts(d_);
    return reach - gap > 0x1p-44 * pair_.size ? pair_.holds_thoroughly(p, q) : pair_.holds(p, q);
  }
  static Nearest made(const Side& side, const Pieces& of) {
    Nearest p{};
    double total = 0;  // without those that are negative
    for (std::size_t k = 0; k < of.count; ++k) total += std::max(of.weight[k], 0.0);
    for (std::size_t k = 0; k < of.count; ++k) {
      if (of.weight[k] > 0) Proposals::add(side, p, {of.at[k], of.piece[k]}, of.weight[k] / total);
    }
    return p;
  }

  Proposals& pair_;
  const Side &a_, &b_;
  V d_;
  Pieces of_a_, of_b_;
  double last2_ = 0;  // the square of the step before this one, of the same pieces
  int changes_ = 0, turns_ = 0, wild_ = 0;
  bool has_looked_ = false, is_last_ = false;  // for pieces that reach further; d is as good as doubles can make it
  bool is_new_ = false;                        // a piece does not reach as far as the others yet: no weight tells
};

}  // namespace

bool refine(Proposals& pair, const DifferenceSimplex& simplex, const Slots& slots, const V& d) {
  if (!(length(d) > 0)) return false;
  const V direction = of_length_one(d);
  if (pair.faces(pair.a, pair.b, direction) || pair.faces(pair.b, pair.a, opposite(direction))) return true;
  return Newton(pair, simplex, slots, direction).run();
}

}  // namespace sunder::solid::round_quick
