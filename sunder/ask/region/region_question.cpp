#include <sunder/ask/region/region_question.h>

#include <sunder/io/text/text.h>

#include <fmt/format.h>

namespace sunder::ask {

PolygonsRequest RegionCall::request() const {
  PolygonsRequest request = polygons;
  request.files = {file};
  request.by_part = true;
  request.tell_inputs = proves();
  return request;
}

Report FeasibilityQuestion::report() const {
  Report report{.answer = is_empty_ ? "infeasible" : "feasible", .code = is_empty_ ? exit_code::yes : exit_code::no};
  report.function = function_;
  report.cost = cost_;
  report.cost_text = count_of(cost_.probes, counted_);
  report.not_proved = not_proved_;
  return report;
}

Report RegionQuestion::report() const {
  Report report = FeasibilityQuestion::report();
  Json object = {{"file", io::one_line(call.file)}};
  object.update(object_json_);
  report.objects.push_back(object);
  report.tell(fmt::format("{}: {}\n{}\n", io::one_line(call.file), things_, verdict_));
  for (const std::uint32_t k : named_) report.tell(fmt::format("    {}\n", thing_text(k)));
  Json region = region_json_;
  region["corners"] = Json::array();
  for (std::size_t k = 0; k < corner_count_; ++k) {
    const Point2 p = corner(k);
    Json told = corner_json(k);
    told["point"] = {p.x, p.y};
    region["corners"].push_back(std::move(told));
  }
  report.add("region", std::move(region), first_of(corner_count_, 20, [&](std::size_t k) { return corner_text(k); }));
  return report;
}

}  // namespace sunder::ask
