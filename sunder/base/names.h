// The names of an enumeration's values, as a table.
#pragma once

#include <cstddef>
#include <string_view>

namespace sunder {

// The name of a value whose enumeration counts from 0 to `last`, for which names has one each, in that order.
template <auto last, std::size_t count>
constexpr std::string_view name_in(const std::string_view (&names)[count], decltype(last) value) noexcept {
  static_assert(count == static_cast<std::size_t>(last) + 1, "a name for each value");
  const auto number = static_cast<std::size_t>(value);
  return number < count ? names[number] : std::string_view();
}

}  // namespace sunder
