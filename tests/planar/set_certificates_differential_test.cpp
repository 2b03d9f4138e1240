// Evidence about circles, half-planes, linear programs and polygons against the checker: what the library says is
// accepted, and what is accepted is true, also of a set that was changed a little.
#include <sunder/base/random.h>
#include <sunder/planar/discs/discs_any_claims.h>
#include <sunder/planar/polygons/convex_polygons_any_claims.h>
#include <sunder/planar/polygons/polygon_simple.h>
#include <sunder/planar/polygons/polygons_claims.h>
#include <sunder/planar/region/convex_polygon_intersection.h>
#include <sunder/planar/region/disc_intersection_claims.h>
#include <sunder/planar/region/half_plane_intersection.h>
#include <sunder/planar/region/linear_program_claims.h>
#include <sunder/planar/region/regions_claims.h>
#include <tests/support/scale.h>
#include <verifier/cpp/verify.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace {

using namespace sunder;
using namespace sunder::planar;
using Rings = std::vector<std::vector<Point2>>;
using nlohmann::json;

class SetCertificates : public testing::Test {
 protected:
  Random random{tests::chosen_seed(51)};
  int accepted = 0, refused = 0;
  std::map<std::string, int> verdicts;

  double whole(std::uint64_t size) {
    return static_cast<double>(random.below(2 * size + 1)) - static_cast<double>(size);
  }

  // Small whole numbers, so that everything degenerate is common.
  Disc circle() {
    const double x = whole(6), y = whole(6);
    return {{x, y}, std::fabs(whole(3))};
  }

  Constraint constraint() {
    for (;;) {
      const double a = whole(2), b = whole(2), c = whole(3);
      if (a != 0 || b != 0) return {a, b, c};
    }
  }

  ConvexPolygon polygon() {
    const double x = whole(8), y = whole(8);
    std::vector<Point2> points;
    for (std::uint64_t k = 1 + random.below(4); k > 0; --k) {
      const double dx = whole(2), dy = whole(2);
      points.push_back({x + dx, y + dy});
    }
    return ConvexPolygon::hull_of(points);
  }

  // A few points around a corner of a coarse grid, in an order that makes a simple ring; or a cell of that grid, so
  // that borders in common are common.
  std::vector<Point2> ring(double x, double y) {
    if (random.below(3) == 0) return {{x, y}, {x + 3, y}, {x + 3, y + 3}, {x, y + 3}};
    for (;;) {
      std::vector<Point2> points;
      for (std::uint64_t k = 3 + random.below(4); k > 0; --k) {
        const double dx = whole(2), dy = whole(2);
        points.push_back({x + dx, y + dy});
      }
      if (points.front() != points.back() && !polygon_simple_by_scan(Polygon(Rings{points})).meet()) {
        return points;
      }
    }
  }

  Polygon polygon_with_holes() {
    const double x = 3 * whole(3), y = 3 * whole(3);
    Rings rings{ring(x, y)};
    if (random.below(3) == 0) {  // around it, and it may be a hole
      rings.insert(rings.begin(), {{x - 4, y - 3}, {x + 4, y - 5}, {x + 5, y + 4}, {x - 3, y + 4}});
    }
    const Polygon all(rings);
    return !polygon_simple_by_scan(all).meet() ? all : Polygon(Rings{rings.front()});
  }

  // With some vertex moved: it need not be simple any longer. But no two of its edges overlap, so that it has an
  // inside.
  Polygon bent(const Polygon& polygon) {
    for (;;) {
      Rings rings;
      for (std::uint32_t r = 0; r < polygon.ring_count(); ++r) {
        rings.emplace_back(polygon.vertices().begin() + polygon.ring_begin(r),
                           polygon.vertices().begin() + polygon.ring_begin(r + 1));
      }
      std::vector<Point2>& ring = rings[random.below(rings.size())];
      Point2& p = ring[random.below(ring.size())];
      p = {p.x + whole(3), p.y + whole(3)};
      if (ring.front() == ring.back()) continue;
      const Polygon all(rings);
      bool overlaps = false;
      for (std::uint32_t e = 0; e < all.size(); ++e) {
        for (std::uint32_t f = 0; f < e; ++f) {
          overlaps |= segment_segment(sorted(all.edge(e)), sorted(all.edge(f))) == ContactKind::overlap;
        }
      }
      if (!overlaps) return all;
    }
  }

  template <class Make>
  auto set_of(std::uint64_t most, const Make& make) {
    std::vector<decltype(make())> all;
    for (std::uint64_t k = 1 + random.below(most); k > 0; --k) all.push_back(make());
    return all;
  }

  template <class Make, class Set>
  Set changed(Set set, const Make& make) {
    set[random.below(set.size())] = make();
    return set;
  }

  void expect_accepted(const std::string& text) {
    const sunder_verifier::FileResult result = sunder_verifier::verify_text(text, "library");
    ASSERT_TRUE(result.accepted()) << text;
    ++verdicts[result.statements.at(0).verdict];
  }

  // The statement of one file about the table of another one, for which the verdict would be `truth`.
  void expect_true_if_accepted(const std::string& text, const std::string& other, const char* table,
                               const std::string& truth) {
    json top = json::parse(text);
    const json from = json::parse(other);
    if (top["sunder_certificate"] == 3) {
      top["tables"][table] = from["tables"][table];
    } else {
      top[table] = from[table];
    }
    if (!sunder_verifier::verify_text(top.dump(), "changed").accepted()) {
      ++refused;
      return;
    }
    ++accepted;
    EXPECT_EQ(top["statements"][0]["verdict"].get<std::string>(), truth) << top.dump();
  }

  void expect_hits(int rounds, int kinds) {
    if (tests::scaled_count(100) < 100) return;
    EXPECT_GE(accepted, rounds / 50);
    EXPECT_GE(refused, rounds / 50);
    EXPECT_GE(static_cast<int>(verdicts.size()), kinds);
  }
};

TEST_F(SetCertificates, DiscsThatMeet) {
  const int rounds = tests::scaled_count(3000);
  for (int round = 0; round < rounds; ++round) {
    const auto make = [this] { return circle(); };
    const std::vector<Disc> given = set_of(7, make);
    const Discs circles(given), others(changed(given, make));
    const Allowed allowed = random.below(2) == 0 ? Allowed::nothing : Allowed::touch;
    const auto text = [&](const Discs& c) { return certificate_text(c, allowed, discs_any(c, {allowed})); };
    const std::string own = text(circles);
    expect_accepted(own);
    const bool meet = discs_any_by_scan(others, {allowed}).meet();
    expect_true_if_accepted(own, text(others), "circles", meet ? "some" : "none");
  }
  expect_hits(rounds, 2);
}

// Of equal discs the lowest number, and the list turned so that it is lexicographically least.
std::vector<std::uint32_t> in_one_form(const Discs& circles, std::vector<std::uint32_t> arcs) {
  for (std::uint32_t& arc : arcs) {
    const auto equal = std::find(circles.all().begin(), circles.all().end(), circles[arc]);
    arc = static_cast<std::uint32_t>(equal - circles.all().begin());
  }
  std::vector<std::uint32_t> least = arcs;
  for (std::size_t k = 1; k < arcs.size(); ++k) {
    std::rotate(arcs.begin(), arcs.begin() + 1, arcs.end());
    least = std::min(least, arcs);
  }
  return least;
}

// Any list of arcs is accepted if and only if it is what bounds the region.
TEST_F(SetCertificates, ArcsOfCommonPartsOfCircles) {
  const int rounds = tests::scaled_count(3000);
  for (int round = 0; round < rounds; ++round) {
    const bool are_wide = round % 2 == 0;  // most of these have a common part, with arcs over half a turn
    const Discs circles(set_of(4, [&] {
      Disc disc = circle();
      return are_wide ? Disc{disc.center, static_cast<double>(3 + random.below(8))} : disc;
    }));
    const planar::DiscIntersection part = disc_intersection(circles);
    if (part.kind != planar::DiscIntersectionKind::region) continue;
    json top = json::parse(certificate_text(circles, part));
    const std::vector<std::uint32_t> truth = in_one_form(circles, planar::disc_intersection_by_scan(circles).arcs);
    for (int change = 0; change < 9; ++change) {
      std::vector<std::uint32_t> arcs = part.arcs;
      const auto at = [&](std::size_t more) {
        return arcs.begin() + static_cast<std::ptrdiff_t>(random.below(arcs.size() + more));
      };
      const auto any = [&] { return static_cast<std::uint32_t>(random.below(circles.size())); };
      switch (change) {
        case 0: break;
        case 1: std::rotate(arcs.begin(), at(0), arcs.end()); break;
        case 2: std::reverse(arcs.begin(), arcs.end()); break;
        case 3: arcs.insert(arcs.end(), part.arcs.begin(), part.arcs.end()); break;
        case 4: arcs.erase(at(0)); break;
        case 5: arcs.insert(at(1), any()); break;
        case 6:  // one disc left out, and the arcs that it parted are one
          std::erase(arcs, any());
          arcs.erase(std::unique(arcs.begin(), arcs.end()), arcs.end());
          if (arcs.size() > 1 && arcs.front() == arcs.back()) arcs.pop_back();
          break;
        default: *at(0) = any(); break;
      }
      top["statements"][0]["arcs"] = arcs;
      const bool is_accepted = sunder_verifier::verify_text(top.dump(), "changed").accepted();
      EXPECT_EQ(is_accepted, !arcs.empty() && in_one_form(circles, arcs) == truth) << top.dump();
      (is_accepted ? accepted : refused) += 1;
    }
    ++verdicts[std::to_string(truth.size())];
  }
  expect_hits(rounds, 3);
}

// Of more than eight discs there are chains of halves. All are wanted, and no list of arcs is accepted but one.
TEST_F(SetCertificates, ArcsOfManyCircles) {
  const int rounds = tests::scaled_count(300);
  for (int round = 0; round < rounds; ++round) {
    const bool is_whole = round % 3 == 0;
    std::vector<Disc> given;
    for (std::uint64_t k = 9 + random.below(40); k > 0; --k) {
      const double x = is_whole ? whole(6) : random.uniform(-1, 1), y = is_whole ? whole(6) : random.uniform(-1, 1);
      const double more = round % 2 == 0 ? 1 : static_cast<double>(1 + random.below(3));
      given.push_back({{x, y}, is_whole ? 8 + more : std::hypot(x, y) + more});
    }
    const Discs circles(given);
    const planar::DiscIntersection part = disc_intersection(circles);
    ASSERT_EQ(part.kind, planar::DiscIntersectionKind::region);
    const std::string text = certificate_text(circles, part);
    expect_accepted(text);
    json top = json::parse(text);
    json& statement = top["statements"][0];
    const auto is_accepted = [&] { return sunder_verifier::verify_text(top.dump(), "changed").accepted(); };
    std::vector<std::uint32_t> arcs = part.arcs;
    arcs[random.below(arcs.size())] = static_cast<std::uint32_t>(random.below(circles.size()));
    statement["arcs"] = arcs;
    EXPECT_EQ(is_accepted(), in_one_form(circles, arcs) == in_one_form(circles, part.arcs)) << text;
    statement["arcs"] = part.arcs;
    json& parts = statement["claims"][1]["parts"];
    ASSERT_FALSE(parts.empty());
    const std::size_t at = random.below(parts.size());
    parts.erase(at);
    EXPECT_FALSE(is_accepted()) << text;
    parts.insert(parts.begin() + static_cast<std::ptrdiff_t>(at), part.arcs);  // within each half
    is_accepted() ? ++accepted : ++refused;  // a half may be beyond its own halves then
    parts.push_back(part.arcs);
    EXPECT_FALSE(is_accepted()) << text;
  }
}

TEST_F(SetCertificates, CommonPartsOfCircles) {
  const int rounds = tests::scaled_count(2000);
  for (int round = 0; round < rounds; ++round) {
    const auto make = [this] { return circle(); };
    const std::vector<Disc> given = set_of(4, make);
    const Discs circles(given), others(changed(given, make));
    const auto text = [](const Discs& c) { return certificate_text(c, disc_intersection(c)); };
    const std::string own = text(circles);
    expect_accepted(own);
    expect_true_if_accepted(own, text(others), "circles", std::string(name_of(disc_intersection_by_scan(others).kind)));
  }
  expect_hits(rounds, 3);
}

TEST_F(SetCertificates, CommonPartsOfHalfPlanes) {
  const int rounds = tests::scaled_count(4000);
  for (int round = 0; round < rounds; ++round) {
    const auto make = [this] { return constraint(); };
    const std::vector<Constraint> given = set_of(7, make);
    const Constraints half(given), others(changed(given, make));
    const auto text = [](const Constraints& h) { return certificate_text(h, half_plane_intersection(h, {true})); };
    const std::string own = text(half);
    expect_accepted(own);
    expect_true_if_accepted(own, text(others), "half_planes",
                            std::string(name_of(half_plane_intersection_by_scan(others).kind)));
  }
  expect_hits(rounds, 9);
}

TEST_F(SetCertificates, LinearPrograms) {
  const int rounds = tests::scaled_count(4000);
  for (int round = 0; round < rounds; ++round) {
    const auto make = [this] { return constraint(); };
    const std::vector<Constraint> given = set_of(7, make);
    const Constraints half(given), others(changed(given, make));
    const double p = whole(2), q = whole(2);
    const Objective objective{p, q};
    const auto text = [&](const Constraints& h) {
      return certificate_text(h, objective, linear_program(h, objective));
    };
    const std::string own = text(half);
    expect_accepted(own);
    expect_true_if_accepted(own, text(others), "half_planes",
                            std::string(name_of(linear_program_by_scan(others, objective).verdict())));
  }
  expect_hits(rounds, 4);
}

TEST_F(SetCertificates, ConvexPolygonsThatMeet) {
  const int rounds = tests::scaled_count(2000);
  for (int round = 0; round < rounds; ++round) {
    const auto make = [this] { return polygon(); };
    const std::vector<ConvexPolygon> given = set_of(6, make), others = changed(given, make);
    const Allowed allowed = random.below(2) == 0 ? Allowed::nothing : Allowed::touch;
    std::vector<std::uint32_t> groups;
    for (std::size_t k = 0, count = random.below(3); count > 0 && k < given.size(); ++k) {
      groups.push_back(static_cast<std::uint32_t>(random.below(count + 1)));
    }
    const auto text = [&](const std::vector<ConvexPolygon>& polygons) {
      const ConvexPolygonsAnswer answer = convex_polygons_any(polygons, {.allowed = allowed, .groups = groups});
      return certificate_text(polygons, allowed, answer, groups);
    };
    const std::string own = text(given);
    expect_accepted(own);
    const bool meet = convex_polygons_any_by_scan(others, {.allowed = allowed, .groups = groups}).meet();
    expect_true_if_accepted(own, text(others), "polygons", meet ? "some" : "none");
  }
  expect_hits(rounds, 2);
}

TEST_F(SetCertificates, CommonPartsOfConvexPolygons) {
  const int rounds = tests::scaled_count(3000);
  for (int round = 0; round < rounds; ++round) {
    // Around one place, so that there is a common part often enough.
    const auto make = [this] {
      std::vector<Point2> points;
      for (std::uint64_t k = 1 + random.below(5); k > 0; --k) {
        const double x = whole(3), y = whole(3);
        points.push_back({x, y});
      }
      return ConvexPolygon::hull_of(points);
    };
    const std::vector<ConvexPolygon> given = set_of(3, make), others = changed(given, make);
    const auto truth = [](const std::vector<ConvexPolygon>& polygons) {
      const PolygonsPartKind kind = convex_polygon_intersection_by_scan(polygons).kind;
      return std::string(kind == PolygonsPartKind::polygon ? "bounded" : name_of(kind));
    };
    const std::string own = certificate_text(given);
    expect_accepted(own);
    EXPECT_EQ(json::parse(own)["statements"][0]["verdict"].get<std::string>(), truth(given));
    expect_true_if_accepted(own, certificate_text(others), "convex_polygons", truth(others));
  }
  expect_hits(rounds, 4);
}

TEST_F(SetCertificates, PolygonsThatMeet) {
  const int rounds = tests::scaled_count(4000);
  std::map<Allowed, std::map<std::string, int>> of_rule;
  for (int round = 0; round < rounds; ++round) {
    const std::vector<Polygon> given = set_of(6, [this] { return polygon_with_holes(); });
    const Allowed allowed = std::array{Allowed::nothing, Allowed::shared_endpoint, Allowed::touch}[random.below(3)];
    const auto text = [&](const std::vector<Polygon>& polygons, const PolygonsAnswer& answer) {
      return certificate_text(polygons, allowed, answer);
    };
    auto* method = random.below(2) == 0 ? polygons_any_by_sweep : polygons_any;
    const PolygonsAnswer answer = method(given, {allowed, {}, nullptr});
    ASSERT_EQ(answer.meet(), polygons_any_by_scan(given, {allowed, {}, nullptr}).meet());
    const std::string own = text(given, answer);
    expect_accepted(own);
    ++of_rule[allowed][answer.meet() ? "some" : "none"];
    std::vector<Polygon> others = given;
    Polygon& other = others[random.below(others.size())];
    other = random.below(3) == 0 ? polygon_with_holes() : bent(other);
    const bool meet = polygons_any_by_scan(others, {allowed, {}, nullptr}).meet();
    expect_true_if_accepted(own, text(others, {}), "polygons", meet ? "some" : "none");
  }
  expect_hits(rounds, 2);
  if (rounds < 4000) return;
  for (const auto& [allowed, times] : of_rule) {
    EXPECT_EQ(times.size(), 2u);
    for (const auto& [verdict, n] : times) EXPECT_GT(n, rounds / 50) << name_of(allowed) << " " << verdict;
  }
}

}  // namespace
