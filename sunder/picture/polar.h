// A picture of a convex polyhedron and its polar about a point inside it, as SVG. Rounded numbers, for people.
#pragma once

#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/represent/polar_about.h>

#include <span>
#include <string>

namespace sunder::picture {

struct PolarPicture {
  const solid::ConvexPolyhedron& body;  // of dimension 3
  const solid::PolarAbout& polar;
  std::span<const Point3> polar_vertices;  // as doubles
  std::string name;                        // of the body
  std::string said;                        // the answer, and what it does not speak of
  std::string title{};                     // empty: a question
};

// Both in the same view, each as large as its panel, with the point in dark. Up to nine facets of the body, those that
// look largest, and the vertices of the polar that they become have the same numbers (Lemmas 3.1 and 3.2 of Barba and
// Langerman 2015): of those that are seen in both panels.
std::string polar_svg(const PolarPicture& picture);

}  // namespace sunder::picture
