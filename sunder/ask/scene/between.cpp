#include <sunder/ask/scene/between.h>
#include <sunder/ask/scene/scene_report.h>

#include <sunder/base/error.h>
#include <sunder/scene/sweep_claims.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace sunder::ask {

namespace {

using scene::SweptAnswer;
using scene::SweptPair;

constexpr const char* between_option = "--between";

struct Stated {
  std::size_t step;
  std::vector<SweptPair> pairs;
};

struct Totals {
  std::uint64_t some = 0, unknown = 0, all_the_way = 0, at_ends_only = 0, stated = 0, surfaces_alone = 0;

  void add(const Totals& other) {
    some += other.some;
    unknown += other.unknown;
    all_the_way += other.all_the_way;
    at_ends_only += other.at_ends_only;
    stated += other.stated;
    surfaces_alone += other.surfaces_alone;
  }
};

// What a chain of steps came to.
struct FoundSteps {
  LineTexts lines;
  std::vector<Stated> stated;
  Totals totals;
};

class Between : RowRun {
 public:
  explicit Between(const RowsAsked& asked)
      : RowRun(asked, true), steps_(table_.rows() - 1), surfaces_consented_(asked.surfaces_consented) {}

  int run() {
    asked_ = run_rows<FoundSteps>(
        scene::StepFollower(bodies_, question_), steps_,
        [&](std::size_t k, SweptAnswer answer, FoundSteps& found) { return take(k, std::move(answer), found); },
        [&](FoundSteps& found) {
          std::move(found.stated.begin(), found.stated.end(), std::back_inserter(stated_));
          totals_.add(found.totals);
          return !call_.first || totals_.some == 0;
        });
    if (!call_.meeting_certificate.empty()) write_certificate();
    files_.commit();
    talk_.print_for_people(summary());
    const bool is_open = totals_.surfaces_alone > 0 && !surfaces_consented_;
    return totals_.some + totals_.unknown > 0 || is_open ? exit_code::yes : exit_code::no;
  }

 private:
  // The lines of a step, and what is counted and kept of it. Are later ones wanted?
  bool take(std::size_t k, SweptAnswer answer, FoundSteps& found) const {
    lines_.add(k, answer, found.lines);
    found.totals.add({answer.some_meet(), !answer.some_meet() && !answer.none_meet(),
                      answer.counts.by_boxes + answer.counts.by_method, answer.counts.at_ends_only, 0,
                      answer.counts.surfaces_alone});
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
    write_motion_certificate(bodies_, asked_, step, question_, origin(), files_.certificate(), said_of_rows());
  }

  std::string summary() const {
    std::string text = beginning(totals_.some, asked_, "step", "bodies that meet during the motion");
    if (totals_.unknown > 0) text += fmt::format("; steps where this is not known: {}", totals_.unknown);
    if (asked_ < steps_)
      text += fmt::format("; not tested, because they follow the first that meets: {}", steps_ - asked_);
    text += fmt::format("; pairs tested for the whole motion: {}", totals_.all_the_way);
    if (totals_.at_ends_only > 0) {
      text += fmt::format("; pairs tested only at both ends, because a part turns: {}", totals_.at_ends_only);
    }
    if (totals_.surfaces_alone > 0) text += "; " + surfaces_alone_text(totals_.surfaces_alone, surfaces_consented_);
    return text + ending(count_of(totals_.stated, "pair"), "there is nothing to be stated");
  }

  const std::size_t steps_;
  const bool surfaces_consented_;
  std::vector<Stated> stated_;  // where there is to be a certificate
  std::size_t asked_ = 0;
  Totals totals_;
};

}  // namespace

int answer_between(RowsAsked asked) {
  if (asked.question.contacts) {
    throw Error(ErrorCode::bad_call, "does not tell touching from overlapping; leave out --classify and --allow touch",
                between_option);
  }
  if (asked.table.rows() < 2) {
    throw Error(ErrorCode::bad_call, "is for two placements or more; there is one, so leave it out", between_option);
  }
  asked.question.every_pair = asked.call.parted;  // pairs that are apart are for proofs alone
  return Between(asked).run();
}

}  // namespace sunder::ask
