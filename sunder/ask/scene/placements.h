// Thousands of placements of a robot in one call of `sunder scene`: a line a placement.
#pragma once

#include <sunder/ask/report.h>
#include <sunder/ask/scene/nearness_lines.h>
#include <sunder/ask/scene/scene_input.h>

#include <sunder/io/robot/joint_table.h>
#include <sunder/io/robot/joint_values.h>
#include <sunder/io/text/file.h>
#include <sunder/robot/cell.h>
#include <sunder/robot/rows.h>
#include <sunder/scene/scene.h>
#include <sunder/scene/timeline.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::ask {

struct PlacementsCall {
  std::string table;                // the file of joint values
  std::string joint_names;          // "a,b,c", of an NPY file; empty: those that can be moved, in the robot's order
  std::string json_lines, csv;      // files to be written; empty: none
  std::string meeting_certificate;  // likewise: the proofs of what meets, and of what is closer
  bool parted = false;              // and the proofs of what is apart, too
  bool first = false;               // stop at the first placement that meets
  std::uint64_t threads = 0;        // 0: all cores
};

// Counts placements where something meets, or where that is undecided, and all pairs that meet; then placements where
// something is closer than it has to be, or where that is undecided, and all pairs that are known to be closer.
struct PlacementsCounts {
  std::uint64_t some = 0, undecided = 0, meeting = 0, not_kept = 0, closer = 0;

  void add(const PlacementsCounts& other);
};

struct PlacementsAnswer : PlacementsCounts {
  std::uint64_t asked = 0;  // how many were asked about
  std::string summary;      // for people

  int code() const { return some + undecided + not_kept > 0 ? exit_code::yes : exit_code::no; }
};

// The lines of some rows, and where lines go: printed, or to the files that the call names.
struct LineTexts {
  std::string text, json, csv;
};

class LineFiles {
 public:
  LineFiles(const PlacementsCall& call, Talk& talk);

  bool has_text() const { return has_text_; }
  bool has_json() const { return json_.has_value(); }
  bool has_csv() const { return csv_.has_value(); }
  void write(const LineTexts& lines);
  bool has_certificate() const { return certificate_.has_value(); }
  TextSink certificate();  // opens the file
  void commit();           // all files are there, then

 private:
  const PlacementsCall& call_;
  Talk& talk_;
  bool has_text_;
  std::optional<io::OutputFile> json_, csv_, certificate_;
};

// What all rows have in common: the first line of JSON lines.
std::string header_line(const robot::Cell& cell, const scene::Question& question, std::span<const scene::Body> bodies,
                        const io::JointTable& table, std::span<const AllowedPair> allowed, const PlacementsCall& call,
                        bool between);

// A list as a field of a table: in quotes; nothing where it is empty.
std::string quoted_csv(std::string_view list);

// What the answer says and a proof of --meeting-certificate does not, in words.
std::vector<std::string> not_proved(const PlacementsCall& call);

// What a proof says of a placement: the values of its row. inputs: the files that were read.
SaidNote joint_values_note(const io::JointTable& table, std::size_t row, const InputFiles& inputs);

// The table with the names of its joints. Throws Error, also where they are not so many as there are columns.
io::JointTable read_placements(Talk& talk, const PlacementsCall& call, const robot::Cell& cell, InputFiles* inputs);

// The same as values by name, one placement after another, named by their numbers, from 0.
std::vector<io::JointValues> joint_values_of(const io::JointTable& table);

// The least and the greatest value of each joint.
std::vector<io::JointValues> extremes_of(const io::JointTable& table);

// Asks the question of each placement, in chains (scene/timeline.h), and writes what comes out: lines of text,
// printed, or the files that are asked for. inputs: what a certificate was made of. near: what else is asked; of the
// nearest no certificate is written. allowed: the pairs of question.allowed, with their reasons. Throws Error; then no
// file is written.
PlacementsAnswer answer_placements(Talk& talk, const PlacementsCall& call, const robot::Cell& cell,
                                   const scene::Question& question, const io::JointTable& table,
                                   const InputFiles& inputs = {}, const scene::NearnessQuestion& near = {},
                                   std::span<const AllowedPair> allowed = {});

}  // namespace sunder::ask
