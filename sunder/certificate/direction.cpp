#include <sunder/base/contract.h>
#include <sunder/certificate/direction.h>

namespace sunder {

namespace {

WorldDirection reversed(const WorldDirection& d) {
  const Vector3<Dyadic> v = d.exact();
  return WorldDirection(Vector3<Dyadic>{-v.x, -v.y, -v.z});
}

WorldDirection turned_right(const WorldDirection& d) {
  const Vector3<Dyadic> v = d.exact();
  return WorldDirection(Vector3<Dyadic>{v.y, -v.x, Dyadic(0)});
}

}  // namespace

WorldDirection world_direction(const Direction& d, const PlacedVertices& a, const PlacedVertices& b) {
  SUNDER_REQUIRE(d.kind != Direction::Kind::exact || d.numbers != nullptr);
  const auto& i = d.index;
  const auto oriented = [&](const WorldDirection& w) { return d.reversed ? reversed(w) : w; };
  switch (d.kind) {
    case Direction::Kind::given: return WorldDirection(d.given);
    case Direction::Kind::normal_of_a: return oriented(cross_direction(a[i[0]], a[i[1]], a[i[0]], a[i[2]]));
    case Direction::Kind::normal_of_b: return oriented(cross_direction(b[i[0]], b[i[1]], b[i[0]], b[i[2]]));
    case Direction::Kind::edge_cross_edge: return oriented(cross_direction(a[i[0]], a[i[1]], b[i[2]], b[i[3]]));
    case Direction::Kind::difference: return oriented(difference_direction(a[i[0]], b[i[1]]));
    case Direction::Kind::side_of_a: return oriented(turned_right(difference_direction(a[i[0]], a[i[1]])));
    case Direction::Kind::side_of_b: return oriented(turned_right(difference_direction(b[i[0]], b[i[1]])));
    case Direction::Kind::exact: break;
  }
  const auto& n = *d.numbers;
  return WorldDirection(Vector3<Dyadic>{n[0], n[1], n[2]});
}

}  // namespace sunder
