// One row of thousands as a line of text, of JSON and of CSV: what meets in a placement, and how near what is, or what
// meets during a step.
#pragma once

#include <sunder/ask/report.h>

#include <sunder/base/json_line.h>
#include <sunder/robot/cell.h>
#include <sunder/scene/scene.h>
#include <sunder/scene/sweep.h>
#include <sunder/scene/timeline.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::ask {

// The lines of some rows.
struct LineTexts {
  std::string text, json, csv;
};

struct LineKinds {
  bool text = false, json = false, csv = false;
};

// Any number of threads may use one at once.
class RowLines {
 public:
  // Keeps a reference to the question. bodies: gives the names of bodies and parts.
  RowLines(const robot::Cell& cell, std::span<const scene::Body> bodies, const scene::Question& question,
           scene::NearnessQuestion near, LineKinds wanted);

  // What stands before the rows. head: what they have in common.
  LineTexts header(Json head, std::string_view row_name) const;

  // Adds the lines of a row that are wanted. Of a step, pairs that are apart are not told.
  void add(std::size_t row, const scene::Moment& moment, LineTexts& lines) const;
  void add(std::size_t step, const scene::SweptAnswer& answer, LineTexts& lines) const;

 private:
  struct PartName {
    std::string name, body_json;  // body_json: of its body, in quotes
    bool is_hull = false;
  };
  struct Names;
  template <class Pair>
  Names of(const Pair& pair) const;
  template <class Pair>
  void open_pair(const Pair& pair, JsonLine& json) const;

  void add_text(const scene::Answer& answer, std::string& text) const;
  void add_text(const scene::Nearness& near, std::span<const scene::Body> bodies, std::string& text) const;
  void add_json(const scene::PartPair& pair, std::span<const scene::Body> bodies, JsonLine& json) const;
  void add_json(const scene::PartDistance& pair, std::optional<double> margin, std::span<const scene::Body> bodies,
                JsonLine& json) const;
  void add_json(const scene::SweptPair& pair, JsonLine& json) const;
  void add_csv(const scene::Nearness& near, std::span<const scene::Body> bodies, std::string& csv) const;

  const scene::Question& question_;
  const scene::NearnessQuestion near_;
  const LineKinds wanted_;
  std::vector<std::vector<PartName>> names_;  // by body, by part
};

}  // namespace sunder::ask
