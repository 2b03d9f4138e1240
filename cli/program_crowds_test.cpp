// Sets of polygons where boxes tell little, by the program: no time or memory that grows with the square of their
// number. Counted probes are bounded by tests/polygon_sets_complexity_test.cpp.
#include <tests/support/program.h>

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>

namespace sunder::tests {
namespace {

std::string polygon(const std::string& rings) { return "POLYGON (" + rings + ")\n"; }
std::string point(double x, double y) { return std::to_string(x) + " " + std::to_string(y); }

std::string square(double d) {
  return "(" + point(-d, -d) + ", " + point(d, -d) + ", " + point(d, d) + ", " + point(-d, d) + ", " + point(-d, -d) +
         ")";
}

// The address sanitizer takes address space of its own.
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define SUNDER_ADDRESS_SANITIZER
#endif
#endif
#if !defined(SUNDER_ADDRESS_SANITIZER) && !defined(__SANITIZE_ADDRESS__)
// Slices about one point, of which neighbours share a side.
std::string pie(int count) {
  const auto rim = [=](int k) {
    const double angle = 2 * std::numbers::pi * (k % count) / count;
    return point(1000 * std::cos(angle), 1000 * std::sin(angle));
  };
  std::string text;
  for (int k = 0; k < count; ++k) text += polygon("(0 0, " + rim(k) + ", " + rim(k + 1) + ", 0 0)");
  return text;
}

TEST_F(Program, APieOfTenThousandIsCountedIn64MiB) {
  write_text(in_folder("pie.wkt"), pie(10000));
  const std::string command = "ulimit -v 65536; '" + program() + "' polygons '" + in_folder("pie.wkt") +
                              "' --allow touch --count > '" + in_folder("out") + "'";
  EXPECT_EQ(std::system(command.c_str()), 0);  // none meet
  EXPECT_NE(read_text(in_folder("out")).find("none meet (touch allowed)"), std::string::npos);
}
#endif

// Frames around one another: none meets another, whatever is asked.
TEST_F(Program, FramesTakeNearLinearTime) {
  std::string frames;
  for (int k = 1; k <= 4000; ++k) frames += polygon(square(k) + ", " + square(k - 0.5));
  write_text(in_folder("frames.wkt"), frames);
  const double edges = 8 * 4000, most = 10 * edges * std::log2(edges);
  for (const std::string rule : {"nothing", "shared-endpoint", "touch"}) {
    for (const std::string question : {"--any", "--all", "--count"}) {
      const json report = this->report("polygons " + in_folder("frames.wkt") + " --allow " + rule + " " + question, 0);
      EXPECT_LE(report["cost"]["probes"].get<double>(), most) << rule << " " << question;
    }
  }
}

}  // namespace
}  // namespace sunder::tests
