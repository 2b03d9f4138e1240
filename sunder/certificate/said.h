// What somebody says that the entries of a certificate file are made of: docs/claims.md, "Said". Nothing of it is
// proved; checkers print it as said. Texts are cut as of cut_text (claims.h).
// Each throws only std::bad_alloc. Cost: linear in the texts.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sunder {

// What entries are made of, and then what has become of that, step by step:
// Said::all(Said::Source::vertices, 0).scaled(by).hull(). At most seven steps.
class Said {
 public:
  enum class Source : std::uint8_t {
    vertices,
    triangles,
    points,
    half_spaces,
    lines,
    centre_lines,  // of the tracks of a board
    polygons,
    circles,
    boxes,
    half_planes,
    shape,  // such as a cylinder of a robot file
  };

  Said() = default;

  // All of an input, by its index in the file's inputs; of a part of it, by its name; without what is left out of it.
  static Said all(Source what, std::size_t input, std::string_view part = "",
                  const std::vector<std::string>& without = {});
  // What the call gives, such as "--line 0,0,1,1".
  static Said given(std::string_view text);

  Said hull() const;  // replaced by its convex hull
  Said scaled(std::span<const double> by) const;
  Said unit(std::string_view name) const;                         // its numbers are in this unit
  Said projected(const std::array<double, 9>& origin_u_v) const;  // onto a frame
  Said dropped(std::string_view axis) const;                      // without this coordinate
  Said with_radius() const;                                       // which is given beside it
  Said mended(const std::vector<std::string>& changes) const;     // such as "2 rings closed"
  Said in_system(std::string_view system) const;                  // of coordinates

  bool empty() const { return json_.empty(); }
  const std::string& json() const { return json_; }

 private:
  explicit Said(std::string json) : json_(std::move(json)) {}
  Said step(std::string_view kind, const std::string& members) const;

  std::string json_;
};

// What is said of a statement.
class SaidNote {
 public:
  // The joint values that bodies are placed by, one at least; in which row of which input they stand, if they do.
  static SaidNote joint_values(const std::vector<std::pair<std::string, double>>& values,
                               std::optional<std::size_t> row = std::nullopt,
                               std::optional<std::size_t> input = std::nullopt);
  // Why the pairs of `except` are not asked about: reasons, each with a number of pairs, not zero. They must sum to the
  // pairs of `except`, of which there is one at least.
  static SaidNote allowed(const std::vector<std::pair<std::string, std::uint64_t>>& reasons);

  const std::string& json() const { return json_; }

 private:
  explicit SaidNote(std::string json) : json_(std::move(json)) {}

  std::string json_;
};

// What the entries of a table of rows are made of: so many of this, then so many of that; each number is not zero, and
// together they are all.
struct SaidOfRows {
  std::string table;
  std::vector<std::pair<std::uint64_t, Said>> parts;
};

}  // namespace sunder
