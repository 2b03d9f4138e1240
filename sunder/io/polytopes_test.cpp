#include <sunder/io/polytopes.h>

#include <gtest/gtest.h>

#include <string>

namespace sunder::io {
namespace {

std::string error_of(std::string_view text) {
  try {
    static_cast<void>(parse_polytope(text, "f.csv"));
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_file);
    return error.what();
  }
  return "none";
}

TEST(Polytopes, PointsWithAndWithoutNames) {
  const auto named = parse_polytope("X1;x2;x3;x4\n1;2;3;4\n\n5;6;7;8e-1\n", "");
  EXPECT_TRUE(named.is_of_points());
  EXPECT_EQ(named.dimension(), 4u);
  EXPECT_EQ(named.size(), 2u);
  EXPECT_EQ(named.row(1)[3], 0.8);
  EXPECT_EQ(parse_polytope("1,2,3,4,5\n", "").dimension(), 5u);
}

TEST(Polytopes, HalfSpaces) {
  const auto given = parse_polytope("a1,a2,a3,b\n1,0,0,0.5\n", "");
  EXPECT_FALSE(given.is_of_points());
  EXPECT_EQ(given.dimension(), 3u);
  EXPECT_EQ(given.row(0)[3], 0.5);
  EXPECT_EQ(parse_polytope("a1,a2,b\n", "").size(), 0u);  // everything
}

TEST(Polytopes, RefusesWhatIsNone) {
  EXPECT_EQ(error_of("1,2,3,4\n1,2,3\n"), "f.csv:2: has 3 numbers, others have 4; give rows of one dimension");
  EXPECT_EQ(error_of("1\n"), "f.csv:1: is a point of dimension 1; give points of dimension 2 to 6");
  EXPECT_EQ(error_of("1,2,3,4,5,6,7\n"), "f.csv:1: is a point of dimension 7; give points of dimension 2 to 6");
  EXPECT_EQ(error_of("x1,x3\n1,2\n"),
            "f.csv:1: has names that are neither x1,..,xd nor a1,..,ad,b; name the columns so, for a d from 2 to 6");
  EXPECT_EQ(error_of("x1,x2\n"),
            "f.csv: has no points; give lines x1,..,xd, or name the columns of half-spaces a1,..,ad,b");
  EXPECT_NE(error_of("1,2\n1,nan\n").find("f.csv:2: 'nan' is NaN"), std::string::npos);
  EXPECT_NE(error_of("1,2\n1,\n").find("f.csv:2: "), std::string::npos);
}

}  // namespace
}  // namespace sunder::io
