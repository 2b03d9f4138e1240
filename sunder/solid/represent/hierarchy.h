// The hierarchy of Dobkin and Kirkpatrick over a convex polyhedron with an interior: P = P_1, P_2, ..., P_k, a
// tetrahedron. Each is the hull of the one before without an independent set of vertices of low degree.
// Also called: Dobkin-Kirkpatrick hierarchy, DK hierarchy.
//
//   A1. P_1 is the polyhedron, P_k a tetrahedron.
//   A2. P_{i+1} lies in P_i.
//   A3. The vertices of P_{i+1} are among those of P_i.
//   A4. The vertices that P_i has and P_{i+1} has not are an independent set of P_i's surface, each of degree at most
//       most_degree there.
//   A5. k is at most a constant times log2 n, and all facets that there ever are, at most a constant times n.
// Surfaces are triangulated, facets of many vertices somehow, and degrees are those of the triangulated ones.
//
// It is held as a history: vertices have ranks, in the order in which they come when the tetrahedron grows to the whole
// again; each comes with its star, the triangles that it has at first; a triangle is there until a vertex comes beyond
// it. So a triangle that many levels have is held once, and a search reads what it walks over, and no level.
//
// Of a flat polygon the same, with edges in the place of triangles: every second vertex of a level goes, P_k is a
// triangle.
//
// Source: Dobkin and Kirkpatrick 1990, section 3; BL15 section 4, A1 to A5. Departure: most_degree and the share of
// vertices that a level loses are measured, not proved (tests bound them).
#pragma once

#include <sunder/predicate/point.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace sunder::solid {

class ConvexPolyhedron;

struct Hierarchy {
  static constexpr std::size_t slot = 0;  // see solid/represent/of.h

  // Requires three vertices or more. Cost: O(n). Every sign is exact.
  static Hierarchy make(const ConvexPolyhedron& body);

  static constexpr std::uint32_t none = 0xffffffff;
  static constexpr std::uint32_t most_degree = 8;  // of a vertex when it comes

  // With the vertex in whose star it lies: counter-clockwise from outside. All are ranks. An edge of a polygon: b is
  // none.
  struct Triangle {
    std::uint32_t a, b;
    std::uint32_t beyond;  // the vertex that comes beyond it, and takes it away; or none
  };

  // The triangles about a vertex, in places from 0 on.
  class Star {
   public:
    class Iterator {
     public:
      Iterator(const Star& star, std::size_t k) : star_(&star), k_(k) {}
      Triangle operator*() const { return (*star_)[k_]; }
      Iterator& operator++() {
        ++k_;
        return *this;
      }
      bool operator!=(const Iterator& other) const { return k_ != other.k_; }

     private:
      const Star* star_;
      std::size_t k_;
    };

    Star(const std::uint32_t* rim, const std::uint32_t* beyond, std::uint32_t size)
        : rim_(rim), beyond_(beyond), size_(size) {}
    std::size_t size() const { return size_; }
    Iterator begin() const { return {*this, 0}; }
    Iterator end() const { return {*this, size_}; }
    // Always inlined: each step of a walk reads some of them.
    [[gnu::always_inline]] Triangle operator[](std::size_t k) const {
      const std::size_t next = k + 1 < size_ || size_ == 1 ? k + 1 : 0;
      return {rim_[k], size_ == 2 ? none : rim_[next], beyond_[k]};
    }

   private:
    const std::uint32_t *rim_, *beyond_;
    std::uint32_t size_;
  };

  struct alignas(64) Node {  // what a walk reads of most vertices is in its first line of the memory cache
    Point3 at;
    // A direction along which the vertex is extreme at every level that has it, about which a search tells the sides of
    // its normal cone apart. These doubles, where the vertex is further along them than all of its neighbours; else
    // (in needles, and where facets are nearly coplanar) the normal of the triangle of P's surface that it has with the
    // vertices of these ranks, counter-clockwise from outside, and the doubles are that normal, rounded. Of a polygon:
    // meaningless.
    Point3 middle;
    std::array<std::uint32_t, 2> middle_triangle{none, none};
    bool has_middle_in_doubles() const { return middle_triangle[0] == none; }

    std::uint32_t vertex;  // its number in the polyhedron
    // Of its star, counter-clockwise about it: a and beyond of the first `size`. Of rank 2, whose star is one triangle,
    // rim[1] is b; else b of one triangle is a of the next.
    std::uint32_t size = 0;
    std::array<std::uint32_t, most_degree> rim;
    std::array<std::uint32_t, most_degree> beyond;

    // Of the tetrahedron: all triangles of rank 3, and one of rank 2, with ranks 0 and 1. Of a polygon: the edge from
    // the vertex before, then that to the vertex after; each vertex of the last triangle has both.
    Star star() const { return {rim.data(), beyond.data(), size}; }
  };

  std::vector<Node> nodes;  // by rank

  // P_k has the first level_end[0] ranks, which is 4, P_{k-1} the first level_end[1], ..., P_1 all.
  std::vector<std::uint32_t> level_end;

  bool is_flat() const { return level_end.front() == 3; }
  std::size_t memory() const;  // bytes
};

}  // namespace sunder::solid
