#include <sunder/polytope/object/polytope.h>

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace sunder::polytope {
namespace {

template <class Make>
std::string error_of(ErrorCode code, const Make& make) {
  try {
    make();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code);
    return error.what();
  }
  return "none";
}

TEST(Polytope, KeepsItsRowsAndColumns) {
  std::vector<double> numbers;
  for (int k = 0; k < 3 * 40; ++k) numbers.push_back(k % 2 == 0 ? k : -k);
  const Polytope p = Polytope::from_points(3, numbers);
  EXPECT_TRUE(p.is_of_points());
  EXPECT_EQ(p.size(), 40u);
  EXPECT_EQ(p.dimension(), 3u);
  const PointColumns& columns = p.columns();
  EXPECT_EQ(columns.stride, 64u);
  for (std::uint32_t k = 0; k < 64; ++k) {
    for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(columns.at(k, c), numbers[3 * std::min(k, 39u) + c]);
  }
  EXPECT_EQ(columns.reach[2], 119);
  const Polytope copy = p;  // shares the columns
  EXPECT_EQ(copy.columns().column, columns.column);
}

TEST(Polytope, HalfSpacesMayBeNone) {
  EXPECT_EQ(Polytope::from_half_spaces(4, {}).size(), 0u);
  const Polytope p = Polytope::from_half_spaces(2, {1, 0, 3, 0, 0, -1});
  EXPECT_EQ(p.size(), 2u);
  EXPECT_EQ(p.row(1)[2], -1);
  EXPECT_EQ(p.columns().dimension, 3u);
}

TEST(Polytope, RefusesWhatIsNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(error_of(ErrorCode::bad_shape, [] { Polytope::from_points(1, {1}); }),
            "points of dimension 1; give a dimension from 2 to 6");
  EXPECT_EQ(error_of(ErrorCode::bad_shape, [] { Polytope::from_half_spaces(7, {}); }),
            "half-spaces of dimension 7; give a dimension from 2 to 6");
  EXPECT_EQ(error_of(ErrorCode::bad_shape, [] { Polytope::from_points(2, {}); }), "no points; give one at least");
  EXPECT_EQ(error_of(ErrorCode::bad_shape, [] { Polytope::from_points(2, {1, 2, 3}); }),
            "3 numbers are no whole number of points; give 2 each");
  EXPECT_EQ(error_of(ErrorCode::bad_value, [&] { Polytope::from_points(2, {1, 2, 3, nan}); }),
            "point 1: a number that is not finite; give finite doubles");
}

}  // namespace
}  // namespace sunder::polytope
