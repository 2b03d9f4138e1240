// A file of lines under construction. For readers of lines; users of files ask lines.h.
#pragma once

#include <sunder/io/lines.h>
#include <sunder/io/text.h>

#include <fmt/format.h>

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace sunder::io {

// By what segments are grouped; field: a column or property of the file.
enum class GroupBy { nothing, feature, ring, field };

// Of LineOptions::group.
inline GroupBy by_name(std::string_view group) {
  if (group.empty()) return GroupBy::nothing;
  return group == "feature" ? GroupBy::feature : group == "ring" ? GroupBy::ring : GroupBy::field;
}

// Adds lines and rings to the file under construction. `place` and `options` must outlive it.
class LineBuilder {
 public:
  LineBuilder(std::string_view place, const LineOptions& options) : place_(place), options_(options) {}

  std::string_view place() const { return place_; }
  const LineOptions& options() const { return options_; }

  void group_by(GroupBy by) { group_by_ = by; }
  void group_by_feature_or_ring() {
    group_by_ = by_name(options_.group);
    if (group_by_ == GroupBy::field) fail_group(place_, options_.group, "feature, ring");
  }

  void begin_feature(std::string name, std::uint32_t line) {
    if (file.features.size() == std::numeric_limits<std::uint32_t>::max()) fail("has too many features; split it");
    line_ = line;
    lines_ = polygons_of_feature_ = 0;
    file.features.push_back(name.empty() ? std::to_string(file.features.size() + 1) : std::move(name));
    if (group_by_ == GroupBy::feature) begin_group(file.features.back());
  }

  void at_line(std::uint32_t line) { line_ = line; }

  // The field's value for what comes now; to be told for each feature where a field groups.
  void group_value(const std::string& value) {
    const auto [known, is_new] = groups_.try_emplace(value, static_cast<std::uint32_t>(file.groups.size()));
    if (is_new) file.groups.push_back(one_line(value));
    group_ = known->second;
  }

  void add(const Point2& a, const Point2& b) {
    file.segments.push_back({a, b});
    file.source.push_back({static_cast<std::uint32_t>(file.features.size() - 1), line_});
    if (group_by_ != GroupBy::nothing) file.group.push_back(group_);
  }

  // several: it is one of a list of polygons.
  void begin_polygon(bool several = false) {
    ++polygons_;
    ++polygons_of_feature_;
    rings_ = 0;
    several_ = several || polygons_of_feature_ > 1;
  }

  // Until the ring is added, errors name it.
  void begin_ring() {
    ++rings_;
    in_ring_ = true;
  }

  void add_line(const std::vector<Point2>& points) {
    if (points.size() < 2) fail("a line has fewer than two points; leave it out");
    if (group_by_ == GroupBy::ring) begin_group(fmt::format("{}, line {}", file.features.back(), lines_));
    ++lines_;
    for (std::size_t i = 1; i < points.size(); ++i) add(points[i - 1], points[i]);
  }

  void add_point(const std::vector<Point2>& points) {
    if (points.size() != 1) fail(fmt::format("a point has {} positions; give one", points.size()));
    add(points[0], points[0]);
  }

  void add_ring(const std::vector<Point2>& points) {
    const bool closed = points.size() > 1 && points.front() == points.back();
    if (points.size() - (closed ? 1 : 0) < 3) {
      fail("fewer than three different corners; give at least three, and the first again");
    }
    if (!closed) fail("does not end where it began; repeat its first point at its end");
    if (group_by_ == GroupBy::ring) begin_group(fmt::format("{}, {}", file.features.back(), ring_name()));
    file.rings.push_back({static_cast<std::uint32_t>(file.segments.size()),
                          static_cast<std::uint32_t>(points.size() - 1), polygons_ - 1});
    for (std::size_t i = 1; i < points.size(); ++i) add(points[i - 1], points[i]);
    in_ring_ = false;
  }

  [[noreturn]] void fail(const std::string& what) const {
    const std::string text = in_ring_ ? fmt::format("{}: {}", ring_name(), what) : what;
    if (line_ > 0) fail_line(place_, line_, text);
    fail_file(place_, file.features.empty() ? text : fmt::format("feature {}: {}", quote(file.features.back()), text));
  }

  double number(std::string_view word) const {
    double value = 0;
    if (const char* problem = parse_number(word, value)) fail(fmt::format("{} {}", quote(word), problem));
    return value;
  }

  void check_dimension(std::size_t numbers) const {
    if (numbers > 2 && !options_.drop_z) fail("has a third coordinate; to ignore it, give --drop-z");
  }

  LineFile file;

 private:
  void begin_group(std::string name) {
    group_ = static_cast<std::uint32_t>(file.groups.size());
    file.groups.push_back(std::move(name));
  }

  std::string ring_name() const {
    const std::string ring = fmt::format("ring {}", rings_ - 1);
    return several_ ? fmt::format("polygon {}, {}", polygons_of_feature_ - 1, ring) : ring;
  }

  std::string_view place_;
  const LineOptions& options_;
  GroupBy group_by_ = GroupBy::nothing;
  std::uint32_t line_ = 0, group_ = 0;
  std::uint32_t lines_ = 0, polygons_ = 0, polygons_of_feature_ = 0, rings_ = 0;  // so far; rings: of the polygon
  bool several_ = false, in_ring_ = false;
  std::unordered_map<std::string, std::uint32_t> groups_;  // by value
};

}  // namespace sunder::io
