#include <sunder/ask/report.h>
#include <sunder/ask/set/polygon_defect_text.h>

#include <fmt/format.h>

namespace sunder::ask {

namespace {

using planar::PolygonDefect;
using planar::RingPlace;
using Kind = planar::PolygonDefectKind;

bool of_one_ring(const PolygonDefect& d) { return d.a.part == d.b.part && d.a.ring == d.b.ring; }

std::string ring_text(const RingPlace& place, bool has_parts) {
  return has_parts ? fmt::format("part {}, ring {}", place.part, place.ring) : fmt::format("ring {}", place.ring);
}

std::string edges_text(const PolygonDefect& d) {
  if (d.a == d.b) return fmt::format("edge {}", d.a.edge);
  if (of_one_ring(d)) return fmt::format("edges {} and {}", d.a.edge, d.b.edge);
  return fmt::format("edge {} of the one, edge {} of the other", d.a.edge, d.b.edge);
}

}  // namespace

std::string text_of(const PolygonDefect& d, bool has_parts) {
  const std::string a = ring_text(d.a, has_parts), b = ring_text(d.b, has_parts), at = place_text(d.place.a);
  const std::string both = of_one_ring(d) ? a : a + " and " + b;
  const auto meet = [&](const char* itself, const char* other) {
    return fmt::format("{} {} at about {}: {}", both, of_one_ring(d) ? itself : other, at, edges_text(d));
  };
  switch (d.kind) {
    case Kind::too_few_points: return fmt::format("{} has fewer than three different vertices, at {}", a, at);
    case Kind::crossing: return meet("crosses itself", "cross");
    case Kind::overlap:
      return fmt::format("{} {} from about {} to {}: {}", both,
                         of_one_ring(d) ? "runs along itself" : "have a piece in common", at, place_text(d.place.b),
                         edges_text(d));
    case Kind::repeated_vertex:
      return fmt::format("{}: vertices {} and {} are the same, {}", a, d.a.edge, d.b.edge, at);
    case Kind::self_touch: return meet("touches itself", "touch");
    case Kind::rings_touch: return meet("touches itself", "touch");
    case Kind::hole_outside: return fmt::format("{} is a hole outside of its shell, at {}: edge {}", a, at, d.a.edge);
    case Kind::nested_holes: return fmt::format("{} is a hole inside of a hole, ring {}, at {}", a, d.b.ring, at);
    case Kind::disconnected:
      return fmt::format("{} part{} the interior in two at {}", both, of_one_ring(d) ? "s" : "", at);
    case Kind::nested_parts: return fmt::format("part {} is inside of part {}, at {}", d.a.part, d.b.part, at);
  }
  return "";
}

}  // namespace sunder::ask
