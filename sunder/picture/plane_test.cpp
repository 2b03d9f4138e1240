#include <sunder/picture/pair.h>
#include <sunder/picture/plane.h>

#include <sunder/certificate/rounded_evidence.h>
#include <sunder/planar/pair/contact_evidence.h>
#include <sunder/planar/pair/polygon_polygon.h>
#include <tests/support/planar_pairs.h>
#include <tests/support/scale.h>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <tinyxml2.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace sunder::picture {
namespace {

void expect_well_formed(const std::string& svg) {
  tinyxml2::XMLDocument document;
  EXPECT_EQ(document.Parse(svg.data(), svg.size()), tinyxml2::XML_SUCCESS) << document.ErrorStr();
  for (const char* text : {"='nan", "='-nan", "='inf", "='-inf", " nan", " inf", " -nan", " -inf", "Mnan", "Minf"}) {
    EXPECT_EQ(svg.find(text), std::string::npos) << text;
  }
}

TEST(PlanePicture, CoordinatesOfAnySize) {
  const double huge = std::numeric_limits<double>::max(), tiny = 5e-324;
  const std::vector<std::array<Point2, 2>> extents{{{{0, 0}, {0, 0}}},
                                                   {{{-huge, -huge}, {huge, huge}}},
                                                   {{{0, 0}, {tiny, tiny}}},
                                                   {{{0, 0}, {huge, tiny}}},
                                                   {{{tiny, -huge}, {tiny, 1}}},
                                                   {{{3, 4}, {5, 4}}},
                                                   {{{1e16, 1e16}, {1e16 + 2, 1e16}}},
                                                   {{{-1, -2}, {3, 4}}}};
  for (const auto& seen : extents) {
    const auto& [p, q] = seen;
    PlanePicture picture(seen);
    picture.circle({p, q.x}, Ink::calm);
    picture.circle({q, tiny}, Ink::bold);
    picture.polygon(seen, Ink::second);
    picture.polygon(std::array{p}, Ink::third);
    picture.line(p, q, Ink::accent);
    picture.line(q, {0, 0}, Ink::accent);
    picture.line(p, {huge, -huge}, Ink::dark, PlanePicture::Extent::half_plane);
    picture.line(q, {-tiny, tiny}, Ink::dark, PlanePicture::Extent::ray, true);
    picture.arrow(p, q, 20, Ink::bold);
    picture.dot({huge, -huge}, Ink::dark, "<far> & \xff");
    picture.rings(std::vector<RingContact>{{picture.at(q), 0, 0}}, std::array{RingKind{Ink::accent, "crossing"}},
                  [](std::uint32_t) { return "]]>"; });
    expect_well_formed(picture.text("<title>", std::string(1000, '&')));
  }
}

TEST(PlanePicture, LabelsDoNotLieOverEachOther) {
  PlanePicture picture(std::array{Point2{0, 0}, Point2{1, 1}});
  for (int k = 0; k < 3; ++k) picture.label({0.5, 0.5}, "here");
  const std::string svg = picture.text("Labels", "");
  tinyxml2::XMLDocument document;
  ASSERT_EQ(document.Parse(svg.data(), svg.size()), tinyxml2::XML_SUCCESS);
  std::vector<double> heights;
  std::size_t at = 0;
  while ((at = svg.find("class='n'", at)) != std::string::npos) {
    at = svg.find(" y='", at) + 4;
    heights.push_back(std::stod(svg.substr(at)));
  }
  ASSERT_EQ(heights.size(), 3u);
  EXPECT_GE(heights[1] - heights[0], 13);
  EXPECT_GE(heights[2] - heights[1], 13);
}

std::size_t count_in(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

// R1 of rings.h: up to 10,000 contacts have rings; more, squares.
TEST(PlanePicture, CrowdsOfContactsAreDark) {
  for (const std::uint32_t size : {10'000u, 10'001u}) {
    PlanePicture picture(std::array{Point2{0, 0}, Point2{3, 3}});
    std::vector<RingContact> contacts{{picture.at({2, 2}), 0, 0}};
    while (contacts.size() < size) {
      contacts.push_back({picture.at({1, 1}), static_cast<std::uint32_t>(contacts.size()), 0});
    }
    picture.rings(contacts, std::array{RingKind{Ink::accent, "crossing"}}, [](std::uint32_t) { return "told"; });
    const std::string svg = picture.text("Many", "");
    expect_well_formed(svg);
    const bool is_crowd = size > 10'000;
    EXPECT_EQ(count_in(svg, "<g class='m "), is_crowd ? 0u : 2u);
    EXPECT_EQ(count_in(svg, "stroke-opacity='0.9'"), is_crowd ? 1u : 0u);
    EXPECT_EQ(count_in(svg, "stroke-opacity='0.2'"), is_crowd ? 1u : 0u);
    EXPECT_EQ(count_in(svg, "up to 10000."), is_crowd ? 1u : 0u);
  }
}

TEST(PlanePicture, NamesStandWhereThereIsRoom) {
  PlanePicture picture(std::array{Point2{0, 0}, Point2{9, 9}});
  const std::vector<Point2> large{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, tiny{{1, 1}, {1.1, 1}, {1.1, 1.1}};
  picture.named("a <large> one", [&] { picture.polygon(large, Ink::calm); });
  picture.named("another", [&] { picture.polygon(large, Ink::calm); });  // no room beside the first one's
  picture.named("a tiny one", [&] { picture.polygon(tiny, Ink::calm); });
  picture.named("a line", [&] { picture.line({2, 2}, {1, 1}, Ink::bold); });
  const std::string svg = picture.text("Names", "");
  expect_well_formed(svg);
  EXPECT_EQ(count_in(svg, ">a &lt;large&gt; one</text>"), 1u);
  EXPECT_EQ(count_in(svg, "class='n h'"), 1u);
  for (const char* name : {"a &lt;large&gt; one", "another", "a tiny one", "a line"}) {
    EXPECT_EQ(count_in(svg, std::string("<title>") + name + "</title>"), 1u) << name;
  }
}

// P3 of plane.h: of many small things the density.
TEST(PlanePicture, ManySmallThingsAreSquares) {
  for (const int count : {5000, 5001}) {
    PlanePicture picture(std::array{Point2{0, 0}, Point2{100, 100}});
    for (int k = 0; k < count; ++k) picture.circle({{k % 70 + 0.5, k / 70 + 0.5}, 0.01}, Ink::accent);
    picture.circle({{50, 50}, 40}, Ink::bold);
    const std::string svg = picture.text("Many", "");
    expect_well_formed(svg);
    EXPECT_EQ(count_in(svg, "<circle cx="), count > 5000 ? 1u : 5001u);
    EXPECT_EQ(count_in(svg, "drawn as squares"), count > 5000 ? 1u : 0u);
    EXPECT_EQ(count_in(svg, "<path class='c' fill='none' stroke-width='5'") > 0, count > 5000);
  }
}

TEST(Density, CountsWhatIsWithin) {
  Density crowd(20, 20);
  for (const Point2& p : {Point2{-1, 5}, Point2{5, -1}, Point2{31, 5}, Point2{5, 1e300}}) crowd.add(p);
  EXPECT_EQ(crowd.most(), 0u);
  EXPECT_EQ(crowd.xml(""), "");
  crowd.add({0, 1}, {20, 1});  // once in each of four squares
  EXPECT_EQ(crowd.most(), 1u);
  EXPECT_EQ(count_in(crowd.xml(""), "h5"), 4u);
  crowd.add({7, 2});
  EXPECT_EQ(crowd.most(), 2u);
  EXPECT_EQ(count_in(crowd.xml("stroke='red'"), "<path stroke='red' "), 2u);
}

TEST(PairPicture, HasATitleAndTheDistance) {
  const std::vector<Point2> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const auto a = planar::ConvexPolygon::from_vertices(square), &b = a;
  const planar::Pose here, there = planar::Pose::from_matrix({1, 0, 0, 1}, {4, 5});
  const auto distance = planar::polygon_polygon_distance(a, here, b, there);
  const PairAnswer apart = planar::polygon_polygon(a, here, b, there), meet = planar::polygon_polygon(a, here, b, here);
  const std::string of_b = "B: polygon, 4 vertices";
  const std::string svg = pair_svg({{a, here, "A<", "A<: of 4 vertices"},
                                    {b, there, "B", of_b},
                                    apart,
                                    "automatic",
                                    closest_of(distance),
                                    "; left out: 1 point"});
  expect_well_formed(svg);
  for (const char* text : {"Do A&lt; and B meet?", "the distance, about 5<", "two parallel lines",
                           "A&lt;: of 4 vertices, ", "from each other; left out: 1 point", "looked at (circles)"}) {
    EXPECT_NE(svg.find(text), std::string::npos) << text;
  }
  const PicturedPolygon in_a{a, here, "A", "A"};
  EXPECT_EQ(pair_svg({in_a, {b, there, "B", of_b}, apart, "automatic"}).find("distance"), std::string::npos);
  EXPECT_NE(pair_svg({in_a, {b, here, "B", of_b}, meet, "automatic"}).find("a common point"), std::string::npos);
}

// The width of the strip, and the vertices that were looked at, are those of the method that answered, or none.
TEST(PairPicture, ShowsTheSearchThatAnswered) {
  using Method =
      PairAnswer(const planar::ConvexPolygon&, const planar::Pose&, const planar::ConvexPolygon&, const planar::Pose&);
  const std::vector<std::pair<std::string, Method*>> methods{{"automatic", planar::polygon_polygon},
                                                             {"difference", planar::polygon_polygon_by_difference},
                                                             {"halving", planar::polygon_polygon_by_halving},
                                                             {"gjk", planar::polygon_polygon_by_gjk},
                                                             {"triangles", planar::polygon_polygon_by_triangles},
                                                             {"scan", planar::polygon_polygon_by_scan}};
  using Family = tests::PlanarFamily;
  constexpr std::array families{Family::grid,       Family::general, Family::near_contact, Family::touching,
                                Family::degenerate, Family::sliver,  Family::contained};
  tests::PlanarPairs pairs(tests::chosen_seed(77));
  const int count = tests::scaled_count(700);
  int apart = 0, differing = 0;
  for (int i = 0; i < count; ++i) {
    const tests::PlanarCase c = pairs.next(families.at(static_cast<std::size_t>(i) % families.size()));
    std::set<std::string> said;
    for (const auto& [name, method] : methods) {
      SCOPED_TRACE(name + " " + std::to_string(i));
      const PairAnswer answer = method(c.a, c.pose_a, c.b, c.pose_b);
      const std::string svg = pair_svg({{c.a, c.pose_a, "A", "A"}, {c.b, c.pose_b, "B", "B"}, answer, name});
      const bool is_watched = name != "triangles" && name != "scan";
      ASSERT_EQ(count_in(svg, " looked at (circles)"), is_watched ? 2u : 0u);
      ASSERT_EQ(count_in(svg, "The vertices that the method " + name + " looked at are not shown."),
                is_watched ? 0u : 1u);
      ASSERT_EQ(count_in(svg, "they meet: a common point"), answer.meet() ? 1u : 0u);
      if (answer.meet()) continue;
      ++apart;
      std::array<std::vector<Point3>, 2> tables;
      for (const Point2& v : c.a.vertices()) tables[0].push_back({v.x, v.y, 0});
      for (const Point2& v : c.b.vertices()) tables[1].push_back({v.x, v.y, 0});
      const Affine3 pose_a = planar::in_space(c.pose_a.affine()), pose_b = planar::in_space(c.pose_b.affine());
      const RoundedGap gap =
          rounded_gap(std::get<Separation>(answer.evidence), {tables[0], pose_a, false}, {tables[1], pose_b, false});
      const std::string width = fmt::format("about {:.4g} from each other", gap.width);
      ASSERT_EQ(count_in(svg, width), 1u) << width;
      said.insert(width);
    }
    differing += said.size() > 1 ? 1 : 0;
  }
  if (count < 200) return;
  EXPECT_GT(apart, count);  // of six methods
  EXPECT_GT(differing, count / 20);
}

}  // namespace
}  // namespace sunder::picture
