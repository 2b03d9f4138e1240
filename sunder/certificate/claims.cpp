#include <sunder/base/contract.h>
#include <sunder/base/error.h>
#include <sunder/base/json.h>
#include <sunder/certificate/claims.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace sunder {

namespace {

constexpr std::size_t kept = 1 << 16;       // bytes that wait to be given away
constexpr std::size_t most_of_text = 4000;  // characters
constexpr int inputs_part = 1, call_part = 2, left_out_part = 3, said_part = 4, tables_part = 5, statements_part = 6;
constexpr std::array<std::string_view, 7> parts{"", "inputs", "call", "left_out", "said", "tables", "statements"};

bool is_object(int part) { return part == said_part || part == tables_part; }

void append_double(std::string& text, double x) {
  std::array<char, 40> digits;
  const auto end =
      std::to_chars(digits.data(), digits.data() + digits.size(), std::fabs(x), std::chars_format::hex).ptr;
  text += std::signbit(x) ? "\"-0x" : "\"0x";
  text.append(digits.data(), end);
  text += '"';
}

void append_index(std::string& text, std::uint32_t value) {
  std::array<char, 12> digits;
  if (value == no_entry) {
    text += "-1";
  } else {
    text.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
  }
}

template <class Values, class Append>
void append_list(std::string& text, const Values& values, const Append& append) {
  text += '[';
  bool is_first = true;
  for (const auto& value : values) {
    if (!std::exchange(is_first, false)) text += ',';
    append(text, value);
  }
  text += ']';
}

void append_exact(std::string& text, const Dyadic& x) { text += '"' + x.hexadecimal() + '"'; }

void append_fraction(std::string& text, const Dyadic& x, const Dyadic& denominator) {
  text += '"' + fraction_text(x, denominator) + '"';
}

void append_fractions(std::string& text, std::span<const Dyadic> values, const Dyadic& denominator) {
  append_list(text, values, [&](std::string& to, const Dyadic& x) { append_fraction(to, x, denominator); });
}

}  // namespace

std::string cut_text(const std::string& text) {
  const std::string dots = "...";
  std::size_t characters = 0, end = 0;
  for (std::size_t i = 0; i < text.size(); i += std::max<std::size_t>(utf8_length(text, i), 1)) {
    if (characters++ == most_of_text - dots.size()) end = i;
  }
  return characters <= most_of_text ? text : text.substr(0, end) + dots;
}

std::string json_double(double x) {
  std::string text;
  append_double(text, x);
  return text;
}

void require_entries(std::size_t count) {
  if (count > 0) return;
  throw Error(ErrorCode::bad_shape, "nothing is left to prove something of; leave the proof out, or give more");
}

// ---- Structure.

void ClaimsWriter::flush(std::size_t most) {
  if (text_.size() <= most) return;
  sink_(text_);
  text_.clear();
}

void ClaimsWriter::next(bool on_new_line) {
  if (!std::exchange(is_first_, false)) text_ += on_new_line ? "," : ", ";
  if (on_new_line) text_ += "\n  ";
  flush(kept);
}

void ClaimsWriter::key(std::string_view name, bool on_new_line) {
  next(on_new_line);
  text_ += '"';
  text_ += name;
  text_ += "\": ";
}

void ClaimsWriter::open(std::string_view what, bool on_new_line) {
  next(on_new_line);
  text_ += what;
  is_first_ = true;
}

void ClaimsWriter::close(std::string_view what) {
  text_ += what;
  is_first_ = false;
}

// Ends the part of the file that is open, and begins the next ones up to this: each is there but for `said`.
void ClaimsWriter::go_to(int part) {
  while (part_ < part) {
    text_ += part_ == 0 ? "{\"sunder_certificate\": 3" : is_object(part_) ? "}" : "]";
    part_ += part_ + 1 == said_part && part != said_part ? 2 : 1;
    text_ += ",\n \"";
    text_ += parts[static_cast<std::size_t>(part_)];
    text_ += is_object(part_) ? "\": {" : "\": [";
    is_first_ = true;
  }
}

void ClaimsWriter::add_origin(const Origin& origin) {
  for (const InputFile& file : origin.inputs) add_input(file.name, file.sha256);
  for (const std::string& word : origin.call) add_call(word);
  for (const std::string& what : origin.left_out) add_left_out(what);
  for (const SaidOfRows& said : origin.said) add_said(said);
}

void ClaimsWriter::add_input(const std::string& name, const std::string& sha256) {
  SUNDER_REQUIRE(!name.empty());
  go_to(inputs_part);
  begin_entry();
  text("name", cut_text(name));
  text("sha256", sha256);
  end_entry();
}

void ClaimsWriter::add_call(const std::string& word) {
  go_to(call_part);
  next();
  text_ += json_string(cut_text(word));
}

void ClaimsWriter::add_said(const SaidOfRows& said) {
  go_to(said_part);
  key(said.table, true);
  append_list(text_, said.parts, [](std::string& text, const std::pair<std::uint64_t, Said>& part) {
    text.append("[").append(std::to_string(part.first)).append(", ").append(part.second.json()).append("]");
  });
  is_first_ = false;
}

void ClaimsWriter::add_left_out(const std::string& what) {
  go_to(left_out_part);
  next(true);
  text_ += json_string(cut_text(what));
}

void ClaimsWriter::begin_table(std::string_view name) {
  go_to(tables_part);
  key(name, true);
  text_ += '[';
  is_first_ = true;
}

void ClaimsWriter::add_row(std::span<const double> numbers) {
  next(true);
  append_list(text_, numbers, append_double);
}

void ClaimsWriter::end_table() {
  require_entries(is_first_ ? 0 : 1);
  close("]");
}

void ClaimsWriter::begin_rows() { open("[", true); }

void ClaimsWriter::end_rows() { close("]"); }

void ClaimsWriter::begin_statement(std::string_view question) {
  go_to(statements_part);
  open("{", true);
  text("question", question);
  if (notes_.empty()) return;
  key("said");
  text_.append("[").append(std::exchange(notes_, "")).append("]");
}

void ClaimsWriter::begin_claims() { begin_list("claims"); }

void ClaimsWriter::begin_claim(std::string_view kind) {
  open("{", true);
  text("claim", kind);
}

void ClaimsWriter::end_claim() { close("}"); }

void ClaimsWriter::claim(std::string_view kind) {
  begin_claim(kind);
  end_claim();
}

void ClaimsWriter::weights_claim(std::string_view kind, std::span<const Weight> weights) {
  begin_claim(kind);
  begin_list("weights");
  for (const auto& [entry, value] : weights) add_weight(entry, value);
  end_list();
  end_claim();
}

void ClaimsWriter::end_statement() { close("]}"); }

void ClaimsWriter::end() {
  go_to(statements_part);
  text_ += "]}\n";
  flush(0);
}

std::string claims_text(const Origin& origin, const std::function<void(ClaimsWriter& file)>& write) {
  std::string text;
  ClaimsWriter file([&](std::string_view piece) { text += piece; });
  file.add_origin(origin);
  write(file);
  file.end();
  return text;
}

// ---- Members and entries.

void ClaimsWriter::begin_entry() {
  open("{", true);
  if (part_ != tables_part || said_.empty()) return;
  key("said");
  text_ += std::exchange(said_, "");
}

void ClaimsWriter::end_entry() { close("}"); }

void ClaimsWriter::text(std::string_view name, std::string_view value) {
  key(name);
  text_ += json_string(value);
}

void ClaimsWriter::index(std::string_view name, std::uint32_t value) {
  key(name);
  append_index(text_, value);
}

void ClaimsWriter::number(std::string_view name, std::uint64_t value) {
  key(name);
  text_ += std::to_string(value);
}

void ClaimsWriter::indices(std::string_view name, std::span<const std::uint32_t> values) {
  key(name);
  append_list(text_, values, append_index);
}

void ClaimsWriter::real(std::string_view name, double value) {
  key(name);
  append_double(text_, value);
}

void ClaimsWriter::doubles(std::string_view name, std::span<const double> values) {
  key(name);
  append_list(text_, values, append_double);
}

void ClaimsWriter::numbers(std::string_view name, std::span<const Dyadic> values) {
  key(name);
  append_list(text_, values, append_exact);
}

void ClaimsWriter::integers(std::string_view name, std::span<const std::int64_t> values) {
  key(name);
  append_list(text_, values, [](std::string& text, std::int64_t n) { text += std::to_string(n); });
}

void ClaimsWriter::fraction(std::string_view name, const Dyadic& value, const Dyadic& denominator) {
  key(name);
  append_fraction(text_, value, denominator);
}

void ClaimsWriter::fractions(std::string_view name, std::span<const Dyadic> values, const Dyadic& denominator) {
  key(name);
  append_fractions(text_, values, denominator);
}

void ClaimsWriter::fractions(std::string_view name, const ExactPoint3& p, std::size_t dimension) {
  const std::array numerators{p.x, p.y, p.z};
  fractions(name, std::span(numerators).first(dimension), p.denominator);
}

void ClaimsWriter::begin_list(std::string_view name) {
  key(name);
  text_ += '[';
  is_first_ = true;
}

void ClaimsWriter::end_list() { close("]"); }

void ClaimsWriter::add_list(std::span<const std::uint32_t> values) {
  next();
  append_list(text_, values, append_index);
}

void ClaimsWriter::add_numbers(std::span<const double> values) {
  next();
  append_list(text_, values, append_double);
}

void ClaimsWriter::add_numbers(std::span<const Dyadic> values) {
  next();
  append_list(text_, values, append_exact);
}

void ClaimsWriter::begin_list() { open("[", true); }

void ClaimsWriter::add_contact(std::uint32_t i, std::uint32_t j, std::string_view kind) {
  next();
  text_ += '[';
  append_index(text_, i);
  text_ += ',';
  append_index(text_, j);
  text_ += ",\"";
  text_ += kind;
  text_ += "\"]";
}

void ClaimsWriter::add_weight(std::uint32_t entry, const Dyadic& weight) {
  next();
  text_ += '[';
  append_index(text_, entry);
  text_ += ", \"" + weight.hexadecimal() + "\"]";
}

void ClaimsWriter::add_weight(std::uint32_t entry, const Dyadic& weight, const Dyadic& denominator) {
  next();
  text_ += '[';
  append_index(text_, entry);
  text_ += ", ";
  append_fraction(text_, weight, denominator);
  text_ += ']';
}

void ClaimsWriter::add_fractions_and_index(std::span<const Dyadic> values, const Dyadic& denominator,
                                           std::uint32_t index) {
  next();
  text_ += '[';
  append_fractions(text_, values, denominator);
  text_ += ", ";
  append_index(text_, index);
  text_ += ']';
}

void ClaimsWriter::add_index(std::uint32_t index) {
  next();
  text_ += std::to_string(index);
}

void ClaimsWriter::add_null() {
  next();
  text_ += "null";
}

}  // namespace sunder
