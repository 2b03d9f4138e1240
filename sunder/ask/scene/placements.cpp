#include <sunder/ask/call_words.h>
#include <sunder/ask/list_stream.h>
#include <sunder/ask/report.h>
#include <sunder/ask/scene/placements.h>
#include <sunder/ask/scene/scene_report.h>

#include <sunder/base/error.h>
#include <sunder/certificate/rounded_evidence.h>
#include <sunder/io/robot/robot_motion.h>
#include <sunder/io/text/file.h>
#include <sunder/io/text/text.h>
#include <sunder/scene/scene_claims.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

namespace sunder::ask {

namespace {

using scene::PartPair;

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

// What lines say of a part, made once.
struct PartNames {
  std::string text, json_body, csv;
  bool is_hull = false;
};

class Lines {
 public:
  Lines(const robot::Cell& cell, const scene::Question& question, std::span<const scene::Body> bodies)
      : question_(question) {
    for (std::uint32_t b = 0; b < bodies.size(); ++b) {
      names_.emplace_back();
      for (std::uint32_t p = 0; p < bodies[b].parts.size(); ++p) {
        const std::string name = part_name(bodies[b], p);
        names_.back().push_back({name, quoted_json(bodies[b].name), name, cell.is_hull(b, p)});
      }
    }
  }

  // "7: hand and link1 meet; hand and link2 meet as hulls, touching"
  void add_text(std::size_t number, const scene::Answer& answer, std::string& out) const {
    fmt::format_to(std::back_inserter(out), "{}: ", number);
    if (answer.pairs.empty()) out += "none meet";
    const char* between = "";
    for (const PartPair& pair : answer.pairs) {
      const auto &a = names_[pair.body_a][pair.part_a], &b = names_[pair.body_b][pair.part_b];
      const char* const verdict = pair.undecided() ? " undecided" : " meet";
      fmt::format_to(std::back_inserter(out), "{}{} and {}{}{}", between, a.text, b.text, verdict,
                     a.is_hull || b.is_hull ? " as hulls" : "");
      if (question_.contacts && pair.meet()) {
        fmt::format_to(std::back_inserter(out), ", {}{}", contact_name(pair), pair.counts ? "" : " (allowed)");
      }
      between = "; ";
    }
    out += '\n';
  }

  // bodies: where they are.
  void add_json(std::size_t number, const scene::Answer& answer, std::span<const scene::Body> bodies,
                std::string& out) const {
    out += R"({"placement": )";
    add_number(number, out);
    out += R"(, "answer": ")";
    out += answer.verdict();
    out += '"';
    if (!answer.pairs.empty()) {
      out += R"(, "pairs": [)";
      const char* between = "";
      for (const PartPair& pair : answer.pairs) {
        out += between;
        add_json(pair, bodies, out);
        between = ", ";
      }
      out += ']';
    }
    out += "}\n";
  }

  // placement,answer,meeting,pairs
  void add_csv(std::size_t number, const scene::Answer& answer, std::string& out) const {
    fmt::format_to(std::back_inserter(out), "{},{},{},", number, answer.verdict(),
                   answer.counts.meeting - answer.counts.touching_only);
    if (!answer.pairs.empty()) {
      out += '"';
      const char* between = "";
      for (const PartPair& pair : answer.pairs) {
        out += between;
        add_quoted(names_[pair.body_a][pair.part_a].csv, out);
        out += " and ";
        add_quoted(names_[pair.body_b][pair.part_b].csv, out);
        const auto &a = names_[pair.body_a][pair.part_a], &b = names_[pair.body_b][pair.part_b];
        std::string said = pair.undecided() ? "undecided" : question_.contacts ? std::string(contact_name(pair)) : "";
        if (a.is_hull || b.is_hull) said += said.empty() ? "as hulls" : ", as hulls";
        if (!said.empty()) fmt::format_to(std::back_inserter(out), " ({})", said);
        between = "; ";
      }
      out += '"';
    }
    out += '\n';
  }

 private:
  void add_json(const PartPair& pair, std::span<const scene::Body> bodies, std::string& out) const {
    const auto &a = names_[pair.body_a][pair.part_a], &b = names_[pair.body_b][pair.part_b];
    const auto add = [&](std::string_view key, std::string_view value) { (out += key) += value; };
    add(R"({"a": )", a.json_body);
    add(R"(, "b": )", b.json_body);
    add(R"(, "part_a": )", "");
    add_number(pair.part_a, out);
    add(R"(, "part_b": )", "");
    add_number(pair.part_b, out);
    add(R"(, "answer": ")", name_of(pair.verdict()));
    out += '"';
    if (question_.contacts && pair.meet()) {
      if (has_unknown_contact(pair)) {
        out += R"(, "contact_unknown": true)";
      } else {
        add(R"(, "contact": ")", name_of(pair.contact));
        out += '"';
      }
    }
    add(R"(, "said_of": ")", a.is_hull || b.is_hull ? "hulls" : "bodies");
    add(R"(", "counted": )", pair.counts ? "true" : "false");
    if (pair.undecided()) {
      const Json direction = to_json(rounded_direction(*pair.round));
      fmt::format_to(std::back_inserter(out), R"(, "evidence": {{"direction_about": {}}}}})", direction.on_one_line());
      return;
    }
    if (pair.round) {
      const Point3 p =
          rounded_common_point(pair, bodies[pair.body_a].parts[pair.part_a], bodies[pair.body_b].parts[pair.part_b]);
      fmt::format_to(std::back_inserter(out), R"(, "evidence": {{"point": {}}}}})", to_json(p).on_one_line());
      return;
    }
    const PairCertificate& c = pair.answer.certificate();
    const std::span<const std::uint32_t> vertices(c.vertices);
    add(R"(, "evidence": {"vertices_a": [)", "");
    add_numbers(vertices.first(c.count_a), out);
    add(R"(], "vertices_b": [)", "");
    add_numbers(vertices.subspan(c.count_a, c.count_b), out);
    out += "]}}";
  }

  static void add_number(std::size_t number, std::string& out) {
    std::array<char, 20> digits;
    out.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr);
  }

  static void add_numbers(std::span<const std::uint32_t> numbers, std::string& out) {
    const char* between = "";
    for (const std::uint32_t number : numbers) {
      out += between;
      add_number(number, out);
      between = ", ";
    }
  }

  static void add_quoted(std::string_view text, std::string& out) {
    for (const char c : text) out.append(c == '"' ? 2 : 1, c);
  }

  const scene::Question& question_;
  std::vector<std::vector<PartNames>> names_;  // by body, by part
};

// What meets, or is undecided, in a placement; and what is closer than it has to be, likewise.
struct Met {
  std::size_t row;
  std::vector<PartPair> pairs;
  std::vector<scene::CloserPair> closer;
};

// What a chain of placements came to.
struct FoundPlacements {
  LineTexts lines;
  std::vector<Met> met;
  PlacementsCounts counts;
};

class Placements {
 public:
  Placements(Talk& talk, const PlacementsCall& call, const robot::Cell& cell, const scene::Question& question,
             const io::JointTable& table, const InputFiles& inputs, const scene::NearnessQuestion& near,
             std::span<const AllowedPair> allowed)
      : talk_(talk),
        call_(call),
        allowed_(allowed),
        inputs_(inputs),
        near_(near),
        cell_(cell),
        table_(table),
        question_(question),
        rows_(cell, table),
        bodies_(cell.place()),
        lines_(cell, question, bodies_),
        near_lines_(near, cell, bodies_),
        files_(call, talk) {
    note_rows_beyond_limits(talk, table, rows_.motion());
  }

  PlacementsAnswer run() {
    LineTexts header{"", header_line(cell_, question_, bodies_, table_, allowed_, call_, false),
                     "placement,answer,meeting,pairs\n"};
    near_lines_.add_json_header(header.json);
    near_lines_.add_csv_header(header.csv);
    files_.write(header);
    const auto report = talk_.progress("placements");
    answer_.asked = scene::run_timeline<FoundPlacements>(
        practised(scene::MomentFollower(bodies_, question_, near_), rows_), rows_, scene::thread_count(call_.threads),
        [&](std::size_t k, const scene::Moment& moment, FoundPlacements& found) { return take(k, moment, found); },
        [&](FoundPlacements& found, std::size_t asked) {
          files_.write(found.lines);
          std::move(found.met.begin(), found.met.end(), std::back_inserter(met_));
          answer_.add(found.counts);
          if (report) report(static_cast<double>(asked) / static_cast<double>(rows_.size()));
          return !call_.first || answer_.some + answer_.not_kept == 0;
        });
    if (!call_.meeting_certificate.empty()) write_certificate();
    files_.commit();
    answer_.summary = summary();
    return answer_;
  }

 private:
  std::string summary() const {
    const LeftOutList& left_out = cell_.left_out();
    const auto& [some, undecided, meeting, not_kept, closer] = static_cast<const PlacementsCounts&>(answer_);
    std::string text = fmt::format("{} of {} {} bodies that meet{}", some, count_of(answer_.asked, "placement"),
                                   some == 1 || answer_.asked == 1 ? "has" : "have",
                                   left_out.empty() ? "" : ", among the bodies read");
    if (undecided > 0) text += fmt::format("; placements where this is undecided: {}", undecided);
    if (near_.clearance) text += fmt::format("; closer than asked for, or undecided: {}", not_kept);
    if (answer_.asked < table_.rows()) {
      text += fmt::format("; not tested, because they follow the first that meets{}: {}",
                          near_.clearance ? " or is closer" : "", table_.rows() - answer_.asked);
    }
    text += left_out.clause() + allowed_clause(allowed_) + "\n" + file_line("JSON lines", call_.json_lines) +
            file_line("table", call_.csv);
    if (call_.meeting_certificate.empty()) return text;
    if (!files_.has_certificate())
      return text + fmt::format("  no proofs are written, as nothing is known to meet{}\n",
                                near_.clearance ? ", or to be closer" : "");
    std::string of = call_.parted ? count_of(answer_.asked, "placement") : count_of(meeting, "pair");
    if (near_.clearance && !call_.parted) of += fmt::format(" that meet, and of {} closer", closer);
    return text + file_line(fmt::format("proofs of {}", of), call_.meeting_certificate) +
           not_proved_line(not_proved(call_));
  }

  // The lines of a placement, and what is counted and kept of it. Are later ones wanted?
  bool take(std::size_t k, const scene::Moment& moment, FoundPlacements& found) const {
    const scene::Answer& answer = moment.meeting;
    LineTexts& lines = found.lines;
    if (files_.has_text()) lines_.add_text(k, answer, lines.text);
    if (files_.has_json()) lines_.add_json(k, answer, moment.bodies, lines.json);
    if (files_.has_csv()) lines_.add_csv(k, answer, lines.csv);
    std::vector<scene::CloserPair> closer;
    if (near_.asks()) {
      if (files_.has_text()) near_lines_.add_text(moment.near, lines.text);
      if (files_.has_json()) near_lines_.add_json(moment.near, lines.json);
      if (files_.has_csv()) near_lines_.add_csv(moment.near, lines.csv);
      found.counts.closer += list_closer(moment.near, closer);
    }
    const bool is_kept = moment.near.is_kept();
    found.counts.add({answer.some_meet(), !answer.some_meet() && !answer.none_meet(), answer.counts.meeting, !is_kept});
    if (!call_.meeting_certificate.empty() && !(answer.pairs.empty() && closer.empty())) {
      found.met.push_back({k, answer.pairs, std::move(closer)});
    }
    return !call_.first || (!answer.some_meet() && is_kept);
  }

  // Of what was found to meet, or to be closer; links are placed again, to the same numbers.
  void write_certificate() {
    if (answer_.meeting + answer_.closer == 0 && !call_.parted) return;
    robot::RowBodies placed(rows_, bodies_);
    const Met nothing{};
    const auto placement_of = [&](std::size_t row, const Met& met) {
      return scene::MeetingPlacement{std::to_string(row), placed.at(row), met.pairs, met.closer};
    };
    const auto joints_in = [&](std::size_t row) { return joint_values_note(table_, row, inputs_); };
    scene::SaidOfScene said{said_of(cell_, inputs_), reason_of_each(allowed_), joints_in};
    const Origin origin = origin_of(talk_, inputs_, left_out_texts(cell_.left_out(), allowed_));
    if (call_.parted) {
      const auto any = [&](std::size_t k) {
        const auto met =
            std::lower_bound(met_.begin(), met_.end(), k, [](const Met& m, std::size_t row) { return m.row < row; });
        return placement_of(k, met != met_.end() && met->row == k ? *met : nothing);
      };
      scene::write_whole_certificate(bodies_, answer_.asked, any, question_, origin, files_.certificate(),
                                     near_.clearance ? &*near_.clearance : nullptr, said);
      return;
    }
    const auto placement = [&](std::size_t k) { return placement_of(met_[k].row, met_[k]); };
    said.joints = [&](std::size_t k) { return joints_in(met_[k].row); };
    scene::write_meeting_certificate(bodies_, met_.size(), placement, question_, origin, files_.certificate(), said);
  }

  Talk& talk_;
  const PlacementsCall& call_;
  const std::span<const AllowedPair> allowed_;
  const InputFiles& inputs_;
  const scene::NearnessQuestion& near_;
  const robot::Cell& cell_;
  const io::JointTable& table_;
  const scene::Question& question_;
  const robot::Rows rows_;
  const std::vector<scene::Body> bodies_;
  const Lines lines_;
  const NearnessLines near_lines_;
  LineFiles files_;
  std::vector<Met> met_;  // where there is to be a certificate
  PlacementsAnswer answer_;
};

}  // namespace

void PlacementsCounts::add(const PlacementsCounts& other) {
  some += other.some;
  undecided += other.undecided;
  meeting += other.meeting;
  not_kept += other.not_kept;
  closer += other.closer;
}

LineFiles::LineFiles(const PlacementsCall& call, Talk& talk)
    : call_(call),
      talk_(talk),
      has_text_(call.json_lines.empty() && call.csv.empty() && call.meeting_certificate.empty()) {
  if (!call.json_lines.empty()) json_.emplace(call.json_lines, talk.instead(call.json_lines));
  if (!call.csv.empty()) csv_.emplace(call.csv, talk.instead(call.csv));
}

void LineFiles::write(const LineTexts& lines) {
  if (has_text_) talk_.print_for_people(lines.text);
  if (json_) json_->write(lines.json);
  if (csv_) csv_->write(lines.csv);
}

TextSink LineFiles::certificate() {
  certificate_.emplace(call_.meeting_certificate, talk_.instead(call_.meeting_certificate));
  return [&](std::string_view text) { certificate_->write(text); };
}

void LineFiles::commit() {
  for (auto* file : {&json_, &csv_, &certificate_}) {
    if (*file) (*file)->commit();
  }
}

std::string header_line(const robot::Cell& cell, const scene::Question& question, std::span<const scene::Body> bodies,
                        const io::JointTable& table, std::span<const AllowedPair> allowed, const PlacementsCall& call,
                        bool between) {
  Json json{{"verb", "scene"}};
  if (between) json["between"] = true;
  json["joints"] = table.joints;
  json["placements"] = table.rows();
  json["bodies"] = Json::array();
  for (const scene::Body& body : bodies) {
    Json parts = Json::array();
    for (const scene::Part& part : body.parts) parts.push_back(part.name);
    json["bodies"].push_back({{"name", body.name}, {"parts", parts}});
  }
  if (!between) json["allowed"] = question.touching_allowed ? "touch" : "nothing";
  json["allowed_pairs"] = Json::array();
  for (const auto& [a, b] : question.allowed) json["allowed_pairs"].push_back({bodies[a].name, bodies[b].name});
  json["allowed_reasons"] = allowed_json(allowed);
  if (Json attached = attached_json(cell); !attached.empty()) json["attached"] = std::move(attached);
  if (!cell.left_out().empty()) json["left_out"] = to_json(cell.left_out());
  if (!call.meeting_certificate.empty()) json["not_proved"] = not_proved(call);
  return json.on_one_line() + "\n";
}

std::string quoted_csv(std::string_view list) {
  if (list.empty()) return "";
  std::string text = "\"";
  for (const char c : list) text.append(c == '"' ? 2 : 1, c);
  return text + '"';
}

SaidNote joint_values_note(const io::JointTable& table, std::size_t row, const InputFiles& inputs) {
  const auto file = std::find_if(inputs.begin(), inputs.end(),
                                 [&](const InputFile& input) { return io::one_line(input.name) == table.file; });
  std::vector<std::pair<std::string, double>> values;
  for (std::size_t c = 0; c < table.columns; ++c) values.emplace_back(table.joints[c], table.row(row)[c]);
  return SaidNote::joint_values(
      values, row,
      file == inputs.end() ? std::nullopt : std::optional(static_cast<std::size_t>(file - inputs.begin())));
}

std::vector<std::string> not_proved(const PlacementsCall& call) {
  std::vector<std::string> words{"the joint values"};
  if (!call.parted) words.emplace_back("what is apart");
  return words;
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

PlacementsAnswer answer_placements(Talk& talk, const PlacementsCall& call, const robot::Cell& cell,
                                   const scene::Question& question, const io::JointTable& table,
                                   const InputFiles& inputs, const scene::NearnessQuestion& near,
                                   std::span<const AllowedPair> allowed) {
  return Placements(talk, call, cell, question, table, inputs, near, allowed).run();
}

}  // namespace sunder::ask
