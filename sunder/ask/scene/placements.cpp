#include <sunder/ask/scene/placements.h>
#include <sunder/ask/scene/scene_report.h>

#include <sunder/base/error.h>
#include <sunder/io/robot/robot_motion.h>
#include <sunder/io/text/file.h>
#include <sunder/io/text/text.h>
#include <sunder/scene/scene_claims.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <span>
#include <string_view>
#include <utility>

namespace sunder::ask {

namespace {

constexpr const char *placements_option = "--placements", *names_option = "--joint-names";

std::vector<std::string> split_at_commas(std::string_view text) {
  std::vector<std::string> names;
  while (!text.empty()) {
    const std::size_t comma = std::min(text.find(','), text.size());
    names.emplace_back(io::trimmed(text.substr(0, comma)));
    text.remove_prefix(std::min(comma + 1, text.size()));
  }
  return names;
}

// Values beyond the limits are asked about as they are, and said.
void note_rows_beyond_limits(Talk& talk, const io::JointTable& table, const io::RobotMotion& motion) {
  std::uint64_t beyond = 0;
  std::string first;
  for (std::size_t k = 0; k < table.rows(); ++k) {
    for (std::size_t c = 0; c < table.columns; ++c) {
      const io::Joint& joint = motion.joint_of(c);
      const double value = table.row(k)[c];
      if (value >= joint.lower && value <= joint.upper) continue;
      if (beyond++ > 0) continue;
      first = fmt::format("{}: joint {}: {} is not from {} to {}", table.place(k), io::quote(joint.name), value,
                          joint.lower, joint.upper);
    }
  }
  if (beyond == 0) return;
  talk.note(fmt::format("{} out of the limits, asked about as {}; the first: {}",
                        beyond == 1 ? "1 value is" : fmt::format("{} values are", beyond),
                        beyond == 1 ? "it is" : "they are", first));
}

// What meets, or is undecided, in a placement; and what is closer than it has to be, likewise.
struct Met {
  std::size_t row;
  std::vector<scene::PartPair> pairs;
  std::vector<scene::CloserPair> closer;
};

// What a chain of placements came to.
struct FoundPlacements {
  LineTexts lines;
  std::vector<Met> met;
  PlacementsCounts counts;
};

// Appends what is closer than it has to be, or may be, as certificates take it. Returns how many pairs are.
std::size_t list_closer(const scene::Nearness& found, std::span<const scene::Body> bodies,
                        std::vector<scene::CloserPair>& list) {
  if (!found.clearance) return 0;
  const auto add = [&](const scene::CloserParts& pair, bool is_undecided) {
    list.push_back(
        {pair.body_a, pair.body_b, pair.part_a, pair.part_b, pair.least, is_undecided, is_of_meshes(pair, bodies)});
  };
  for (const scene::CloserParts& pair : found.clearance->closer) add(pair, false);
  for (const scene::CloserParts& pair : found.clearance->undecided) add(pair, true);
  return found.clearance->closer.size();
}

class Placements : RowRun {
 public:
  explicit Placements(const RowsAsked& asked) : RowRun(asked, false), surfaces_consented_(asked.surfaces_consented) {
    note_rows_beyond_limits(talk_, table_, rows_.motion());
  }

  PlacementsCounts run() {
    asked_ = run_rows<FoundPlacements>(
        practised(scene::MomentFollower(bodies_, question_, near_), rows_), rows_.size(),
        [&](std::size_t k, const scene::Moment& moment, FoundPlacements& found) { return take(k, moment, found); },
        [&](FoundPlacements& found) {
          std::move(found.met.begin(), found.met.end(), std::back_inserter(met_));
          counts_.add(found.counts);
          return !call_.first || counts_.some + counts_.not_kept == 0;
        });
    if (!call_.meeting_certificate.empty()) write_certificate();
    files_.commit();
    talk_.print_for_people(summary());
    return counts_;
  }

 private:
  std::string summary() const {
    const auto& [some, undecided, meeting, not_kept, closer, surfaces_alone] = counts_;
    std::string text = beginning(some, asked_, "placement", "bodies that meet");
    if (undecided > 0) text += fmt::format("; placements where this is undecided: {}", undecided);
    if (near_.clearance) text += fmt::format("; closer than asked for, or undecided: {}", not_kept);
    if (asked_ < table_.rows()) {
      text += fmt::format("; not tested, because they follow the first that meets{}: {}",
                          near_.clearance ? " or is closer" : "", table_.rows() - asked_);
    }
    if (surfaces_alone > 0) text += "; " + surfaces_alone_text(surfaces_alone, surfaces_consented_);
    std::string proofs = call_.parted ? count_of(asked_, "placement") : count_of(meeting, "pair");
    if (near_.clearance && !call_.parted) proofs += fmt::format(" that meet, and of {} closer", closer);
    return text +
           ending(proofs, near_.clearance ? "nothing is known to meet, or to be closer" : "nothing is known to meet");
  }

  // The lines of a placement, and what is counted and kept of it. Are later ones wanted?
  bool take(std::size_t k, const scene::Moment& moment, FoundPlacements& found) const {
    const scene::Answer& answer = moment.meeting;
    lines_.add(k, moment, found.lines);
    std::vector<scene::CloserPair> closer;
    found.counts.closer += list_closer(moment.near, moment.bodies, closer);
    const bool is_kept = moment.near.is_kept();
    found.counts.add({answer.some_meet(), !answer.some_meet() && !answer.none_meet(), answer.counts.meeting, !is_kept,
                      0, answer.counts.surfaces_alone});
    if (!call_.meeting_certificate.empty() && !(answer.pairs.empty() && closer.empty())) {
      found.met.push_back({k, answer.pairs, std::move(closer)});
    }
    return !call_.first || (!answer.some_meet() && is_kept);
  }

  // Of what was found to meet, or to be closer; links are placed again, to the same numbers.
  void write_certificate() {
    if (counts_.meeting + counts_.closer == 0 && !call_.parted) return;
    robot::RowBodies placed(rows_, bodies_);
    const Met nothing{};
    const auto placement_of = [&](std::size_t row, const Met& met) {
      return scene::MeetingPlacement{std::to_string(row), placed.at(row), met.pairs, met.closer};
    };
    scene::SaidOfScene said = said_of_rows();
    if (call_.parted) {
      const auto any = [&](std::size_t k) {
        const auto met =
            std::lower_bound(met_.begin(), met_.end(), k, [](const Met& m, std::size_t row) { return m.row < row; });
        return placement_of(k, met != met_.end() && met->row == k ? *met : nothing);
      };
      scene::write_whole_certificate(bodies_, asked_, any, question_, origin(), files_.certificate(),
                                     near_.clearance ? &*near_.clearance : nullptr, said);
      return;
    }
    const auto placement = [&](std::size_t k) { return placement_of(met_[k].row, met_[k]); };
    said.joints = [&, joints = std::move(said.joints)](std::size_t k) { return joints(met_[k].row); };
    scene::write_meeting_certificate(bodies_, met_.size(), placement, question_, origin(), files_.certificate(), said);
  }

  std::vector<Met> met_;  // where there is to be a certificate
  const bool surfaces_consented_;
  std::size_t asked_ = 0;
  PlacementsCounts counts_;
};

}  // namespace

void PlacementsCounts::add(const PlacementsCounts& other) {
  some += other.some;
  undecided += other.undecided;
  meeting += other.meeting;
  not_kept += other.not_kept;
  closer += other.closer;
  surfaces_alone += other.surfaces_alone;
}

io::JointTable read_placements(Talk& talk, const PlacementsCall& call, const robot::Cell& cell, InputFiles* inputs) {
  const io::Robot& robot = cell.robot(placements_option);
  io::JointTable table = io::read_joint_table(call.table, inputs, scene::thread_count(call.threads));
  if (!table.joints.empty()) {
    if (!call.joint_names.empty()) {
      throw Error(ErrorCode::bad_call, "the file names its joints itself; leave it out", names_option);
    }
    noting(talk, [&](auto& remarks) { io::fit_joint_table(robot, table, remarks); });
  } else {
    table.joints = call.joint_names.empty() ? io::movable_joints(robot) : split_at_commas(call.joint_names);
    if (table.joints.size() != table.columns) {
      throw Error(ErrorCode::bad_call,
                  fmt::format("{} has {}, but there {} {}: {}; name one joint for each column", io::quote(table.file),
                              count_of(table.columns, "column"), table.joints.size() == 1 ? "is" : "are",
                              count_of(table.joints.size(), "joint"),
                              io::one_line(fmt::format("{}", fmt::join(table.joints, ", ")))),
                  names_option);
    }
    for (auto name = table.joints.begin(); name != table.joints.end(); ++name) {
      if (std::find(table.joints.begin(), name, *name) != name) {
        throw Error(ErrorCode::bad_call, "joint " + io::quote(*name) + " comes twice", names_option);
      }
    }
  }
  (void)io::RobotMotion(robot, table.joints);  // are there these joints?
  return table;
}

std::vector<io::JointValues> joint_values_of(const io::JointTable& table) {
  std::vector<io::JointValues> all;
  for (std::size_t k = 0; k < table.rows(); ++k) {
    io::JointValues& values = all.emplace_back();
    values.name = std::to_string(k);
    for (std::size_t c = 0; c < table.columns; ++c) values.values[table.joints[c]] = table.row(k)[c];
  }
  return all;
}

std::vector<io::JointValues> extremes_of(const io::JointTable& table) {
  io::JointValues least, greatest;
  for (std::size_t c = 0; c < table.columns && table.rows() > 0; ++c) {
    double& low = least.values[table.joints[c]] = table.row(0)[c];
    double& high = greatest.values[table.joints[c]] = low;
    for (std::size_t k = 1; k < table.rows(); ++k) {
      low = std::min(low, table.row(k)[c]);
      high = std::max(high, table.row(k)[c]);
    }
  }
  return {least, greatest};
}

PlacementsCounts answer_placements(const RowsAsked& asked) { return Placements(asked).run(); }

}  // namespace sunder::ask
