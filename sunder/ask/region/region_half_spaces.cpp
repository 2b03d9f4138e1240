// sunder region: of half-spaces of two to six dimensions.
#include <sunder/ask/region/region_question.h>

#include <sunder/base/error.h>
#include <sunder/io/text/polytopes.h>
#include <sunder/io/text/text.h>
#include <sunder/polytope/region/half_space_region.h>
#include <sunder/polytope/region/linear_program.h>
#include <sunder/polytope/region/region_claims.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace sunder::ask {

namespace {

using polytope::ExactEvidence;
using polytope::HalfSpaceRegion;
using polytope::LinearProgramAnswer;
using polytope::Polytope;

using ProgramMethod = LinearProgramAnswer(const Polytope&, std::span<const double>);
constexpr std::array<Named<ProgramMethod>, 3> program_methods{
    {SUNDER_METHOD("automatic", polytope::linear_program), SUNDER_METHOD("seidel", polytope::linear_program_by_seidel),
     SUNDER_METHOD("scan", polytope::linear_program_by_scan)}};

Polytope read_half_spaces(const RegionCall& call, Origin& origin) {
  Polytope polytope = io::read_polytope(call.file, call.proves() ? &origin.inputs : nullptr);
  if (polytope.is_of_points()) {
    throw Error(ErrorCode::bad_file,
                fmt::format("{}: points; give half-spaces, in columns a1, .., ad, b that the first line names",
                            io::one_line(call.file)));
  }
  return polytope;
}

std::vector<double> objective_of(const std::string& text, std::size_t d) {
  if (text.empty()) return {};
  std::vector<double> numbers = parse_numbers(text, "--maximize");
  if (numbers.size() != d) {
    throw Error(ErrorCode::bad_call, fmt::format("{}; give {}, one a dimension", count_of(numbers.size(), "number"), d),
                "--maximize");
  }
  return numbers;
}

// "2 x1 - 3 x3"
std::string form_text(std::span<const double> numbers) {
  std::string text;
  for (std::size_t c = 0; c < numbers.size(); ++c) {
    if (numbers[c] == 0) continue;
    const char* const sign = numbers[c] < 0 ? (text.empty() ? "-" : " - ") : (text.empty() ? "" : " + ");
    text += fmt::format("{}{:.10g} x{}", sign, std::fabs(numbers[c]), c + 1);
  }
  return text.empty() ? "0" : text;
}

std::vector<double> nearest(const std::vector<Dyadic>& numbers, const Dyadic& denominator) {
  constexpr double most = std::numeric_limits<double>::max();  // JSON has no infinity
  std::vector<double> result;
  for (const Dyadic& n : numbers) result.push_back(std::clamp(nearest_ratio(n, denominator), -most, most));
  return result;
}

// Its greatest number is about 1.
std::vector<double> direction_about(const std::vector<Dyadic>& direction) {
  std::optional<std::int64_t> top;
  for (const Dyadic& x : direction) {
    if (x.sign() != Sign::zero) top = top ? std::max(*top, x.top()) : x.top();
  }
  std::vector<double> result;
  for (const Dyadic& x : direction) result.push_back(x.scaled(-top.value_or(0)).nearest());
  return result;
}

std::string numbers_text(const std::vector<double>& numbers) {
  std::string text;
  for (const double x : numbers) text += fmt::format("{}{:.10g}", text.empty() ? "" : ", ", x);
  return "(" + text + ")";
}

std::vector<std::uint32_t> rows_of(const Weights& weights) {
  std::vector<std::uint32_t> rows;
  for (const Weights::Part& part : weights.parts) rows.push_back(part.index);
  std::sort(rows.begin(), rows.end());
  return rows;
}

class HalfSpacesQuestion final : public FeasibilityQuestion {
 public:
  static constexpr const char* verb = "region";
  static constexpr const char* drawn_noun = "half-space";

  HalfSpacesQuestion(const RegionCall& asked, Talk& told)
      : FeasibilityQuestion(asked, told),
        method_(method_by(asked.method, program_methods, ", for half-spaces")),
        half_spaces_(read_half_spaces(asked, origin_)),
        d_(half_spaces_.dimension()),
        objective_(objective_of(asked.maximize, d_)) {
    if (objective_.empty() && method_.method != polytope::linear_program) {
      throw Error(ErrorCode::bad_call, "methods of half-spaces are for --maximize; leave it out", "--method");
    }
    counted_ = "half-space";
  }

  static std::uint64_t drawn() { return 0; }
  static std::string picture() { return ""; }

  void ask() {
    function_ = objective_.empty() ? "polytope::half_space_region" : method_.function;
    if (objective_.empty()) {
      region_ = polytope::half_space_region(half_spaces_);
      const auto* empty = std::get_if<polytope::EmptyRegion>(&region_.evidence);
      is_empty_ = empty != nullptr;
      cost_ = region_.cost;
      rows_ = rows_of(is_empty_ ? empty->contradiction : extent_of(region_)->flat);
      if (!is_empty_) not_proved_.emplace_back("how far it goes along each axis");
    } else {
      best_ = method_(half_spaces_, objective_);
      is_empty_ = !is_feasible(best_);
      cost_ = best_.cost;
      if (const Weights* multipliers = named_multipliers(best_.evidence)) rows_ = rows_of(*multipliers);
    }
  }

  std::string certificate() const {
    return claims_text(by_this_call(talk, origin_), [&](ClaimsWriter& file) {
      const std::string name = std::filesystem::path(call.file).stem().string();
      file.say(said_of_file(Said::Source::half_spaces, origin_.inputs, call.file));
      if (objective_.empty()) {
        add_claims(file, name, half_spaces_, region_);
      } else {
        add_claims(file, name, half_spaces_, objective_, best_);
      }
    });
  }

  Report report() const {
    Report report = FeasibilityQuestion::report();
    report.objects.push_back({{"file", io::one_line(call.file)},
                              {"format", "CSV"},
                              {"half_spaces", half_spaces_.size()},
                              {"dimension", d_}});
    report.tell(fmt::format("{}: {} of dimension {}\n", io::one_line(call.file),
                            count_of(half_spaces_.size(), "half-space"), d_));
    if (is_empty_) {
      report.tell("empty: these contradict each other\n" + rows_text("") +
                  "  certain positive multiples of them add up to 0 <= a negative number\n");
    }
    if (objective_.empty()) {
      report.add("region", region_json(), is_empty_ ? "" : region_text());
    } else {
      report.add("best", best_json(), is_empty_ ? "" : best_text());
    }
    return report;
  }

 private:
  Json best_json() const {
    Json best{{"objective", objective_}, {"outcome", name_of(best_.verdict())}, {"rows", rows_}};
    if (!is_empty_) best["point"] = point_of(best_point());
    return best;
  }

  Json region_json() const {
    Json extents = Json::array(), points = Json::array();
    const polytope::RegionExtent* const extent = extent_of(region_);
    for (std::size_t c = 0; c < d_ && extent != nullptr; ++c) {
      const auto number = [](const std::optional<double>& x) {
        constexpr double most = std::numeric_limits<double>::max();
        return x ? Json(std::clamp(*x, -most, most)) : Json();
      };
      extents.push_back({number(extent->ranges[c].least), number(extent->ranges[c].greatest)});
    }
    if (extent != nullptr) {
      for (const ExactPointN& point : extent->points) points.push_back(point_of(point));
    }
    Json region{{"kind", name_of(region_.verdict())}, {"rows", rows_}, {"points", points}, {"extents", extents}};
    if (extent != nullptr) region["dimension"] = extent->dimension;
    if (const auto* far = unbounded()) region["direction_about"] = direction_about(far->direction);
    return region;
  }

  static std::vector<double> point_of(const ExactPointN& place) { return nearest(place.numbers, place.denominator); }

  std::string rows_text(const char* before) const {
    std::string text;
    for (const std::uint32_t k : rows_) {
      const std::span<const double> row = half_spaces_.row(k);
      text += fmt::format("    {}half-space {}: {} <= {:.10g}\n", before, k, form_text(row.first(d_)), row[d_]);
    }
    return text;
  }

  const polytope::UnboundedRegion* unbounded() const {
    return std::get_if<polytope::UnboundedRegion>(&region_.evidence);
  }

  std::string region_text() const {
    const polytope::RegionExtent& extent = *extent_of(region_);
    std::string text = fmt::format("{}, of dimension {}\n", name_of(region_.verdict()), extent.dimension);
    if (!rows_.empty()) text += "  it lies in the boundary hyperplanes of:\n" + rows_text("");
    for (std::size_t c = 0; c < d_; ++c) {
      const auto& [least, greatest] = extent.ranges[c];
      const std::string from = least ? fmt::format(" from about {:.10g}", *least) : "",
                        to = greatest ? fmt::format(" to about {:.10g}", *greatest) : "";
      text += fmt::format("  x{}{}\n", c + 1,
                          least && greatest ? from + to
                          : least           ? from + " on"
                          : greatest        ? " up" + to
                                            : " takes all values");
    }
    if (const auto* far = unbounded()) {
      text += fmt::format("  it extends without end in the direction of about {}\n",
                          numbers_text(direction_about(far->direction)));
    }
    return text;
  }

  // From the exact point: of rounded coordinates nothing may be left where products cancel. Infinite beyond doubles.
  double best_value() const {
    Dyadic sum;
    for (std::size_t c = 0; c < d_; ++c) sum = sum + Dyadic(objective_[c]) * best_point().numbers[c];
    return nearest_ratio(sum, best_point().denominator);
  }
  const ExactPointN& best_point() const { return *named_point(best_.evidence); }

  std::string best_text() const {
    const std::string aim = form_text(objective_);
    if (const auto* far = std::get_if<polytope::NoBound>(&best_.evidence)) {
      return fmt::format("{} is as great as one likes, from {} on along the direction of about {}\n", aim,
                         numbers_text(point_of(far->point)), numbers_text(direction_about(far->direction)));
    }
    if (best_.verdict() == Optimum::all) {
      return fmt::format("{} is zero everywhere: every common point is an optimum, such as about {}\n", aim,
                         numbers_text(point_of(best_point())));
    }
    const double value = best_value();
    return fmt::format("{} is greatest, {}, {} about {}\n", aim,
                       std::isfinite(value) ? fmt::format("about {:.10g}", value) : "beyond the range of doubles",
                       best_.verdict() == Optimum::one ? "at" : "at more points than one, such as",
                       numbers_text(point_of(best_point()))) +
           rows_text("held by ");
  }

  Named<ProgramMethod> method_;
  Origin origin_;
  Polytope half_spaces_;
  std::size_t d_;
  std::vector<double> objective_;
  HalfSpaceRegion region_;
  LinearProgramAnswer best_;
  std::vector<std::uint32_t> rows_;
};

}  // namespace

bool is_of_half_spaces(const RegionCall& call) {
  return call.of == "half-spaces" || (call.of == "half-planes" && io::names_polytope(call.file));
}

Report run_region_half_spaces(const RegionCall& call, Talk& talk) {
  return answer(HalfSpacesQuestion(call, talk), talk);
}

std::string half_space_method_names() { return method_names(program_methods); }

}  // namespace sunder::ask
