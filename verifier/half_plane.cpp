#include "half_plane.h"

#include <algorithm>

namespace sunder_verifier {

Integer turn(const HalfPlane& h, const HalfPlane& k) { return h.a * k.b - h.b * k.a; }

Integer facing(const HalfPlane& h, const HalfPlane& k) { return h.a * k.a + h.b * k.b; }

bool are_opposite(const HalfPlane& h, const HalfPlane& k) { return turn(h, k) == 0 && facing(h, k) < 0; }

Place corner(const HalfPlane& h, const HalfPlane& k) {
  return {h.c * k.b - k.c * h.b, h.a * k.c - k.a * h.c, turn(h, k)};
}

int excess(const HalfPlane& h, const Place& point) {
  const Integer beyond = h.a * point.x + h.b * point.y - h.c * point.w;
  return beyond.sign();
}

int width(const HalfPlane& h, const HalfPlane& k) {
  const Integer between = facing(h, h) * k.c - facing(h, k) * h.c;
  return between.sign();
}

bool holds(const HalfPlane& h, const HalfPlane& k) { return facing(k, h) * k.c <= facing(k, k) * h.c; }

HalfPlane left_of(const Numbers& arrow, const std::string& where) {
  const Common scaled = common(arrow);
  const Integer &px = scaled.integers[0], &py = scaled.integers[1];
  const Integer &qx = scaled.integers[2], &qy = scaled.integers[3];
  // In units of 2^e are a and b, and c is in units of their square.
  const std::int64_t finer = std::max<std::int64_t>(-scaled.e, 0), coarser = std::max<std::int64_t>(scaled.e, 0);
  HalfPlane h{shifted(qy - py, finer), shifted(px - qx, finer), shifted(px * qy - qx * py, coarser)};
  if (h.a == 0 && h.b == 0) refuse_form(where + " has no direction");
  return h;
}

HalfPlane read_half_plane(const json& item, const std::string& where) {
  const std::size_t count = item.is_array() && item.size() == 4 ? 4 : 3;
  const Numbers numbers = read_numbers(item, count, read_double, where);
  if (count == 4) return left_of(numbers, where);
  const Common scaled = common(numbers);
  HalfPlane h{scaled.integers[0], scaled.integers[1], scaled.integers[2]};
  if (h.a == 0 && h.b == 0) refuse_form(where + " has no direction");
  return h;
}

}  // namespace sunder_verifier
