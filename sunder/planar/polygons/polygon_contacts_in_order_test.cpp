#include <sunder/base/random.h>
#include <sunder/planar/polygons/polygon_contacts_in_order.h>
#include <sunder/planar/polygons/polygons_all.h>

#include <gtest/gtest.h>

#include <tuple>
#include <vector>

namespace sunder::planar {
namespace {

Polygon square_at(double x, double y, double side) {
  return Polygon(std::vector<std::vector<Point2>>{{{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}}});
}

// On a few whole numbers: they share corners and borders, cross, are equal, and lie within each other.
std::vector<Polygon> some_squares(std::uint32_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Polygon> squares;
  const auto whole = [&](std::uint64_t below) { return static_cast<double>(random.below(below)); };
  for (std::uint32_t i = 0; i < count; ++i) squares.push_back(square_at(whole(24), whole(24), 1 + whole(6)));
  return squares;
}

// What does not depend on the method: of those that overlap, what shows it does.
auto told_of(const PolygonsContact& c) {
  return std::tuple(c.i, c.j, c.contact, c.contact == Relation::touching ? c.kind : ContactKind::none);
}

void expect_same(const std::vector<PolygonsContact>& found, const std::vector<PolygonsContact>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < found.size(); ++k) ASSERT_EQ(told_of(found[k]), told_of(expected[k])) << k;
}

std::vector<PolygonsContact> all_of(PolygonContactsInOrder& contacts) {
  std::vector<PolygonsContact> found;
  contacts.visit([&](const PolygonsContact& c) {
    found.push_back(c);
    return true;
  });
  return found;
}

TEST(PolygonContactsInOrder, AnyNumberThatIsHeldGivesTheSameList) {
  constexpr std::uint32_t size = 150;
  const std::vector<Polygon> squares = some_squares(size, 1);
  std::vector<std::uint32_t> groups;
  for (std::uint32_t i = 0; i < size; ++i) groups.push_back(i * i % 11 % 5);
  for (const Allowed allowed : {Allowed::nothing, Allowed::shared_endpoint, Allowed::touch}) {
    for (const Groups of : {Groups(), Groups(groups)}) {
      const SetOptions options{allowed, of, nullptr};
      const std::vector<PolygonsContact> expected = polygons_all_by_scan(squares, options).found;
      ASSERT_GT(expected.size(), std::size_t{3} * size);
      for (PolygonsFinder* find : {find_contacts_by_boxes, find_contacts_by_grid, find_contacts_by_sweep}) {
        for (const std::size_t most : {std::size_t{2} * size, std::size_t{3} * size, expected.size()}) {
          PolygonContactsInOrder contacts(squares, options, find, most);
          EXPECT_EQ(contacts.touching() + contacts.overlapping(), expected.size());
          for (int again = 0; again < 2; ++again) expect_same(all_of(contacts), expected);
        }
      }
    }
  }
}

TEST(PolygonContactsInOrder, StopsWhereTheVisitorDoes) {
  const std::vector<Polygon> squares = some_squares(150, 2);
  PolygonContactsInOrder contacts(squares, {}, find_contacts_by_sweep, 300);
  const std::vector<PolygonsContact> all = all_of(contacts);
  ASSERT_GT(all.size(), 800u);
  for (const std::size_t wanted : {std::size_t{1}, std::size_t{500}}) {
    std::vector<PolygonsContact> found;
    contacts.visit([&](const PolygonsContact& c) {
      found.push_back(c);
      return found.size() < wanted;
    });
    EXPECT_EQ(found, std::vector<PolygonsContact>(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(wanted)));
  }
}

// Boxes give up: frames around each other, which touch in nothing, and squares in the innermost one.
TEST(PolygonContactsInOrder, WhereBoxesGiveUp) {
  std::vector<Polygon> set;
  for (int d = 200; d > 20; --d) {
    const double s = d, t = d - 0.5;
    set.push_back(Polygon(std::vector<std::vector<Point2>>{{{-s, -s}, {s, -s}, {s, s}, {-s, s}},  //
                                                           {{-t, -t}, {t, -t}, {t, t}, {-t, t}}}));
  }
  for (int k = 0; k < 60; ++k) set.push_back(square_at(0, 0, 1 + k % 7));
  PolygonContactsInOrder contacts(set, {}, find_contacts_by_boxes, 2 * set.size());
  EXPECT_EQ(contacts.overlapping(), 60u * 59 / 2);
  expect_same(all_of(contacts), polygons_all_by_sweep(set).found);
}

TEST(PolygonContactsInOrder, OfNothing) {
  PolygonContactsInOrder contacts({}, {}, find_contacts_by_boxes);
  EXPECT_EQ(contacts.touching() + contacts.overlapping(), 0u);
  EXPECT_TRUE(all_of(contacts).empty());
}

// Each pair many times, first what tells less, and never more than twice what may be held.
TEST(LowestContacts, KeepsTheLowestAndWhatTellsMost) {
  constexpr std::uint32_t size = 3000, most = 20000;
  LowestContacts found(size, most, Allowed::shared_endpoint);
  Random random(3);
  for (int k = 0; k < 300000; ++k) {
    const auto i = static_cast<std::uint32_t>(random.below(size - 8));
    const auto j = i + 1 + static_cast<std::uint32_t>(random.below(8));
    found.add({Relation::touching, ContactKind::shared_endpoint, false, i, j, 0, 0});  // does not count
    found.add({Relation::touching, ContactKind::touch, false, i, j, 1, 1});
    if (j == i + 1) found.add({Relation::overlapping, ContactKind::crossing, false, i, j, 2, 2});
    if (j == i + 2) found.add({Relation::touching, ContactKind::overlap, false, i, j, 3, 3});
    found.add({Relation::touching, ContactKind::touch, false, i, j, 1, 1});
  }
  const std::vector<PolygonsContact> kept = found.take_in_order();
  const std::uint32_t end = found.end();
  EXPECT_LT(end, size);
  EXPECT_LE(kept.size(), most);
  EXPECT_GT(kept.size(), most / 2);
  std::size_t k = 0;
  for (std::uint32_t i = 0; i < end; ++i) {
    for (std::uint32_t j = i + 1; j <= i + 8; ++j, ++k) {
      ASSERT_LT(k, kept.size());
      ASSERT_EQ(std::tuple(kept[k].i, kept[k].j), std::tuple(i, j));
      ASSERT_EQ(kept[k].of_j, j == i + 1 ? 2u : j == i + 2 ? 3u : 1u);
    }
  }
  EXPECT_EQ(k, kept.size());
}

}  // namespace
}  // namespace sunder::planar
