// What sunder polygons answers, in words, in JSON, as GeoJSON and as a picture.
#pragma once

#include <cli/common.h>
#include <cli/list_stream.h>
#include <cli/polygons_input.h>

#include <sunder/planar/set/polygon_contacts_in_order.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace sunder::cli {

struct PolygonsCall {
  std::vector<std::string> files;
  bool any = false, all = false, count = false;  // at most one; none: any
  std::string allow = "nothing";
  std::string method = "automatic";
  std::string group, name, certificate, geojson, svg, title;
  std::uint64_t svg_limit = most_drawn;  // edges and contacts
  bool drop_z = false, leave_out = false, skip_invalid = false, mend = false, self_touch = false;
  bool json = false;

  bool lists() const { return all || !geojson.empty() || !svg.empty(); }
  bool groups() const { return !group.empty(); }
};

struct PolygonsResult {
  std::unique_ptr<planar::PolygonContactsInOrder> contacts;  // of a list, else null
  std::optional<planar::PolygonsContact> found;              // with --any
  std::uint64_t touching = 0, overlapping = 0;
  Cost cost;

  std::uint64_t pairs() const { return touching + overlapping; }

  // Calls for each contact, in the order of i, then j, until the visitor returns false.
  void visit(const planar::PolygonContactsInOrder::Visitor& visitor) const {
    if (contacts) {
      contacts->visit(visitor);
    } else if (found) {
      visitor(*found);
    }
  }
};

// listed: the first of the contacts.
std::string human_text(const PolygonsCall& call, const PolygonsInput& input, const PolygonsResult& result,
                       std::span<const planar::PolygonsContact> listed);

// All but the contacts.
Json report(const PolygonsCall& call, const PolygonsInput& input, const PolygonsResult& result);

// A contact in the report, with its point.
Json to_json(const PolygonsCall& call, const PolygonsInput& input, const planar::PolygonsContact& contact);

// A contact as a point of a FeatureCollection. Properties: number (from 1), and those that it has in the report, but
// for the point. Bytes of names that are no UTF-8 become U+FFFD.
std::string contact_feature(const PolygonsCall& call, const PolygonsInput& input,
                            const planar::PolygonsContact& contact, std::uint64_t number);

// contacts: all of them.
std::string picture(const PolygonsCall& call, const PolygonsInput& input, const PolygonsResult& result,
                    std::span<const planar::PolygonsContact> contacts);

}  // namespace sunder::cli
