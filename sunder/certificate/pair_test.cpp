// Certificates are plain data: what a default one holds, and what copying one means.
#include <sunder/certificate/pair.h>

#include <gtest/gtest.h>

#include <type_traits>
#include <utility>

namespace sunder {
namespace {

TEST(PairCertificateTest, IsSmallPlainData) {
  static_assert(std::is_nothrow_default_constructible_v<PairCertificate>);
  static_assert(std::is_nothrow_copy_constructible_v<Separation> && std::is_nothrow_copy_assignable_v<Separation>);
  static_assert(std::is_trivially_copyable_v<CommonVertices>);
  static_assert(std::is_nothrow_move_constructible_v<PairCertificate>);
  static_assert(std::is_nothrow_move_assignable_v<PairCertificate>);
  static_assert(sizeof(PairCertificate) <= 128, "two cache lines");
}

TEST(PairCertificateTest, ADefaultOneStatesNothingThatHolds) {
  const PairCertificate c;
  EXPECT_EQ(verdict_of(c), Verdict::apart);
  const auto& [direction, extreme_a, extreme_b] = std::get<Separation>(c);
  EXPECT_EQ(direction.kind, Direction::Kind::given);
  EXPECT_EQ(direction.given, Point3());  // along which nothing is strictly apart
  EXPECT_FALSE(direction.reversed);
  EXPECT_EQ(direction.numbers, nullptr);
  EXPECT_EQ(extreme_a + extreme_b, 0u);
}

TEST(PairCertificateTest, TheVerdictIsThatOfWhatIsHeld) {
  EXPECT_EQ(verdict_of(PairCertificate(Separation{})), Verdict::apart);
  EXPECT_EQ(verdict_of(PairCertificate(CommonVertices{})), Verdict::meet);
}

TEST(PairCertificateTest, CopiesShareTheExactNumbers) {
  Separation c;
  c.direction.kind = Direction::Kind::exact;
  c.direction.numbers =
      std::make_shared<const std::array<Dyadic, 3>>(std::array<Dyadic, 3>{1.0, -0.5, Dyadic(7.0).scaled(-2000)});
  Separation copy = c;
  EXPECT_EQ(copy.direction.numbers.get(), c.direction.numbers.get());
  const Separation moved = std::move(copy);
  copy = {};
  c = {};
  ASSERT_NE(moved.direction.numbers, nullptr);
  EXPECT_TRUE((*moved.direction.numbers)[2] == Dyadic(7.0).scaled(-2000));
}

}  // namespace
}  // namespace sunder
