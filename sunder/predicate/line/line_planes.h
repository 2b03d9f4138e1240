// A line of the world, and planes through three points of a posed body: how the line goes around the triangle, and in
// which of two planes it is first. Exact.
// Also called: Pluecker side test; ray-triangle intersection predicate.
#pragma once

#include <sunder/number/sign.h>
#include <sunder/predicate/point.h>
#include <sunder/predicate/posed.h>

#include <array>

namespace sunder {

using PosedTriangle = std::array<Posed3, 3>;

// The signs of orient_3d(a, b, p, q), of (a, b, q, r) and of (a, b, r, p), for the triangle p, q, r: with no two of
// them different the line meets the triangle, or is in one plane with an edge.
std::array<Sign, 3> turns_about_line(const Point3& a, const Point3& b, const PosedTriangle& triangle,
                                     StageTally* tally = nullptr);

// For the planes of f and of g, with normals N = (second - first) x (third - first) and d = b - a: the signs of N_f.d
// and of N_g.d; and that of N_g.(x - g) times -N_f.d, where x is the line's point in the plane of f. (Formula:
// N_f.(a - f) N_g.d - N_g.(a - g) N_f.d, which is defined where there is no such point, too.)
struct LineAndPlanes {
  Sign facing_f, facing_g, beyond;
};
LineAndPlanes line_and_planes(const Point3& a, const Point3& b, const PosedTriangle& f, const PosedTriangle& g,
                              StageTally* tally = nullptr);

// The sign of N.d, N of the triangle.
Sign facing(const Point3& a, const Point3& b, const PosedTriangle& triangle, StageTally* tally = nullptr);

}  // namespace sunder
