// What sunder region and sunder kernel tell of what is common to many things.
#pragma once

#include <sunder/ask/question.h>
#include <sunder/ask/said_of.h>
#include <sunder/ask/set/polygons_input.h>

#include <sunder/picture/plane.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::ask {

struct RegionCall : QuestionCall {
  std::string file;
  std::string of = "half-planes", maximize;  // region
  std::string feature;                       // kernel: empty: all
  PolygonsRequest polygons;                  // how they are read

  // Of the parts of this file's features.
  PolygonsRequest request() const;
};

// What questions (question.h) about common parts share. ask() fills in what is protected here.
class FeasibilityQuestion {
 public:
  const RegionCall& call;
  Talk& talk;

  FeasibilityQuestion(const RegionCall& asked, Talk& told) : call(asked), talk(told) {}

  Report report() const;

 protected:
  bool is_empty_ = false;
  Cost cost_;
  const char* counted_ = "sign";
  std::string_view function_;  // of the library, that answers
  std::vector<std::string> not_proved_;
};

// The same where the common part is that of one file.
class RegionQuestion : public FeasibilityQuestion {
 public:
  static constexpr const char* verb = "region";

  using FeasibilityQuestion::FeasibilityQuestion;

  Report report() const;

 protected:
  ~RegionQuestion() = default;

  // All of the `count` things by draw(number, ink), those that the answer names over the others.
  template <class Draw>
  void draw_things(std::size_t count, const Draw& draw) const {
    std::vector<bool> is_named(count, false);
    for (const std::uint32_t k : named_) is_named[k] = true;
    for (const bool named : {false, true}) {
      for (std::uint32_t k = 0; k < count; ++k) {
        if (is_named[k] == named) draw(k, named ? picture::Ink::accent : picture::Ink::calm);
      }
    }
  }

  // A thing that the answer names, for people.
  virtual std::string thing_text(std::uint32_t k) const = 0;

  // Of a corner: about where it is; a line for people; its members beside "point" in reports.
  virtual Point2 corner(std::size_t k) const = 0;
  virtual std::string corner_text(std::size_t k) const = 0;
  virtual Json corner_json(std::size_t) const { return Json::object(); }

  // The file: "3 circles"; {"format": "CSV", "circles": 3}.
  std::string things_;
  Json object_json_;

  std::string verdict_;               // "empty: these have nothing in common"
  std::vector<std::uint32_t> named_;  // the things that it speaks of, by number
  Json region_json_;                  // {"kind": ...}, without its corners
  std::size_t corner_count_ = 0;
};

// By --of, or by the names in the first line of the file.
bool is_of_half_spaces(const RegionCall& call);

// Methods of each kind, for help texts.
std::string half_plane_method_names();
std::string half_space_method_names();
std::string circle_method_names();
std::string polygon_method_names();

// Each answers about a kind of things. Throws Error for bad input, also where a polygon is not
// convex.
Report run_region_half_planes(const RegionCall& call, Talk& talk);
Report run_region_half_spaces(const RegionCall& call, Talk& talk);
Report run_region_circles(const RegionCall& call, Talk& talk);
Report run_region_polygons(const RegionCall& call, Talk& talk);

}  // namespace sunder::ask
