// Rows of joint values, one placement after another, of which `sunder scene --placements` writes a line each: what such
// calls have in common, whether they ask about each placement or about the way to the next.
#pragma once

#include <sunder/ask/report.h>
#include <sunder/ask/scene/row_lines.h>
#include <sunder/ask/scene/scene_input.h>
#include <sunder/ask/talk.h>

#include <sunder/io/robot/joint_table.h>
#include <sunder/io/text/file.h>
#include <sunder/robot/rows.h>
#include <sunder/scene/scene_said.h>
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

// What is asked of all rows.
struct RowsAsked {
  Talk& talk;
  const PlacementsCall& call;
  const robot::Cell& cell;
  scene::Question question;
  scene::NearnessQuestion near;
  const io::JointTable& table;
  const InputFiles& inputs;              // what a certificate was made of
  std::span<const AllowedPair> allowed;  // the pairs of question.allowed, with their reasons
  bool surfaces_consented = false;       // as of SceneReport
};

// Writes lines to the files that the call names, or prints them if it names none.
class LineFiles {
 public:
  LineFiles(const PlacementsCall& call, Talk& talk);

  LineKinds kinds() const { return {has_text_, json_.has_value(), csv_.has_value()}; }
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

class RowRun {
 protected:
  // between: it is about the ways from row to row.
  RowRun(const RowsAsked& asked, bool between);

  // Asks about each of so many rows, in chains (scene/timeline.h), and writes what comes out. take(k, answer, found)
  // adds to `found`, which has the lines of a chain; total(found) takes what a chain came to. Each returns whether more
  // is wanted. Returns how many were asked about.
  template <class Found, class Start, class Take, class Total>
  std::size_t run_rows(const Start& start, std::size_t all, const Take& take, const Total& total) {
    files_.write(header());
    const auto report = talk_.progress("placements");
    return scene::run_timeline<Found>(start, rows_, scene::thread_count(call_.threads), take,
                                      [&](Found& found, std::size_t asked) {
                                        files_.write(found.lines);
                                        if (report) report(static_cast<double>(asked) / static_cast<double>(all));
                                        return total(found);
                                      });
  }

  // The summary, for people: "1 of 7 placements has bodies that meet, among the bodies read"; and what was left out,
  // which files are written, and what is not proved. proofs: of what; why_none: "nothing is known to meet".
  std::string beginning(std::uint64_t some, std::uint64_t asked, std::string_view row_name,
                        std::string_view what) const;
  std::string ending(std::string_view proofs, std::string_view why_none) const;

  Origin origin() const;
  scene::SaidOfScene said_of_rows() const;  // its joints: of a row

  Talk& talk_;
  const PlacementsCall& call_;
  const robot::Cell& cell_;
  const scene::Question question_;
  const scene::NearnessQuestion near_;
  const io::JointTable& table_;
  const InputFiles& inputs_;
  const std::span<const AllowedPair> allowed_;
  const robot::Rows rows_;
  const std::vector<scene::Body> bodies_;
  LineFiles files_;
  const RowLines lines_;

 private:
  LineTexts header() const;

  const bool between_;
};

}  // namespace sunder::ask
