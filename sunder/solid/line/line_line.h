// What have two lines of space in common; a line and a ray, a segment, a point; or any two of these? In constant time.
// Also called: line-line intersection in three dimensions; skew lines; segment-segment intersection.
//
// All are closed: touching is meeting. Answers are exactly right for the numbers given. A segment whose ends are equal
// is a point. None allocates while filters decide, and none throws, but for want of memory.
// Source: CD87, Figure 1.
#pragma once

#include <sunder/certificate/pair_answer.h>
#include <sunder/solid/object/line.h>

#include <cstdint>
#include <string_view>

namespace sunder::solid {

// What two flat things have in common.
enum class FlatKind : std::uint8_t { nothing, point, segment, ray, line, plane };

std::string_view name_of(FlatKind);  // "segment"

// Their common part, and how they meet there: none of nothing. Relative interiors are meant: of a line and a plane all
// of it, of a ray all but its beginning, of a segment all but its ends, of a point the point.
struct FlatContact {
  FlatKind kind = FlatKind::nothing;
  Relation contact = Relation::none;
};
inline Verdict verdict_of(const FlatContact& part) {
  return part.kind == FlatKind::nothing ? Verdict::apart : Verdict::meet;
}

using FlatCommon = Answer<FlatContact>;  // probes: signs that were asked for

// Exact; of the world. Cost: at most 13 signs.
FlatCommon line_line(const Line& a, const Line& b);
FlatCommon line_ray(const Line& a, const Ray& b);
FlatCommon line_segment(const Line& a, const Segment& b);
FlatCommon ray_ray(const Ray& a, const Ray& b);
FlatCommon ray_segment(const Ray& a, const Segment& b);
FlatCommon segment_segment(const Segment& a, const Segment& b);
FlatCommon line_point(const Line& a, const Point3& b);
FlatCommon ray_point(const Ray& a, const Point3& b);
FlatCommon segment_point(const Segment& a, const Point3& b);

// A line, a ray, a segment or a point by two of its points.
struct Linear {
  Point3 a, b;
  bool begins = false, ends = false;  // in a; in b

  Linear(const Line& line) : a(line.a), b(line.b) {}
  Linear(const Ray& ray) : a(ray.a), b(ray.b), begins(true) {}
  Linear(const Segment& segment) : a(segment.a), b(segment.b), begins(true), ends(true) {}
  Linear(const Point3& point) : a(point), b(point), begins(true), ends(true) {}

  bool is_point() const { return a == b; }
};

// Of any two.
FlatCommon linear_linear(const Linear& p, const Linear& q);

}  // namespace sunder::solid
