#include <cli/unbounded_certificate.h>

#include <sunder/base/error.h>
#include <sunder/certificate/check.h>
#include <sunder/certificate/json.h>
#include <sunder/number/dyadic.h>
#include <sunder/planar/pair/polygon_polygon.h>
#include <sunder/predicate/orient.h>

#include <array>
#include <cmath>
#include <vector>

namespace sunder::cli {

namespace {

using Kind = io::PlanarObject::Kind;
using planar::Place;
using planar::Pose;

[[noreturn]] void fail(const std::string& what) { throw Error(ErrorCode::bad_call, what, "--certificate"); }

// A point strictly to the left of the way from a to b: the body's vertex furthest there, if it is; else one near a.
Point2 point_left_of(const PlanarBody& body, const Unbounded& unbounded, std::uint32_t witness) {
  const Point2 &a = unbounded.a, &b = unbounded.b;
  std::vector<Point2> candidates;
  if (const std::optional<Point2> w = exact_image(body.pose, body.polygon[witness])) candidates.push_back(*w);
  candidates.push_back({a.x - (b.y - a.y), a.y + (b.x - a.x)});
  candidates.push_back({a.x - std::copysign(1.0, b.y - a.y), a.y + std::copysign(1.0, b.x - a.x)});
  for (const Point2& c : candidates) {
    if (std::isfinite(c.x) && std::isfinite(c.y) && orient_2d(a, b, c) == Sign::positive) return c;
  }
  fail("no point of the half-plane beside its line was found to write down; give its two points nearer to each other");
}

PairCertificate apart(const Direction& direction, std::uint32_t extreme_a, std::uint32_t extreme_b) {
  PairCertificate c;
  c.verdict = Verdict::apart;
  c.direction = direction;
  c.extreme_a = extreme_a;
  c.extreme_b = extreme_b;
  return c;
}

Direction named(Direction::Kind kind, std::uint32_t from, std::uint32_t to, bool reversed) {
  Direction d;
  d.kind = kind;
  d.index = {from, to, 0, 0};
  d.reversed = reversed;
  return d;
}

// A ray whose line meets the body: across an edge at which the line leaves it, or along the ray. A body of one edge or
// none is left in its last vertex.
std::vector<PairCertificate> behind_the_beginning(const PlanarBody& body, const planar::CutEnd& last) {
  const std::uint32_t n = body.polygon.size(), v = last.feature;
  std::vector<PairCertificate> candidates;
  for (const std::uint32_t e : {v, (v + n - 1) % n}) {
    for (const bool reversed : {false, true}) {
      if (n > 1) candidates.push_back(apart(named(Direction::Kind::side_of_a, e, (e + 1) % n, reversed), e, 0));
    }
  }
  candidates.push_back(apart(named(Direction::Kind::difference, v, 0, false), v, 0));
  return candidates;
}

}  // namespace

std::optional<Point2> exact_image(const Pose& pose, const Point2& p) {
  const auto& [m, t] = pose.affine();
  const Dyadic x = Dyadic(m[0]) * Dyadic(p.x) + Dyadic(m[1]) * Dyadic(p.y) + Dyadic(t[0]);
  const Dyadic y = Dyadic(m[2]) * Dyadic(p.x) + Dyadic(m[3]) * Dyadic(p.y) + Dyadic(t[1]);
  const Point2 image{x.nearest(), y.nearest()};
  if (!std::isfinite(image.x) || !std::isfinite(image.y)) return std::nullopt;
  if (!(Dyadic(image.x) == x) || !(Dyadic(image.y) == y)) return std::nullopt;
  return image;
}

std::string certificate_of_unbounded(const PlanarBody& body, const Unbounded& unbounded, bool meet,
                                     const planar::PolygonCut& line_cut, std::uint32_t witness) {
  const auto& [kind, a, b, name] = unbounded;
  std::vector<Point2> piece{a, b};
  if (kind == Kind::half_plane) piece.push_back(point_left_of(body, unbounded, witness));
  std::vector<Point3> vertices;
  for (const Point2& p : piece) vertices.push_back({p.x, p.y, 0});
  const Affine3 world;
  const PlacedVertices in_a = body.in_space(), in_b{vertices, world, false};

  std::vector<PairCertificate> statements;
  if (meet) {
    const auto polygon = planar::ConvexPolygon::from_vertices(piece);
    statements.push_back(planar::polygon_polygon(body.polygon, body.pose, polygon, Pose()).certificate());
    if (statements[0].verdict != Verdict::meet) {
      fail(
          "they meet, but not between the two points given, and a certificate speaks of these; give two points of "
          "the same line with a common point between them");
    }
  } else if (line_cut.meet()) {
    for (const PairCertificate& c : behind_the_beginning(body, line_cut.last)) {
      if (check_absolutely(c, in_a, in_b) == CheckResult::accepted) {
        statements.push_back(c);
        break;
      }
    }
  } else {
    // Across the line, from the body's nearest vertex to it; one of the two signs is right.
    for (const bool reversed : {false, true}) {
      const Direction d = named(Direction::Kind::side_of_b, 0, 1, reversed);
      const PairCertificate c = apart(d, line_cut.nearest, 0);
      if (check_absolutely(c, in_a, in_b) != CheckResult::accepted) continue;
      statements = {c, apart(d, line_cut.nearest, 1)};
    }
  }
  if (statements.empty()) fail("none was found; leave it out, and report this as a fault");

  CertificateWriter writer;
  const std::uint32_t of_body = writer.add_body(body.name, body.vertices), of_piece = writer.add_body(name, vertices);
  const std::uint32_t placed_body = writer.add_placed(body.name, of_body, body.pose_in_space);
  const std::uint32_t placed_piece = writer.add_placed(name, of_piece, world);
  for (const PairCertificate& c : statements) writer.add_pair(placed_body, placed_piece, c);
  return writer.text();
}

}  // namespace sunder::cli
