// Polygons of a file: those that are valid, those that are skipped or mended, and what is told of them.
#include <sunder/io/plane/polygons.h>
#include <sunder/io/text/file.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <initializer_list>
#include <string>

namespace sunder::io {
namespace {

class Polygons : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(file_); }

  PolygonsRequest request(std::initializer_list<const char*> lines) const {
    std::string text;
    for (const char* const line : lines) text += line;
    write_file_atomically(file_, text);
    PolygonsRequest request;
    request.files = {file_};
    request.rule = planar::PolygonRule::valid;
    return request;
  }

  std::string file_ = testing::TempDir() + "polygons_test.wkt";
};

constexpr const char *triangle_wkt = "POLYGON ((0 0, 1 0, 1 1, 0 0))\n", *open_wkt = "POLYGON ((0 0, 1 0, 1 1))\n",
                     *hourglass_wkt = "POLYGON ((0 0, 4 4, 4 0, 0 4, 0 0))\n",
                     *two_parts_wkt = "MULTIPOLYGON (((0 0, 1 0, 1 1, 0 0)), ((5 0, 6 0, 6 1, 5 0)))\n";

std::string polygons_refusal(const PolygonsRequest& request) {
  try {
    static_cast<void>(read_polygons(request));
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST_F(Polygons, AFeatureIsOneOrEachPartIs) {
  PolygonsRequest asked = request({triangle_wkt, two_parts_wkt});
  const PolygonsInput input = read_polygons(asked);
  ASSERT_EQ(input.polygons.size(), 2u);
  EXPECT_EQ(input.source[1].feature, 1u);
  EXPECT_EQ(input.source[1].part_of_ring, (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(input.edges(), 9u);
  EXPECT_EQ(input.left_out_words(), "");
  asked.by_part = true;
  EXPECT_EQ(read_polygons(asked).polygons.size(), 3u);
}

TEST_F(Polygons, WhatIsNotValidIsRefusedOrSkipped) {
  PolygonsRequest asked = request({hourglass_wkt, triangle_wkt});
  EXPECT_NE(polygons_refusal(asked).find(
                "feature 1: is not valid: ring 0 crosses itself at about (2, 2): edges 0 and 2; mend"),
            std::string::npos)
      << polygons_refusal(asked);
  asked.skip_invalid = true;
  const PolygonsInput input = read_polygons(asked);
  EXPECT_EQ(input.polygons.size(), 1u);
  ASSERT_EQ(input.skipped.size(), 1u);
  EXPECT_EQ(input.skipped[0].line, 1u);
  EXPECT_EQ(input.left_out_words(), "skipped: 1 invalid feature");
  EXPECT_EQ(input.origin().left_out, std::vector<std::string>{"skipped: 1 invalid feature"});
  asked.files = {request({hourglass_wkt}).files[0]};
  EXPECT_NE(polygons_refusal(asked).find("no polygon is valid"), std::string::npos) << polygons_refusal(asked);
}

TEST_F(Polygons, WhatIsMendedIsTold) {
  PolygonsRequest asked = request({triangle_wkt, open_wkt});
  EXPECT_NE(polygons_refusal(asked).find("feature 2: is not valid"), std::string::npos) << polygons_refusal(asked);
  asked.mend = true;
  const PolygonsInput input = read_polygons(asked);
  EXPECT_EQ(input.polygons.size(), 2u);
  ASSERT_EQ(input.mended.size(), 1u);
  EXPECT_EQ(input.mended[0].feature, 1u);
  EXPECT_EQ(input.mended[0].changes.closed, 1u);
  EXPECT_EQ(input.origin().left_out, std::vector<std::string>{"mended: 1 feature"});
}

}  // namespace
}  // namespace sunder::io
