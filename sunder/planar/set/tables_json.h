// The tables of certificate files about sets and regions, and what is in their statements (docs/certificates.md,
// "Sets"). Each function appends to a text.
#pragma once

#include <sunder/planar/object/convex_polygon.h>
#include <sunder/predicate/crossing.h>

#include <cstdint>
#include <span>
#include <string>

namespace sunder::planar {

inline constexpr const char* json_file_begin = "{\"sunder_set_certificate\": 1,\n";

// A double as a string.
void append_double(std::string& text, double x);

// A list of indices; 0xffffffff stands for none, -1.
void append_indices(std::string& text, std::span<const std::uint32_t> indices);

// The coordinates of a point, as fractions.
void append_point(std::string& text, const ExactPoint2& p);

// A list of doubles.
void append_doubles(std::string& text, std::span<const double> numbers);

// The table, with its key.
void append_convex_polygons(std::string& text, std::span<const ConvexPolygon> polygons);

}  // namespace sunder::planar
