#include <sunder/base/contract.h>
#include <sunder/polytope/hull/hull_claims.h>
#include <sunder/predicate/point/simplex_plane.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace sunder::polytope {

namespace {

// Behind which simplex of the boundary is a point, seen from the mean of the vertices?
class Homes {
 public:
  Homes(const Polytope& points, const ConvexHull& hull)
      : k_(hull.dimension), points_(k_, numbers_of(points, hull)), center_(k_ + 1), across_(hull.simplex_count()) {
    for (std::size_t s = 0; s < hull.simplex_count(); ++s) {
      SimplexCorners corners{};
      std::copy_n(hull.simplex_corners.begin() + static_cast<std::ptrdiff_t>(s * k_), k_, corners.begin());
      corners_.push_back(corners);
      planes_.push_back(points_.rounded_plane(corners));
    }
    const auto count = static_cast<double>(hull.vertices.size());
    center_[k_] = count;
    for (const std::uint32_t v : hull.vertices) {
      for (std::size_t c = 0; c < k_; ++c) {
        center_[c] = center_[c] + Dyadic(points.row(v)[hull.columns[c]]);
        rounded_center_[c] += points_.rounded(v)[c] / count;
      }
    }
    for (const RoundedPlane& plane : planes_) heights_.push_back(plane.offset - along(plane, rounded_center_.data()));
    find_neighbours();
    seen_.resize(corners_.size());
  }

  // Cost: from the simplex of the last point uphill, by floating point, to where the way to this one leaves the hull;
  // there, and then around it, exact signs decide.
  std::uint32_t of(std::uint32_t q) {
    double here = share(last_, q);
    for (bool goes_on = true; goes_on;) {
      goes_on = false;
      for (std::size_t i = 0; i < k_; ++i) {
        const std::uint32_t other = across_[last_][i];
        const double there = share(other, q);
        if (!(there > here)) continue;
        here = there;
        last_ = other;
        goes_on = true;
        break;
      }
    }
    ++turn_;
    std::vector<std::uint32_t> around{last_};
    seen_[last_] = turn_;
    for (std::size_t at = 0; at < around.size(); ++at) {
      if (points_.in_cone(center_, corners_[around[at]], q)) return around[at];
      for (std::size_t i = 0; i < k_; ++i) {
        const std::uint32_t other = across_[around[at]][i];
        if (std::exchange(seen_[other], turn_) != turn_) around.push_back(other);
      }
    }
    return last_;  // not reached: some cone holds each point
  }

 private:
  static std::vector<double> numbers_of(const Polytope& points, const ConvexHull& hull) {
    std::vector<double> numbers;
    for (std::uint32_t k = 0; k < points.size(); ++k) {
      for (const std::size_t c : hull.columns) numbers.push_back(points.row(k)[c]);
    }
    return numbers;
  }

  double along(const RoundedPlane& plane, const double* p) const {
    double sum = 0;
    for (std::size_t c = 0; c < k_; ++c) sum += plane.normal[c] * p[c];
    return sum;
  }

  // How far the point is from the mean to the plane of the simplex, of the whole; negative on the other side.
  double share(std::uint32_t s, std::uint32_t q) const {
    return (along(planes_[s], points_.rounded(q)) - along(planes_[s], rounded_center_.data())) / heights_[s];
  }

  // The first k.
  void sort(SimplexCorners& corners) const {
    for (std::size_t j = 1; j < k_; ++j) {
      for (std::size_t i = j; i > 0 && corners[i] < corners[i - 1]; --i) std::swap(corners[i], corners[i - 1]);
    }
  }

  void find_neighbours() {
    struct Ridge {
      SimplexCorners corners;
      std::uint32_t simplex;
      std::size_t without;
    };
    std::vector<Ridge> ridges;
    for (std::uint32_t s = 0; s < corners_.size(); ++s) {
      for (std::size_t i = 0; i < k_; ++i) {
        Ridge ridge{corners_[s], s, i};
        ridge.corners[i] = 0xffffffffu;
        sort(ridge.corners);
        ridges.push_back(ridge);
      }
    }
    std::sort(ridges.begin(), ridges.end(), [](const Ridge& a, const Ridge& b) { return a.corners < b.corners; });
    for (std::size_t r = 0; r + 1 < ridges.size(); r += 2) {
      SUNDER_REQUIRE(ridges[r].corners == ridges[r + 1].corners);
      across_[ridges[r].simplex][ridges[r].without] = ridges[r + 1].simplex;
      across_[ridges[r + 1].simplex][ridges[r + 1].without] = ridges[r].simplex;
    }
  }

  std::size_t k_;
  PlanePoints points_;
  std::vector<Dyadic> center_;  // the sum, and the number of vertices
  std::array<double, most_dimension> rounded_center_{};
  std::vector<SimplexCorners> corners_, across_;
  std::vector<RoundedPlane> planes_;
  std::vector<double> heights_;
  std::vector<std::uint32_t> seen_;
  std::uint32_t last_ = 0, turn_ = 0;
};

void write_boundary(ClaimsWriter& file, const Polytope& points, const ConvexHull& hull) {
  file.begin_list("facets");
  for (std::size_t f = 0; f < hull.facet_count(); ++f) {
    file.begin_list();
    const auto simplices = hull.simplices(f);
    for (std::size_t at = 0; at < simplices.size(); at += hull.dimension) {
      file.add_list(simplices.subspan(at, hull.dimension));
    }
    file.end_list();
  }
  file.end_list();
  file.begin_claims();
  file.begin_claim("boundary");
  file.begin_list("simplices");
  Homes homes(points, hull);
  for (std::uint32_t k = 0; k < points.size(); ++k) {
    const bool is_vertex = std::binary_search(hull.vertices.begin(), hull.vertices.end(), k);
    is_vertex ? file.add_null() : file.add_index(homes.of(k));
  }
  file.end_list();
  file.end_claim();
}

}  // namespace

void write_hull(ClaimsWriter& file, const std::string& name, const Polytope& points, const ConvexHull& hull) {
  file.begin_table("bodies");
  file.begin_entry();
  file.text("name", name.empty() ? "unnamed" : cut_text(name));
  file.begin_list("points");
  for (std::uint32_t k = 0; k < points.size(); ++k) file.add_row(points.row(k));
  file.end_list();
  file.end_entry();
  file.end_table();
  file.begin_statement("polytope_hull");
  file.index("body", 0);
  file.text("verdict", hull.dimension == 0 ? "point" : hull.dimension == 1 ? "segment" : "facets");
  if (hull.dimension >= 2) {
    write_boundary(file, points, hull);
  } else {
    if (hull.dimension == 1) {
      file.index("i", hull.vertices[0]);
      file.index("j", hull.vertices[1]);
    }
    file.begin_claims();
    file.claim(hull.dimension == 1 ? "between" : "one_point");
  }
  file.end_statement();
}

}  // namespace sunder::polytope
