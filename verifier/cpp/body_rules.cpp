// The rules about convex bodies: docs/claims.md, "Rules", from `parted` to `inside`.
#include <verifier/cpp/reader.h>
#include <verifier/cpp/rules.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace sunder_verifier {
namespace {

// -1, 0, +1 as m * 2^e is less than, equal to, greater than n * 2^f.
int compare(const Integer& m, std::int64_t e, const Integer& n, std::int64_t f) {
  return shifted(m, std::max<std::int64_t>(e - f, 0)).compare(shifted(n, std::max<std::int64_t>(f - e, 0)));
}

// How far a body reaches along a direction.
struct Reach {
  Integer greatest;  // product with a point, in units of 2^e
  std::int64_t e = 0;
  bool is_flat = true;  // all of the body is as far
};

// Requires by that rule that no way goes on along the direction.
Reach reach(const char* rule, const HullBody& body, const Integers& direction) {
  const auto [all, e] = products(body, direction);
  Reach result{all[0], e, true};
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (body.is_way(k)) {
      require(all[k] <= 0, rule, "a way of " + body.name + " goes on along the direction");
      result.is_flat = result.is_flat && all[k] == 0;
    } else {
      result.is_flat = result.is_flat && all[k] == all[0];
      if (all[k] > result.greatest) result.greatest = all[k];
    }
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

// The sign of how much further B begins along the direction than A ends, and whether both are flat.
struct Parting {
  int gap;
  bool is_flat;
};

Parting parting(const Claim& claim, const HullBody& a, const HullBody& b) {
  const Integers direction = common(claim.direction).integers;  // a positive multiple of it
  const Reach of_a = reach("parted", a, direction), of_b = reach("parted", b, opposite(direction));
  return {compare(-of_b.greatest, of_b.e, of_a.greatest, of_a.e), of_a.is_flat && of_b.is_flat};
}

// Requires that no part of the body is further along the direction than the point x, .., w.
void require_behind(const HullBody& body, const Integers& direction, const Integers& place) {
  const auto [all, e] = products(body, direction);
  const Integer limit = dot(direction, place);  // of one number more, which does not count
  for (std::size_t k = 0; k < all.size(); ++k) {
    const bool is_behind = body.is_way(k) ? all[k] <= 0 : compare(all[k] * place.back(), e, limit, 0) <= 0;
    require(is_behind, "slab", body.name + " is not behind its point");
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

}  // namespace

void check_parted(const Claim& claim, const HullBody& a, const HullBody& b) {
  require(parting(claim, a, b).gap > 0, "parted",
          a.name + " is not strictly less far along the direction than " + b.name);
}

void check_parted_weakly(const Claim& claim, const HullBody& a, const HullBody& b) {
  const auto [gap, is_flat] = parting(claim, a, b);
  require(gap >= 0, "parted", a.name + " is not less far along the direction than " + b.name);
  require(gap > 0 || !is_flat, "parted", "all of " + a.name + " and " + b.name + " is as far along the direction");
}

void check_holds(const Claim& claim, const HullBody& body, const Numbers& point) {
  const WeightList& list = claim.weights;
  const Common weights = common_weights(list.values);
  Integer total = 0;
  for (std::size_t k = 0; k < list.named.size(); ++k) {
    require(weights.integers[k] >= 0, "holds", "a weight of " + body.name + " is negative");
    if (!body.is_way(list.named[k])) total += weights.integers[k];
  }
  require(compare(total, weights.e, weights.d, 0) == 0, "holds", "the weights of " + body.name + " do not sum to 1");
  Integers mean(body.dimension());
  std::int64_t e = 0;
  for (std::size_t k = 0; k < list.named.size(); ++k) {
    const auto [place, f] = image(body, list.named[k]);
    e = f;
    for (std::size_t r = 0; r < mean.size(); ++r) mean[r] += weights.integers[k] * place[r];
  }
  for (std::size_t r = 0; r < mean.size(); ++r) {
    require(compare(mean[r] * point[r].d, weights.e + e, point[r].n * weights.d, point[r].e) == 0, "holds",
            "the weighted sum of " + body.name + " is not the point in coordinate " + std::to_string(r));
  }
}

void check_slab(const HullBody& a, const HullBody& b, const Numbers& from_a, const Numbers& to_b) {
  const Integers p = projective(from_a), q = projective(to_b);
  const Integers way = way_between(p, q);
  require(std::any_of(way.begin(), way.end(), [](const Integer& n) { return n != 0; }), "slab",
          "the two points are one");
  require_behind(a, way, p);
  require_behind(b, opposite(way), q);
}

void check_clear(const Claim& claim, const HullBody& a, const HullBody& b, const Number& least) {
  const Integers direction = common(claim.direction).integers;  // a positive multiple of it
  const Reach of_a = reach("clear", a, direction), of_b = reach("clear", b, opposite(direction));
  const std::int64_t e = std::min(of_a.e, of_b.e);
  const Integer gap = -shifted(of_b.greatest, of_b.e - e) - shifted(of_a.greatest, of_a.e - e);
  const bool is_wide =
      gap > 0 && compare(gap * gap, 2 * e, least.n * least.n * dot(direction, direction), 2 * least.e) >= 0;
  require(is_wide, "clear", "along the direction they are nearer");
}

void check_nearer(const Numbers& from_a, const Numbers& to_b, const Number& least) {
  const std::size_t size = length(from_a) + length(to_b);
  take_steps(16, size, size);
  const Integers p = projective(from_a), q = projective(to_b), way = way_between(p, q);
  const Integer limit = least.n * p.back() * q.back();
  require(compare(dot(way, way), 0, limit * limit, 2 * least.e) < 0, "nearer", "the points are as far apart");
}

void check_inside(const Claim& claim, const HullBody& body, const Numbers& point) {
  check_holds(claim, body, point);
  const std::vector<Integers>& rows = body.rows();
  take_steps(body.dimension() * rows.size(), 4 * body.given->bits, 4 * body.given->bits);
  std::vector<std::size_t> named;
  for (std::size_t k = 0; k < claim.weights.named.size(); ++k) {
    if (claim.weights.values[k].n > 0) named.push_back(claim.weights.named[k]);
  }
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
    require(span.holds(vector_to(k)), "inside", "what makes the point does not span all of " + body.name);
  }
}

}  // namespace sunder_verifier
