// The rules about half-planes: docs/claims.md, "Rules".
#include <verifier/cpp/linear.h>
#include <verifier/cpp/reader.h>
#include <verifier/cpp/rules.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace sunder_verifier {
namespace {

Integer turn(const Integer& ux, const Integer& uy, const Integer& vx, const Integer& vy) { return ux * vy - uy * vx; }

Integer along(const LinearConstraint& h, const Integers& way) { return h.a * way[0] + h.b * way[1]; }

// Positive: the point x, y, w is outside; zero: on the line.
Integer excess(const LinearConstraint& h, const Integers& place) { return along(h, place) - h.c * place[2]; }

// Requires by that rule that all hold the point x, y, w, or go on along the way x, y, 0.
void require_kept(const char* rule, const Constraints& given, const Integers& place, const char* words,
                  const char* words_after = "") {
  take_steps(2 * given.size(), bits(place), given.bits);
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (excess(given[i], place) > 0) require(false, rule, words + std::to_string(i) + words_after);
  }
}

// The weighted sum of constraints, times a positive number.
LinearConstraint weighted_sum(const WeightList& list, const Constraints& given) {
  Integers row = combined({"weights", true, "a weight is not positive"}, list, 3, [&](std::size_t k) {
                   return std::pair(Integers{given[k].a, given[k].b, given[k].c}, given[k].e);
                 }).row;
  return {row[0], row[1], row[2]};
}

void check_feasible(const Constraints& given, const Numbers& point) {
  require_kept("feasible", given, projective(point), "the point is outside of half-plane ");
}

void check_bounds(const WeightList& list, const Constraints& given, const Numbers& objective, const Numbers& point) {
  const LinearConstraint sum = weighted_sum(list, given);
  const Integers up = common(objective).integers;
  require(turn(sum.a, sum.b, up[0], up[1]) == 0 && along(sum, up) > 0, "bounds",
          "the weighted normals are not the objective");
  const Integers place = projective(point);
  for (const std::size_t k : list.named) {
    require(excess(given[k], place) == 0, "bounds", "the point is not on the line of half-plane " + std::to_string(k));
  }
}

void check_bounds_only(const WeightList& list, const Constraints& given, const Numbers& objective,
                       const Numbers& point) {
  check_bounds(list, given, objective, point);
  const LinearConstraint& first = given[list.named[0]];
  const auto is_parallel = [&](std::size_t k) { return turn(first.a, first.b, given[k].a, given[k].b) == 0; };
  require(!std::all_of(list.named.begin(), list.named.end(), is_parallel), "bounds", "the lines at the point coincide");
}

void check_no_objective(const Numbers& objective) {
  require(all_zero(common(objective).integers), "no_objective", "there is an objective");
}

void check_contradict(const WeightList& list, const Constraints& given) {
  const LinearConstraint sum = weighted_sum(list, given);
  require(sum.a == 0 && sum.b == 0 && sum.c < 0, "contradict", "the weighted constraints have a common point");
}

void check_goes_on(const Numbers& direction, const Constraints& given, const Numbers& objective) {
  Integers way = common(direction).integers;
  require(dot(common(objective).integers, way) > 0, "goes_on",
          "the direction does not lead further along the objective");
  way.emplace_back(0);
  require_kept("goes_on", given, way, "the direction leaves half-plane ");
}

void check_ends(const TwoEnds& ends, const Constraints& given, const Numbers& objective, const Numbers& point) {
  const Integers up = common(objective).integers, start = projective(point);
  Integers way{up[1], -up[0], 0};
  std::vector<Integers> places;
  for (const std::optional<EndOnLine>& end : ends) {
    if (end) {
      const Integers& place = places.emplace_back(projective(end->point));
      const LinearConstraint& h = given[end->side];
      require_kept("ends", given, place, "an end is outside of half-plane ");
      require(dot(up, way_between(start, place)) == 0, "ends", "an end is not as far along the objective");
      require(excess(h, place) == 0 && excess(h, way) > 0, "ends",
              "half-plane " + std::to_string(end->side) + " does not end it");
    } else {
      require_kept("ends", given, way, "there is an end, at half-plane ", ", and it is not given");
    }
    way = opposite(way);
  }
  if (places.size() < 2) return;
  const Integers between = way_between(places[0], places[1]);  // it goes to the left of the objective
  require(turn(up[0], up[1], between[0], between[1]) > 0, "ends", "the two ends are the same point");
}

// ---- Common parts.

bool has_corners(const std::string& verdict) {
  return verdict != "half-plane" && verdict != "line" && verdict != "strip";
}

bool is_open(const std::string& verdict) { return verdict == "ray" || verdict == "unbounded"; }

Integer facing(const LinearConstraint& h, const LinearConstraint& k) { return h.a * k.a + h.b * k.b; }

// The common point of the lines, as x, y, w. Requires that h turns to k.
Integers corner(const LinearConstraint& h, const LinearConstraint& k) {
  return {h.c * k.b - k.c * h.b, h.a * k.c - k.a * h.c, turn(h, k)};
}

void require_no_corners(const Constraints& sides, const std::string& verdict) {
  const std::size_t wanted = verdict == "half-plane" ? 1 : 2;
  require(sides.size() == wanted, "sides", "there are " + std::to_string(sides.size()) + " sides");
  if (wanted < 2) return;
  const LinearConstraint &h = sides[0], &k = sides[1];
  const Integer between = facing(h, h) * k.c - facing(h, k) * h.c;
  const bool is_so = turn(h, k) == 0 && facing(h, k) < 0 && (verdict == "line" ? between == 0 : between > 0);
  require(is_so, "sides", "the sides are not opposite, or not as far apart as they must be");
}

// Does each turn to the next, and the first to all but the last, which may be opposite, and is of a ray?
bool turn_on(const Constraints& sides, bool is_ray) {
  if (sides.size() < 2) return false;
  for (std::size_t k = 0; k + 1 < sides.size(); ++k) {
    if (turn(sides[k], sides[k + 1]) <= 0) return false;
    if (k > 0 && turn(sides[0], sides[k]) <= 0) return false;
  }
  const Integer whole = turn(sides.front(), sides.back());
  return whole == 0 || (whole > 0 && !is_ray);
}

// How many sides with a corner at each end are more than a point; all must be, but for the thin kinds.
void require_extents(const Constraints& sides, const std::string& verdict) {
  const std::size_t n = sides.size(), first = is_open(verdict) ? 1 : 0;
  std::size_t extents = 0;
  bool any_before = false;
  for (std::size_t k = first; k + first < n; ++k) {
    const Integer end = excess(sides[(k + 1) % n], corner(sides[(k + n - 1) % n], sides[k]));
    if (end < 0) ++extents;
    any_before = any_before || end > 0;
  }
  const bool is_point = verdict == "point" || verdict == "ray";
  const std::size_t wanted = is_point ? 0 : verdict == "segment" ? 2 : n - 2 * first;
  require(extents == wanted && !any_before, "sides", std::to_string(extents) + " sides have a part of the boundary");
}

void check_cones(const Indices& cones, const Constraints& given, const std::string& verdict, const Indices& named) {
  Constraints sides;
  for (const std::size_t k : named) sides.push_back(given[k]);
  if (!has_corners(verdict)) {
    require_no_corners(sides, verdict);
  } else {
    require(is_open(verdict) ? turn_on(sides, verdict == "ray") : goes_round_once(sides), "sides",
            "the sides do not turn as they must");
    require_extents(sides, verdict);
  }
  for (std::size_t i = 0; i < given.size(); ++i) {
    const LinearConstraint &h = given[i], &side = sides[cones[i]];
    bool is_between = false, is_kept = false;
    if (has_corners(verdict)) {
      const LinearConstraint& after = sides[(cones[i] + 1) % sides.size()];
      is_between = turn(side, h) >= 0 && turn(h, after) >= 0;
      is_kept = excess(h, corner(side, after)) <= 0;
    } else {
      is_between = turn(side, h) == 0 && facing(side, h) > 0;
      is_kept = facing(side, h) * side.c <= facing(side, side) * h.c;
    }
    const std::string name = "half-plane " + std::to_string(i);
    require(is_between, "cones", name + " does not face as between its sides");
    require(is_kept, "cones", name + " does not hold its corner");
  }
}

}  // namespace

const ClaimRows claims_of_half_planes{
    {"feasible", "", rule<check_feasible>},
    {"bounds", "weights: weights of subject", rule<check_bounds>},
    {"bounds_only", "weights: weights of subject", rule<check_bounds_only>},
    {"no_objective", "", rule<check_no_objective>},
    {"contradict", "weights: weights of subject", rule<check_contradict>},
    {"goes_on", "direction: point", rule<check_goes_on>},
    {"ends", "ends: two ends of subject", rule<check_ends>},
    {"cones", "cones: corners of subject", rule<check_cones>},
};

}  // namespace sunder_verifier
