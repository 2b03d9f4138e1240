// The rule about convex hulls of points of R^d, as facets: docs/claims.md, "Boundaries".
#include <verifier/cpp/linear.h>
#include <verifier/cpp/rules.h>
#include <verifier/cpp/sets.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace sunder_verifier {
namespace {

using Rows = std::vector<Integers>;

// Nothing of rows that are not independent, as the first columns tell.
std::optional<Elimination> eliminated(const Rows& rows, std::size_t columns) {
  Elimination result(columns);
  for (const Integers& row : rows) {
    if (!result.take(row)) return std::nullopt;
  }
  return result;
}

// Seen from the mean of all corners, with as many coordinates as a simplex has corners.
struct Simplex {
  Indices corners;
  std::size_t facet;
  // Its plane: normal p = height, which is positive; and on which side of it the mean is, by the order of the corners.
  Integers normal;
  Integer height;
  bool is_even = false;
};

Rows corners_of(const Simplex& simplex, const Rows& points) {
  Rows result;
  for (const std::size_t v : simplex.corners) result.push_back(points[v]);
  return result;
}

// All points are in the flat of the first simplex and the mean; then those columns are left that tell the others.
void leave_flat(const Simplex& first, Rows& points) {
  const auto found = eliminated(corners_of(first, points), points[0].size());
  require(found.has_value(), "boundary", "the corners of the first simplex and the mean of all are in a flat");
  const Set columns = as_set(found->columns());
  for (std::size_t q = 0; q < points.size(); ++q) {
    require(all_zero(found->rest(points[q])), "boundary",
            "point " + std::to_string(q) + " is not in the flat of the first simplex");
  }
  for (Integers& point : points) {
    Integers left;
    for (const std::size_t c : columns) left.push_back(point[c]);
    point = std::move(left);
  }
}

// False: the corners are not independent.
bool find_plane(Simplex& simplex, const Rows& points) {
  Rows rows = corners_of(simplex, points);
  for (Integers& row : rows) row.emplace_back(1);
  const std::size_t k = rows.size();
  const auto found = eliminated(rows, k);
  if (!found) return false;
  const int sign = found->unit().sign();
  simplex.height = abs(found->unit());
  simplex.is_even = found->sign_of_determinant() < 0;
  simplex.normal.resize(k);
  for (std::size_t r = 0; r < k; ++r) simplex.normal[found->columns()[r]] = sign * found->row(r)[k];
  return true;
}

// Is the point a combination of the corners, with no number less than zero?
bool is_in_cone(const Simplex& simplex, const Rows& points, const Integers& point) {
  Rows rows(point.size());
  for (std::size_t c = 0; c < rows.size(); ++c) {
    for (const std::size_t v : simplex.corners) rows[c].push_back(points[v][c]);
    rows[c].push_back(point[c]);
  }
  const auto found = eliminated(rows, rows.size());
  for (std::size_t r = 0; found && r < rows.size(); ++r) {
    if (found->row(r).back() * found->unit() < 0) return false;
  }
  return found.has_value();
}

// Each ridge has one simplex on either side, and facets bend there.
void look_at_ridges(const std::vector<Simplex>& simplices, const Rows& points) {
  Ridges<IndexPair> ridges;  // their owners: a simplex, and its corner that is not of the ridge
  for (std::size_t s = 0; s < simplices.size(); ++s) {
    for (std::size_t i = 0; i < simplices[s].corners.size(); ++i) {
      const bool is_new = ridges.take(ridge_of(simplices[s].corners, i), {s, simplices[s].corners[i]});
      require(is_new, "boundary", "two simplices are on one side of a ridge of simplex " + std::to_string(s));
    }
  }
  for (std::size_t s = 0; s < simplices.size(); ++s) {
    const Simplex& simplex = simplices[s];
    for (std::size_t i = 0; i < simplex.corners.size(); ++i) {
      const IndexPair* const twin = ridges.beyond(ridge_of(simplex.corners, i));
      require(twin != nullptr, "boundary", "only one simplex contains a ridge of simplex " + std::to_string(s));
      const std::size_t facet = simplices[twin->first].facet;
      require(
          simplex.facet == facet || dot(simplex.normal, points[twin->second]) < simplex.height, "boundary",
          "facets " + std::to_string(simplex.facet) + " and " + std::to_string(facet) + " are not convex at a ridge");
    }
  }
}

// No other simplex is met on the way through the middle of the first.
void look_through_first(const std::vector<Simplex>& simplices, const Rows& points) {
  const Integers middle = sum_of(points, simplices[0].corners);
  std::size_t axis = 0;
  for (std::size_t c = 1; c < middle.size(); ++c) {
    if (abs(middle[c]) > abs(middle[axis])) axis = c;
  }
  // Are all corners on one side of a plane through the mean and the middle?
  const auto is_beside = [&](const Indices& corners, std::size_t c) {
    const auto side = [&](std::size_t v) {
      return Integer(points[v][c] * middle[axis] - points[v][axis] * middle[c]).sign();
    };
    const int first = side(corners[0]);
    return first != 0 && std::all_of(corners.begin(), corners.end(), [&](std::size_t v) { return side(v) == first; });
  };
  for (std::size_t s = 1; s < simplices.size(); ++s) {
    bool is_apart = false;
    for (std::size_t c = 0; c < middle.size() && !is_apart; ++c) is_apart = is_beside(simplices[s].corners, c);
    require(is_apart || !is_in_cone(simplices[s], points, middle), "boundary",
            "simplex " + std::to_string(s) + " is in the way of the first");
  }
}

// The facets at a corner have no other one in common.
void look_at_corners(const std::vector<Set>& facets) {
  std::map<std::size_t, Indices> facets_at;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    for (const std::size_t v : facets[f]) facets_at[v].push_back(f);
  }
  for (const auto& [v, those] : facets_at) {
    const std::size_t least = *std::min_element(
        those.begin(), those.end(), [&](std::size_t f, std::size_t g) { return facets[f].size() < facets[g].size(); });
    take_steps(those.size() * facets[least].size(), 0, 0);
    Set shared = facets[least];
    for (const std::size_t f : those) shared = only(shared, [&](std::size_t w) { return has(facets[f], w); });
    require(shared.size() == 1, "boundary", "point " + std::to_string(v) + " is between others");
  }
}

void check_boundary(const Indices& homes, const HullBody& body, const std::vector<IndexLists>& given) {
  std::vector<Simplex> simplices;
  std::vector<Set> facets;  // the corners of each
  for (const IndexLists& facet : given) {
    for (const Indices& simplex : facet) simplices.push_back({simplex, facets.size(), {}, {}});
    facets.push_back(as_set(joined(facet)));
  }
  const Set corners = as_set(joined(facets));
  const std::size_t k = simplices[0].corners.size();
  const std::size_t size = k * (body.given->bits + bits(Integer(corners.size())) + 1) / 2;
  take_steps((body.rows().size() + simplices.size()) * k * k * k, size, size);
  Rows points = from_mean(body.rows(), corners);
  leave_flat(simplices[0], points);
  for (std::size_t s = 0; s < simplices.size(); ++s) {
    Simplex& simplex = simplices[s];
    require(find_plane(simplex, points) && simplex.is_even == simplices[0].is_even, "boundary",
            "simplex " + std::to_string(s) + " is not seen from the mean as the first one is");
    if (s > 0 && simplices[s - 1].facet == simplex.facet) continue;
    for (const std::size_t v : facets[simplex.facet]) {
      require(dot(simplex.normal, points[v]) == simplex.height, "boundary",
              "facet " + std::to_string(simplex.facet) + " is not in one plane");
    }
  }
  look_at_ridges(simplices, points);
  look_through_first(simplices, points);
  look_at_corners(facets);
  for (std::size_t q = 0; q < homes.size(); ++q) {
    const std::string point = "point " + std::to_string(q);
    if (homes[q] == no_index) {
      require(has(corners, q), "boundary", point + " has no home");
      continue;
    }
    const Simplex& home = simplices[homes[q]];
    require(dot(home.normal, points[q]) <= home.height && is_in_cone(home, points, points[q]), "boundary",
            point + " is not in its home");
  }
}

}  // namespace

const ClaimRows claims_of_boundaries{
    {"boundary", "simplices: simplices of subject", rule<check_boundary>},
};

}  // namespace sunder_verifier
