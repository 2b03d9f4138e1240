// The rules about what discs have in common: docs/claims.md, "in_discs", "powers" and "Arcs".
#include <verifier/cpp/contacts.h>
#include <verifier/cpp/linear.h>
#include <verifier/cpp/rules.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <utility>

namespace sunder_verifier {
namespace {

void check_in_discs(const Circles& circles, const Numbers& point, const std::string& verdict) {
  const std::size_t bits = length(point) + circles.bits;
  take_steps(4 * circles.size(), bits, bits);
  const SweepPoint place = place_in_units(point, circles.exponent);
  for (std::size_t k = 0; k < circles.size(); ++k) {
    const int power = power_of(circles[k], place).sign();
    require(power < 0 || (power == 0 && verdict != "region"), "in_discs",
            "the point is not inside of circle " + std::to_string(k));
  }
}

void check_powers(const WeightList& list, const Circles& circles, const std::string& verdict) {
  const auto [sums, d, e, total] = combined({"weights", true, "a weight is not positive"}, list, 3, [&](std::size_t k) {
    const PlanarDisc& disc = circles[k];
    return std::pair(Integers{disc.x, disc.y, square(disc.x) + square(disc.y) - square(disc.r)}, std::int64_t{0});
  });
  const Integer least =
      total.n * sums[2] - square(sums[0]) - square(sums[1]);  // of the mean of the powers, times the total squared
  require(least > 0 || (verdict == "point" && least == 0), "powers", "the mean of the powers is not as it must be");
}

struct ArcArrow {
  Integer x, y;
};

Integer determinant(const ArcArrow& p, const ArcArrow& q) { return p.x * q.y - p.y * q.x; }

// A direction even + odd sqrt(root).
struct Way {
  ArcArrow even, odd;
  Integer root;
  bool is_upper;  // its bearing is less than half a turn

  Way(ArcArrow e, ArcArrow o, Integer r) : even(std::move(e)), odd(std::move(o)), root(std::move(r)) {
    const int y = sign_of_root(even.y, odd.y, root);
    is_upper = y > 0 || (y == 0 && sign_of_root(even.x, odd.x, root) > 0);
  }
};

int turn(const Way& p, const Way& q) {
  const std::array coefficients{determinant(p.even, q.even), determinant(p.odd, q.even), determinant(p.even, q.odd),
                                determinant(p.odd, q.odd)};
  return sign_of_roots(coefficients, std::array{p.root, q.root});
}

// Does p come before q, going round from the bearing 0?
bool is_before(const Way& p, const Way& q) { return p.is_upper == q.is_upper ? turn(p, q) > 0 : p.is_upper; }

// Is a way strictly inside of the angle from u counter-clockwise to v? in_order: u is not after v, going round from the
// bearing 0.
bool is_in_angle(const Way& u, const Way& way, const Way& v, bool in_order) {
  if (in_order && u.is_upper == v.is_upper) return turn(u, way) > 0 && turn(way, v) > 0;  // less than half a turn
  const int whole = turn(u, v);
  const bool after = turn(u, way) > 0;
  if (whole == 0) return after && u.is_upper != v.is_upper;  // half a turn, or nothing
  return after == (whole < 0) ? after : turn(way, v) > 0;    // after and ahead; beyond half a turn, after or ahead
}

// Where an arc of a ends and one of b begins: of the points where the circles cross, that at which the way around a
// leaves the disc of b.
class ArcCorner {
 public:
  ArcCorner(const PlanarDisc& a, const PlanarDisc& b)
      : a_(a),
        u_{b.x - a.x, b.y - a.y},
        square_(square(u_.x) + square(u_.y)),
        along_(square_ + square(a.r) - square(b.r)),
        root_(4 * square(a.r) * square_ - square(along_)) {}

  bool is_crossing() const { return root_ > 0; }

  // From the point x / w, y / w.
  Way seen_from(const Integers& place) const {
    const Integer &w = place[2], twice = 2 * square_;
    return {{twice * (a_.x * w - place[0]) + along_ * u_.x * w, twice * (a_.y * w - place[1]) + along_ * u_.y * w},
            {-u_.y * w, u_.x * w},
            root_};
  }

  // 1: it is outside of the disc; 0: on its circle.
  int power(const PlanarDisc& disc) const {
    // The powers of a point for two discs differ by a linear function of it; that for a is zero here.
    const ArcArrow v{disc.x - a_.x, disc.y - a_.y};
    const Integer rest = square(v.x) + square(v.y) + square(a_.r) - square(disc.r);
    return sign_of_root(rest * square_ - along_ * (u_.x * v.x + u_.y * v.y), -determinant(u_, v), root_);
  }

 private:
  PlanarDisc a_;
  ArcArrow u_;  // from centre to centre
  // The corner is (along u + sqrt(root) u turned left) / (2 square) from the centre of a.
  Integer square_, along_, root_;
};

struct End {
  Way way;
  ArcCorner corner;
};

// Arcs of named discs, counter-clockwise around a point inside of all discs, once round.
struct Chain {
  std::vector<std::size_t> named;
  std::vector<End> ends;  // from the bearing 0 on; arc k ends with end k
};

class Arcs {
 public:
  Arcs(const IndexLists& parts, const Circles& circles, Integers place)
      : parts_(parts), discs_(circles), place_(std::move(place)), bits_(4 * circles.bits + 2 * bits(place_)) {}

  void require_bounded_by(const std::vector<std::size_t>& arcs) {
    chain_of(0, discs_.size(), &arcs);
    require(next_ == parts_.size(), "arcs", "there are more parts than ranges of discs");
  }

 private:
  void take(std::size_t looks) const { take_steps(6 * looks, bits_, bits_); }

  Chain make_chain(const std::vector<std::size_t>& named) const {
    take(named.size());
    Chain chain{named, {}};
    const std::size_t n = named.size();
    for (std::size_t m = 0; n > 1 && m < n; ++m) {
      const ArcCorner corner(discs_[named[m]], discs_[named[(m + 1) % n]]);
      require(corner.is_crossing(), "arcs", "circles do not cross in two points");
      chain.ends.push_back({corner.seen_from(place_), corner});
    }
    std::size_t starts = 0, first = 0;
    for (std::size_t m = 0; m < chain.ends.size(); ++m) {
      if (is_before(chain.ends[(m + n - 1) % n].way, chain.ends[m].way)) continue;
      ++starts;
      first = m;
    }
    require(starts == std::min<std::size_t>(chain.ends.size(), 1), "arcs",
            "the corners do not go once around the point");
    const auto by = static_cast<std::ptrdiff_t>(first);
    std::rotate(chain.named.begin(), chain.named.begin() + by, chain.named.end());
    std::rotate(chain.ends.begin(), chain.ends.begin() + (chain.ends.empty() ? 0 : by), chain.ends.end());
    return chain;
  }

  // Of c, the point that is furthest from the centre of d. Requires that the centres differ.
  Way furthest(const PlanarDisc& c, const PlanarDisc& d) const {
    const ArcArrow away{c.x - d.x, c.y - d.y};
    const Integer distance = square(away.x) + square(away.y), &w = place_[2], reach = c.r * w;
    return {{distance * (c.x * w - place_[0]), distance * (c.y * w - place_[1])},
            {reach * away.x, reach * away.y},
            distance};
  }

  static bool holds(const PlanarDisc& outer, const PlanarDisc& inner) {
    return outer.r >= inner.r && square(outer.x - inner.x) + square(outer.y - inner.y) <= square(outer.r - inner.r);
  }

  // Seen from the point, no arc of the chain is further than the other one in that direction.
  void require_within(const Chain& chain, const Chain& other) const {
    take(chain.ends.size() + other.ends.size() + 1);
    using Marked = std::pair<const End*, bool>;  // whether it is the other one's
    std::vector<Marked> own, others, all;
    for (const End& end : chain.ends) own.emplace_back(&end, false);
    for (const End& end : other.ends) others.emplace_back(&end, true);
    std::merge(own.begin(), own.end(), others.begin(), others.end(), std::back_inserter(all),
               [](const Marked& p, const Marked& q) { return is_before(p.first->way, q.first->way); });
    std::size_t i = 0, k = 0;
    for (std::size_t m = 0; m < all.size(); ++m) {
      const auto& [end, is_other] = all[m];
      const PlanarDisc &c = discs_[chain.named[i % chain.named.size()]],
                       &d = discs_[other.named[k % other.named.size()]];
      const bool may_leave = !holds(d, c) && (c.x != d.x || c.y != d.y);
      const End& before = *all[(m + all.size() - 1) % all.size()].first;
      require(!may_leave || !is_in_angle(before.way, furthest(c, d), end->way, m > 0), "arcs",
              "an arc is not all in a circle");
      const int power = end->corner.power(is_other ? c : d);
      require(is_other ? power >= 0 : power <= 0, "arcs", "a corner is not in a circle");
      ++(is_other ? k : i);
    }
    require(!all.empty() || holds(discs_[other.named[0]], discs_[chain.named[0]]), "arcs",
            "a circle does not hold another one");
  }

  // What bounds the common part of a range of discs.
  Chain chain_of(std::size_t first, std::size_t last, const std::vector<std::size_t>* named) {
    std::vector<Chain> within;
    if (last - first > 8) {
      const std::size_t half = (first + last) / 2;
      within.push_back(chain_of(first, half, nullptr));
      within.push_back(chain_of(half, last, nullptr));
    } else {
      for (std::size_t k = first; k < last; ++k) within.push_back(make_chain({k}));
    }
    require(named != nullptr || next_ < parts_.size(), "arcs",
            "there are not as many parts as there are ranges of discs");
    Chain chain = make_chain(named != nullptr ? *named : parts_[next_++]);
    for (const Chain& other : within) require_within(chain, other);
    return chain;
  }

  const IndexLists& parts_;
  const Circles& discs_;
  Integers place_;
  std::size_t bits_, next_ = 0;
};

void check_arcs(const IndexLists& parts, const Circles& circles, const Numbers& point, const Indices& arcs) {
  Numbers in_units = point;
  for (Number& value : in_units) value.e -= circles.exponent;
  Arcs(parts, circles, projective(in_units)).require_bounded_by(arcs);
}

}  // namespace

const ClaimRows claims_of_discs{
    {"in_discs", "", rule<check_in_discs>},
    {"powers", "weights: weights of subject", rule<check_powers>},
    {"arcs", "parts: lists of arcs of subject", rule<check_arcs>},
};

}  // namespace sunder_verifier
