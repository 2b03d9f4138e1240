#include <sunder/predicate/point/along.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/represent/drums.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace sunder::solid {

namespace {

// Times a power of two, so that its greatest component is about 1.
Point3 to_one(const Point3& v) {
  const double size = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  if (!(size > 0)) return v;
  const int by = -std::ilogb(size);
  return {std::ldexp(v.x, by), std::ldexp(v.y, by), std::ldexp(v.z, by)};
}

// What brings the sides of the box near 1, or nothing where a side is zero.
Point3 shrink_of(std::span<const Point3> vertices) {
  Point3 shrink{1, 1, 1};
  for (const std::size_t k : {0u, 1u, 2u}) {
    const auto [low, high] = std::minmax_element(vertices.begin(), vertices.end(),
                                                 [k](const Point3& p, const Point3& q) { return p[k] < q[k]; });
    const double half = (*high)[k] / 2 - (*low)[k] / 2;  // halves: no overflow
    if (half > 0) shrink[k] = std::ldexp(1.0, std::clamp(-std::ilogb(half), -1000, 1000));
  }
  return shrink;
}

// A direction of measuring, in the frame of points times `by`, its greatest component of size 1.
Point3 divided(const Point3& d, const Point3& by) {
  const auto exponent = [&](std::size_t k) { return std::ilogb(d[k]) - std::ilogb(by[k]); };
  int greatest = std::numeric_limits<int>::min();
  for (const std::size_t k : {0u, 1u, 2u}) {
    if (d[k] != 0) greatest = std::max(greatest, exponent(k));
  }
  Point3 result;
  for (const std::size_t k : {0u, 1u, 2u}) result[k] = std::ldexp(d[k], -std::ilogb(by[k]) - greatest);
  return result;
}

// Of three vertices of the facet, a third of the way round apart.
Point3 rounded_normal(std::span<const Point3> vertices, std::span<const std::uint32_t> facet, const Point3& shrink) {
  const std::size_t n = facet.size();
  const auto to = [&](std::size_t k) {
    const Point3 &a = vertices[facet[0]], &b = vertices[facet[k]];
    const Point3 v = to_one({shrink.x * (b.x / 2 - a.x / 2), shrink.y * (b.y / 2 - a.y / 2),  //
                             shrink.z * (b.z / 2 - a.z / 2)});
    return Vector3<double>{v.x, v.y, v.z};
  };
  const auto normal = cross(to(std::max<std::size_t>(1, n / 3)), to(std::max<std::size_t>(2, 2 * n / 3)));
  return to_one({normal.x, normal.y, normal.z});
}

// A path of edges from the lowest slice to the highest, by number.
std::vector<std::uint32_t> path_upwards(const std::vector<LateralEdge>& edges, std::uint32_t from) {
  std::vector<std::uint32_t> path;
  // Edges are sorted by their lower vertex.
  const auto edge_up = [&](std::uint32_t v) {
    return std::lower_bound(edges.begin(), edges.end(), v,
                            [](const LateralEdge& e, std::uint32_t vertex) { return e.low < vertex; });
  };
  for (auto e = edge_up(from); e != edges.end() && e->low == from; e = edge_up(from)) {
    path.push_back(static_cast<std::uint32_t>(e - edges.begin()));
    from = e->high;
  }
  return path;
}

// The surface between the lowest slice and the highest, cut open along a path upwards: edges from left to right, as
// they are seen from outside. An edge is after all edges on the left side of the facet on its own left; so in every
// drum they stand in the order in which the drum has them, beginning with the path's. left[e]: the facet before edge e.
std::vector<std::uint32_t> order_sideways(const std::vector<LateralEdge>& edges, const std::vector<std::uint32_t>& left,
                                          const std::vector<std::uint32_t>& path, std::uint32_t facet_count) {
  const auto count = static_cast<std::uint32_t>(edges.size());
  std::vector<std::uint32_t> begin(facet_count + 1), right_of(count), pending(facet_count);
  for (std::uint32_t e = 0; e < count; ++e) ++begin[left[e] + 1], ++pending[edges[e].side];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<std::uint32_t> at(begin.begin(), begin.end() - 1);
  for (std::uint32_t e = 0; e < count; ++e) right_of[at[left[e]]++] = e;

  std::vector<std::uint32_t> order(path);
  order.reserve(count);
  std::vector<bool> is_in(count);
  for (const std::uint32_t e : path) is_in[e] = true;
  for (std::size_t done = 0; done < order.size(); ++done) {
    const std::uint32_t facet = edges[order[done]].side;
    if (--pending[facet] > 0) continue;
    for (std::uint32_t i = begin[facet]; i < begin[facet + 1]; ++i) {
      if (!is_in[right_of[i]]) order.push_back(right_of[i]);
    }
  }
  SUNDER_REQUIRE(order.size() == count);
  return order;
}

}  // namespace

Drums Drums::make(const ConvexPolyhedron& body) {
  const auto [low, high] = body.box();
  const Point3 direction = low.z < high.z ? Point3{0, 0, 1} : low.x < high.x ? Point3{1, 0, 0} : Point3{0, 1, 0};
  return {body, direction, std::nullopt};
}

Drums::Drums(const ConvexPolyhedron& body, const Point3& direction, std::optional<DrumsForm> form)
    : direction_(direction) {
  for (const double x : {direction.x, direction.y, direction.z}) {
    if (!std::isfinite(x))
      throw Error(ErrorCode::bad_value, "a number is not finite; give finite numbers", "direction");
  }
  if (direction == Point3{}) {
    throw Error(ErrorCode::bad_shape, "it is zero; give the direction in which drums are stacked", "direction");
  }
  find_slices(body.vertices());
  find_edges(body);
  begun_.assign(drum_count(), 0);
  ended_.assign(drum_count(), 0);
  for (const LateralEdge& e : edges_) {
    ++begun_[e.begin];
    if (e.end < drum_count()) ++ended_[e.end];
  }
  std::partial_sum(begun_.begin(), begun_.end(), begun_.begin());
  std::partial_sum(ended_.begin(), ended_.end(), ended_.begin());
  form_ = form ? *form : listed_size() <= most_listed_unasked ? DrumsForm::listed : DrumsForm::persistent;
  if (form_ == DrumsForm::listed) {
    make_lists();
  } else {
    make_trees();
  }
  shrink_ = shrink_of(body.vertices());
  up_ = divided(direction, shrink_);
  for (std::uint32_t f = 0; f < body.facet_count(); ++f) {
    normals_.push_back(rounded_normal(body.vertices(), body.facet(f), shrink_));
  }
}

void Drums::find_slices(std::span<const Point3> vertices) {
  const WorldDirection direction(direction_);
  const Affine3 identity;
  const SizeRange sizes = size_range(vertices);
  const bool tame = images_are_tame(size_range(std::span<const double>(identity.linear)), {}, sizes);
  const auto rise = [&](std::uint32_t v, std::uint32_t w) {
    return compare_along(direction, Posed3{vertices[v], &identity, tame, sizes.greatest},
                         Posed3{vertices[w], &identity, tame, sizes.greatest});
  };
  std::vector<std::uint32_t> order(vertices.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t v, std::uint32_t w) {
    const Sign sign = rise(v, w);
    return sign == Sign::positive || (sign == Sign::zero && v < w);
  });
  slice_of_.resize(vertices.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i == 0 || rise(order[i - 1], order[i]) != Sign::zero) slices_.push_back(order[i]);
    slice_of_[order[i]] = slice_count() - 1;
  }
}

void Drums::find_edges(const ConvexPolyhedron& body) {
  if (slice_of_.size() == 2 && drum_count() == 1) edges_ = {{vertex_of(0), vertex_of(1), 0, 1, 0}};  // a segment
  // Each edge that is not level goes up on one facet's border, and down on another's.
  std::vector<LateralEdge> left_of, right_of;
  for (std::uint32_t f = 0; f < body.facet_count(); ++f) {
    const std::span<const std::uint32_t> facet = body.facet(f);
    const auto slice = [&](std::size_t k) { return slice_of_[facet[k]]; };
    if (slice(0) == slice(1) && slice(0) == slice(2)) level_facets_[slice(0) == 0 ? 0 : 1] = f;
    for (std::size_t k = 0; k < facet.size(); ++k) {
      const std::uint32_t v = facet[k], w = facet[k + 1 < facet.size() ? k + 1 : 0];
      const std::uint32_t from = slice_of_[v], to = slice_of_[w];
      if (from < to) left_of.push_back({v, w, from, to, f});
      if (from > to) right_of.push_back({w, v, to, from, f});
    }
  }
  const auto by_vertices = [](const LateralEdge& d, const LateralEdge& e) {
    return std::tie(d.low, d.high) < std::tie(e.low, e.high);
  };
  std::sort(left_of.begin(), left_of.end(), by_vertices);
  std::sort(right_of.begin(), right_of.end(), by_vertices);
  if (right_of.empty()) return;
  std::vector<std::uint32_t> left;
  for (const LateralEdge& e : left_of) left.push_back(e.side);
  const std::vector<std::uint32_t> path = path_upwards(right_of, vertex_of(0));
  for (const std::uint32_t e : order_sideways(right_of, left, path, body.facet_count())) edges_.push_back(right_of[e]);
}

std::uint64_t Drums::listed_size() const {
  std::uint64_t entries = 0;
  for (std::uint32_t drum = 0; drum < drum_count(); ++drum) entries += size(drum);
  return entries;
}

void Drums::make_lists() {
  list_begin_.assign(std::size_t{drum_count()} + 1, 0);
  for (std::uint32_t drum = 0; drum < drum_count(); ++drum) list_begin_[drum + 1] = list_begin_[drum] + size(drum);
  if (list_begin_.back() > most_listed) {
    throw Error(ErrorCode::bad_shape, "its drums have " + std::to_string(list_begin_.back()) +
                                          " edges in all, too many to list; take the form DrumsForm::persistent");
  }
  lists_.resize(list_begin_.back());
  std::vector<std::uint64_t> at(list_begin_.begin(), list_begin_.end() - 1);
  for (std::uint32_t e = 0; e < edges_.size(); ++e) {
    for (std::uint32_t drum = edges_[e].begin; drum < edges_[e].end; ++drum) lists_[at[drum]++] = e;
  }
}

// Level l of a tree has the edges' positions sorted by their first l bits, and else as they begin (or end); a bit is
// bit l of a position, counted from the highest. As every position stands once, a node's positions begin where its
// least one would stand.
void Drums::make_trees() {
  const auto count = static_cast<std::uint32_t>(edges_.size());
  levels_ = count <= 2 ? 1 : 32 - static_cast<std::uint32_t>(std::countl_zero(count - 1));
  bits_ = RankedBits(2 * levels_, count);
  for (const std::uint32_t tree : {0u, 1u}) {
    const auto time = [&](std::uint32_t e) { return tree == 0 ? edges_[e].begin : edges_[e].end; };
    std::vector<std::uint32_t> sequence(count), next(count), filled;
    std::iota(sequence.begin(), sequence.end(), 0u);
    std::sort(sequence.begin(), sequence.end(),
              [&](std::uint32_t d, std::uint32_t e) { return time(d) != time(e) ? time(d) < time(e) : d < e; });
    for (std::uint32_t level = 0; level < levels_; ++level) {
      const std::uint32_t shift = levels_ - 1 - level;
      filled.assign((std::size_t{count} >> shift) + 1, 0);
      for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t node = sequence[i] >> shift;
        if (node % 2 == 1) bits_.set(2 * level + tree, i);
        next[(node << shift) + filled[node]++] = sequence[i];
      }
      sequence.swap(next);
    }
  }
  bits_.count();
}

std::uint32_t Drums::select(std::uint32_t drum, std::uint32_t k) const {
  std::uint32_t node = 0, begun = begun_[drum], ended = ended_[drum];  // of the node's positions
  for (std::uint32_t level = 0; level < levels_; ++level) {
    // Nodes before this one are full, and half of their positions have bit 1.
    const std::uint32_t begun_1 = bits_.rank(2 * level, node + begun) - node / 2;
    const std::uint32_t ended_1 = bits_.rank(2 * level + 1, node + ended) - node / 2;
    const std::uint32_t begun_0 = begun - begun_1, ended_0 = ended - ended_1;
    if (k < begun_0 - ended_0) {
      begun = begun_0, ended = ended_0;
    } else {
      k -= begun_0 - ended_0;
      begun = begun_1, ended = ended_1;
      node += 1u << (levels_ - 1 - level);
    }
  }
  return node;
}

std::size_t Drums::memory() const {
  const auto bytes = [](const auto& of) { return of.capacity() * sizeof(of[0]); };
  return sizeof(*this) + bytes(slices_) + bytes(slice_of_) + bytes(edges_) + bytes(begun_) + bytes(ended_) +
         bytes(normals_) + bytes(list_begin_) + bytes(lists_) + bits_.memory();
}

}  // namespace sunder::solid
