#include <sunder/io/mesh/plane_text.h>
#include <sunder/io/mesh/section_text.h>

#include <gtest/gtest.h>

namespace sunder::io {
namespace {

TEST(PlaneTextTest, OnePlane) {
  const PlaneStack z = parse_planes("z=0.5", "--plane");
  EXPECT_EQ(z.plane, solid::Plane::at({0, 0, 1}, 0));
  EXPECT_EQ(z.offsets, std::vector<double>{0.5});
  EXPECT_EQ(z.name, "z");
  const PlaneStack any = parse_planes(" 1,-2,3,1e300 ", "--plane");
  EXPECT_EQ(any.plane.normal, (Point3{1, -2, 3}));
  EXPECT_EQ(any.offsets, std::vector<double>{1e300});
}

// Each is the double nearest to its decimal: three times 0.1 is not 0.3.
TEST(PlaneTextTest, StacksAreDecimals) {
  const PlaneStack stack = parse_planes("x=-0.1:0.3:0.1", "--plane");
  EXPECT_EQ(stack.offsets, (std::vector<double>{-0.1, 0, 0.1, 0.2, 0.3}));
  EXPECT_EQ(parse_planes("z=0:1:0.01", "").offsets.size(), 101u);
  EXPECT_EQ(parse_planes("z=0:1:0.01", "").offsets[29], 0.29);
  EXPECT_EQ(parse_planes("0,0,2,0:1:0.3", "").offsets, (std::vector<double>{0, 0.3, 0.6, 0.9}));
  EXPECT_EQ(parse_planes("y=2:2:1", "").offsets, std::vector<double>{2});
}

TEST(PlaneTextTest, BadTexts) {
  for (const char* text : {"",
                           "z",
                           "z=",
                           "w=1",
                           "z=1,2",
                           "1,2,3",
                           "1,2,x,4",
                           "z=nan",
                           "z=0:1",
                           "z=0:1:0",
                           "z=0:1:-1",
                           "z=1:0:1",
                           "z=0:1:0.0000001",
                           "z=0:1e3:1",
                           "z=::",
                           "z=0:1:1:1",
                           "z=0:9999999999:0.000001",
                           "0,0,0,1",
                           "1,2,3,4,5",
                           "z=0:-:1",
                           "z=0:1:0.1234567890123456"}) {
    EXPECT_THROW((void)parse_planes(text, "--plane"), Error) << text;
  }
}

TEST(SectionTextTest, EachKindInEachFormat) {
  const std::vector<SectionText> sections{{"z = 0", {}},
                                          {"z = 1", {{0, 0, 1}}},
                                          {"z = 2", {{0, 0.5, 2}, {1, 0, 2}}},
                                          {"z = 3", {{0, -0.0, 3}, {1, 0, 3}, {0.25, 1, 3}}}};
  EXPECT_EQ(to_text(SectionFormat::obj, sections),
            "o z = 1\nv 0 0 1\np 1\n"
            "o z = 2\nv 0 0.5 2\nv 1 0 2\nl 2 3\n"
            "o z = 3\nv 0 0 3\nv 1 0 3\nv 0.25 1 3\nf 4 5 6\n");
  EXPECT_EQ(to_text(SectionFormat::wkt, sections),
            "POLYGON Z EMPTY\nPOINT Z (0 0 1)\nLINESTRING Z (0 0.5 2, 1 0 2)\n"
            "POLYGON Z ((0 0 3, 1 0 3, 0.25 1 3, 0 0 3))\n");
  EXPECT_EQ(section_format_of_name("A.OBJ"), SectionFormat::obj);
  EXPECT_THROW((void)section_format_of_name("a.stl"), Error);
}

}  // namespace
}  // namespace sunder::io
