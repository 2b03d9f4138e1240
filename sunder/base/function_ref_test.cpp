#include <sunder/base/function_ref.h>

#include <gtest/gtest.h>

#include <type_traits>

namespace sunder {
namespace {

int twice(FunctionRef<int(int)> f, int x) { return f(f(x)); }

TEST(FunctionRef, CallsWhatItRefersTo) {
  int calls = 0;
  const auto add = [&](int x) { return ++calls, x + 3; };
  EXPECT_EQ(twice(add, 1), 7);
  EXPECT_EQ(calls, 2);
  EXPECT_EQ(twice([](int x) { return x * x; }, 3), 81);
}

TEST(FunctionRef, PassesReferencesAsTheyAre) {
  const auto add = [](int& x, int&& y) -> int& { return x += y; };
  const FunctionRef<int&(int&, int&&)> f(add);
  int x = 1;
  EXPECT_EQ(&f(x, 2), &x);
  EXPECT_EQ(x, 3);
}

TEST(FunctionRef, OfAnotherRefersToTheSameFunction) {
  const auto one = [](int) { return 1; };
  const auto two = [](int) { return 2; };
  FunctionRef<int(int)> f = one;
  const FunctionRef<int(int)> g = f;
  f = two;
  EXPECT_EQ(f(0), 2);
  EXPECT_EQ(g(0), 1);
}

static_assert(!std::is_constructible_v<FunctionRef<int(int)>, int>);
static_assert(!std::is_constructible_v<FunctionRef<int(int)>, int (&)(const char*)>);

}  // namespace
}  // namespace sunder
