// A file of lines under construction. For readers of lines; users of files ask lines.h.
#pragma once

#include <sunder/io/plane/lines.h>
#include <sunder/io/text/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
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
    line_ = at_line_ = line;
    lines_ = polygons_of_feature_ = 0;
    in_ring_ = false;
    file.features.push_back(name.empty() ? std::to_string(file.features.size() + 1) : std::move(name));
    file.system.push_back(no_system);
    if (group_by_ == GroupBy::feature) begin_group(file.features.back());
  }

  // The values of the fields that are asked for; to be told for each feature where there are some.
  void property_values(PropertyValues values) { file.properties.push_back(std::move(values)); }

  // For messages; segments have the line on which their feature begins.
  void at_line(std::uint32_t line) { at_line_ = line; }

  // That of the feature; it may be told again, and then holds.
  void system(const CoordinateSystem& system) {
    if (!system.declared()) return;
    const auto [found, is_new] = systems_.try_emplace(system.id, static_cast<std::uint32_t>(file.systems.size()));
    if (is_new) file.systems.push_back({system, owner()});
    file.system.back() = found->second;
  }

  // To be called at the end: the system of features that declare none; owner of the first of them as above.
  void rest_in(const CoordinateSystem& system) {
    const auto first = std::find(file.system.begin(), file.system.end(), no_system);
    if (first == file.system.end()) return;
    const auto feature = static_cast<std::size_t>(first - file.system.begin());
    const auto [found, is_new] = systems_.try_emplace(system.id, static_cast<std::uint32_t>(file.systems.size()));
    if (is_new) file.systems.push_back({system, fmt::format("feature {}", quote(file.features[feature]))});
    std::replace(first, file.system.end(), no_system, found->second);
  }

  // Something of another kind: "point", "line".
  void leave_out(const std::string& kind) {
    if (!options_.leave_out) {
      fail(fmt::format("{} is not what is asked about; give a file without such, or ask without them: --leave-out",
                       kind.starts_with('a') ? "an " + kind : "a " + kind));
    }
    file.left_out.push_back({kind, owner(), 1});
  }

  // A geometry, or a part of one, that holds nothing.
  void add_nothing() {
    if (empty_++ == 0) first_empty_ = owner();
  }

  // A ring that holds nothing: a hole that is none; or an outer ring, behind which nothing may follow.
  void add_empty_ring() {
    if (rings_ == 0) {
      is_hollow_ = true;
      return add_nothing();
    }
    if (empty_rings_++ == 0) first_empty_ring_ = owner();
  }

  // To be called at the end.
  void tell_of_nothing() {
    if (empty_rings_ > 0) {
      file.remarks.push_back(
          fmt::format("holes that are empty: {}, the first of {}; they hold nothing", empty_rings_, first_empty_ring_));
    }
    if (empty_ == 0) return;
    file.remarks.push_back(
        fmt::format("geometries that are null or empty: {}, the first of {}; they hold nothing", empty_, first_empty_));
  }

  // The field's value for what comes now; to be told for each feature where a field groups.
  void group_value(std::string value) {
    next_group_ = std::move(value);
    value_groups_ = true;
  }

  void add(const Point2& a, const Point2& b) {
    file.segments.push_back({a, b});
    file.source.push_back({static_cast<std::uint32_t>(file.features.size() - 1), line_});
    if (group_by_ == GroupBy::nothing) return;
    if (next_group_) enter_group();
    file.group.push_back(group_);
  }

  // several: it is one of a list of polygons.
  void begin_polygon(bool several = false) {
    ++polygons_;
    ++polygons_of_feature_;
    rings_ = 0;
    is_hollow_ = false;
    several_ = several || polygons_of_feature_ > 1;
  }

  // Until the ring is added, errors name it.
  void begin_ring() {
    if (is_hollow_) fail("the outer ring is empty, and a hole follows; give the outer ring, or leave the polygon out");
    ++rings_;
    in_ring_ = true;
  }

  void add_line(const std::vector<Point2>& points) {
    if (!options_.lines) return leave_out("line");
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
    const std::size_t corners = points.size() - (closed ? 1 : 0);
    if (group_by_ == GroupBy::ring) begin_group(fmt::format("{}, {}", file.features.back(), ring_name()));
    if (corners < 3 || !closed) {
      const std::string what = corners < 3
                                   ? "fewer than three different corners; give at least three, and the first again"
                                   : "does not end where it began; repeat its first point at its end";
      if (!options_.keep_broken) fail(what);
      const auto feature = static_cast<std::uint32_t>(file.features.size() - 1);
      if (next_group_) enter_group();
      const std::size_t end = what.find("; ");
      file.broken.push_back({feature, fmt::format("{}: {}", ring_name(), what.substr(0, end)), points,
                             static_cast<std::uint32_t>(file.rings.size()), polygons_ - 1, group_, line_,
                             what.substr(end + 2), corners >= 3});
      in_ring_ = false;
      return;
    }
    file.rings.push_back({static_cast<std::uint32_t>(file.segments.size()),
                          static_cast<std::uint32_t>(points.size() - 1), polygons_ - 1});
    for (std::size_t i = 1; i < points.size(); ++i) add(points[i - 1], points[i]);
    in_ring_ = false;
  }

  [[noreturn]] void fail(const std::string& what) const {
    const std::string text = in_ring_ ? fmt::format("{}: {}", ring_name(), what) : what;
    if (at_line_ > 0) fail_line(place_, at_line_, text);
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
  static constexpr std::uint32_t no_system = std::numeric_limits<std::uint32_t>::max();

  void begin_group(std::string name) {
    next_group_ = std::move(name);
    value_groups_ = false;
  }

  // With the first segment, so that each group has one.
  void enter_group() {
    group_ = static_cast<std::uint32_t>(file.groups.size());
    bool is_new = true;
    if (value_groups_) {
      const auto found = groups_.try_emplace(*next_group_, group_);
      group_ = found.first->second;
      is_new = found.second;
    }
    if (is_new) file.groups.push_back(one_line(*next_group_));
    next_group_.reset();
  }

  std::string owner() const { return line_ > 0 ? fmt::format("line {}", line_) : quote(file.features.back()); }

  std::string ring_name() const {
    const std::string ring = fmt::format("ring {}", rings_ - 1);
    return several_ ? fmt::format("polygon {}, {}", polygons_of_feature_ - 1, ring) : ring;
  }

  std::string_view place_;
  const LineOptions& options_;
  GroupBy group_by_ = GroupBy::nothing;
  std::uint32_t line_ = 0, at_line_ = 0, group_ = 0;                              // line_: on which the feature begins
  std::uint32_t lines_ = 0, polygons_ = 0, polygons_of_feature_ = 0, rings_ = 0;  // so far; rings: of the polygon
  bool several_ = false, in_ring_ = false, is_hollow_ = false;
  std::uint64_t empty_ = 0, empty_rings_ = 0;
  std::string first_empty_, first_empty_ring_;
  std::optional<std::string> next_group_;                            // of what comes now, until its first segment
  bool value_groups_ = false;                                        // is it a value, which may have come before?
  std::unordered_map<std::string, std::uint32_t> groups_, systems_;  // by value; by id
};

}  // namespace sunder::io
