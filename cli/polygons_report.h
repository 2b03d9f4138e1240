// What sunder polygons answers, in words, in JSON, as GeoJSON and as a picture.
#pragma once

#include <cli/common.h>
#include <cli/polygons_input.h>

#include <sunder/planar/set/polygons_all.h>

#include <string>
#include <vector>

namespace sunder::cli {

struct PolygonsCall {
  std::vector<std::string> files;
  bool any = false, all = false, count = false;  // at most one; none: any
  std::string allow = "nothing";
  std::string method = "automatic";
  std::string group, name, certificate, geojson, svg, title;
  bool drop_z = false, leave_out = false, skip_invalid = false, mend = false, self_touch = false;
  bool json = false;

  bool lists() const { return all || !geojson.empty() || !svg.empty(); }
  bool groups() const { return !group.empty() && group != "feature"; }  // a feature is one object anyway
};

struct PolygonsResult {
  std::vector<planar::PolygonsContact> contacts;  // with --any at most one
  std::uint64_t touching = 0, overlapping = 0;
  Cost cost;

  std::uint64_t pairs() const { return touching + overlapping; }
};

std::string human_text(const PolygonsCall& call, const PolygonsInput& input, const PolygonsResult& result);
Json report(const PolygonsCall& call, const PolygonsInput& input, const PolygonsResult& result);

// A FeatureCollection with a point for each contact, in their order, one on each line. Properties: number (from 1), and
// those that a contact has in the report, but for the point. Bytes of names that are no UTF-8 become U+FFFD.
std::string contacts_geojson(const PolygonsCall& call, const PolygonsInput& input, const PolygonsResult& result);

std::string picture(const PolygonsCall& call, const PolygonsInput& input, const PolygonsResult& result);

}  // namespace sunder::cli
