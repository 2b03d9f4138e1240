#include <sunder/base/random.h>
#include <sunder/near/contacts_in_order.h>
#include <sunder/planar/discs/discs_all.h>
#include <sunder/planar/segments/segments_all.h>

#include <tests/support/shapes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace sunder::planar {
namespace {

using Contacts = ContactsInOrder<SegmentsContact>;

Segments some_segments(std::uint32_t count, double length, std::uint64_t seed) {
  Random random(seed);
  return Segments(tests::short_segments(count, {0, 0}, 1, length / 2, random));
}

Discs some_circles(std::uint32_t count, double radius, std::uint64_t seed) {
  Random random(seed);
  return Discs(tests::discs_in_square(count, {0, 0}, 1, radius, random));
}

std::vector<SegmentsContact> all_in_order(const Segments& segments) {
  std::vector<SegmentsContact> contacts = segments_all(segments).found;
  std::sort(contacts.begin(), contacts.end());
  return contacts;
}

struct Asked {
  std::vector<Block> blocks;
  std::size_t most = 0;  // contacts of a block
};

Contacts contacts_of(const Segments& segments, std::size_t most, Asked& asked) {
  return Contacts(segments.size(), most, [&](const Block& block, const Contacts::Take& take) {
    std::size_t count = 0;
    asked.blocks.push_back(block);
    segments_visit_block(segments, {}, block, segments_visit, [&](const SegmentsContact& c) {
      EXPECT_TRUE(block.holds(c.i));
      ++count;
      take(c);
      return true;
    });
    if (asked.blocks.size() > 1) asked.most = std::max(asked.most, count);
  });
}

TEST(ContactsInOrder, AnyNumberThatIsHeldGivesTheSameList) {
  const Segments segments = some_segments(200, 0.8, 1);
  const std::vector<SegmentsContact> expected = all_in_order(segments);
  ASSERT_GT(expected.size(), 500u);
  for (const std::size_t most :
       {std::size_t{1}, std::size_t{7}, std::size_t{100}, expected.size() - 1, expected.size()}) {
    Asked asked;
    Contacts contacts = contacts_of(segments, most, asked);
    EXPECT_EQ(contacts.count(), expected.size());
    for (int again = 0; again < 2; ++again) {
      std::vector<SegmentsContact> found;
      contacts.visit([&](const SegmentsContact& c) {
        found.push_back(c);
        return true;
      });
      EXPECT_EQ(found, expected) << most;
    }
    EXPECT_LE(asked.most, std::max<std::size_t>(most, segments.size()));
    if (most == expected.size()) {
      EXPECT_EQ(asked.blocks.size(), 1u);
    } else {
      EXPECT_LE(asked.blocks.size(), 1 + 2 * (2 * expected.size() / most + 1));
    }
  }
}

TEST(ContactsInOrder, StopsWhereTheVisitorDoes) {
  const Segments segments = some_segments(100, 0.8, 2);
  const std::vector<SegmentsContact> expected = all_in_order(segments);
  Asked asked;
  Contacts contacts = contacts_of(segments, 50, asked);
  std::vector<SegmentsContact> found;
  contacts.visit([&](const SegmentsContact& c) {
    found.push_back(c);
    return found.size() < 10;
  });
  EXPECT_EQ(found, std::vector<SegmentsContact>(expected.begin(), expected.begin() + 10));
  EXPECT_EQ(asked.blocks.size(), 2u);
}

TEST(ContactsInOrder, OfOneMember) {
  std::vector<Segment> star{{{0, 0}, {1, 0}}};  // the first meets all others, which are apart
  for (int i = 0; i < 50; ++i) star.push_back({{i / 100.0, -1}, {i / 100.0, 1}});
  const Segments segments(star);
  Asked asked;
  Contacts contacts = contacts_of(segments, 10, asked);
  EXPECT_EQ(contacts.count(), 50u);
  std::uint32_t next = 1;
  contacts.visit([&](const SegmentsContact& c) {
    EXPECT_EQ(c.i, 0u);
    EXPECT_EQ(c.j, next++);
    return true;
  });
  EXPECT_EQ(next, 51u);
  EXPECT_EQ(asked.blocks.size(), 2u);  // all, and its own
}

TEST(ContactsInOrder, KnownOnes) {
  Contacts none((std::vector<SegmentsContact>()));
  EXPECT_EQ(none.count(), 0u);
  none.visit([](const SegmentsContact&) { return true; });
  Contacts one(std::vector<SegmentsContact>{{1, 2, ContactKind::touch}});
  std::uint64_t count = 0;
  one.visit([&](const SegmentsContact& c) { return ++count > 0 && c.i == 1; });
  EXPECT_EQ(count, 1u);
}

template <class Contact, class Visit>
std::vector<Contact> in_order(const Visit& visit) {
  std::vector<Contact> contacts;
  visit([&](const Contact& c) {
    contacts.push_back(c);
    return true;
  });
  std::sort(contacts.begin(), contacts.end());
  return contacts;
}

// Blocks that are looked at by boxes, and those that are asked for again.
TEST(ContactsInOrder, NarrowAndWideBlocks) {
  constexpr std::uint32_t size = 9000;
  const Segments segments = some_segments(size, 0.02, 3);
  const Discs circles = some_circles(size, 0.01, 4);
  std::vector<std::uint32_t> groups;
  for (std::uint32_t i = 0; i < size; ++i) groups.push_back(i % 7);
  int narrow = 0, wide = 0;
  for (const Block block : {Block{0, 0}, Block{0, 1}, Block{3000, 3500}, Block{size - 2, size}, Block{1, size},
                            Block{500, 8500}, Block{0, size}}) {
    ++(is_narrow(block, size) ? narrow : wide);
    const SetOptions of_segments{Allowed::shared_endpoint, groups};
    const auto found = in_order<SegmentsContact>([&](const SegmentsVisitor& visit) {
      segments_visit_block(segments, of_segments, block, segments_all_by_grid, visit);
    });
    auto expected = in_order<SegmentsContact>(
        [&](const SegmentsVisitor& visit) { segments_all_by_grid(segments, of_segments, visit); });
    EXPECT_GT(expected.size(), 100u);
    std::erase_if(expected, [&](const SegmentsContact& c) { return !block.holds(c.i); });
    EXPECT_EQ(found, expected);

    const SetOptions of_circles{Allowed::touch, groups};
    const auto found_discs = in_order<DiscsContact>(
        [&](const DiscsVisitor& visit) { discs_visit_block(circles, of_circles, block, discs_all_by_grid, visit); });
    auto expected_discs =
        in_order<DiscsContact>([&](const DiscsVisitor& visit) { discs_all_by_grid(circles, of_circles, visit); });
    EXPECT_GT(expected_discs.size(), 100u);
    std::erase_if(expected_discs, [&](const DiscsContact& c) { return !block.holds(c.i); });
    EXPECT_EQ(found_discs, expected_discs);
  }
  EXPECT_EQ(narrow, 4);
  EXPECT_EQ(wide, 3);
}

}  // namespace
}  // namespace sunder::planar
