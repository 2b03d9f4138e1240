// The writer of certificate files (docs/claims.md): tables, then statements with the claims that prove them. Numbers
// are exact. It writes as it goes, and keeps nothing but what it has not yet given away.
// Throws only std::bad_alloc, what the sink throws, and what end_table() says. Cost: linear in what is written.
#pragma once

#include <sunder/base/error.h>
#include <sunder/certificate/origin.h>
#include <sunder/certificate/said.h>
#include <sunder/number/dyadic.h>
#include <sunder/predicate/exact_point.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace sunder {

// Takes the text, piece by piece.
using TextSink = std::function<void(std::string_view)>;

inline constexpr std::uint32_t no_entry = 0xffffffffu;  // -1 in the file

struct Weight {
  std::uint32_t entry;
  Dyadic value;
};

// Calls follow the file: inputs, the call, what was left out, what is said of rows, then tables, then statements, each
// with its members, then its claims.
class ClaimsWriter {
 public:
  explicit ClaimsWriter(TextSink sink) : sink_(std::move(sink)) {}

  void add_origin(const Origin& origin);
  // What the tables were made of. Requires a name.
  void add_input(const std::string& name, const std::string& sha256);
  // A word of the call that made it, as far as this says how inputs are read. Requires a text.
  void add_call(const std::string& word);
  // What the file does not speak of. Cut to 4,000 characters, and then ends in "...".
  void add_left_out(const std::string& what);
  // What the entries of a table of rows are made of. Each table comes once.
  void add_said(const SaidOfRows& said);

  // What is said of the next entry that begin_entry() begins in a table; of the next statement. Notes add up.
  void say(const Said& said) { said_ = said.json(); }
  void note(const SaidNote& note) { notes_ += (notes_.empty() ? "" : ", ") + note.json(); }

  void begin_table(std::string_view name);
  void add_row(std::span<const double> numbers);
  // Throws as require_entries(), of the entries of the table.
  void end_table();
  // An entry that is a list of rows, each an add_row().
  void begin_rows();
  void end_rows();

  void begin_statement(std::string_view question);
  void begin_claims();
  void begin_claim(std::string_view kind);
  void end_claim();
  void claim(std::string_view kind);  // one without members
  void weights_claim(std::string_view kind, std::span<const Weight> weights);
  void end_statement();
  // Ends the file.
  void end();

  // Members of the object that is open: an entry of a table, a statement, a claim.
  void begin_entry();
  void end_entry();
  void text(std::string_view key, std::string_view value);
  void index(std::string_view key, std::uint32_t value);
  void number(std::string_view key, std::uint64_t value);
  void indices(std::string_view key, std::span<const std::uint32_t> values);
  void integers(std::string_view key, std::span<const std::int64_t> values);
  void real(std::string_view key, double value);
  void doubles(std::string_view key, std::span<const double> values);
  void numbers(std::string_view key, std::span<const Dyadic> values);
  // Divided by the denominator, which is not zero.
  void fraction(std::string_view key, const Dyadic& value, const Dyadic& denominator);
  // Each divided by it.
  void fractions(std::string_view key, std::span<const Dyadic> values, const Dyadic& denominator);
  // The first so many of the point's coordinates; its denominator is not zero.
  void fractions(std::string_view key, const ExactPoint3& point, std::size_t dimension = 3);
  void begin_list(std::string_view key);
  void end_list();

  // Entries of the list that is open.
  void add_list(std::span<const std::uint32_t> values);
  void add_numbers(std::span<const double> values);
  void add_numbers(std::span<const Dyadic> values);
  void begin_list();  // a list itself
  void add_contact(std::uint32_t i, std::uint32_t j, std::string_view kind);
  void add_weight(std::uint32_t entry, const Dyadic& weight);
  void add_weight(std::uint32_t entry, const Dyadic& weight, const Dyadic& denominator);
  void add_fractions_and_index(std::span<const Dyadic> values, const Dyadic& denominator, std::uint32_t index);
  void add_index(std::uint32_t index);
  void add_null();

 private:
  void open(std::string_view what, bool on_new_line);
  void close(std::string_view what);
  void next(bool on_new_line = false);
  void key(std::string_view name, bool on_new_line = false);
  void go_to(int part);
  void flush(std::size_t most);

  TextSink sink_;
  std::string text_;
  bool is_first_ = true;      // of the object or list that is open
  int part_ = 0;              // of the file; 0: nothing yet
  std::string said_, notes_;  // of what comes next
};

// The file as one text: write(file) writes all but its end.
std::string claims_text(const Origin& origin, const std::function<void(ClaimsWriter& file)>& write);

// The text, or its beginning and "...": at most 4,000 characters, where a byte that is not UTF-8 counts as one.
std::string cut_text(const std::string& text);

// Throws Error bad_shape where a proof would be about nothing: checkers refuse such statements.
void require_entries(std::size_t count);

// The double as a string of JSON.
std::string json_double(double x);

}  // namespace sunder
