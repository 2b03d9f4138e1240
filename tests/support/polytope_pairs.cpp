#include <tests/support/polytope_pairs.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sunder::tests {

using polytope::Polytope;

std::string_view name_of(PolytopeFamily family) {
  switch (family) {
    case PolytopeFamily::random: return "random";
    case PolytopeFamily::cross: return "cross-polytopes";
    case PolytopeFamily::cube: return "cubes";
    case PolytopeFamily::simplex: return "simplices";
    case PolytopeFamily::cyclic: return "cyclic";
    case PolytopeFamily::flat: return "lower-dimensional";
    case PolytopeFamily::touching: return "touching";
    case PolytopeFamily::last_bit: return "last bit";
    case PolytopeFamily::scales: return "scales";
  }
  return "";
}

Polytope PolytopePairs::body(PolytopeFamily family, std::size_t d, std::size_t count) {
  Numbers rows;
  const auto add = [&](const std::vector<double>& row) { rows.insert(rows.end(), row.begin(), row.end()); };
  switch (family) {
    case PolytopeFamily::cross:
      for (std::size_t c = 0; c < d; ++c) {
        for (const double side : {1.0, -1.0}) {
          std::vector<double> row(d);
          row[c] = side;
          add(row);
        }
      }
      break;
    case PolytopeFamily::cube:
      for (std::size_t k = 0; k < std::size_t{1} << std::min<std::size_t>(d, 4); ++k) {
        std::vector<double> row(d, 0.5);  // of more than four dimensions a face
        for (std::size_t c = 0; c < std::min<std::size_t>(d, 4); ++c) row[c] = (k >> c) & 1 ? 1.0 : -1.0;
        add(row);
      }
      break;
    case PolytopeFamily::simplex:
      for (std::size_t k = 0; k <= d; ++k) {
        std::vector<double> row(d);
        if (k > 0) row[k - 1] = 1;
        add(row);
      }
      break;
    case PolytopeFamily::cyclic:  // on the moment curve
      for (std::size_t k = 0; k < count; ++k) {
        std::vector<double> row(d, static_cast<double>(random_.between(-8, 8)) / 8);
        for (std::size_t c = 1; c < d; ++c) row[c] = row[c - 1] * row[0];
        add(row);
      }
      break;
    case PolytopeFamily::flat: {  // in the span of few vectors of small integers
      const std::size_t rank = random_.below(d);
      std::vector<std::vector<double>> basis(rank + 1, std::vector<double>(d));
      for (auto& vector : basis) {
        for (double& x : vector) x = static_cast<double>(random_.between(-2, 2));
      }
      for (std::size_t k = 0; k < count; ++k) {
        std::vector<double> row = basis[0];
        for (std::size_t v = 1; v <= rank; ++v) {
          const auto by = static_cast<double>(random_.between(-2, 2));
          for (std::size_t c = 0; c < d; ++c) row[c] += by * basis[v][c];
        }
        add(row);
      }
      break;
    }
    default:
      for (std::size_t k = 0; k < count; ++k) {
        std::vector<double> row(d);
        for (double& x : row) x = random_.uniform(-1, 1);
        add(row);
      }
  }
  return Polytope::from_points(d, std::move(rows));
}

// The identity, a shift by small numbers, or any matrix and shift.
polytope::Pose PolytopePairs::pose(std::size_t d, double reach) {
  const std::uint64_t kind = random_.below(4);
  if (kind == 0) return polytope::Pose(d);
  std::vector<double> linear(d * d), translation(d);
  for (std::size_t c = 0; c < d; ++c) {
    linear[c * d + c] = 1;
    translation[c] = kind == 1 ? static_cast<double>(random_.between(-2, 2)) / 2 : random_.uniform(-reach, reach);
  }
  if (kind == 3) {
    for (double& x : linear) x += random_.uniform(-0.4, 0.4);
  }
  return polytope::Pose::from_matrix(d, linear, translation);
}

// B has a vertex, or a corner of small integers, on the boundary of A, and lies on the other side of a plane through
// it; or a last bit from there.
PolytopePair PolytopePairs::touching(std::size_t d, PolytopeFamily family) {
  std::vector<double> normal(d);
  do {
    for (double& x : normal) x = static_cast<double>(random_.between(-2, 2));
  } while (std::all_of(normal.begin(), normal.end(), [](double x) { return x == 0; }));
  const auto level = [&](const std::vector<double>& p) {
    double sum = 0;
    for (std::size_t c = 0; c < d; ++c) sum += normal[c] * p[c];
    return sum;
  };
  // Small integers below the plane and above it; on it are points of both, few or many.
  Numbers below, above;
  const std::size_t on_plane = 1 + random_.below(d + 1), count = on_plane + 1 + random_.below(8);
  const bool share = random_.below(4) > 0;  // the first point
  for (Numbers* const rows : {&below, &above}) {
    const double side = rows == &below ? 1 : -1;
    for (std::size_t k = 0; k < count; ++k) {
      std::vector<double> p(d);
      do {
        for (double& x : p) x = static_cast<double>(random_.between(-4, 4));
      } while (level(p) * side > 0);
      if (k < on_plane) {  // moved by a multiple of a coordinate onto the plane, if that is an integer; else the origin
        const std::size_t c = static_cast<std::size_t>(
            std::find_if(normal.begin(), normal.end(), [](double x) { return x != 0; }) - normal.begin());
        const double by = level(p) / normal[c];
        p[c] -= by;
        if (level(p) != 0) std::fill(p.begin(), p.end(), 0.0);
      }
      if (k == 0 && share && rows == &above) std::copy_n(below.begin(), d, p.begin());
      rows->insert(rows->end(), p.begin(), p.end());
    }
  }
  std::vector<double> linear(d * d), translation(d);
  for (std::size_t c = 0; c < d; ++c) linear[c * d + c] = 1;
  if (family == PolytopeFamily::last_bit) {
    const std::size_t c = random_.below(d);
    const double bit = std::ldexp(random_.below(2) == 0 ? 1.0 : -1.0, -static_cast<int>(random_.below(200)) - 20);
    translation[c] = bit;
  }
  return {family, Polytope::from_points(d, std::move(below)), Polytope::from_points(d, std::move(above)),
          polytope::Pose(d), polytope::Pose::from_matrix(d, linear, translation)};
}

polytope::HierarchicalTree small_tree(const Polytope& body) {
  const auto rows = static_cast<std::uint32_t>(body.columns().dimension);
  return polytope::HierarchicalTree(
      body, {.net = rows + 2, .leaf = 3, .share = 0.99, .levels = rows < 5 ? 2u : 1u, .samples = 4});
}

PolytopePair PolytopePairs::next() { return next(polytope::least_dimension + random_.below(5)); }

PolytopePair PolytopePairs::next(std::size_t d) {
  const PolytopeFamily family = all_polytope_families[turn_++ % all_polytope_families.size()];
  if (family == PolytopeFamily::touching || family == PolytopeFamily::last_bit) return touching(d, family);
  const std::size_t count_a = 1 + random_.below(20), count_b = 1 + random_.below(20);
  if (family == PolytopeFamily::scales) {
    const double scale_a = std::ldexp(1.0, static_cast<int>(random_.between(-1000, 1000)));
    const double scale_b =
        random_.below(2) == 0 ? scale_a : std::ldexp(1.0, static_cast<int>(random_.between(-1000, 1000)));
    const auto scaled = [&](const Polytope& body, double by, double shift) {
      Numbers rows;
      for (std::uint32_t k = 0; k < body.size(); ++k) {
        for (const double x : body.row(k)) rows.push_back((x + shift) * by);
      }
      return Polytope::from_points(d, std::move(rows));
    };
    const PolytopeFamily kind = random_.below(2) == 0 ? PolytopeFamily::cyclic : PolytopeFamily::random;
    const double shift = random_.below(2) == 0 ? 0.0 : 1.0;
    return {family, scaled(body(kind, d, count_a), scale_a, -shift), scaled(body(kind, d, count_b), scale_b, shift),
            polytope::Pose(d), polytope::Pose(d)};
  }
  // B of the same family, or of another.
  const PolytopeFamily other = random_.below(2) == 0 ? family : all_polytope_families[random_.below(6)];
  Polytope a = body(family, d, count_a), b = body(other, d, count_b);
  const bool in_place = family == PolytopeFamily::flat && random_.below(3) > 0;  // small integers meet at times
  const polytope::Pose pose_a = in_place ? polytope::Pose(d) : pose(d, 1),
                       pose_b = in_place ? polytope::Pose(d) : pose(d, 1.5);
  return {family, std::move(a), std::move(b), pose_a, pose_b};
}

// Small integers: parallel, opposite, repeated; without a normal now and then.
Polytope PolytopePairs::half_spaces(std::size_t d) {
  Numbers rows;
  const std::size_t count = random_.below(2 * d + 3);
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t c = 0; c < d; ++c) {
      rows.push_back(random_.below(3) == 0 ? random_.uniform(-1, 1) : static_cast<double>(random_.between(-1, 1)));
    }
    rows.push_back(random_.below(3) == 0 ? random_.uniform(-1, 2) : static_cast<double>(random_.between(-1, 4)) / 2);
  }
  if (random_.below(3) == 0) {  // a box
    for (std::size_t c = 0; c < d; ++c) {
      for (const double side : {1.0, -1.0}) {
        std::vector<double> row(d + 1);
        row[c] = side;
        row[d] = 1;
        rows.insert(rows.end(), row.begin(), row.end());
      }
    }
  }
  return Polytope::from_half_spaces(d, std::move(rows));
}

PolytopePair PolytopePairs::next_of_half_spaces() {
  const std::size_t d = polytope::least_dimension + random_.below(5);
  const std::uint64_t kind = random_.below(3);
  const PolytopeFamily family = all_polytope_families[random_.below(6)];
  Polytope a = kind == 0 ? body(family, d, 1 + random_.below(12)) : half_spaces(d);
  Polytope b = kind == 1 ? body(family, d, 1 + random_.below(12)) : half_spaces(d);
  const polytope::Pose pose_a = pose(d, 1), pose_b = pose(d, 1.5);
  return {family, std::move(a), std::move(b), pose_a, pose_b};
}

}  // namespace sunder::tests
