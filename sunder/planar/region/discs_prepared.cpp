#include <sunder/planar/region/discs_prepared.h>
#include <sunder/predicate/disc/disc_powers.h>

#include <algorithm>
#include <cmath>

namespace sunder::planar {

std::vector<Disc> of_moderate_size(std::span<const Disc> circles) {
  std::vector<Disc> out(circles.begin(), circles.end());
  double most = 0;
  for (const Disc& c : circles) {
    most = std::max(std::max(most, c.radius), std::max(std::fabs(c.center.x), std::fabs(c.center.y)));
  }
  const int exponent = std::ilogb(most);
  if (most == 0 || std::abs(exponent) < 50) return out;
  bool is_exact = true;
  const auto scale = [&](double& x) {
    const double given = x;
    x = std::ldexp(x, -exponent);
    is_exact = is_exact && std::ldexp(x, exponent) == given;
  };
  for (Disc& c : out) {
    scale(c.center.x);
    scale(c.center.y);
    scale(c.radius);
  }
  if (!is_exact) out.assign(circles.begin(), circles.end());
  return out;
}

Viewpoint inside_of_all(std::span<const Disc> circles, const DeepestPoint& deepest, Cost& cost) {
  const DiscBasis basis = discs_of(circles, deepest.basis());
  const Point2 p = nearest(deepest_point(basis));
  const PowerBound bound{{p.x, p.y}, 0};
  StageTally tally;
  const auto holds = [&](const Disc& c) {
    return is_surely_less(c, bound) || power_at(p, c, &tally) == Sign::negative;
  };
  cost.probes += circles.size();
  const bool is_inside = std::all_of(circles.begin(), circles.end(), holds);
  cost.exact += tally.exact;
  if (is_inside) return viewpoint(p);
  for (std::uint32_t bits = 128;; bits *= 2) {  // ends, because the deepest point itself is inside
    cost.probes += circles.size();
    cost.exact += static_cast<std::uint32_t>(circles.size());
    Viewpoint near = deepest_viewpoint(basis, bits);
    if (std::all_of(circles.begin(), circles.end(),
                    [&](const Disc& c) { return power_at(near, c) == Sign::negative; })) {
      return near;
    }
  }
}

namespace {

// Where the lexicographically least rotation begins. Source: Booth 1980, as the usual walk of two candidates.
std::size_t least_rotation(std::span<const std::uint32_t> a) {
  const std::size_t n = a.size();
  std::size_t i = 0, j = 1, k = 0;
  while (i < n && j < n && k < n) {
    const std::uint32_t x = a[(i + k) % n], y = a[(j + k) % n];
    if (x == y) {
      ++k;
      continue;
    }
    (x > y ? i : j) += k + 1;
    if (i == j) ++j;
    k = 0;
  }
  return std::min(i, j);
}

}  // namespace

std::vector<std::uint32_t> arcs_of(std::span<const ArcPiece> chain) {
  std::vector<std::uint32_t> arcs = discs_around(chain);
  std::rotate(arcs.begin(), arcs.begin() + static_cast<std::ptrdiff_t>(least_rotation(arcs)), arcs.end());
  return arcs;
}

}  // namespace sunder::planar
