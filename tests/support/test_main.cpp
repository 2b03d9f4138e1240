// The main function of every test executable. Besides GoogleTest's own options it takes --file=NAME: only the tests of
// the source NAME.cpp are run, so that a CTest entry is one file though an executable holds many. A file without tests,
// or a run that selects none, is a failure.
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>

namespace {

// A filter of GoogleTest that names every test of the file.
std::string tests_of_file(std::string_view file) {
  std::string names;
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  for (int s = 0; s < all.total_test_suite_count(); ++s) {
    const testing::TestSuite& suite = *all.GetTestSuite(s);
    for (int t = 0; t < suite.total_test_count(); ++t) {
      const testing::TestInfo& test = *suite.GetTestInfo(t);
      if (std::filesystem::path(test.file()).stem() != file) continue;
      names += (names.empty() ? "" : ":") + std::string(suite.name()) + "." + test.name();
    }
  }
  return names;
}

}  // namespace

int main(int count, char** words) {
  testing::InitGoogleTest(&count, words);
  constexpr std::string_view option = "--file=";
  std::string& filter = testing::GTEST_FLAG(filter);
  for (int k = 1; k < count; ++k) {
    const std::string_view word = words[k];
    const bool is_file = word.substr(0, option.size()) == option;
    const std::string names = is_file ? tests_of_file(word.substr(option.size())) : "";
    if (names.empty()) {
      std::fprintf(stderr, "%s: %s\n", words[k], is_file ? "no test is of this file" : "is no option");
      return 2;
    }
    const std::size_t dash = filter.find('-');  // what the environment leaves out stays out
    filter = names + (dash == std::string::npos ? "" : filter.substr(dash));
  }
  return RUN_ALL_TESTS();
}
