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

// Trees are for many questions about the same bodies; here they are made for one.
PolytopeAnswer by_trees_made_now(const Polytope& a, const polytope::Pose& pose_a, const Polytope& b,
                                 const polytope::Pose& pose_b) {
  return polytope_polytope_by_columns(polytope::HierarchicalTree(a), pose_a, polytope::HierarchicalTree(b), pose_b);
}

// The trees of A and of B that a descent goes down: those of the faces of one, and of the polar of the other, which has
// to be about a point inside.
struct Descended {
  Descended(const Polytope& first, const Polytope& second) {
    b.emplace(second, polytope::FaceTreesOf::polar);
    if (!b->is_full()) b.emplace(second, polytope::FaceTreesOf::faces);
    a.emplace(first, b->is_full() ? polytope::FaceTreesOf::faces : polytope::FaceTreesOf::polar);
  }

  std::optional<polytope::FaceTrees> a, b;
};

PolytopeAnswer by_face_trees_made_now(const Polytope& a, const polytope::Pose& pose_a, const Polytope& b,
                                      const polytope::Pose& pose_b) {
  const Descended trees(a, b);
  return polytope_polytope_by_tree(*trees.a, pose_a, *trees.b, pose_b);
}

constexpr std::array<PolytopeMethod, 5> methods{
    {SUNDER_METHOD("automatic", polytope::polytope_polytope),
     SUNDER_METHOD("gjk", polytope::polytope_polytope_by_gjk),
     SUNDER_METHOD("scan", polytope::polytope_polytope_by_scan),
     {"columns", by_trees_made_now, "polytope::polytope_polytope_by_columns"},
     {"tree", by_face_trees_made_now, "polytope::polytope_polytope_by_tree"}}};

// d numbers, a translation; or d + 1 a row of the linear part and the translation.
polytope::Pose parse_polytope_pose(const PairSide& side, std::size_t d) {
  if (side.pose.empty()) return polytope::Pose(d);
  const std::string place = side.option("pose");
  const std::vector<double> n = parse_numbers(side.pose, place);
  std::vector<double> linear(d * d), translation(d);
  if (n.size() == d) {
    translation = n;
    for (std::size_t c = 0; c < d; ++c) linear[c * d + c] = 1;
  } else if (n.size() == d * (d + 1)) {
    for (std::size_t r = 0; r < d; ++r) {
      for (std::size_t c = 0; c < d; ++c) linear[r * d + c] = n[r * (d + 1) + c];
      translation[r] = n[r * (d + 1) + d];
    }
  } else {
    throw Error(ErrorCode::bad_call,
                fmt::format("a pose of {}; of dimension {} give {}, a translation, or {}, a matrix row by row",
                            count_of(n.size(), "number"), d, d, d * (d + 1)),
                place);
  }
  try {
    return polytope::Pose::from_matrix(d, linear, translation);
  } catch (const Error& error) {
    throw Error(error.code(), error.what(), place);
  }
}

struct PolytopeInput {
  Polytope polytope;
  polytope::Pose pose;
  PairObject object;
};

PolytopeInput read_input(const PairSide& side, PairFiles& files) {
  const auto unnamed = side.half_spaces ? polytope::Form::half_spaces : polytope::Form::points;
  Polytope read = io::read_polytope(side.file, files.inputs(), unnamed);
  polytope::Pose pose = parse_polytope_pose(side, read.dimension());
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
    if (call.hyperplanes && call.method == "tree") {
      const Descended trees(of_a_.polytope, of_b_.polytope);
      answer_ = polytope_polytope_by_tree(*trees.a, of_a_.pose, *trees.b, of_b_.pose);
      if (!answer_.meet()) {
        hyperplanes_ = hyperplanes_by_tree(*trees.a, of_a_.pose, *trees.b, of_b_.pose);
        if (!hyperplanes_) {
          hyperplanes_ = parting_hyperplanes(trees.a->walks(), of_a_.pose, trees.b->walks(), of_b_.pose, answer_);
        }
      }
    } else if (call.hyperplanes) {
      const polytope::HierarchicalTree a(of_a_.polytope), b(of_b_.polytope);
      answer_ = polytope_polytope_by_columns(a, of_a_.pose, b, of_b_.pose);
      if (!answer_.meet()) hyperplanes_ = parting_hyperplanes(a, of_a_.pose, b, of_b_.pose, answer_);
    } else {
      answer_ = method_(of_a_.polytope, of_a_.pose, of_b_.polytope, of_b_.pose);
    }
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

}  // namespace

bool are_polytopes(const PairCall& call) {
  return call.polytopes || io::names_polytope(call.a.file) || io::names_polytope(call.b.file);
}

Report run_polytope_pair(const PairCall& call, Talk& talk) {
  if (call.hyperplanes && call.method != "columns" && call.method != "tree") {
    throw Error(ErrorCode::bad_call, "is of --method tree or columns; give one of these, too", "--hyperplanes");
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
  return answer(PolytopePair(call, method, a, b, files), files.talk);
}

std::string polytope_method_names() { return method_names(methods); }

}  // namespace sunder::ask
