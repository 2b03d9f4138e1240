#include <sunder/picture/density.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace sunder::picture {

namespace {

constexpr double pixel_side = 5;  // pixels
constexpr std::array shades{0.2, 0.35, 0.5, 0.7, 0.9};

}  // namespace

Density::Density(double width, double height)
    : columns_(static_cast<std::size_t>(width / pixel_side) + 1),
      rows_(static_cast<std::size_t>(height / pixel_side) + 1),
      count_(columns_ * rows_) {}

void Density::add(const Point2& pixel) {
  const double column = std::floor(pixel.x / pixel_side), row = std::floor(pixel.y / pixel_side);
  if (!(column >= 0 && row >= 0)) return;
  if (!(column < static_cast<double>(columns_) && row < static_cast<double>(rows_))) return;
  ++count_[static_cast<std::size_t>(row) * columns_ + static_cast<std::size_t>(column)];
}

void Density::add(const Point2& from, const Point2& to) {
  const double steps = std::ceil(std::max({std::fabs(to.x - from.x), std::fabs(to.y - from.y), 1.0}) / pixel_side);
  for (std::uint32_t k = 0; k < steps; ++k) {
    const double t = (k + 0.5) / steps;
    add({from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)});
  }
}

std::uint32_t Density::most() const { return *std::max_element(count_.begin(), count_.end()); }

std::string Density::xml(std::string_view attributes) const {
  // The logarithm decides: a crowd does not make all the rest pale.
  const double scale = std::max(std::log(static_cast<double>(most())), 1.0) / static_cast<double>(shades.size());
  std::array<std::string, shades.size()> data;
  for (std::size_t k = 0; k < count_.size(); ++k) {
    if (count_[k] == 0) continue;
    const std::size_t row = k / columns_, column = k % columns_;
    const auto shade = static_cast<std::size_t>(std::log(static_cast<double>(count_[k])) / scale);
    fmt::format_to(std::back_inserter(data.at(std::min(shade, shades.size() - 1))), "M{:.0f} {:.1f}h{:.0f}",
                   static_cast<double>(column) * pixel_side, (static_cast<double>(row) + 0.5) * pixel_side, pixel_side);
  }
  std::string text;
  for (std::size_t s = 0; s < shades.size(); ++s) {
    if (data.at(s).empty()) continue;
    text += fmt::format("<path {} fill='none' stroke-width='{:.0f}' stroke-opacity='{}' d='{}'/>\n", attributes,
                        pixel_side, shades.at(s), data.at(s));
  }
  return text;
}

}  // namespace sunder::picture
