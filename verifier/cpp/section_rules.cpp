// The rules about what a plane has in common with the hull of a body's points: docs/claims.md, "Sections".
#include <verifier/cpp/linear.h>
#include <verifier/cpp/rules.h>
#include <verifier/cpp/sets.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace sunder_verifier {
namespace {

// The plane, pulled back to where the rows of the body are.
class Pulled {
 public:
  Pulled(const HullBody& body, const StatedPlane& plane) : body_(body), normal_(plane.normal), level_(plane.level) {
    std::int64_t turned = body.given->e, moved = turned;
    Integer shift = 0;
    if (body.is_image()) {
      const Integers& m = body.linear.rows[0];
      take_steps(9, bits(plane.normal), body.linear.bits);
      shift = dot(plane.normal, body.translation.rows[0]);
      turned += body.linear.e;
      moved = body.translation.e;
      normal_ = transposed_times(body.linear, plane.normal);
      upright_ = dot({m[0], m[1], m[2]}, cross({m[3], m[4], m[5]}, {m[6], m[7], m[8]}));
    }
    const std::int64_t e = std::min({turned, moved, std::int64_t{0}});
    for (Integer& n : normal_) n = shifted(n, turned - e);
    level_ = shifted(level_, -e) - shifted(shift, moved - e);
  }

  void take_looks(std::size_t looks) const {
    take_steps(looks, std::max(bits(normal_), bits(level_)), body_.given->bits);
  }

  Integer height(std::size_t k) const { return dot(normal_, body_.rows()[k]) - level_; }
  bool is_on(std::size_t k) const { return height(k) == 0; }

  std::vector<Integer> heights() const {
    take_looks(body_.rows().size());
    std::vector<Integer> result;
    for (std::size_t k = 0; k < body_.rows().size(); ++k) result.push_back(height(k));
    return result;
  }

  // A triangle at the first of three corners, where they are placed: the product of the normal with that of its ways
  // is a fraction of these, in units of 2^unit_of_triangles().
  std::pair<Integer, Integer> triangle(const StatedPlane& plane, const IndexPair& first, const IndexPair& second,
                                       const IndexPair& third) const {
    const Integers p = place(first), q = place(second), r = place(third);
    const Integers to_q = turned(body_, way_between(p, q)), to_r = turned(body_, way_between(p, r));
    return {dot(plane.normal, cross(to_q, to_r)), p[3] * q[3] * p[3] * r[3]};
  }
  std::int64_t unit_of_triangles() const { return 2 * (body_.given->e + (body_.is_image() ? body_.linear.e : 0)); }

  // Do three corners turn counter-clockwise, seen from where the normal points to?
  bool turn_left(const IndexPairs& corners) const {
    const Integers p = place(corners[0]), q = place(corners[1]), r = place(corners[2]);
    return upright_ * dot(normal_, cross(way_between(p, q), way_between(p, r))) > 0;
  }

 private:
  // x, y, z, w, for the point (x / w, y / w, z / w); w is positive.
  Integers place(const IndexPair& corner) const {
    const auto& [i, j] = corner;
    const Integers& a = body_.rows()[i];
    if (i == j) return {a[0], a[1], a[2], 1};
    const Integers& b = body_.rows()[j];
    const Integer above = height(i), below = height(j);
    return {above * b[0] - below * a[0], above * b[1] - below * a[1], above * b[2] - below * a[2], above - below};
  }

  const HullBody& body_;
  Integers normal_;
  Integer level_, upright_ = 1;  // negative: the body is mirrored; zero: flattened
};

bool holds_both(const Indices& face, const IndexPair& c, const IndexPair& d) {
  const Set named = as_set(face);
  return has(named, c.first) && has(named, c.second) && has(named, d.first) && has(named, d.second);
}

// Of a ring the ends of its edges, in both orders, and its vertices; of two points the edge alone.
std::set<IndexPair> sides_of(const Indices& ring) {
  std::set<IndexPair> sides;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const std::size_t i = ring[k], j = ring[after(k, ring.size())];
    sides.insert({{i, j}, {j, i}});
    if (ring.size() > 2) sides.insert({i, i});
  }
  return sides;
}

void check_beyond(const HullBody& body, const StatedPlane& plane) {
  const std::vector<Integer> heights = Pulled(body, plane).heights();
  const auto [least, greatest] = std::minmax_element(heights.begin(), heights.end());
  require(*least > 0 || *greatest < 0, "beyond", "the plane is not beyond " + body.quoted);
}

void check_touches(const HullBody& body, const StatedPlane& plane, const IndexPairs& corners) {
  const std::vector<Integer> heights = Pulled(body, plane).heights();
  const auto [least, greatest] = std::minmax_element(heights.begin(), heights.end());
  const bool are_on_plane = std::all_of(corners.begin(), corners.end(), [&](const IndexPair& corner) {
    return corner.first == corner.second && heights[corner.first] == 0;
  });
  const Integers &first = body.rows()[corners.front().first], &last = body.rows()[corners.back().first];
  const bool is_as_many = corners.size() == 1 || (corners.size() == 2 && first != last);
  require((*least >= 0 || *greatest <= 0) && are_on_plane && is_as_many, "touches",
          "the plane does not touch it there only");
  const auto zeros = static_cast<std::size_t>(std::count(heights.begin(), heights.end(), Integer(0)));
  take_steps(4 * zeros, body.given->bits, body.given->bits);
  for (std::size_t k = 0; k < heights.size(); ++k) {
    require(heights[k] != 0 || is_between(first, last, body.rows()[k]), "touches",
            "point " + std::to_string(k) + " is on the plane, too");
  }
}

void check_outlined(const Indices& along, const HullBody& body, const StatedPlane& plane, const IndexPairs& corners,
                    const Proved& proved) {
  const auto known = proved.hulls.find(body.base);
  require(known != proved.hulls.end() && known->second.verdict != "point", "outlined",
          "what the hull of " + body.quoted + " is has not been proved before");
  const auto& [verdict, faces] = known->second;
  const Pulled pulled(body, plane);
  pulled.take_looks(64 * corners.size());
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto [i, j] = corners[k];
    const bool is_corner = i == j ? pulled.is_on(i) : pulled.height(i) > 0 && pulled.height(j) < 0;
    require(is_corner, "outlined", "corner " + std::to_string(k) + " is not on the plane");
  }
  std::size_t looks = 0;
  for (const std::size_t f : along) {
    require(f < faces.size(), "outlined", "a face is none of the hull's");
    looks += faces[f].size();
  }
  take_steps(looks, 1, 1);
  const auto is_in_plane = [&](const Indices& face) {
    return std::all_of(face.begin(), face.begin() + 3, [&](std::size_t k) { return pulled.is_on(k); });
  };
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Indices& face = faces[along[k]];
    require(holds_both(face, corners[k], corners[after(k, corners.size())]), "outlined",
            "corner " + std::to_string(k) + " and the next one are not in that face");
    require(verdict != "solid" || !is_in_plane(face), "outlined",
            "face " + std::to_string(along[k]) + " is in the plane");
  }
  if (verdict == "solid") {
    const bool is_round = corners.size() > 2 && as_set(along).size() == along.size();
    require(is_round, "outlined", "the corners are not around the body");
  } else {
    const Indices& ring = faces[0];
    const std::set<IndexPair> sides = sides_of(ring);
    const bool is_whole = verdict == "flat" && is_in_plane(ring);
    bool fits = true;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const auto [i, j] = corners[k];
      fits = fits && sides.contains({i, is_whole ? corners[after(k, corners.size())].first : j});
    }
    const std::size_t wanted = is_whole ? ring.size() : ring.size() == 2 ? 1 : 2;
    require(fits && corners.size() == wanted, "outlined", "the corners are not those of the hull");
  }
  require(corners.size() < 3 || pulled.turn_left(corners), "outlined", "the corners do not go counter-clockwise");
}

// Twice the area, times the length of the normal, is from one sum to another.
void check_area(const HullBody& body, const StatedPlane& plane, const IndexPairs& corners, const Number& area_from,
                const Number& area_to) {
  const Pulled pulled(body, plane);
  pulled.take_looks(32 * corners.size());
  std::vector<std::pair<Integer, std::int64_t>> parts;
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
    auto [n, d] = pulled.triangle(plane, corners[0], corners[k], corners[k + 1]);
    require(n > 0, "area", "the corners do not turn to the left");
    const std::int64_t s = 64 + static_cast<std::int64_t>(bits(d)) - static_cast<std::int64_t>(bits(n));
    (s > 0 ? n : d) <<= std::abs(s);
    parts.emplace_back(n / d, -s);
  }
  require(!parts.empty(), "area", "there are not three corners");
  std::int64_t e = parts[0].second;
  for (const auto& part : parts) e = std::min(e, part.second);
  Integer low = 0, high = 0;
  for (const auto& [n, s] : parts) {
    low += shifted(n, s - e);
    high += shifted(n + 1, s - e);
  }
  const Integer across = 4 * dot(plane.normal, plane.normal);
  const std::int64_t unit = 2 * (e + pulled.unit_of_triangles());
  const auto compared = [&](const Integer& sum, const Number& area) {
    return compare(sum * sum, unit, across * area.n * area.n, 2 * area.e);
  };
  require(compared(low, area_from) >= 0 && compared(high, area_to) <= 0, "area", "the area is not between these");
}

}  // namespace

const ClaimRows claims_of_sections{
    {"beyond", "", rule<check_beyond>},
    {"touches", "", rule<check_touches>},
    {"outlined", "along: face for each of corners", rule<check_outlined>},
    {"area", "", rule<check_area>},
};

}  // namespace sunder_verifier
