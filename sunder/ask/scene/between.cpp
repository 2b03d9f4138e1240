#include <sunder/ask/call_words.h>
#include <sunder/ask/list_stream.h>
#include <sunder/ask/report.h>
#include <sunder/ask/scene/between.h>

#include <sunder/base/error.h>
#include <sunder/scene/sweep_claims.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace sunder::ask {

namespace {

using scene::Body;
using scene::SweptAnswer;
using scene::SweptPair;

constexpr const char* between_option = "--between";

// What is said of a step. With every_pair the answers have pairs that are apart; these are for proofs alone.
class StepLines {
 public:
  StepLines(const robot::Cell& cell, std::span<const Body> bodies) : cell_(cell), bodies_(bodies) {}

  // "3 to 4: hand and link1 meet from about 0.25 of the way on; hand and post undecided"
  void add_text(std::size_t step, const SweptAnswer& answer, std::string& out) const {
    fmt::format_to(std::back_inserter(out), "{} to {}: ", step, step + 1);
    const char* between = "";
    for (const SweptPair& pair : answer.pairs) {
      if (is_apart(pair)) continue;
      fmt::format_to(std::back_inserter(out), "{}{} and {} {}{}", between, name_a(pair), name_b(pair),
                     pair.meet() ? "meet" : "undecided", is_hull(pair) ? " as hulls" : "");
      if (pair.meet()) out += " " + time_text(pair);
      between = "; ";
    }
    if (*between == 0) out += answer.none_meet() ? "none meet" : "none is known to meet";
    out += '\n';
  }

  void add_json(std::size_t step, const SweptAnswer& answer, std::string& out) const {
    Json json{{"step", step}, {"answer", answer.verdict()}, {"at_ends_only", answer.counts.at_ends_only}};
    for (const SweptPair& pair : answer.pairs) {
      if (is_apart(pair)) continue;
      Json of_pair{{"a", bodies_[pair.body_a].name},
                   {"b", bodies_[pair.body_b].name},
                   {"part_a", pair.part_a},
                   {"part_b", pair.part_b},
                   {"answer", pair.meet() ? "meet" : "undecided"},
                   {"said_of", is_hull(pair) ? "hulls" : "bodies"},
                   {"all_the_way", pair.all_the_way}};
      if (pair.meet()) of_pair["time"] = {{"low", pair.time.low}, {"high", pair.time.high}};
      if (pair.first) {
        const Point3 p = nearest(pair.first->contact.point.at);
        of_pair["evidence"] = {{"point", {p.x + 0.0, p.y + 0.0, p.z + 0.0}}};
      }
      json["pairs"].push_back(std::move(of_pair));
    }
    out += json.on_one_line() + "\n";
  }

  // step,answer,meeting,pairs
  void add_csv(std::size_t step, const SweptAnswer& answer, std::string& out) const {
    fmt::format_to(std::back_inserter(out), "{},{},{},", step, answer.verdict(), answer.counts.meeting);
    std::string list;
    for (const SweptPair& pair : answer.pairs) {
      if (is_apart(pair)) continue;
      list += fmt::format("{}{} and {} ({}{})", list.empty() ? "" : "; ", name_a(pair), name_b(pair),
                          pair.meet() ? time_text(pair) : "undecided", is_hull(pair) ? ", as hulls" : "");
    }
    out += quoted_csv(list) + '\n';
  }

 private:
  static bool is_apart(const SweptPair& pair) { return !pair.meet() && !pair.undecided(); }
  static std::string time_text(const SweptPair& pair) {
    if (!pair.all_the_way) return fmt::format("at the {}", pair.time.low == 0 ? "beginning" : "end");
    return fmt::format("from {}{:.6g} of the way on", pair.time.low == pair.time.high ? "" : "about ", pair.time.high);
  }
  std::string name_a(const SweptPair& pair) const { return part_name(bodies_[pair.body_a], pair.part_a); }
  std::string name_b(const SweptPair& pair) const { return part_name(bodies_[pair.body_b], pair.part_b); }
  bool is_hull(const SweptPair& pair) const {
    return cell_.is_hull(pair.body_a, pair.part_a) || cell_.is_hull(pair.body_b, pair.part_b);
  }

  const robot::Cell& cell_;
  std::span<const Body> bodies_;
};

struct Stated {
  std::size_t step;
  std::vector<SweptPair> pairs;
};

struct Totals {
  std::uint64_t some = 0, unknown = 0, all_the_way = 0, at_ends_only = 0, stated = 0;

  void add(const Totals& other) {
    some += other.some;
    unknown += other.unknown;
    all_the_way += other.all_the_way;
    at_ends_only += other.at_ends_only;
    stated += other.stated;
  }
};

// What a chain of steps came to.
struct FoundSteps {
  LineTexts lines;
  std::vector<Stated> stated;
  Totals totals;
};

class Between {
 public:
  Between(Talk& talk, const PlacementsCall& call, const robot::Cell& cell, const scene::Question& question,
          const io::JointTable& table, const InputFiles& inputs, std::span<const AllowedPair> allowed)
      : talk_(talk),
        call_(call),
        allowed_(allowed),
        inputs_(inputs),
        cell_(cell),
        table_(table),
        question_(question),
        rows_(cell, table),
        bodies_(cell.place()),
        lines_(cell, bodies_),
        steps_(table.rows() - 1),
        files_(call, talk) {
    question_.every_pair = call.parted;
  }

  int run() {
    files_.write(
        {"", header_line(cell_, question_, bodies_, table_, allowed_, call_, true), "step,answer,meeting,pairs\n"});
    const auto report = talk_.progress("placements");
    asked_ = scene::run_timeline<FoundSteps>(
        scene::StepFollower(bodies_, question_), rows_, scene::thread_count(call_.threads),
        [&](std::size_t k, scene::SweptAnswer answer, FoundSteps& found) { return take(k, std::move(answer), found); },
        [&](FoundSteps& found, std::size_t asked) {
          files_.write(found.lines);
          std::move(found.stated.begin(), found.stated.end(), std::back_inserter(stated_));
          totals_.add(found.totals);
          if (report) report(static_cast<double>(asked) / static_cast<double>(steps_));
          return !call_.first || totals_.some == 0;
        });
    if (!call_.meeting_certificate.empty()) write_certificate();
    files_.commit();
    talk_.print_for_people(summary());
    return totals_.some + totals_.unknown > 0 ? exit_code::yes : exit_code::no;
  }

 private:
  // The lines of a step, and what is counted and kept of it. Are later ones wanted?
  bool take(std::size_t k, SweptAnswer answer, FoundSteps& found) const {
    if (files_.has_text()) lines_.add_text(k, answer, found.lines.text);
    if (files_.has_json()) lines_.add_json(k, answer, found.lines.json);
    if (files_.has_csv()) lines_.add_csv(k, answer, found.lines.csv);
    found.totals.add({answer.some_meet(), !answer.some_meet() && !answer.none_meet(),
                      answer.counts.by_boxes + answer.counts.by_method, answer.counts.at_ends_only});
    const bool goes_on = !call_.first || !answer.some_meet();
    if (!call_.meeting_certificate.empty() && !answer.pairs.empty()) {
      for (const SweptPair& pair : answer.pairs) found.totals.stated += !pair.undecided();
      found.stated.push_back({k, std::move(answer.pairs)});
    }
    return goes_on;
  }

  void write_certificate() {
    if (totals_.stated == 0) return;
    robot::RowBodies last(rows_, bodies_), next(rows_, bodies_);
    auto stated = stated_.cbegin();
    const auto step = [&](std::size_t k) {
      if (k == 0) stated = stated_.cbegin();
      while (stated != stated_.cend() && stated->step < k) ++stated;
      const bool has_some = stated != stated_.cend() && stated->step == k;
      if (!has_some) return scene::SweptStep{bodies_, bodies_, {}};
      return scene::SweptStep{last.at(k), next.at(k + 1), stated->pairs};
    };
    const scene::SaidOfScene said{said_of(cell_, inputs_), reason_of_each(allowed_),
                                  [&](std::size_t row) { return joint_values_note(table_, row, inputs_); }};
    write_motion_certificate(bodies_, asked_, step, question_,
                             origin_of(talk_, inputs_, left_out_texts(cell_.left_out(), allowed_)),
                             files_.certificate(), said);
  }

  std::string summary() const {
    const LeftOutList& left_out = cell_.left_out();
    std::string text = fmt::format("{} of {} {} bodies that meet during the motion{}", totals_.some,
                                   count_of(asked_, "step"), totals_.some == 1 || asked_ == 1 ? "has" : "have",
                                   left_out.empty() ? "" : ", among the bodies read");
    if (totals_.unknown > 0) text += fmt::format("; steps where this is not known: {}", totals_.unknown);
    if (asked_ < steps_)
      text += fmt::format("; not tested, because they follow the first that meets: {}", steps_ - asked_);
    text += fmt::format("; pairs tested for the whole motion: {}", totals_.all_the_way);
    if (totals_.at_ends_only > 0) {
      text += fmt::format("; pairs tested only at both ends, because a part turns: {}", totals_.at_ends_only);
    }
    text += left_out.clause() + allowed_clause(allowed_) + "\n" + file_line("JSON lines", call_.json_lines) +
            file_line("table", call_.csv);
    if (call_.meeting_certificate.empty()) return text;
    if (!files_.has_certificate()) return text + "  no proofs are written, as there is nothing to be stated\n";
    return text + file_line(fmt::format("proofs of {}", count_of(totals_.stated, "pair")), call_.meeting_certificate) +
           not_proved_line(not_proved(call_));
  }

  Talk& talk_;
  const PlacementsCall& call_;
  const std::span<const AllowedPair> allowed_;
  const InputFiles& inputs_;
  const robot::Cell& cell_;
  const io::JointTable& table_;
  scene::Question question_;
  const robot::Rows rows_;
  const std::vector<Body> bodies_;
  const StepLines lines_;
  const std::size_t steps_;
  LineFiles files_;
  std::vector<Stated> stated_;  // where there is to be a certificate
  std::size_t asked_ = 0;
  Totals totals_;
};

}  // namespace

int answer_between(Talk& talk, const PlacementsCall& call, const robot::Cell& cell, const scene::Question& question,
                   const io::JointTable& table, const InputFiles& inputs, std::span<const AllowedPair> allowed) {
  if (question.contacts) {
    throw Error(ErrorCode::bad_call, "does not tell touching from overlapping; leave out --classify and --allow touch",
                between_option);
  }
  if (table.rows() < 2) {
    throw Error(ErrorCode::bad_call, "is for two placements or more; there is one, so leave it out", between_option);
  }
  return Between(talk, call, cell, question, table, inputs, allowed).run();
}

}  // namespace sunder::ask
