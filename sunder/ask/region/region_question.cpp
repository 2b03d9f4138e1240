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

std::string RegionQuestion::text() const {
  std::string text = fmt::format("{}: {}\n{}\n", io::one_line(call.file), things_, verdict_);
  for (const std::uint32_t k : named_) text += fmt::format("    {}\n", thing_text(k));
  return text + first_of(corner_count_, 20, [&](std::size_t k) { return corner_text(k); });
}

void RegionQuestion::add_to(Json& json) const {
  Json object = {{"file", io::one_line(call.file)}};
  object.update(object_json_);
  json["objects"] = Json::array({object});
  Json corners = Json::array();
  for (std::size_t k = 0; k < corner_count_; ++k) {
    const Point2 p = corner(k);
    corners.push_back(corner_json(k));
    corners.back()["point"] = {p.x, p.y};
  }
  json["region"] = region_json_;
  json["region"]["corners"] = corners;
}

}  // namespace sunder::ask
