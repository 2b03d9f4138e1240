#include <sunder/number/rounded_elimination_internal.h>
#include <sunder/polytope/represent/far_apart.h>
#include <sunder/polytope/represent/normal_fan.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace sunder::polytope {

namespace {

using Numbers = NormalFan::Numbers;
using Row = std::array<double, most_columns>;

// The first d.
void sort(Numbers& numbers, std::size_t d) {
  for (std::size_t k = 1; k < d; ++k) {
    for (std::size_t i = k; i > 0 && numbers[i] < numbers[i - 1]; --i) std::swap(numbers[i], numbers[i - 1]);
  }
}

struct Facet {
  Numbers points{};  // ascending; behind the first d `none`
  Row normal{};
  bool has(std::uint32_t k) const { return std::find(points.begin(), points.end(), k) != points.end(); }
};

// The hull of points in general position, one point after the other (beneath and beyond).
class Hull {
 public:
  Hull(std::size_t d, std::span<const double> points) : d_(d), points_(points), count_(points.size() / d) {}

  bool build() {
    if (!begin()) return false;
    for (std::uint32_t k = 0; k < count_; ++k) {
      if (!first_[k] && !add(k)) return false;
    }
    return true;
  }

  std::vector<Facet> facets;
  std::uint64_t looks = 0;  // at facets

 private:
  const double* point(std::uint32_t k) const { return points_.data() + k * d_; }

  // A simplex.
  bool begin() {
    if (count_ < d_ + 1) return false;
    first_.assign(count_, false);
    const std::vector<std::uint32_t> all = far_apart(d_, {points_.begin(), points_.end()}, 0, 0x1p-90);
    if (all.size() != d_ + 1) return false;
    for (const std::uint32_t k : all) {
      first_[k] = true;
      for (std::size_t c = 0; c < d_; ++c) interior_[c] += point(k)[c] / static_cast<double>(d_ + 1);
    }
    for (std::size_t without = 0; without <= d_; ++without) {
      Numbers some;
      some.fill(NormalFan::none);
      for (std::size_t k = 0, i = 0; k <= d_; ++k) {
        if (k != without) some[i++] = all[k];
      }
      if (!add_facet(some)) return false;
    }
    return true;
  }

  bool add_facet(Numbers numbers) {
    sort(numbers, d_);
    Facet facet;
    facet.points = numbers;
    // The normal: what is orthogonal to all edges.
    RoundedElimination edges(d_ - 1, d_);
    for (std::size_t r = 0; r + 1 < d_; ++r) {
      for (std::size_t c = 0; c < d_; ++c) edges[r][c] = point(numbers[r + 1])[c] - point(numbers[0])[c];
    }
    while (edges.rank() + 1 < d_) {
      if (!edges.step(0x1p-60)) return false;
    }
    facet.normal[edges.column(d_ - 1)] = 1;
    double largest = 1;
    for (std::size_t k = d_ - 1; k-- > 0;) {
      double sum = 0;
      for (std::size_t c = k + 1; c < d_; ++c) sum += edges.row(k)[edges.column(c)] * facet.normal[edges.column(c)];
      facet.normal[edges.column(k)] = -sum / edges.pivot(k);
      largest = std::max(largest, std::fabs(facet.normal[edges.column(k)]));
    }
    const double inside = side(facet, interior_.data());
    if (!(std::fabs(inside) > 0x1p-70 * largest) || !std::isfinite(inside)) return false;
    for (std::size_t c = 0; c < d_; ++c) facet.normal[c] /= inside < 0 ? largest : -largest;
    facets.push_back(facet);
    return true;
  }

  double side(const Facet& facet, const double* p) const {
    double sum = 0;
    for (std::size_t c = 0; c < d_; ++c) sum += facet.normal[c] * (p[c] - point(facet.points[0])[c]);
    return sum;
  }

  bool add(std::uint32_t k) {
    std::vector<Numbers> ridges;
    looks += facets.size();
    const auto hidden =
        std::partition(facets.begin(), facets.end(), [&](const Facet& facet) { return !(side(facet, point(k)) > 0); });
    for (auto facet = hidden; facet != facets.end(); ++facet) {
      for (std::size_t without = 0; without < d_; ++without) {
        Numbers ridge = facet->points;
        std::copy(ridge.begin() + static_cast<std::ptrdiff_t>(without) + 1, ridge.end(),
                  ridge.begin() + static_cast<std::ptrdiff_t>(without));
        ridge[d_ - 1] = NormalFan::none;
        ridges.push_back(ridge);
      }
    }
    facets.erase(hidden, facets.end());
    looks += ridges.size();
    std::sort(ridges.begin(), ridges.end());
    for (std::size_t i = 0; i < ridges.size(); ++i) {  // the horizon: those of one facet only
      if (i + 1 < ridges.size() && ridges[i] == ridges[i + 1]) {
        ++i;
        continue;
      }
      ridges[i][d_ - 1] = k;
      if (!add_facet(ridges[i])) return false;
    }
    return true;
  }

  std::size_t d_;
  std::span<const double> points_;
  std::size_t count_;
  std::vector<bool> first_;
  Row interior_{};
};

// Cones of the facets that have a face, each with the rays chosen so far: the ray of the least facet, with the cones of
// the faces that have one point more and are not of that facet.
class Pulling {
 public:
  Pulling(const std::vector<Facet>& facets, NormalFan& fan, std::uint64_t& looks)
      : facets_(facets), fan_(fan), looks_(looks) {}

  void cut(std::uint32_t apex) {
    std::vector<std::uint32_t> all;
    looks_ += facets_.size();
    for (std::uint32_t f = 0; f < facets_.size(); ++f) {
      if (facets_[f].has(apex)) all.push_back(f);
    }
    if (all.empty()) return;
    cone_.apex = apex;
    go_on(all, 0);
  }

 private:
  void go_on(const std::vector<std::uint32_t>& facets, std::size_t depth) {
    cone_.rays[depth] = facets.front();
    if (depth + 1 == fan_.dimension) {
      fan_.cones.push_back(cone_);
      return;
    }
    std::vector<std::uint32_t> more;
    for (const std::uint32_t f : facets) {
      for (std::size_t k = 0; k < fan_.dimension; ++k) {
        const std::uint32_t v = facets_[f].points[k];
        if (!facets_[facets.front()].has(v)) more.push_back(v);
      }
    }
    std::sort(more.begin(), more.end());
    more.erase(std::unique(more.begin(), more.end()), more.end());
    looks_ += facets.size() * (1 + more.size());
    for (const std::uint32_t v : more) {
      std::vector<std::uint32_t> having;
      std::copy_if(facets.begin(), facets.end(), std::back_inserter(having),
                   [&](std::uint32_t f) { return facets_[f].has(v); });
      go_on(having, depth + 1);
    }
  }

  const std::vector<Facet>& facets_;
  NormalFan& fan_;
  std::uint64_t& looks_;
  NormalFan::Cone cone_{};
};

// False where a facet of a cone has not one cone on the other side.
bool join(NormalFan& fan) {
  struct Side {
    Numbers rays;
    std::uint32_t cone, facet;
  };
  const std::size_t d = fan.dimension;
  std::vector<Side> sides;
  for (std::uint32_t k = 0; k < fan.cones.size(); ++k) {
    for (std::uint32_t i = 0; i < d; ++i) {
      Side side{fan.cones[k].rays, k, i};
      side.rays[i] = NormalFan::none;
      sort(side.rays, d);
      sides.push_back(side);
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.rays < b.rays; });
  for (std::size_t i = 0; i < sides.size(); i += 2) {
    if (i + 1 == sides.size() || sides[i].rays != sides[i + 1].rays) return false;
    if (i + 2 < sides.size() && sides[i].rays == sides[i + 2].rays) return false;
    fan.cones[sides[i].cone].across[sides[i].facet] = sides[i + 1].cone;
    fan.cones[sides[i + 1].cone].across[sides[i + 1].facet] = sides[i].cone;
  }
  return true;
}

}  // namespace

std::optional<NormalFan> normal_fan(std::size_t d, std::span<const double> points, std::uint64_t& looks) {
  Hull hull(d, points);
  const bool is_built = hull.build();
  looks += hull.looks;
  if (!is_built) return std::nullopt;
  NormalFan fan;
  fan.dimension = d;
  for (const Facet& facet : hull.facets) {
    fan.rays.insert(fan.rays.end(), facet.normal.begin(), facet.normal.begin() + static_cast<std::ptrdiff_t>(d));
    fan.facets.push_back(facet.points);
  }
  Pulling pulling(hull.facets, fan, looks);
  for (std::uint32_t k = 0; k < points.size() / d; ++k) pulling.cut(k);
  looks += fan.cones.size() * d;
  if (!join(fan)) return std::nullopt;
  return fan;
}

}  // namespace sunder::polytope
