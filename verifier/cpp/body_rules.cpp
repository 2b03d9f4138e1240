// The rules about convex bodies, how deep they are in each other, and how they move: docs/claims.md, "Rules".
#include <verifier/cpp/linear.h>
#include <verifier/cpp/rules.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace sunder_verifier {
namespace {

// n * 2^e + sqrt(spread), which is not negative.
struct Furthest {
  Integer n;
  std::int64_t e = 0;
  Number spread;
};

// How far a body reaches along a direction: as far as the furthest of these.
struct Reach {
  std::vector<Furthest> furthest;
  bool is_flat = true;   // all of the body is as far
  bool goes_on = false;  // along a way, for ever
};

// How far along the direction a body goes beyond its core, squared.
Number spread_of(const HullBody& body, const Integers& direction) {
  if (body.radius.n == 0) return {};
  Number spread{body.radius.n * body.radius.n, 1, 2 * body.radius.e};
  Integers across = direction;
  if (body.around == Around::ellipsoid && body.is_image()) {
    across = transposed_times(body.linear, direction);
    spread.e += 2 * body.linear.e;
  } else if (!body.axis.empty()) {  // as d d - (d a)^2 / (a a) = |d x a|^2 / (a a)
    across = cross(direction, body.axis);
    spread.d = dot(body.axis, body.axis);
  }
  spread.n *= dot(across, across);
  return spread;
}

Reach reach(const HullBody& body, const Integers& direction) {
  const auto [all, e] = products(body, direction);
  Reach result;
  Integer greatest = all[0];
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (body.is_way(k)) {
      result.goes_on = result.goes_on || all[k] > 0;
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

// Requires by that rule that no way goes on along the direction.
Reach end_of(const char* rule, const HullBody& body, const Integers& direction) {
  Reach result = reach(body, direction);
  require(!result.goes_on, rule, "a way of " + body.quoted + " goes on along the direction");
  return result;
}

// The sign of how much further B begins along the direction than A ends, with a length added or (sign -1) taken away,
// which is in units of that of the direction; and whether both are flat.
struct Parting {
  int gap = 1;
  bool is_flat;
};

Parting parting(const char* rule, const Integers& direction, const HullBody& a, const HullBody& b, int sign = 0,
                const Number& added = {}) {
  const Reach of_a = end_of(rule, a, direction), of_b = end_of(rule, b, opposite(direction));
  Number square;
  if (added.n != 0) square = {added.n * added.n * dot(direction, direction), 1, 2 * added.e};
  Parting result{1, of_a.is_flat && of_b.is_flat};
  for (const Furthest& last : of_a.furthest) {
    for (const Furthest& first : of_b.furthest) {
      const std::size_t size = bits(direction) + a.size() + b.size() + length({added});
      if (a.is_round() || b.is_round() || sign > 0) take_steps(16, size, size);
      const std::int64_t e = std::min(last.e, first.e);
      const Integer gap = -shifted(first.n, first.e - e) - shifted(last.n, last.e - e);
      result.gap =
          std::min(result.gap, sign_with_roots(gap, e, {{-1, last.spread}, {-1, first.spread}, {sign, square}}));
    }
  }
  return result;
}

// Of all of a body, is none further along the direction than the point x, .., w?
bool is_behind(const Reach& ends, const Integers& direction, const Integers& place) {
  const Integer limit = dot(direction, place), &w = place.back();  // of one number more, which does not count
  return !ends.goes_on && std::all_of(ends.furthest.begin(), ends.furthest.end(), [&](const Furthest& last) {
    const std::int64_t e = std::min<std::int64_t>(last.e, 0);
    const Integer gap = shifted(limit, -e) - shifted(last.n * w, last.e - e);
    return sign_with_roots(gap, e, {{-1, {last.spread.n * w * w, last.spread.d, last.spread.e}}}) >= 0;
  });
}

// Requires, of a body with a radius, that it reaches from the point of its core, mean / d * 2^e, to the point. Is it
// then nearer to that than the body reaches?
bool reaches(const WeightList& list, const Numbers& from, const HullBody& body, const Integers& mean, const Integer& d,
             std::int64_t e, const Numbers& point) {
  const std::size_t size = body.size() + length(point) + length(from) + length(list.values);
  take_steps(8, size, size);
  const bool is_mapped = body.around == Around::ellipsoid;
  require(!is_mapped || differs(body, projective(from), point) == no_index, "holds",
          "the point of " + body.quoted + " comes from elsewhere");
  Numbers values;  // all times d
  for (const Number& n : is_mapped ? from : point) values.push_back({n.n * d, n.d, n.e});
  for (const Integer& n : mean) values.push_back({n, 1, e});
  Number radius = body.radius;
  if (body.around == Around::cone) {
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

// The mean of points of a body, as they are placed, but of an ellipsoid, and what ways add to it. Refuses by that rule.
Combination mean_of(const char* rule, const WeightList& list, const HullBody& body) {
  const bool is_unplaced = body.around == Around::ellipsoid;
  const Combination mean = combined(
      {rule, false, "a weight of " + body.quoted + " is negative"}, list, body.dimension(),
      [&](std::size_t k) { return is_unplaced ? std::pair(body.rows()[k], body.given->e) : image(body, k); },
      body.count);
  require(are_equal(mean.total, {1, 1, 0}), rule, "the weights of " + body.quoted + " do not sum to 1");
  return mean;
}

}  // namespace

Numbers moved_back(const Numbers& point, const Number& time, const HullBody& begin, const HullBody& end) {
  const std::size_t size = length(point) + length({time}) + begin.size() + end.size();
  take_steps(16, size, size);
  Numbers result;
  for (std::size_t axis = 0; axis < point.size(); ++axis) {
    Numbers parts{point[axis]};
    for (const auto& [place, sign] : {std::pair(&begin, 1), std::pair(&end, -1)}) {
      if (!place->is_image()) continue;
      const Scaled& moved = place->translation;
      parts.push_back({sign * time.n * moved.rows[0][axis], time.d, time.e + moved.e});
    }
    result.push_back(sum(parts));
  }
  return result;
}

bool holds(const WeightList& list, const Numbers& from, const HullBody& body, const Numbers& point) {
  const Combination mean = mean_of("holds", list, body);
  if (body.is_round()) return reaches(list, from, body, mean.row, mean.d, mean.e, point);
  for (std::size_t r = 0; r < point.size(); ++r) {
    require(are_equal({mean.row[r], mean.d, mean.e}, point[r]), "holds",
            "the weighted sum of the points of " + body.quoted + " differs from the stated point in coordinate " +
                std::to_string(r));
  }
  return false;
}

void require_beyond(const char* rule, const EndOfPart& part, const Integers& direction, const HullBody& body,
                    const Number& least) {
  require(!all_zero(direction), rule, "a direction is zero");
  const Reach of_body = end_of(rule, body, opposite(direction));
  const std::size_t size = bits(direction) + body.size() + part.size + length({least});
  if (body.is_round() || least.n != 0) take_steps(16, size, size);
  Number square;
  if (least.n != 0) square = {least.n * least.n * dot(direction, direction), 1, 2 * least.e};
  for (const Furthest& first : of_body.furthest) {
    const std::int64_t e = std::min(part.e, first.e);
    const Integer gap = -shifted(first.n, first.e - e) - shifted(part.last, part.e - e);
    const int order = sign_with_roots(gap, e, {{-1, first.spread}, {-1, square}});
    require(least.n == 0 ? order > 0 : order >= 0, rule,
            body.quoted + " does not begin far enough beyond a part, along its direction");
  }
}

namespace {

void check_parted(const Numbers& direction, const HullBody& a, const HullBody& b) {
  const Parting found = parting("parted", common(direction).integers, a, b);  // along a positive multiple
  require(found.gap > 0, "parted", a.quoted + " is not strictly less far along the direction than " + b.quoted);
}

void check_parted_weakly(const Numbers& direction, const HullBody& a, const HullBody& b) {
  const auto [gap, is_flat] = parting("parted", common(direction).integers, a, b);
  require(gap >= 0, "parted", a.quoted + " is not less far along the direction than " + b.quoted);
  require(gap > 0 || !is_flat, "parted", "all of " + a.quoted + " and " + b.quoted + " is as far along the direction");
}

void check_holds(const WeightList& weights, const Numbers& from, const HullBody& body, const Numbers& point) {
  holds(weights, from, body, point);
}

// Row k of a body: a way, or how far a point is from that at the origin.
Integers way_to(const HullBody& body, std::size_t k, std::size_t origin = 0) {
  return body.is_way(k) ? body.rows()[k] : minus(body.rows()[k], body.rows()[origin]);
}

// Requires by that rule that along the direction nothing of A is beyond the point p, nothing of B before q.
void require_between(const char* rule, const Integers& direction, const HullBody& a, const HullBody& b,
                     const Integers& p, const Integers& q, const char* otherwise) {
  const Integers back = opposite(direction);
  const bool a_ends = is_behind(reach(a, direction), direction, p);
  require(a_ends && is_behind(reach(b, back), back, q), rule, (a_ends ? b : a).quoted + otherwise);
}

void check_slab(const HullBody& a, const HullBody& b, const Numbers& from_a, const Numbers& to_b) {
  const Integers p = projective(from_a), q = projective(to_b), way = way_between(p, q);
  require(!all_zero(way), "slab", "the two points are the same");
  require_between("slab", way, a, b, p, q, " extends beyond its point along the direction");
}

void check_clear(const Numbers& given, const HullBody& a, const HullBody& b, const Number& least) {
  const Integers direction = common(given).integers;  // a positive multiple of it
  const Parting found = parting("clear", direction, a, b, -1, least);
  require(!all_zero(direction) && found.gap >= 0, "clear", "along the direction they are less far apart than stated");
}

void check_nearer(const Numbers& from_a, const Numbers& to_b, const Number& least) {
  const std::size_t size = length(from_a) + length(to_b);
  take_steps(16, size, size);
  const Integers p = projective(from_a), q = projective(to_b), way = way_between(p, q);
  const Integer limit = least.n * p.back() * q.back();
  require(compare(dot(way, way), 0, limit * limit, 2 * least.e) < 0, "nearer",
          "the points are not nearer than the stated distance");
}

void check_leaves(const Numbers& given, const HullBody& a, const HullBody& b, const Number& most) {
  const Integers direction = common(given).integers;
  const Parting found = parting("leaves", direction, a, b, 1, most);
  require(!all_zero(direction) && found.gap >= 0, "leaves",
          "along the direction they overlap by more than the stated depth");
}

// Requires by that rule that a body is more than a point, and on one line: along this, as it is not placed.
Integers line_of(const char* rule, const HullBody& body) {
  const std::vector<Integers>& rows = body.rows();
  take_steps(4 * body.dimension() * rows.size(), 2 * body.given->bits, 2 * body.given->bits);
  Elimination span(body.dimension());
  Integers along(body.dimension());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    Integers way = way_to(body, k);
    if (span.rank() == 0 && span.take(way))
      along = std::move(way);
    else
      require(all_zero(span.rest(way)), rule, body.quoted + " is not on one line");
  }
  require(span.rank() == 1, rule, body.quoted + " is a point");
  return along;
}

// B is on a line; along it, one of A and B ends at the first point one way, and at the last point the other way.
void check_no_further(const Numbers& before, const Numbers& after_last, const HullBody& a, const HullBody& b,
                      const Numbers& first, const Numbers& last) {
  const Integers along = line_of("no_further", b);
  int sides = 1;
  for (const auto& [given, point] : {std::pair(&before, &first), std::pair(&after_last, &last)}) {
    const Integers direction = common(*given).integers, place = projective(*point);
    const bool is_end =
        is_behind(reach(a, direction), direction, place) || is_behind(reach(b, direction), direction, place);
    require(is_end, "no_further", "both go on beyond a point");
    sides *= dot(direction, turned(b, along)).sign();
  }
  require(sides < 0, "no_further", "the directions are not along " + b.quoted + ", to either side");
}

// Along a direction A begins at its point i; B is the hyperplane across it, or the half-space up to that, and ends
// before A, if it ends.
void check_first_along(const Numbers& given, const HullBody& a, const HullBody& b, std::size_t i) {
  const Integers direction = common(given).integers;
  const auto [of_a, e] = products(a, direction);
  const auto [of_b, f] = products(b, direction);
  const std::vector<Integers>& rows = b.rows();
  const std::size_t d = b.dimension(), twice = 2 * b.given->bits;
  take_steps(4 * d * d * (rows.size() - b.count), twice, twice);
  std::set<Integers> level;
  Elimination span(d);
  bool is_across = !all_zero(direction), goes_back = false;
  Integer last = of_b[0];
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (!b.is_way(k)) {
      last = std::max(last, of_b[k]);
    } else if (of_b[k] != 0 || all_zero(rows[k])) {
      is_across = is_across && of_b[k] <= 0;
      goes_back = goes_back || of_b[k] < 0;
    } else {
      level.insert(reduced(rows[k]));
      if (span.rank() + 1 < d) span.take(turned(b, rows[k]));
    }
  }
  for (const Integers& way : level) is_across = is_across && level.contains(opposite(way));
  require(is_across && span.rank() + 1 == d, "first_along",
          b.quoted + " is not all that is across the direction, or up to there");
  const Integer& first = *std::min_element(of_a.begin(), of_a.end());
  require(goes_back || compare(last, f, first, e) <= 0, "first_along", a.quoted + " does not begin beyond " + b.quoted);
  require(of_a[i] == first, "first_along", a.quoted + " begins before its point " + std::to_string(i));
}

void check_inside(const WeightList& weights, const Numbers& from, const HullBody& body, const Numbers& point) {
  const bool is_nearer = holds(weights, from, body, point);
  const std::vector<Integers>& rows = body.rows();
  std::vector<std::size_t> named;
  for (std::size_t k = 0; k < weights.named.size(); ++k) {
    if (weights.values[k].n > 0) named.push_back(weights.named[k]);
  }
  if (body.radius.n != 0) {
    const bool is_inner = is_nearer && (body.axis.empty() || named.size() == 2);
    return require(is_inner, "inside", "the point is on the boundary of " + body.quoted);
  }
  take_steps(body.dimension() * rows.size(), 4 * body.given->bits, 4 * body.given->bits);
  const std::size_t origin =
      *std::find_if_not(named.begin(), named.end(), [&](std::size_t k) { return body.is_way(k); });
  Elimination span(body.dimension());
  for (const std::size_t k : named) span.take(way_to(body, k, origin));
  for (std::size_t k = 0; k < rows.size() && span.rank() < body.dimension(); ++k) {
    require(all_zero(span.rest(way_to(body, k, origin))), "inside",
            "the points with a positive weight do not span " + body.quoted);
  }
}

// Requires by that rule that all of B is across a direction, and A nowhere further along it: these points of A just as
// far, and no others. On which side of B is each of them, seen along the direction?
std::vector<int> sides_of_touched(const char* rule, const Numbers& given, const HullBody& a, const HullBody& b,
                                  const Integers& along, const Indices& named) {
  const Integers direction = common(given).integers;
  const auto [of_a, e] = products(a, direction);
  const auto [of_b, f] = products(b, direction);
  bool is_across = !all_zero(direction);
  for (std::size_t k = 0; k < of_b.size(); ++k) is_across = is_across && of_b[k] == (b.is_way(k) ? 0 : of_b[0]);
  require(is_across, rule, b.quoted + " is not across the direction");
  Indices touched;
  for (std::size_t k = 0; k < of_a.size(); ++k) {
    const int order = compare(of_a[k], e, of_b[0], f);
    require(order <= 0, rule, a.quoted + " is further along the direction than " + b.quoted);
    if (order == 0) touched.push_back(k);
  }
  require(touched == named, rule, "the points of " + a.quoted + " that are as far as " + b.quoted + " are others");
  const Integers beside = cross(direction, turned(b, along));
  const auto [to_a, g] = products(a, beside);
  const auto [to_b, h] = products(b, beside);
  std::vector<int> sides;
  for (const std::size_t k : touched) sides.push_back(compare(to_a[k], g, to_b[0], h));
  return sides;
}

bool has_side(const std::vector<int>& sides, int side) {
  return std::find(sides.begin(), sides.end(), side) != sides.end();
}

void check_wedge(const Numbers& before, const Numbers& after_last, const HullBody& a, const HullBody& b,
                 const Indices& on_first, const Indices& on_last) {
  const Integers along = line_of("wedge", b);
  for (const auto& [given, named] : {std::pair(&before, &on_first), std::pair(&after_last, &on_last)}) {
    const std::vector<int> sides = sides_of_touched("wedge", *given, a, b, along, *named);
    require(has_side(sides, 1) || has_side(sides, -1), "wedge",
            "no point of " + a.quoted + " that is as far as " + b.quoted + " is beside its line");
  }
  require(!all_zero(cross(common(before).integers, common(after_last).integers)), "wedge",
          "the directions are parallel");
}

void check_rests(const Numbers& given, const HullBody& a, const HullBody& b, const Indices& on_plane) {
  const std::vector<int> sides = sides_of_touched("rests", given, a, b, line_of("rests", b), on_plane);
  require(has_side(sides, 1) && has_side(sides, -1), "rests",
          "the points of " + a.quoted + " that are as far as " + b.quoted + " are not on both sides of its line");
}

void check_full(std::size_t i, std::size_t j, std::size_t k, std::size_t l, const HullBody& body) {
  take_steps(16, body.size(), body.size());
  const auto way = [&](std::size_t to) { return turned(body, way_to(body, to, i)); };
  require(dot(cross(way(j), way(k)), way(l)) != 0, "full", "the four points of " + body.quoted + " are in one plane");
}

void check_parted_all_along(const Numbers& direction, const HullBody& a, const HullBody& b, const HullBody& to_a,
                            const HullBody& to_b) {
  check_parted(direction, a, b);
  check_parted(direction, to_a, to_b);
}

void check_holds_at(const WeightList& weights, const Numbers& from, const HullBody& body, const HullBody& to_body,
                    const Number& time, const Numbers& point) {
  check_holds(weights, from, body, moved_back(point, time, body, to_body));
}

void check_not_before(const Numbers& given, const HullBody& a, const HullBody& b, const HullBody& to_a,
                      const HullBody& to_b, const Number& time, const Numbers& point) {
  const Integers direction = common(given).integers;  // along a positive multiple
  const Integers of_a = projective(moved_back(point, time, a, to_a)),
                 of_b = projective(moved_back(point, time, b, to_b));
  require_between("not_before", direction, a, b, of_a, of_b, " extends beyond the point");
  require(dot(direction, way_between(of_a, of_b)) > 0, "not_before",
          "along the direction " + a.quoted + " and " + b.quoted + " do not come nearer");
}

// The point of the core that the weights of a hull make; of others the point, which the body holds.
Numbers place_of(const SurfaceEnd& end, const HullBody& body) {
  if (body.around != Around::nothing && body.around != Around::hull) {
    check_holds(end.weights, end.from, body, end.point);
    return end.point;
  }
  const Combination mean = mean_of("surrounds", end.weights, body);
  Numbers place;
  for (const Integer& n : mean.row) place.push_back({n, mean.d, mean.e});
  return place;
}

// x, y, z, w, or x, y, w, of a point of A less one of B.
Integers difference_of(const SurfaceCorner& corner, const HullBody& a, const HullBody& b) {
  const Numbers p = place_of(corner.of_a, a), q = place_of(corner.of_b, b);
  take_steps(16, a.size() + b.size() + length(p) + length(q), a.size() + b.size() + length(p) + length(q));
  Numbers way;
  for (std::size_t axis = 0; axis < a.dimension(); ++axis) {
    way.push_back(sum({p[axis], {-q[axis].n, q[axis].d, q[axis].e}}));
  }
  return projective(way);
}

// A normal, and how far along it the corners are; both times the product of the corners' w.
struct SurfacePiece {
  Integers normal;
  Integer height;
};

// In the plane: from p to q, which is counterclockwise around the origin.
SurfacePiece side_of(const Integers& p, const Integers& q) {
  return {{q[0] * p[2] - p[0] * q[2], q[1] * p[2] - p[1] * q[2]}, p[0] * q[1] - p[1] * q[0]};
}

SurfacePiece face_of(const Integers& p, const Integers& q, const Integers& r) {
  const Integers pq = cross(p, q), qr = cross(q, r), rp = cross(r, p);
  SurfacePiece face{{}, p[0] * qr[0] + p[1] * qr[1] + p[2] * qr[2]};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    face.normal.push_back(r[3] * pq[axis] + p[3] * qr[axis] + q[3] * rp[axis]);
  }
  return face;
}

Number radius_of(const HullBody& body) { return body.around == Around::hull ? body.radius : Number{}; }

void check_surrounds(const SurfaceCorners& corners, const IndexLists& triangles, const HullBody& a, const HullBody& b,
                     const Number& least) {
  const Number r = radius_of(a), s = radius_of(b);
  // What is left of `least` beyond the radii, in units of 2^e.
  const Common lengths = common({least, r, s});
  const Integer rest = lengths.integers[0] - lengths.integers[1] - lengths.integers[2];
  const Number square{rest * rest, lengths.d * lengths.d, 2 * lengths.e};
  const auto compared = [&](const Integer& n, const Integer& whole) {  // n against square whole
    return sum({{n, 1, 0}, {-square.n * whole, square.d, square.e}}).n.sign();
  };
  std::vector<Integers> at;
  std::size_t size = length({least, r, s});
  for (const SurfaceCorner& corner : corners) {
    at.push_back(difference_of(corner, a, b));
    size = std::max(size, bits(at.back()));
  }
  if (triangles.empty()) {
    require(at.size() == 1, "surrounds", "there is no surface, and not one point");
    const Integers& p = at[0];
    take_steps(8, size, size);
    const Integers offset(p.begin(), p.end() - 1);
    const bool is_near = rest <= 0 && compared(dot(offset, offset), p.back() * p.back()) <= 0;
    require(is_near, "surrounds", "the point is too far from the origin");
    return;
  }
  Ridges<bool> edges;
  for (const Indices& triangle : triangles) {
    take_steps(24, size, size);
    const auto [normal, volume] = a.dimension() == 2 ? side_of(at[triangle[0]], at[triangle[1]])
                                                     : face_of(at[triangle[0]], at[triangle[1]], at[triangle[2]]);
    require(volume > 0, "surrounds", "a piece of the surface is not counterclockwise from outside");
    if (rest > 0) {
      require(compared(volume * volume, dot(normal, normal)) >= 0, "surrounds",
              "a piece of the surface is too near to the origin");
    }
    for (std::size_t corner = 0; corner < triangle.size(); ++corner) {
      const bool is_new = edges.take(ridge_of(triangle, corner), true);
      require(is_new, "surrounds", "an edge occurs twice in the same direction");
    }
  }
  for (const Indices& triangle : triangles) {
    for (std::size_t corner = 0; corner < triangle.size(); ++corner) {
      require(edges.beyond(ridge_of(triangle, corner)) != nullptr, "surrounds", "the surface is not closed");
    }
  }
}

}  // namespace

const ClaimRows claims_of_bodies{
    {"parted", "direction: point", rule<check_parted>},
    {"parted_weakly", "direction: point", rule<check_parted_weakly>},
    {"holds", "weights: weights of subject; from: point", rule<check_holds>},
    {"slab", "", rule<check_slab>},
    {"clear", "direction: point", rule<check_clear>},
    {"nearer", "", rule<check_nearer>},
    {"leaves", "direction: point", rule<check_leaves>},
    {"first_along", "direction: point", rule<check_first_along>},
    {"no_further", "before, after: point", rule<check_no_further>},
    {"inside", "weights: weights of subject; from: point", rule<check_inside>},
    {"wedge", "before, after: point", rule<check_wedge>},
    {"rests", "direction: point", rule<check_rests>},
    {"full", "i, j, k, l: index of subject", rule<check_full>},
    {"parted_all_along", "direction: point", rule<check_parted_all_along>},
    {"holds_at", "weights: weights of subject; from: point", rule<check_holds_at>},
    {"not_before", "direction: point", rule<check_not_before>},
    {"surrounds", "differences: differences; triangles: triangles of differences", rule<check_surrounds>},
};

}  // namespace sunder_verifier
