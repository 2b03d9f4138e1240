#include <sunder/ask/pair/pair_polytopes.h>

#include <sunder/base/error.h>
#include <sunder/io/text/polytopes.h>
#include <sunder/io/text/text.h>
#include <sunder/polytope/pair/polytope_claims.h>
#include <sunder/polytope/tree/polytope_polytope_by_tree.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace sunder::ask {

namespace {

using polytope::ExactEvidence;
using polytope::HyperplaneEvidence;
using polytope::Polytope;
using polytope::PolytopeAnswer;

using PolytopeMethod =
    Named<PolytopeAnswer(const Polytope&, const polytope::Pose&, const Polytope&, const polytope::Pose&)>;

// The last two work on trees, which Prepared makes first; so they have no function of two polytopes here.
constexpr std::array<PolytopeMethod, 5> methods{{SUNDER_METHOD("automatic", polytope::polytope_polytope),
                                                 SUNDER_METHOD("gjk", polytope::polytope_polytope_by_gjk),
                                                 SUNDER_METHOD("scan", polytope::polytope_polytope_by_scan),
                                                 {"columns", nullptr, "polytope::polytope_polytope_by_columns"},
                                                 {"tree", nullptr, "polytope::polytope_polytope_by_tree"}}};

struct PolytopeInput {
  Polytope polytope;
  polytope::Pose pose;
  PairObject object;
};

// A and B as the method wants them: trees are made once, for all poses.
class Prepared {
 public:
  Prepared(const PolytopeMethod& method, const PolytopeInput& a, const PolytopeInput& b)
      : method_(method), a_(a.polytope), b_(b.polytope) {
    if (method.name == "columns") {
      prepare(walks_a_, a);
      prepare(walks_b_, b);
    } else if (method.name == "tree") {
      // The method needs the faces of one body and the faces of the other one's polar; that body must have an inside.
      prepare(faces_b_, b, polytope::FaceTreesOf::polar);
      const bool is_full = faces_b_->is_full();
      if (!is_full) prepare(faces_b_, b, polytope::FaceTreesOf::faces);
      prepare(faces_a_, a, is_full ? polytope::FaceTreesOf::faces : polytope::FaceTreesOf::polar);
    }
  }

  PolytopeAnswer ask(const polytope::Pose& pose_a, const polytope::Pose& pose_b) const {
    if (walks_a_) return polytope_polytope_by_columns(*walks_a_, pose_a, *walks_b_, pose_b);
    if (faces_a_) return polytope_polytope_by_tree(*faces_a_, pose_a, *faces_b_, pose_b);
    return method_(a_, pose_a, b_, pose_b);
  }

  // Hyperplanes between A and B. Requires that ask() used trees, and found A and B apart.
  HyperplaneEvidence hyperplanes(const polytope::Pose& pose_a, const polytope::Pose& pose_b,
                                 const PolytopeAnswer& answer) const {
    if (walks_a_) return parting_hyperplanes(*walks_a_, pose_a, *walks_b_, pose_b, answer);
    if (auto planes = hyperplanes_by_tree(*faces_a_, pose_a, *faces_b_, pose_b)) return *std::move(planes);
    return parting_hyperplanes(faces_a_->walks(), pose_a, faces_b_->walks(), pose_b, answer);
  }

 private:
  // Refused with the name of the file.
  template <class Tree, class... Options>
  static void prepare(std::optional<Tree>& tree, const PolytopeInput& of, Options... options) {
    try {
      tree.emplace(of.polytope, options...);
    } catch (const Error& error) {
      throw Error(error.code(), error.text(), of.object.file);
    }
  }

  PolytopeMethod method_;
  const Polytope &a_, &b_;
  std::optional<polytope::HierarchicalTree> walks_a_, walks_b_;
  std::optional<polytope::FaceTrees> faces_a_, faces_b_;
};

PolytopeInput read_input(const PairSide& side, PairFiles& files) {
  const auto unnamed = side.half_spaces ? polytope::Form::half_spaces : polytope::Form::points;
  Polytope read = io::read_polytope(side.file, files.inputs(), unnamed);
  const std::string at = side.option("pose");
  polytope::Pose pose = side.pose.empty() ? polytope::Pose(read.dimension())
                                          : io::polytope_pose(parse_numbers(side.pose, at), read.dimension(), at);
  const std::string file = io::one_line(side.file);
  const std::string name = io::one_line(std::filesystem::path(side.file).stem().string());
  const char* const noun = read.is_of_points() ? "point" : "half-space";
  PairObject object{.file = file,
                    .name = name,
                    .text = fmt::format("{}: {} of dimension {}", name, count_of(read.size(), noun), read.dimension()),
                    .json = {{"file", file},
                             {"name", name},
                             {"format", io::ending_of(side.file) == ".npy" ? "NPY" : "CSV"},
                             {"shape", read.is_of_points() ? "points" : "half-spaces"},
                             {"dimension", read.dimension()},
                             {"rows", read.size()}},
                    .vertices = {},
                    .said = said_of_file(read.is_of_points() ? Said::Source::points : Said::Source::half_spaces,
                                         files.read, side.file)};
  return {std::move(read), pose, std::move(object)};
}

std::vector<double> nearest(const std::vector<Dyadic>& numbers, const Dyadic& denominator) {
  std::vector<double> result;
  constexpr double most = std::numeric_limits<double>::max();  // JSON has no infinity
  for (const Dyadic& n : numbers) result.push_back(std::clamp(nearest_ratio(n, denominator), -most, most));
  return result;
}

// Of length 1, about.
std::vector<double> unit(const std::vector<Dyadic>& direction) {
  std::int64_t top = 0;
  bool found = false;
  for (const Dyadic& x : direction) {
    if (x.sign() == Sign::zero) continue;
    top = found ? std::max(top, x.top()) : x.top();
    found = true;
  }
  std::vector<double> result;
  double square = 0;
  for (const Dyadic& x : direction) {
    result.push_back(x.scaled(-top).nearest());
    square += result.back() * result.back();
  }
  for (double& x : result) x = square > 0 ? x / std::sqrt(square) : 0;
  return result;
}

std::vector<std::uint32_t> rows_of(const Weights& weights) {
  std::vector<std::uint32_t> rows;
  for (const Weights::Part& part : weights.parts) rows.push_back(part.index);
  return rows;
}

std::string about_all(const std::vector<double>& numbers) {
  std::string text;
  for (const double x : numbers) text += (text.empty() ? "" : ", ") + about(x);
  return "(" + text + ")";
}

class PolytopePair : public PairQuestion {
 public:
  PolytopePair(const PairCall& asked, PolytopeMethod method, const PolytopeInput& a, const PolytopeInput& b,
               const PairFiles& files)
      : PairQuestion(asked, a.object, b.object, files), method_(method), of_a_(a), of_b_(b) {}

  void ask() {
    function_ = method_.function;
    const Prepared pair(method_, of_a_, of_b_);
    answer_ = pair.ask(of_a_.pose, of_b_.pose);
    if (call.hyperplanes && !answer_.meet()) hyperplanes_ = pair.hyperplanes(of_a_.pose, of_b_.pose, answer_);
    const bool are_points = of_a_.polytope.is_of_points() && of_b_.polytope.is_of_points();
    const bool is_program = !are_points && answer_.decided_by == DecidedBy::finishing;
    take(answer_, is_program ? "a linear program in exact arithmetic" : decided_text(answer_.decided_by));
    facts_ = {told()};
    if (hyperplanes_) facts_.push_back(hyperplanes_told());
  }

  std::string certificate() const {
    return claims_text(origin(), [&](ClaimsWriter& file) {
      const polytope::NamedPolytope a{a_.name, of_a_.polytope, of_a_.pose, a_.said},
          b{b_.name, of_b_.polytope, of_b_.pose, b_.said};
      if (hyperplanes_) {
        add_claims(file, a, b, *hyperplanes_);
      } else {
        add_claims(file, a, b, answer_);
      }
    });
  }

 private:
  Fact hyperplanes_told() const {
    const std::size_t of_a = HyperplaneEvidence::count(hyperplanes_->a),
                      of_b = HyperplaneEvidence::count(hyperplanes_->b);
    const std::size_t named = hyperplanes_->a.multipliers.parts.size() + hyperplanes_->b.multipliers.parts.size();
    return {"planes",
            {{"a", of_a}, {"b", of_b}, {"multiplied", named}},
            fmt::format("{} that {} A, {} B; multiples of {} contradict", count_of(of_a, "half-space"),
                        of_a == 1 ? "holds" : "hold", of_b, named)};
  }

  Fact told() const {
    const ExactEvidence evidence = exact_evidence(of_a_.polytope, of_a_.pose, of_b_.polytope, of_b_.pose, answer_);
    const std::vector<std::uint32_t> of_a = rows_of(evidence.of_a), of_b = rows_of(evidence.of_b);
    if (meet_) {
      const std::vector<double> point = nearest(evidence.numbers, evidence.denominator);
      std::string text = fmt::format("a common point at about {}", about_all(point));
      const char* word = "made of";
      for (const auto& [input, rows, letter] : {std::tuple(&of_a_, &of_a, "A"), std::tuple(&of_b_, &of_b, "B")}) {
        if (!input->polytope.is_of_points()) continue;
        text += fmt::format(", {} {} of {}", word, count_of(rows->size(), "point"), letter);
        word = "and";
      }
      return {"evidence", {{"point", point}, {"vertices_a", of_a}, {"vertices_b", of_b}}, text};
    }
    const std::vector<double> direction = unit(evidence.numbers);
    const std::string parted =
        fmt::format("A is less far than B along the direction of about {}", about_all(direction));
    const std::string multiples =
        fmt::format("multiples of {} of A and {} of B", count_of(of_a.size(), "half-space"), of_b.size());
    const bool is_some = std::any_of(direction.begin(), direction.end(), [](double x) { return x != 0; });
    const bool have_half_spaces = !of_a.empty() || !of_b.empty();
    const std::string text = !is_some           ? multiples + " contradict each other"
                             : have_half_spaces ? parted + ",\nby " + multiples
                                                : parted;
    return {"evidence", {{"direction_about", direction}, {"half_spaces_a", of_a}, {"half_spaces_b", of_b}}, text};
  }

  PolytopeMethod method_;
  const PolytopeInput &of_a_, &of_b_;
  PolytopeAnswer answer_;
  std::optional<HyperplaneEvidence> hyperplanes_;
};

// B at each of many poses.
class PolytopeAtPoses {
 public:
  static constexpr const char *verb = "pair", *drawn_noun = "point";
  const PairCall& call;

  PolytopeAtPoses(const PairCall& asked, PolytopeMethod method, const PolytopeInput& a, const PolytopeInput& b,
                  PairFiles& files)
      : call(asked),
        method_(method),
        a_(a),
        b_(b),
        files_(files),
        poses_(io::read_polytope_poses(call.b.poses, b.polytope.dimension(), files.inputs())) {}

  static std::uint64_t drawn() { return 0; }
  static std::string picture() { return ""; }

  void ask() {
    const Prepared pair(method_, a_, b_);
    for (const polytope::Pose& pose : poses_) {
      const PolytopeAnswer& answer = answers_.emplace_back(pair.ask(a_.pose, pose));
      if (answer.meet()) meet_.push_back(answers_.size() - 1);
      ++decided_by_[static_cast<std::size_t>(answer.decided_by)];
      cost_.probes += answer.cost.probes;
      cost_.iterations += answer.cost.iterations;
      cost_.exact += answer.cost.exact;
      cost_.proposals += answer.cost.proposals;
    }
  }

  std::string certificate() const {
    return claims_text(origin_of(files_.talk, files_.read, files_.left_out.texts()), [&](ClaimsWriter& file) {
      const PairObject &a = a_.object, &b = b_.object;
      add_claims(file, {a.name, a_.polytope, a_.pose, a.said}, {b.name, b_.polytope, b_.pose, b.said}, poses_,
                 answers_);
    });
  }

  Report report() const {
    Report report{.answer = meet_.empty() ? "apart" : "meet",
                  .code = meet_.empty() ? exit_code::no : exit_code::yes,
                  .function = method_.function,
                  .cost = cost_,
                  .objects = Json::array({a_.object.json, b_.object.json})};
    report.tell(fmt::format(
        "{} and {}: {}\n", a_.object.file, b_.object.file,
        meet_.empty() ? fmt::format("apart, with B at each of {}", count_of(poses_.size(), "pose"))
                      : fmt::format("meet, with B at {} of {}", meet_.size(), count_of(poses_.size(), "pose"))));
    report.tell(titled("A", a_.object.text) + titled("B", b_.object.text));
    if (call.proves()) report.not_proved = {"that these are all poses of the file"};
    Json decided = Json::object(), meet = Json::array();
    for (const DecidedBy by : {DecidedBy::filter, DecidedBy::evidence, DecidedBy::finishing, DecidedBy::scan}) {
      decided[std::string(name_of(by))] = decided_by_[static_cast<std::size_t>(by)];
    }
    for (const std::size_t k : meet_) meet.push_back(k);
    const std::span<const std::size_t> first(meet_.data(), std::min<std::size_t>(meet_.size(), 10));
    std::string text = fmt::format("at pose {}", fmt::join(first, ", "));
    if (meet_.size() > first.size()) text += fmt::format(", and {} more; --json has all", meet_.size() - first.size());
    report.add("poses", {{"count", poses_.size()}, {"meet", meet}, {"decided_by", decided}},
               meet_.empty() ? "" : titled("meet", text + ", counted from 0"));
    return report;
  }

 private:
  PolytopeMethod method_;
  const PolytopeInput &a_, &b_;
  PairFiles& files_;
  std::vector<polytope::Pose> poses_;
  std::vector<PolytopeAnswer> answers_;
  std::vector<std::size_t> meet_;
  std::array<std::uint64_t, 4> decided_by_{};  // by each DecidedBy
  Cost cost_;
};

}  // namespace

bool are_polytopes(const PairCall& call) {
  return call.polytopes || io::names_polytope(call.a.file) || io::names_polytope(call.b.file);
}

Report run_polytope_pair(const PairCall& call, Talk& talk) {
  if (call.hyperplanes && call.method != "columns" && call.method != "tree") {
    throw Error(ErrorCode::bad_call, "is of --method tree or columns; give one of these, too", "--hyperplanes");
  }
  if (!call.b.poses.empty() && (call.hyperplanes || !call.b.pose.empty())) {
    throw Error(
        ErrorCode::bad_call,
        fmt::format("asks about each pose of its file; leave out {}", call.hyperplanes ? "--hyperplanes" : "--pose-b"),
        "--poses-b");
  }
  PolytopeMethod const method = method_by(call.method, methods, ", for polytopes");
  PairFiles files(call, talk);
  const PolytopeInput a = read_input(call.a, files), b = read_input(call.b, files);
  if (a.polytope.dimension() != b.polytope.dimension()) {
    throw Error(ErrorCode::bad_call, fmt::format("A is of dimension {}, B of {}; give two of one dimension",
                                                 a.polytope.dimension(), b.polytope.dimension()));
  }
  for (const auto& [side, input] : {std::pair(&call.a, &a), std::pair(&call.b, &b)}) {
    if (call.method != "tree" || input->polytope.is_of_points()) continue;
    throw Error(ErrorCode::bad_call, "is of half-spaces, and --method tree of points; give --method columns",
                io::one_line(side->file));
  }
  if (!call.b.poses.empty()) return answer(PolytopeAtPoses(call, method, a, b, files), files.talk);
  return answer(PolytopePair(call, method, a, b, files), files.talk);
}

std::string polytope_method_names() { return method_names(methods); }

}  // namespace sunder::ask
