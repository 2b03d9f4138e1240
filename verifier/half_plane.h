// Half-planes a x + b y <= c as integers, and what checks ask about a few of them.
#pragma once

#include "statement_reader.h"

namespace sunder_verifier {

// Any positive multiple of the three numbers is the same half-plane. a and b are not both zero.
struct HalfPlane {
  Integer a, b, c;
};

// The point x / w, y / w; w > 0.
struct Place {
  Integer x, y, w;
};

// Positive: the normal of k is less than half a turn counter-clockwise from that of h.
Integer turn(const HalfPlane& h, const HalfPlane& k);
Integer facing(const HalfPlane& h, const HalfPlane& k);  // the normals' product
bool are_opposite(const HalfPlane& h, const HalfPlane& k);

// The common point of the lines. Requires that h turns to k.
Place corner(const HalfPlane& h, const HalfPlane& k);

// 1: the point is outside; 0: on the line; -1: inside.
int excess(const HalfPlane& h, const Place& point);

// Of two opposite ones. 1: their common part is a strip; 0: a line; -1: empty.
int width(const HalfPlane& h, const HalfPlane& k);

// Of two that face the same way: does h hold k?
bool holds(const HalfPlane& h, const HalfPlane& k);

// Of three numbers a, b, c, or of the four of an arrow, which has it on its left. Throws Refused for another form.
HalfPlane read_half_plane(const json& item, const std::string& where);

// To the left of the arrow from (px, py) to (qx, qy), four numbers.
HalfPlane left_of(const Numbers& arrow, const std::string& where);

}  // namespace sunder_verifier
