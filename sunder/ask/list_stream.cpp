#include <sunder/ask/list_stream.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace sunder::ask {

namespace {

constexpr std::size_t piece_size = std::size_t{1} << 16;

// The text of the report before and behind the items of the list.
std::pair<std::string, std::string> around(Json report, std::string_view list) {
  report[list] = Json::array();
  const std::string text = to_text(report), opening = fmt::format("\n  {}: [", quoted_json(list));
  const std::size_t middle = text.find(opening) + opening.size();
  return {text.substr(0, middle), text.substr(middle)};
}

// What a collection begins with.
std::string opening_of(Talk& talk, const io::CoordinateSystems& systems) {
  const io::CoordinateSystem* const only = systems.only();
  std::string crs;
  if (only != nullptr && !only->urn.empty()) {
    crs = fmt::format(R"("crs":{{"type":"name","properties":{{"name":{}}}}},)", quoted_json(only->urn));
  } else if (!systems.declared().empty() && (only == nullptr || !only->is_assumed)) {
    talk.note(fmt::format("the GeoJSON written names no coordinate system: {}",
                          only == nullptr ? "those read differ" : "that of " + only->name));
  }
  return fmt::format(R"({{"type":"FeatureCollection",{}"features":[)", crs);
}

}  // namespace

ListStream::ListStream(std::string opening, std::string margin, TextSink sink)
    : text_(std::move(opening)), margin_(std::move(margin)), sink_(std::move(sink)) {}

void ListStream::add(std::string_view item) {
  text_ += count_++ == 0 ? "\n" : ",\n";
  text_ += margin_;
  append(item);
}

void ListStream::append(std::string_view more) {
  text_ += more;
  if (text_.size() < piece_size) return;
  sink_(text_);
  text_.clear();
}

void ListStream::close(std::string_view closing) {
  text_ += closing;
  sink_(text_);
  text_.clear();
}

ListReport::ListReport(Talk& talk, std::pair<std::string, std::string> around)
    : list_(std::move(around.first), "    ", [&talk](std::string_view text) { talk.print(text); }),
      closing_(std::move(around.second)) {}

ListReport::ListReport(Talk& talk, const Json& report, std::string_view list)
    : ListReport(talk, around(report, list)) {}

void ListReport::add_list(const Json& head, std::string_view key, const std::function<void(ListStream&)>& fill) {
  std::string opening = head.on_one_line();
  opening.pop_back();  // "}"
  list_.add(fmt::format("{}, {}: [", opening, quoted_json(key)));
  ListStream items("", "      ", [this](std::string_view text) { list_.append(text); });
  fill(items);
  items.close(items.count() == 0 ? "]}" : "\n    ]}");
}

void ListReport::close() { list_.close((list_.count() == 0 ? "" : "\n  ") + closing_); }

GeojsonFile::GeojsonFile(Talk& talk, const std::string& name, const io::CoordinateSystems& systems)
    : file_(name, talk.instead(name)),
      list_(opening_of(talk, systems), "", [this](std::string_view text) { file_.write(text); }) {}

void GeojsonFile::close() {
  list_.close("\n]}\n");
  file_.commit();
}

void add_quoted_json(std::string& to, std::string_view text) {
  const bool is_plain =
      std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c < 127 && c != '"' && c != '\\'; });
  if (is_plain) {
    (to += '"').append(text) += '"';
  } else {
    to += json_string(text);
  }
}

std::string quoted_json(std::string_view text) {
  std::string quoted;
  add_quoted_json(quoted, text);
  return quoted;
}

}  // namespace sunder::ask
