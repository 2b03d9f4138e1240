#include <sunder/ask/call_words.h>
#include <sunder/ask/list_stream.h>
#include <sunder/ask/progress.h>
#include <sunder/ask/report.h>
#include <sunder/ask/scene/placements.h>
#include <sunder/ask/scene/scene_report.h>

#include <sunder/base/error.h>
#include <sunder/io/file.h>
#include <sunder/io/robot_motion.h>
#include <sunder/io/text.h>
#include <sunder/scene/chains.h>
#include <sunder/scene/follower.h>
#include <sunder/scene/rounded_evidence.h>
#include <sunder/scene/scene_json.h>

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
void note_limits(const io::JointTable& table, const io::RobotMotion& motion) {
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
  note(fmt::format("{} out of the limits, asked about as {}; the first: {}",
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
  Lines(const SceneInput& input, const scene::Question& question, std::span<const scene::Body> bodies)
      : question_(question) {
    for (std::uint32_t b = 0; b < bodies.size(); ++b) {
      names_.emplace_back();
      for (std::uint32_t p = 0; p < bodies[b].parts.size(); ++p) {
        const std::string name = part_name(bodies[b], p);
        names_.back().push_back({name, quoted_json(bodies[b].name), name, input.is_hull(b, p)});
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
    add(R"(, "answer": ")", pair.verdict());
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
      const Json direction = to_json(scene::rounded_direction(*pair.round));
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

// What all placements have in common: the first line of JSON lines.
std::string header_line(const SceneInput& input, const scene::Question& question, std::span<const scene::Body> bodies,
                        const io::JointTable& table, std::span<const AllowedPair> allowed, const PlacementsCall& call) {
  Json json{{"verb", "scene"}, {"joints", table.joints}, {"placements", table.rows()}};
  json["bodies"] = Json::array();
  for (const scene::Body& body : bodies) {
    Json parts = Json::array();
    for (const scene::Part& part : body.parts) parts.push_back(part.name);
    json["bodies"].push_back({{"name", body.name}, {"parts", parts}});
  }
  json["allowed"] = question.touching_allowed ? "touch" : "nothing";
  json["allowed_pairs"] = Json::array();
  for (const auto& [a, b] : question.allowed) json["allowed_pairs"].push_back({bodies[a].name, bodies[b].name});
  json["allowed_reasons"] = allowed_json(allowed);
  if (!input.left_out().empty()) json["left_out"] = to_json(input.left_out());
  if (!call.meeting_certificate.empty()) json["not_proved"] = not_proved(call);
  return json.on_one_line() + "\n";
}

// What meets, or is undecided, in a placement; and what is closer than it has to be, likewise.
struct Met {
  std::size_t row;
  std::vector<PartPair> pairs;
  std::vector<scene::CloserPair> closer;
};

// A chain of placements, and what it came to.
struct Chain {
  Chain(const scene::Follower& start, std::size_t link_count) : follower(start), links(link_count) {}

  scene::Follower follower;
  std::optional<scene::ClearanceFollower> near{};
  std::vector<Affine3> links;      // where they are
  std::size_t begin = 0, end = 0;  // rows
  std::string text, json, csv;
  std::vector<Met> met;
  std::uint64_t some = 0, undecided = 0, meeting = 0, not_kept = 0;  // as in PlacementsAnswer
  std::uint64_t closer = 0;                                          // pairs that are known to be
};

class Placements {
 public:
  Placements(const PlacementsCall& call, const SceneInput& input, const scene::Question& question,
             const io::JointTable& table, const InputFiles& inputs, const NearnessQuestion& near,
             std::span<const AllowedPair> allowed)
      : call_(call),
        allowed_(allowed),
        inputs_(inputs),
        near_(near),
        input_(input),
        table_(table),
        motion_(input.robot(placements_option), table.joints),
        start_(input.bodies({}), question),
        lines_(input, question, start_.bodies()),
        near_lines_(near, input, start_.bodies(), question.allowed),
        near_start_(near_lines_.follower()),
        prints_text_(call.json_lines.empty() && call.csv.empty() && call.meeting_certificate.empty()),
        threads_(scene::thread_count(call.threads)),
        question_(question) {
    note_limits(table, motion_);
  }

  PlacementsAnswer run() {
    open(call_.json_lines, json_);
    open(call_.csv, csv_);
    if (json_) {
      std::string header = header_line(input_, question_, start_.bodies(), table_, allowed_, call_);
      near_lines_.add_json_header(header);
      json_->write(header);
    }
    if (csv_) {
      std::string header = "placement,answer,meeting,pairs\n";
      near_lines_.add_csv_header(header);
      csv_->write(header);
    }
    practise();
    Progress progress("placements");
    const auto report = progress.reporter();
    chains_.resize(scene::chain_places(threads_));
    scene::run_chains(
        threads_, {[&](std::size_t place) { return begin(place); }, [&](std::size_t place) { run(*chains_[place]); },
                   [&](std::size_t place) { return end(*chains_[place], report); }});
    if (!call_.meeting_certificate.empty()) write_certificate();
    if (json_) json_->commit();
    if (csv_) csv_->commit();
    if (certificate_) certificate_->commit();
    return {asked_, some_, undecided_, meeting_, not_kept_, summary()};
  }

 private:
  std::string summary() const {
    const LeftOutList& left_out = input_.left_out();
    std::string text =
        fmt::format("{} of {} {} bodies that meet{}", some_, count_of(asked_, "placement"),
                    some_ == 1 || asked_ == 1 ? "has" : "have", left_out.empty() ? "" : ", among the bodies read");
    if (undecided_ > 0) text += fmt::format("; placements where this is undecided: {}", undecided_);
    if (near_.clearance) text += fmt::format("; closer than asked for, or undecided: {}", not_kept_);
    if (asked_ < table_.rows()) {
      text += fmt::format("; not tested, because they follow the first that meets{}: {}",
                          near_.clearance ? " or is closer" : "", table_.rows() - asked_);
    }
    text += left_out.clause() + allowed_clause(allowed_) + "\n" + file_line("JSON lines", call_.json_lines) +
            file_line("table", call_.csv);
    if (call_.meeting_certificate.empty()) return text;
    if (!certificate_)
      return text + fmt::format("  no proofs are written, as nothing is known to meet{}\n",
                                near_.clearance ? ", or to be closer" : "");
    std::string of = call_.parted ? count_of(asked_, "placement") : count_of(meeting_, "pair");
    if (near_.clearance && !call_.parted) of += fmt::format(" that meet, and of {} closer", closer_);
    return text + file_line(fmt::format("proofs of {}", of), call_.meeting_certificate) +
           not_proved_line(not_proved(call_));
  }

  static void open(const std::string& name, std::optional<io::OutputFile>& file) {
    if (!name.empty()) file.emplace(name);
  }

  bool begin(std::size_t place) {
    if (next_ == table_.rows()) return false;
    auto& chain = chains_[place];
    if (!chain) chain = std::make_unique<Chain>(start_, input_.robot(placements_option).links.size());
    chain->begin = next_;
    next_ = chain->end = std::min(next_ + scene::chain_length, table_.rows());
    return true;
  }

  void run(Chain& chain) const {
    for (std::string* out : {&chain.text, &chain.json, &chain.csv}) out->clear();
    chain.some = chain.undecided = chain.meeting = chain.not_kept = chain.closer = 0;
    chain.met.clear();
    chain.follower = start_;
    chain.near = near_start_;
    for (std::size_t k = chain.begin; k < chain.end; ++k) {
      try {
        motion_.place(table_.row(k), chain.links);
        input_.place_links(chain.links,
                           [&](std::uint32_t part, const solid::Pose& pose) { chain.follower.place(part, pose); });
      } catch (const Error& error) {
        throw Error(error.code(), error.what(), table_.place(k));
      }
      const scene::Answer& answer = chain.follower.ask();
      if (prints_text_) lines_.add_text(k, answer, chain.text);
      if (json_) lines_.add_json(k, answer, chain.follower.bodies(), chain.json);
      if (csv_) lines_.add_csv(k, answer, chain.csv);
      std::vector<scene::CloserPair> closer;
      const bool is_kept = !near_.asks() || look_near(chain, closer);
      chain.meeting += answer.counts.meeting;
      if (!call_.meeting_certificate.empty() && !(answer.pairs.empty() && closer.empty())) {
        chain.met.push_back({k, answer.pairs, std::move(closer)});
      }
      if (!answer.some_meet() && !answer.none_meet()) ++chain.undecided;
      chain.some += answer.some_meet();
      if (!call_.first || (!answer.some_meet() && is_kept)) continue;
      chain.end = k + 1;
      return;
    }
  }

  // Adds to the lines of the placement, and lists what is closer than it has to be, or may be. Is there nothing?
  bool look_near(Chain& chain, std::vector<scene::CloserPair>& closer) const {
    const Nearness found = near_lines_.ask(chain.follower.bodies(), chain.near);
    if (prints_text_) near_lines_.add_text(found, chain.text);
    if (json_) near_lines_.add_json(found, chain.json);
    if (csv_) near_lines_.add_csv(found, chain.csv);
    chain.not_kept += !found.is_kept();
    chain.closer += list_closer(found, closer);
    return found.is_kept();
  }

  // What all chains begin from: what the first one leaves of evidence, where there are several. A fixed beginning, so
  // that nothing depends on threads; and evidence of other placements mostly serves.
  void practise() {
    if (table_.rows() < 4 * scene::chain_length) return;
    std::vector<Affine3> links(input_.robot(placements_option).links.size());
    try {
      for (std::size_t k = 0; k < scene::chain_length; ++k) {
        motion_.place(table_.row(k), links);
        input_.place_links(links, [&](std::uint32_t part, const solid::Pose& pose) { start_.place(part, pose); });
        (void)start_.ask();
        if (near_start_) (void)near_start_->ask(start_.bodies());
      }
    } catch (const Error&) {  // which is told in its turn
    }
  }

  // Of what was found to meet, or to be closer; links are placed again, to the same numbers.
  void write_certificate() {
    if (meeting_ + closer_ == 0 && !call_.parted) return;
    certificate_.emplace(call_.meeting_certificate);
    std::vector<scene::Body> bodies(start_.bodies().begin(), start_.bodies().end());
    std::vector<scene::Part*> parts;
    for (scene::Body& body : bodies) {
      for (scene::Part& part : body.parts) parts.push_back(&part);
    }
    std::vector<Affine3> links(input_.robot(placements_option).links.size());
    const Met nothing{};
    const auto placement_of = [&](std::size_t row, const Met& met) {
      motion_.place(table_.row(row), links);
      input_.place_links(links, [&](std::uint32_t part, const solid::Pose& pose) { parts[part]->pose = pose; });
      return scene::MeetingPlacement{std::to_string(row), bodies, met.pairs, met.closer};
    };
    const auto write = [&](std::string_view text) { certificate_->write(text); };
    const auto joints_in = [&](std::size_t row) { return joint_values_note(table_, row, inputs_); };
    scene::SaidOfScene said{input_.said(inputs_), reason_of_each(allowed_), joints_in};
    if (call_.parted) {
      const auto any = [&](std::size_t k) {
        const auto met =
            std::lower_bound(met_.begin(), met_.end(), k, [](const Met& m, std::size_t row) { return m.row < row; });
        return placement_of(k, met != met_.end() && met->row == k ? *met : nothing);
      };
      scene::write_whole_certificate(start_.bodies(), asked_, any, question_,
                                     origin_of(inputs_, left_out_texts(input_.left_out(), allowed_)), write,
                                     near_.clearance ? &*near_.clearance : nullptr, said);
      return;
    }
    const auto placement = [&](std::size_t k) { return placement_of(met_[k].row, met_[k]); };
    said.joints = [&](std::size_t k) { return joints_in(met_[k].row); };
    scene::write_meeting_certificate(start_.bodies(), met_.size(), placement, question_,
                                     origin_of(inputs_, left_out_texts(input_.left_out(), allowed_)), write, said);
  }

  bool end(Chain& chain, const std::function<void(double)>& report) {
    if (prints_text_) print_for_people(chain.text);
    if (json_) json_->write(chain.json);
    if (csv_) csv_->write(chain.csv);
    std::move(chain.met.begin(), chain.met.end(), std::back_inserter(met_));
    some_ += chain.some;
    undecided_ += chain.undecided;
    meeting_ += chain.meeting;
    not_kept_ += chain.not_kept;
    closer_ += chain.closer;
    asked_ = chain.end;
    if (report) report(static_cast<double>(asked_) / static_cast<double>(table_.rows()));
    return !call_.first || some_ + not_kept_ == 0;
  }

  const PlacementsCall& call_;
  const std::span<const AllowedPair> allowed_;
  const InputFiles& inputs_;
  const NearnessQuestion& near_;
  const SceneInput& input_;
  const io::JointTable& table_;
  const io::RobotMotion motion_;
  scene::Follower start_;
  const Lines lines_;
  const NearnessLines near_lines_;
  std::optional<scene::ClearanceFollower> near_start_;
  const bool prints_text_;
  const std::size_t threads_;
  const scene::Question& question_;
  std::optional<io::OutputFile> json_, csv_, certificate_;
  std::vector<std::unique_ptr<Chain>> chains_;
  std::vector<Met> met_;  // where there is to be a certificate
  std::size_t next_ = 0, asked_ = 0;
  std::uint64_t some_ = 0, undecided_ = 0, meeting_ = 0, not_kept_ = 0, closer_ = 0;
};

}  // namespace

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

io::JointTable read_placements(const PlacementsCall& call, const SceneInput& input, InputFiles* inputs) {
  const io::Robot& robot = input.robot(placements_option);
  io::JointTable table = io::read_joint_table(call.table, inputs, scene::thread_count(call.threads));
  if (!table.joints.empty()) {
    if (!call.joint_names.empty()) {
      throw Error(ErrorCode::bad_call, "the file names its joints itself; leave it out", names_option);
    }
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

PlacementsAnswer answer_placements(const PlacementsCall& call, const SceneInput& input, const scene::Question& question,
                                   const io::JointTable& table, const InputFiles& inputs, const NearnessQuestion& near,
                                   std::span<const AllowedPair> allowed) {
  return Placements(call, input, question, table, inputs, near, allowed).run();
}

}  // namespace sunder::ask
