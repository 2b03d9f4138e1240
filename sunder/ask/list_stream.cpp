#include <sunder/ask/list_stream.h>

#include <sunder/base/error.h>
#include <sunder/io/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <utility>

namespace sunder::ask {

namespace {

constexpr std::size_t piece = std::size_t{1} << 16;

// The members of the report that stand before the list, or those behind it.
Json part_of(const Json& report, std::string_view list, bool is_before) {
  Json part = Json::object();
  bool is_passed = false;
  for (const auto& [key, value] : report.items()) {
    if (key == list) {
      is_passed = true;
    } else if (is_passed != is_before) {
      part[key] = value;
    }
  }
  return part;
}

std::string opening_of(const Json& report, std::string_view list) {
  std::string text = to_text(part_of(report, list, true));
  text.resize(text.size() - 3);  // "\n}\n"
  return fmt::format("{},\n  {}: [", text, quoted_json(list));
}

std::string closing_of(const Json& report, std::string_view list) {
  const Json part = part_of(report, list, false);
  return part.empty() ? "\n}\n" : "," + to_text(part).substr(1);  // "{"
}

}  // namespace

ListStream::ListStream(std::string opening, std::string margin, Sink sink)
    : text_(std::move(opening)), margin_(std::move(margin)), sink_(std::move(sink)) {}

void ListStream::add(std::string_view item) {
  text_ += count_++ == 0 ? "\n" : ",\n";
  text_ += margin_;
  append(item);
}

void ListStream::append(std::string_view more) {
  text_ += more;
  if (text_.size() < piece) return;
  sink_(text_);
  text_.clear();
}

void ListStream::close(std::string_view closing) {
  text_ += closing;
  sink_(text_);
  text_.clear();
}

ListReport::ListReport(const Json& report, std::string_view list)
    : list_(opening_of(report, list), "    ", print), closing_(closing_of(report, list)) {}

void ListReport::add_list(const Json& head, std::string_view key, const std::function<void(ListStream&)>& fill) {
  std::string opening = to_line(head);
  opening.pop_back();  // "}"
  list_.add(fmt::format("{}, {}: [", opening, quoted_json(key)));
  ListStream items("", "      ", [this](std::string_view text) { list_.append(text); });
  fill(items);
  items.close(items.count() == 0 ? "]}" : "\n    ]}");
}

void ListReport::close() { list_.close((list_.count() == 0 ? "]" : "\n  ]") + closing_); }

GeojsonFile::GeojsonFile(const std::string& name)
    : file_(name),
      list_(R"({"type":"FeatureCollection","features":[)", "", [this](std::string_view text) { file_.write(text); }) {}

void GeojsonFile::close() {
  list_.close("\n]}\n");
  file_.commit();
}

std::string quoted_json(std::string_view text) {
  const bool is_plain =
      std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c < 127 && c != '"' && c != '\\'; });
  if (is_plain) return fmt::format("\"{}\"", text);
  return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string number_json(double x) {
  std::array<char, 32> digits{};
  std::string text(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), x).ptr);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

std::string pair_json(std::string_view first, std::string_view second) {
  return fmt::format("[{}, {}]", first, second);
}

void require_drawable(std::uint64_t things, std::string_view noun, std::uint64_t contacts, std::uint64_t most) {
  if (things + contacts <= most) return;
  throw Error(ErrorCode::bad_call,
              fmt::format("{}{}: more than {}, a picture too large to look at; leave it out, or give --svg-limit {}",
                          count_of(things, noun), contacts > 0 ? " and " + count_of(contacts, "contact") : "", most,
                          things + contacts),
              "--svg");
}

void require_provable(std::uint64_t contacts) {
  constexpr std::uint64_t most = 10'000'000, bytes_each = 24;  // [1234567,1234567,"inside"],
  if (contacts <= most) return;
  throw Error(ErrorCode::bad_call,
              fmt::format("the proof of a list is as long as the list: {} contacts, about {} MB; ask for --count",
                          contacts, contacts * bytes_each / 1'000'000),
              "--certificate");
}

}  // namespace sunder::ask
