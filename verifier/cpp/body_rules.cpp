// The rules about convex bodies: docs/claims.md, "Rules", from `parted` to `inside`.
#include <verifier/cpp/reader.h>
#include <verifier/cpp/rules.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace sunder_verifier {
namespace {

// -1, 0, +1 as m * 2^e is less than, equal to, greater than n * 2^f.
int compare(const Integer& m, std::int64_t e, const Integer& n, std::int64_t f) {
  return shifted(m, std::max<std::int64_t>(e - f, 0)).compare(shifted(n, std::max<std::int64_t>(f - e, 0)));
}

// n * 2^e + sqrt(spread), which is not negative.
struct Furthest {
  Integer n;
  std::int64_t e = 0;
  Number spread;
};

// How far a body reaches along a direction: as far as the furthest of these.
struct Reach {
  std::vector<Furthest> furthest;
  bool is_flat = true;  // all of the body is as far
};

// How far along the direction a body goes beyond its core, squared.
Number spread_of(const HullBody& body, const Integers& direction) {
  if (body.radius.n == 0) return {};
  Number spread{body.radius.n * body.radius.n, 1, 2 * body.radius.e};
  Integers across = direction;
  if (body.around == Around::ellipsoid && body.is_image()) {  // the transposed matrix times the direction
    const Integers& m = body.linear.rows[0];
    for (std::size_t c = 0; c < 3; ++c) {
      across[c] = m[c] * direction[0] + m[3 + c] * direction[1] + m[6 + c] * direction[2];
    }
    spread.e += 2 * body.linear.e;
  } else if (!body.axis.empty()) {  // as d d - (d a)^2 / (a a) = |d x a|^2 / (a a)
    across = cross(direction, body.axis);
    spread.d = dot(body.axis, body.axis);
  }
  spread.n *= dot(across, across);
  return spread;
}

// Requires by that rule that no way goes on along the direction.
Reach reach(const char* rule, const HullBody& body, const Integers& direction) {
  const auto [all, e] = products(body, direction);
  Reach result;
  Integer greatest = all[0];
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (body.is_way(k)) {
      require(all[k] <= 0, rule, "a way of " + body.quoted + " goes on along the direction");
      result.is_flat = result.is_flat && all[k] == 0;
    } else {
      result.is_flat = result.is_flat && all[k] == all[0];
      if (all[k] > greatest) greatest = all[k];
    }
  }
  const Number spread = spread_of(body, direction);
  result.is_flat = result.is_flat && spread.n == 0;
  if (body.around == Around::cone) {
    result.furthest = {{all[0], e, spread}, {all[1], e, {}}};
  } else {
    result.furthest = {{greatest, e, spread}};
  }
  return result;
}

Integers opposite(Integers direction) {
  for (Integer& n : direction) n = -n;
  return direction;
}

// From one point x, .., w to another, times a positive number.
Integers way_between(const Integers& p, const Integers& q) {
  Integers way;
  for (std::size_t axis = 0; axis + 1 < p.size(); ++axis) way.push_back(q[axis] * p.back() - p[axis] * q.back());
  return way;
}

// The sign of m - sqrt(u) - sqrt(v), where u is positive, and v not negative.
int sign_less_roots(const Integer& m, const Integer& u, const Integer& v) {
  if (m <= 0) return -1;
  // sqrt(s) - sqrt(u) >= 0, as is sqrt(v): they compare as their squares do.
  const Integer s = m * m, rest = s + u - v;
  if (s < u || rest < 0) return -1;
  return v == 0 ? s.compare(u) : Integer(rest * rest).compare(4 * s * u);
}

// The sign of n * 2^e less the roots of some numbers, three at most, none of which is negative.
int sign_less_roots(const Integer& n, std::int64_t e, const Numbers& roots) {
  const auto is_some = [](const Number& root) { return root.n != 0; };
  if (std::none_of(roots.begin(), roots.end(), is_some)) return n.sign();
  if (n <= 0) return -1;
  Numbers values{{n * n, 1, 2 * e}};
  std::copy_if(roots.begin(), roots.end(), std::back_inserter(values), is_some);
  Integers squares = common(values).integers;
  squares.resize(4);
  const Integer &s = squares[0], &u = squares[1], &v = squares[2], &w = squares[3];
  if (v == 0) return s.compare(u);
  // sqrt(s) - sqrt(u) against sqrt(v) + sqrt(w): if neither is negative, as their squares do.
  return s < u ? -1 : sign_less_roots(s + u - v - w, 4 * s * u, 4 * v * w);
}

// Is m - sqrt(u) - sqrt(v) not negative? No number under a root is.
bool covers(const Integer& m, const Integer& u, const Integer& v) {
  const Integer rest = m * m - u - v;
  return m >= 0 && rest >= 0 && rest * rest >= 4 * u * v;
}

// Is m + sqrt(u) - sqrt(v) not negative?
bool covers_with(const Integer& m, const Integer& u, const Integer& v) {
  if (m < 0) {  // sqrt(u) against sqrt(m m) + sqrt(v)
    const Integer rest = u - m * m - v;
    return rest >= 0 && rest * rest >= 4 * m * m * v;
  }
  const Integer rest = v - m * m - u;  // sqrt(v) against sqrt(m m) + sqrt(u)
  return rest <= 0 || 4 * m * m * u >= rest * rest;
}

// Is n * 2^e + sqrt(most) - sqrt(u) - sqrt(v) not negative?
bool covers_with(const Integer& n, std::int64_t e, const Number& most, const Number& u, const Number& v) {
  const Integers all = common({{n * n, 1, 2 * e}, most, u, v}).integers;
  const Integer &s = all[0], &w = all[1], &x = all[2], &y = all[3];
  // sqrt(s) + sqrt(w), or sqrt(w) - sqrt(s), against sqrt(x) + sqrt(y): if none is negative, as their squares do.
  if (n < 0) return w >= s && covers(s + w - x - y, 4 * s * w, 4 * x * y);
  return covers_with(s + w - x - y, 4 * s * w, 4 * x * y);
}

// The sign of how much further B begins along the direction than A ends, less a length, which is in units of that of
// the direction; and whether both are flat.
struct Parting {
  int gap = 1;
  bool is_flat;
};

Parting parting(const char* rule, const Integers& direction, const HullBody& a, const HullBody& b,
                const Number& least = {}) {
  const Reach of_a = reach(rule, a, direction), of_b = reach(rule, b, opposite(direction));
  Number wanted;
  if (least.n != 0) wanted = {least.n * least.n * dot(direction, direction), 1, 2 * least.e};
  Parting result{1, of_a.is_flat && of_b.is_flat};
  for (const Furthest& last : of_a.furthest) {
    for (const Furthest& first : of_b.furthest) {
      const std::size_t size = bits(direction) + a.size() + b.size() + length({least});
      if (a.is_round() || b.is_round()) take_steps(16, size, size);
      const std::int64_t e = std::min(last.e, first.e);
      const Integer gap = -shifted(first.n, first.e - e) - shifted(last.n, last.e - e);
      result.gap = std::min(result.gap, sign_less_roots(gap, e, {last.spread, first.spread, wanted}));
    }
  }
  return result;
}

// Requires that no part of the body is further along the direction than the point x, .., w.
void require_behind(const HullBody& body, const Integers& direction, const Integers& place) {
  const auto [all, e] = products(body, direction);
  const Integer limit = dot(direction, place);  // of one number more, which does not count
  for (std::size_t k = 0; k < all.size(); ++k) {
    const bool is_behind = body.is_way(k) ? all[k] <= 0 : compare(all[k] * place.back(), e, limit, 0) <= 0;
    require(is_behind, "slab", body.quoted + " extends beyond its point along the direction");
  }
}

// The rank of vectors, one by one.
class Span {
 public:
  // Is it in the span of those before? If not, it is taken in.
  bool holds(Integers row) {
    for (const auto& [other, lead] : basis_) {
      const Integer scale = other[lead], shift = row[lead];
      for (std::size_t k = 0; k < row.size(); ++k) row[k] = row[k] * scale - other[k] * shift;
    }
    const auto first = std::find_if(row.begin(), row.end(), [](const Integer& n) { return n != 0; });
    if (first == row.end()) return true;
    const auto lead = static_cast<std::size_t>(first - row.begin());
    basis_.emplace_back(std::move(row), lead);
    return false;
  }
  std::size_t rank() const { return basis_.size(); }

 private:
  std::vector<std::pair<Integers, std::size_t>> basis_;
};

Integer sum_of(const Numbers& values) {
  Integer sum = 0;
  for (const Integer& n : common(values).integers) sum += n;
  return sum;
}

// Requires that the point is the image of the one that the claim says.
void require_image(const Claim& claim, const HullBody& body, const Numbers& point) {
  const Common from = common(claim.from);
  const Integers v = turned(body, from.integers);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Number& p = point[axis];
    Numbers values{{v[axis], from.d, from.e + body.linear.e}, {-p.n, p.d, p.e}};
    if (body.is_image()) values.push_back({body.translation.rows[0][axis], 1, body.translation.e});
    require(sum_of(values) == 0, "holds", "the point of " + body.quoted + " comes from elsewhere");
  }
}

// Requires, of a body with a radius, that it reaches from the point of its core, mean / d * 2^e, to the point. Is it
// then nearer to that than the body reaches?
bool reaches(const Claim& claim, const HullBody& body, const Integers& mean, const Integer& d, std::int64_t e,
             const Numbers& point) {
  const std::size_t size = body.size() + length(point) + length(claim.from) + length(claim.weights.values);
  take_steps(8, size, size);
  const bool is_mapped = body.around == Around::ellipsoid;
  if (is_mapped) require_image(claim, body, point);
  Numbers values;  // all times d
  for (const Number& n : is_mapped ? claim.from : point) values.push_back({n.n * d, n.d, n.e});
  for (const Integer& n : mean) values.push_back({n, 1, e});
  Number radius = body.radius;
  if (body.around == Around::cone) {
    const WeightList& list = claim.weights;
    const auto base = std::find(list.named.begin(), list.named.end(), std::size_t{0});
    const Number share =
        base == list.named.end() ? Number{} : list.values[static_cast<std::size_t>(base - list.named.begin())];
    radius = {radius.n * share.n, share.d, radius.e + share.e};
  }
  radius.n *= d;
  values.push_back(radius);
  const Integers scaled = common(values).integers;
  const Integers way{scaled[0] - scaled[3], scaled[1] - scaled[4], scaled[2] - scaled[5]};
  if (!body.axis.empty()) {
    require(dot(way, body.axis) == 0, "holds",
            "the offset of the point from the axis is not perpendicular to the axis of " + body.quoted);
  }
  const int order = dot(way, way).compare(scaled[6] * scaled[6]);
  require(order <= 0, "holds", "the point is outside of " + body.quoted);
  return order < 0;
}

// Requires that the body holds the point. Is it, if the body has a radius, nearer to the core than that?
bool holds(const Claim& claim, const HullBody& body, const Numbers& point) {
  const WeightList& list = claim.weights;
  const Common weights = common_weights(list.values);
  Integer total = 0;
  for (std::size_t k = 0; k < list.named.size(); ++k) {
    require(weights.integers[k] >= 0, "holds", "a weight of " + body.quoted + " is negative");
    if (!body.is_way(list.named[k])) total += weights.integers[k];
  }
  require(compare(total, weights.e, weights.d, 0) == 0, "holds", "the weights of " + body.quoted + " do not sum to 1");
  Integers mean(body.dimension());
  std::int64_t e = 0;
  for (std::size_t k = 0; k < list.named.size(); ++k) {
    const bool is_unplaced = body.around == Around::ellipsoid;
    const auto [place, f] =
        is_unplaced ? std::pair(body.rows()[list.named[k]], body.given->e) : image(body, list.named[k]);
    e = f;
    for (std::size_t r = 0; r < mean.size(); ++r) mean[r] += weights.integers[k] * place[r];
  }
  if (body.is_round()) return reaches(claim, body, mean, weights.d, weights.e + e, point);
  for (std::size_t r = 0; r < mean.size(); ++r) {
    require(compare(mean[r] * point[r].d, weights.e + e, point[r].n * weights.d, point[r].e) == 0, "holds",
            "the weighted sum of the points of " + body.quoted + " differs from the stated point in coordinate " +
                std::to_string(r));
  }
  return false;
}

}  // namespace

bool is_behind(const char* rule, const HullBody& body, const Integers& direction, const Integers& place) {
  const Integer limit = dot(direction, place);  // of one number more, which does not count
  const Reach ends = reach(rule, body, direction);
  return std::all_of(ends.furthest.begin(), ends.furthest.end(), [&](const Furthest& last) {
    const std::int64_t e = std::min<std::int64_t>(last.e, 0);
    const Integer gap = shifted(limit, -e) - shifted(last.n * place.back(), last.e - e);
    const Integer& w = place.back();
    return sign_less_roots(gap, e, {{last.spread.n * w * w, last.spread.d, last.spread.e}}) >= 0;
  });
}

void check_parted(const Claim& claim, const HullBody& a, const HullBody& b) {
  const Parting found = parting("parted", common(claim.direction).integers, a, b);  // along a positive multiple
  require(found.gap > 0, "parted", a.quoted + " is not strictly less far along the direction than " + b.quoted);
}

void check_parted_weakly(const Claim& claim, const HullBody& a, const HullBody& b) {
  const auto [gap, is_flat] = parting("parted", common(claim.direction).integers, a, b);
  require(gap >= 0, "parted", a.quoted + " is not less far along the direction than " + b.quoted);
  require(gap > 0 || !is_flat, "parted", "all of " + a.quoted + " and " + b.quoted + " is as far along the direction");
}

void check_holds(const Claim& claim, const HullBody& body, const Numbers& point) { holds(claim, body, point); }

void check_slab(const HullBody& a, const HullBody& b, const Numbers& from_a, const Numbers& to_b) {
  const Integers p = projective(from_a), q = projective(to_b);
  const Integers way = way_between(p, q);
  require(std::any_of(way.begin(), way.end(), [](const Integer& n) { return n != 0; }), "slab",
          "the two points are the same");
  require_behind(a, way, p);
  require_behind(b, opposite(way), q);
}

void check_clear(const Claim& claim, const HullBody& a, const HullBody& b, const Number& least) {
  const Integers direction = common(claim.direction).integers;  // a positive multiple of it
  const Parting found = parting("clear", direction, a, b, least);
  const bool is_some = std::any_of(direction.begin(), direction.end(), [](const Integer& n) { return n != 0; });
  require(is_some && found.gap >= 0, "clear", "along the direction they are less far apart than stated");
}

void check_nearer(const Numbers& from_a, const Numbers& to_b, const Number& least) {
  const std::size_t size = length(from_a) + length(to_b);
  take_steps(16, size, size);
  const Integers p = projective(from_a), q = projective(to_b), way = way_between(p, q);
  const Integer limit = least.n * p.back() * q.back();
  require(compare(dot(way, way), 0, limit * limit, 2 * least.e) < 0, "nearer",
          "the points are not nearer than the stated distance");
}

void check_leaves(const Claim& claim, const HullBody& a, const HullBody& b, const Number& most) {
  const Integers direction = common(claim.direction).integers;
  const Reach of_a = reach("leaves", a, direction), of_b = reach("leaves", b, opposite(direction));
  const Number length_of{most.n * most.n * dot(direction, direction), 1, 2 * most.e};
  bool leaves = std::any_of(direction.begin(), direction.end(), [](const Integer& n) { return n != 0; });
  for (const Furthest& last : of_a.furthest) {
    for (const Furthest& first : of_b.furthest) {
      const std::size_t size = bits(direction) + a.size() + b.size() + length({most});
      take_steps(16, size, size);
      const std::int64_t e = std::min(last.e, first.e);
      const Integer gap = -shifted(first.n, first.e - e) - shifted(last.n, last.e - e);
      leaves = leaves && covers_with(gap, e, length_of, last.spread, first.spread);
    }
  }
  require(leaves, "leaves", "along the direction they overlap by more than the stated depth");
}

void check_inside(const Claim& claim, const HullBody& body, const Numbers& point) {
  const bool is_nearer = holds(claim, body, point);
  const std::vector<Integers>& rows = body.rows();
  std::vector<std::size_t> named;
  for (std::size_t k = 0; k < claim.weights.named.size(); ++k) {
    if (claim.weights.values[k].n > 0) named.push_back(claim.weights.named[k]);
  }
  if (body.radius.n != 0) {
    const bool is_inner = is_nearer && (body.axis.empty() || named.size() == 2);
    return require(is_inner, "inside", "the point is on the boundary of " + body.quoted);
  }
  take_steps(body.dimension() * rows.size(), 4 * body.given->bits, 4 * body.given->bits);
  const std::size_t origin =
      *std::find_if_not(named.begin(), named.end(), [&](std::size_t k) { return body.is_way(k); });
  const auto vector_to = [&](std::size_t k) {
    Integers row = rows[k];
    for (std::size_t axis = 0; axis < row.size() && !body.is_way(k); ++axis) row[axis] -= rows[origin][axis];
    return row;
  };
  Span span;
  for (const std::size_t k : named) span.holds(vector_to(k));
  for (std::size_t k = 0; k < rows.size() && span.rank() < body.dimension(); ++k) {
    require(span.holds(vector_to(k)), "inside", "the points with a positive weight do not span " + body.quoted);
  }
}

}  // namespace sunder_verifier
