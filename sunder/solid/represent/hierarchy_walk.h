// From the top of a hierarchy to the vertex of the polyhedron that is extreme along a direction, in O(log n) steps on
// every polyhedron, vertices of any degree and ties included.
// Also called: extreme vertex query, support; point location in the normal fan.
//
// The vertex of a level that is extreme is that of the level above, v, or one that comes at this level (BL15
// Lemma 4.2): a neighbour of v, of which v may have very many. So more is kept than v: the directions along which v is
// extreme are a convex cone, with a normal of a triangle at each corner, and a neighbour at each side. From its middle
// (Hierarchy::middle) it is cut into sectors, one for each neighbour u, between the triangles left and right of the
// edge from v to u, and the walk knows the sector with the direction.
//   W1. Only what comes beyond one of these two triangles can cut the sector. Let w be the first of these.
//   W2. Where w is further than v, it is the extreme one; its sector is one of those of its star, at most most_degree.
//   W3. Where it is not, the sector goes on at the new triangles along the edge from v to w: one sign tells on which
//       side of the new corner the direction is, and none is needed where w has both old triangles.
//   W4. Where no vertex comes beyond either triangle, v is extreme: the direction lies in a cone of three along each of
//       which v is.
// Closed sectors that hold the direction are as good as each other, so zero signs may go either way; but at W3 a zero
// keeps u, since where the new corner is the middle itself every sign is zero, and the direction is on u's side of it.
//
// Source: the idea of BL15 section 4 and of Kirkpatrick 1983 (search in planar subdivisions), on the normal fan. This
// cure of the degree problem needs no bounded hierarchy. (Ours.)
#pragma once

#include <sunder/number/sign.h>
#include <sunder/solid/represent/hierarchy.h>

#include <algorithm>
#include <cstdint>

namespace sunder::solid {

// compare(i, j): is rank j further along than rank i? turn(v, i, j): the sign of the determinant of the normals of v's
// middle and of the triangle v, i, j, counter-clockwise from outside, and of the direction. Where both are exact, so is
// the answer; else it is some vertex. Adds the vertices asked about to `probes`.
template <class Compare, class Turn>
class HierarchyWalk {
 public:
  HierarchyWalk(const Hierarchy& hierarchy, const Compare& compare, const Turn& turn, std::uint64_t& probes)
      : hierarchy_(hierarchy), compare_(compare), turn_(turn), probes_(probes) {}

  // The rank of the extreme vertex of the first `end` ranks, which are a level of the hierarchy, or between two; of
  // the polyhedron.
  std::uint32_t run(std::uint32_t end = none) {
    start();
    return go_on(end);
  }

  // In pieces: from the top, along what may be another direction than before, and then on to ever more ranks. All
  // pieces together cost as much as a run.
  void start() {
    at_ = 0;
    const std::uint32_t corners = hierarchy_.level_end.front();
    for (std::uint32_t k = 1; k < corners; ++k) {
      if (is_positive(compare_(at_, k))) at_ = k;
    }
    probes_ += corners;
    if (hierarchy_.is_flat()) {
      enter(star_of(at_)[0], star_of(at_)[1]);
    } else {
      start_sector();
    }
  }
  std::uint32_t go_on(std::uint32_t end) {
    for (std::uint32_t w = next(); w < end; w = next()) {
      if (is_further(w)) {
        go_to(w);
      } else {
        pass(w);
      }
    }
    return at_;
  }

  // A step at a time: the rank that comes next where the walk is, or none; is it further than what it is at? Then
  // go_to it, else pass it.
  std::uint32_t next() const { return std::min(left_, right_); }
  bool is_further(std::uint32_t w) {
    __builtin_prefetch(&hierarchy_.nodes[w].rim);
    ++probes_;
    return is_positive(compare_(at_, w));
  }
  // w may be any rank: the walk goes on from where w comes, along what may be another direction than before, along
  // which w must be extreme there.
  void go_to(std::uint32_t w) {
    at_ = w;
    const Star star = star_of(w);
    if (hierarchy_.is_flat()) {
      enter(star[0], star[1]);
    } else {
      choose_sector(star);
    }
  }
  void pass(std::uint32_t w) {
    if (hierarchy_.is_flat()) {
      pass_edge(w);
    } else {
      pass_triangles(w);
    }
  }

  std::uint32_t at() const { return at_; }         // the rank that is extreme so far
  std::uint32_t neighbour() const { return to_; }  // that of the sector, meaningless in a polygon

 private:
  using Triangle = Hierarchy::Triangle;
  using Star = Hierarchy::Star;
  static constexpr std::uint32_t none = Hierarchy::none;

  Star star_of(std::uint32_t rank) const { return hierarchy_.nodes[rank].star(); }
  static bool is_positive(Sign sign) { return sign == Sign::positive; }
  static bool is_negative(Sign sign) { return sign == Sign::negative; }

  // Of a vertex of the tetrahedron, whose triangles are in the stars of ranks 2 and 3.
  void start_sector() {
    std::array<Triangle, 3> around;
    std::size_t count = 0;
    for (const std::uint32_t of : {2u, 3u}) {
      for (const Triangle triangle : star_of(of)) {
        const std::array<std::uint32_t, 3> corner{of, triangle.a, triangle.b};
        for (std::size_t k = 0; k < 3; ++k) {
          if (corner[k] == at_) around[count++] = {corner[(k + 1) % 3], corner[(k + 2) % 3], triangle.beyond};
        }
      }
    }
    if (around[1].a != around[0].b) std::swap(around[1], around[2]);
    choose_sector(around);
  }

  // The sector of at_, whose triangles these are, counter-clockwise. Where both signs are zero the corners lie on one
  // line with the middle and the direction, which may be beyond the middle: another sector has it, too, unless all
  // signs are zero, as the direction is the middle, and in all of them.
  template <class Triangles>
  void choose_sector(const Triangles& around) {
    std::size_t right = around.size() - 1, left = 0;
    Sign of_right = turn_(at_, around[right].a, around[right].b);
    for (; left + 1 < around.size(); right = left++) {
      const Sign of_left = turn_(at_, around[left].a, around[left].b);
      if (!is_negative(of_right) && !is_positive(of_left) && of_left != of_right) break;
      of_right = of_left;
    }
    to_ = around[left].a;
    left_ = around[left].beyond;
    right_ = around[right].beyond;
  }

  // W3.
  void pass_triangles(std::uint32_t w) {
    const Star star = star_of(w);
    if (left_ == right_) {
      const std::size_t f = find(star, [&](const Triangle& t) { return t.b == at_; });
      to_ = w;
      left_ = star[f].beyond;
      right_ = star[f + 1 < star.size() ? f + 1 : 0].beyond;
    } else if (right_ == w) {
      const std::size_t f = find(star, [&](const Triangle& t) { return t.a == to_ && t.b == at_; });
      right_ = star[f].beyond;
      if (!is_negative(turn_(at_, w, to_))) return;
      to_ = w;
      left_ = star[f].beyond;
      right_ = star[f + 1 < star.size() ? f + 1 : 0].beyond;
    } else {
      const std::size_t f = find(star, [&](const Triangle& t) { return t.a == at_ && t.b == to_; });
      left_ = star[f].beyond;
      if (!is_positive(turn_(at_, to_, w))) return;
      to_ = w;
      right_ = star[f].beyond;
      left_ = star[f > 0 ? f - 1 : star.size() - 1].beyond;
    }
  }

  // Of a polygon: left_ is the edge from the vertex before, right_ that to the vertex after.
  void pass_edge(std::uint32_t w) {
    const Star star = star_of(w);
    if (left_ == w) {
      left_ = star[1].beyond;
    } else {
      right_ = star[0].beyond;
    }
  }

  void enter(const Triangle& left, const Triangle& right) {
    left_ = left.beyond;
    right_ = right.beyond;
  }

  template <class Is>
  static std::size_t find(const Star& star, const Is& is) {
    std::size_t f = 0;
    while (f + 1 < star.size() && !is(star[f])) ++f;
    return f;
  }

  const Hierarchy& hierarchy_;
  const Compare& compare_;
  const Turn& turn_;
  std::uint64_t& probes_;
  std::uint32_t at_ = 0;                      // the extreme one so far
  std::uint32_t to_ = 0;                      // the neighbour of the sector
  std::uint32_t left_ = none, right_ = none;  // what comes beyond the triangles left and right of the edge to it
};

}  // namespace sunder::solid
