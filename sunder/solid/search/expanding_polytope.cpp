#include <sunder/base/contract.h>
#include <sunder/number/root.h>
#include <sunder/predicate/point/plane_side.h>
#include <sunder/solid/search/expanding_polytope.h>

#include <algorithm>
#include <cmath>

namespace sunder::solid {

namespace {

// What the estimate is of lies in it.
Interval enclosure(const Estimate& x) {
  const double error = x.error * (1 + 0x1p-50) + std::fabs(x.value.low) * (1 + 0x1p-50);
  return interval_detail::widened(x.value.high - error, x.value.high + error);
}

}  // namespace

std::uint32_t ExpandingPolytope::add_corner(const Vector3<Estimate>& at) {
  at_.push_back(at);
  exact_.emplace_back();
  facet_from_.push_back(0);
  return corner_count() - 1;
}

void ExpandingPolytope::remove_last_corner() {
  at_.pop_back();
  exact_.pop_back();
  facet_from_.pop_back();
}

const Vector3<Dyadic>& ExpandingPolytope::exact(std::uint32_t corner) {
  if (!exact_[corner]) exact_[corner] = exact_of_(corner);
  return *exact_[corner];
}

Vector3<Dyadic> ExpandingPolytope::exact_normal_of(const std::array<std::uint32_t, 3>& corner) {
  const Vector3<Dyadic>& first = exact(corner[0]);
  return cross(exact(corner[1]) - first, exact(corner[2]) - first);
}

Vector3<Dyadic> ExpandingPolytope::exact_normal(std::uint32_t facet) { return exact_normal_of(facets_[facet].corner); }

Interval ExpandingPolytope::exact_height(const Facet& facet) {
  ++tally_.exact;
  const Vector3<Dyadic> normal = exact_normal_of(facet.corner);
  const Dyadic along = dot(normal, exact(facet.corner[0]));
  const Interval height = root({along * along, dot(normal, normal)});
  return along.sign() == Sign::negative ? -height : height;
}

std::uint32_t ExpandingPolytope::add_facet(const std::array<std::uint32_t, 3>& corner) {
  Facet facet;
  facet.corner = corner;
  const Vector3<Estimate>& first = at_[corner[0]];
  facet.normal = cross(at_[corner[1]] - first, at_[corner[2]] - first);
  const Interval square = enclosure(dot(facet.normal, facet.normal)), along = enclosure(dot(facet.normal, first));
  facet.height = along / square_root(square);
  // Where the square is near the ends of the range, or the height is not known well.
  const double size = std::max(std::fabs(facet.height.low), std::fabs(facet.height.high));
  if (!(square.low > 0x1p-900 && square.high < 0x1p900) || !(facet.height.high - facet.height.low <= 0x1p-48 * size)) {
    facet.height = exact_height(facet);
  }
  facets_.push_back(facet);
  ++alive_;
  const auto index = static_cast<std::uint32_t>(facets_.size() - 1);
  put_back(index);
  return index;
}

void ExpandingPolytope::put_back(std::uint32_t facet) {
  heap_.push_back(facet);
  std::push_heap(heap_.begin(), heap_.end(),
                 [this](std::uint32_t x, std::uint32_t y) { return facets_[x].height.low > facets_[y].height.low; });
}

std::optional<std::uint32_t> ExpandingPolytope::nearest() {
  while (!heap_.empty()) {
    std::pop_heap(heap_.begin(), heap_.end(),
                  [this](std::uint32_t x, std::uint32_t y) { return facets_[x].height.low > facets_[y].height.low; });
    const std::uint32_t facet = heap_.back();
    heap_.pop_back();
    if (facets_[facet].is_alive && !facets_[facet].is_closed) return facet;
  }
  return std::nullopt;
}

Sign ExpandingPolytope::side(std::uint32_t facet, std::uint32_t corner) {
  const Facet& of = facets_[facet];
  return side_of_plane(
      of.normal, at_[of.corner[0]], at_[corner],
      [&] { return dot(exact_normal_of(of.corner), exact(corner) - exact(of.corner[0])); }, &tally_);
}

ExactFraction ExpandingPolytope::square(std::uint32_t facet) {
  ++tally_.exact;
  const Vector3<Dyadic> normal = exact_normal(facet);
  const Dyadic along = dot(normal, exact(facets_[facet].corner[0]));
  return {along * along, dot(normal, normal)};
}

void ExpandingPolytope::begin(const std::array<std::uint32_t, 4>& corners) {
  std::array<std::uint32_t, 4> c = corners;
  const Sign last = dot(exact_normal_of({c[0], c[1], c[2]}), exact(c[3]) - exact(c[0])).sign();
  SUNDER_REQUIRE(last != Sign::zero);
  if (last == Sign::positive) std::swap(c[1], c[2]);  // the last one is below the others
  // Facet k is across from corner 3 - k.
  for (const auto& of : {std::array{c[0], c[1], c[2]}, {c[0], c[3], c[1]}, {c[0], c[2], c[3]}, {c[1], c[3], c[2]}}) {
    add_facet(of);
  }
  for (Facet& facet : facets_) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = facet.corner[k], to = facet.corner[(k + 1) % 3];
      for (std::uint32_t other = 0; other < 4; ++other) {
        for (std::size_t j = 0; j < 3; ++j) {
          if (facets_[other].corner[j] == to && facets_[other].corner[(j + 1) % 3] == from) facet.neighbour[k] = other;
        }
      }
    }
  }
}

// What the corner is beyond is a piece of the surface without holes: the hull is convex. Its outline goes round once; a
// facet from each of its edges to the corner closes the surface again. None is flat: were the corner in line with an
// edge, it would be in the plane of the facet behind it, and not beyond.
void ExpandingPolytope::expand(std::uint32_t facet, std::uint32_t corner) {
  constexpr std::uint8_t unseen = 0, visible = 1, hidden = 2;
  mark_.resize(facets_.size(), unseen);
  visible_.assign(1, facet);
  seen_.assign(1, facet);
  horizon_.clear();
  mark_[facet] = visible;
  for (std::size_t next = 0; next < visible_.size(); ++next) {
    const Facet& of = facets_[visible_[next]];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t other = of.neighbour[k];
      if (mark_[other] == unseen) {
        mark_[other] = side(other, corner) == Sign::positive ? visible : hidden;
        seen_.push_back(other);
        if (mark_[other] == visible) visible_.push_back(other);
      }
      if (mark_[other] == hidden) horizon_.push_back({of.corner[k], of.corner[(k + 1) % 3], other});
    }
  }
  for (const std::uint32_t seen : seen_) mark_[seen] = unseen;
  for (const std::uint32_t gone : visible_) facets_[gone].is_alive = false;
  alive_ -= static_cast<std::uint32_t>(visible_.size());
  for (const Edge& edge : horizon_) {
    const std::uint32_t made = add_facet({edge.from, edge.to, corner});
    facet_from_[edge.from] = made;
    facets_[made].neighbour[0] = edge.beyond;
    Facet& beyond = facets_[edge.beyond];
    for (std::size_t k = 0; k < 3; ++k) {
      if (beyond.corner[k] == edge.to && beyond.corner[(k + 1) % 3] == edge.from) beyond.neighbour[k] = made;
    }
  }
  for (const Edge& edge : horizon_) {
    const std::uint32_t made = facet_from_[edge.from], after = facet_from_[edge.to];
    facets_[made].neighbour[1] = after;
    facets_[after].neighbour[2] = made;
  }
}

}  // namespace sunder::solid
