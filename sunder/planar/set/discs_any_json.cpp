#include <sunder/near/cover_order.h>
#include <sunder/planar/set/disc_boxes.h>
#include <sunder/planar/set/discs_any_json.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace sunder::planar {

namespace {

void begin(ClaimsWriter& file, const DiscsQuestion& question, std::string_view verdict) {
  file.begin_table("circles");
  for (const Disc& c : question.circles.all()) file.add_row(std::array{c.center.x, c.center.y, c.radius});
  file.end_table();
  file.begin_statement("circles");
  file.text("allowed", std::string(name_of(question.allowed)));
  if (!question.groups.empty()) file.indices("groups", question.groups);
  file.text("verdict", std::string(verdict));
}

void end_with_cover(ClaimsWriter& file, const DiscsQuestion& question) {
  file.begin_claims();
  file.begin_claim("cover");
  file.indices("order", cover_order(rounded_boxes(question.circles), question.groups));
  file.end_claim();
  file.end_statement();
}

template <class Write>
std::string text_of(const Write& write) {
  std::string text;
  ClaimsWriter file([&](std::string_view piece) { text += piece; });
  write(file);
  file.end();
  return text;
}

}  // namespace

void write_statement(ClaimsWriter& file, const DiscsQuestion& question, const DiscsAnswer& answer) {
  if (!answer.meet()) {
    begin(file, question, "none");
    end_with_cover(file, question);
    return;
  }
  begin(file, question, "some");
  const auto [i, j, kind] = *answer.found;
  file.index("i", i);
  file.index("j", j);
  file.text("kind", std::string(name_of(kind)));
  const ExactPoint2 p = common_point(question.circles[i], question.circles[j]);
  file.fractions("point", std::array{p.x, p.y}, p.denominator);
  file.begin_claims();
  file.begin_claim("contact");
  file.end_claim();
  file.end_statement();
}

void write_list_statement(ClaimsWriter& file, const DiscsQuestion& question, const EachDiscsContact& visit) {
  begin(file, question, "these");
  file.begin_list("contacts");
  visit([&](const DiscsContact& contact) { file.add_contact(contact.i, contact.j, name_of(contact.kind)); });
  file.end_list();
  end_with_cover(file, question);
}

void write_count_statement(ClaimsWriter& file, const DiscsQuestion& question, std::uint64_t number) {
  begin(file, question, "count");
  file.number("number", number);
  end_with_cover(file, question);
}

std::string certificate_text(const Discs& circles, Allowed allowed, const DiscsAnswer& answer, Groups groups) {
  return text_of([&](ClaimsWriter& file) { write_statement(file, {circles, allowed, groups}, answer); });
}

std::string certificate_text(const Discs& circles, Allowed allowed, DiscsAllAnswer answer, Groups groups) {
  std::sort(answer.contacts.begin(), answer.contacts.end());
  return text_of([&](ClaimsWriter& file) {
    write_list_statement(file, {circles, allowed, groups}, [&](const std::function<void(const DiscsContact&)>& take) {
      std::for_each(answer.contacts.begin(), answer.contacts.end(), take);
    });
  });
}

std::string certificate_text(const Discs& circles, Allowed allowed, const CountAnswer& answer, Groups groups) {
  return text_of([&](ClaimsWriter& file) { write_count_statement(file, {circles, allowed, groups}, answer.count); });
}

}  // namespace sunder::planar
