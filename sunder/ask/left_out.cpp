#include <sunder/ask/left_out.h>

namespace sunder::ask {

const char* const leave_out_help = "ask without what is not read (shapes, lines, loose vertices), and say so";

Json to_json(const LeftOutList& list) {
  Json json = Json::array();
  for (const LeftOutList::Kind& kind : list.kinds()) {
    json.push_back({{"kind", kind.name}, {"count", kind.count}, {"of", kind.of}});
  }
  return json;
}

}  // namespace sunder::ask
