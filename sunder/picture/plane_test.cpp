#include <sunder/picture/pair.h>
#include <sunder/picture/plane.h>

#include <gtest/gtest.h>
#include <tinyxml2.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
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
  const std::string svg = pair_svg({a, here, "A<"}, {b, there, "B"}, distance.closest, "");
  expect_well_formed(svg);
  for (const char* text : {"Do A&lt; and B meet?", "the distance, about 5<", "two parallel lines", "of 4 vertices"}) {
    EXPECT_NE(svg.find(text), std::string::npos) << text;
  }
  EXPECT_EQ(pair_svg({a, here, "A"}, {b, there, "B"}, {}, "Mine").find("distance"), std::string::npos);
  EXPECT_NE(pair_svg({a, here, "A"}, {b, here, "B"}, {}, "Mine").find("a common point"), std::string::npos);
}

}  // namespace
}  // namespace sunder::picture
