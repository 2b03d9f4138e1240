#include <sunder/ask/call_words.h>
#include <sunder/ask/scene/row_run.h>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace sunder::ask {

namespace {

// What the answer says and a proof of --meeting-certificate does not, in words.
std::vector<std::string> not_proved(const PlacementsCall& call) {
  std::vector<std::string> words{"the joint values"};
  if (!call.parted) words.emplace_back("what is apart");
  return words;
}

}  // namespace

LineFiles::LineFiles(const PlacementsCall& call, Talk& talk)
    : call_(call),
      talk_(talk),
      has_text_(call.json_lines.empty() && call.csv.empty() && call.meeting_certificate.empty()) {
  if (!call.json_lines.empty()) json_.emplace(call.json_lines, talk.instead(call.json_lines));
  if (!call.csv.empty()) csv_.emplace(call.csv, talk.instead(call.csv));
}

void LineFiles::write(const LineTexts& lines) {
  if (has_text_) talk_.print_for_people(lines.text);
  if (json_) json_->write(lines.json);
  if (csv_) csv_->write(lines.csv);
}

TextSink LineFiles::certificate() {
  certificate_.emplace(call_.meeting_certificate, talk_.instead(call_.meeting_certificate));
  return [&](std::string_view text) { certificate_->write(text); };
}

void LineFiles::commit() {
  for (auto* file : {&json_, &csv_, &certificate_}) {
    if (*file) (*file)->commit();
  }
}

RowRun::RowRun(const RowsAsked& asked, bool between)
    : talk_(asked.talk),
      call_(asked.call),
      cell_(asked.cell),
      question_(asked.question),
      near_(asked.near),
      table_(asked.table),
      inputs_(asked.inputs),
      allowed_(asked.allowed),
      rows_(cell_, table_),
      bodies_(cell_.place()),
      files_(call_, talk_),
      lines_(cell_, bodies_, question_, near_, files_.kinds()),
      between_(between) {}

LineTexts RowRun::header() const {
  Json json{{"verb", "scene"}};
  if (between_) json["between"] = true;
  json["joints"] = table_.joints;
  json["placements"] = table_.rows();
  json["bodies"] = Json::array();
  for (const scene::Body& body : bodies_) {
    Json parts = Json::array();
    for (const scene::Part& part : body.parts) parts.push_back(part.name);
    json["bodies"].push_back({{"name", body.name}, {"parts", parts}});
  }
  if (!between_) json["allowed"] = question_.touching_allowed ? "touch" : "nothing";
  json["allowed_pairs"] = Json::array();
  for (const auto& [a, b] : question_.allowed) json["allowed_pairs"].push_back({bodies_[a].name, bodies_[b].name});
  json["allowed_reasons"] = allowed_json(allowed_);
  if (Json attached = attached_json(cell_); !attached.empty()) json["attached"] = std::move(attached);
  if (!cell_.left_out().empty()) json["left_out"] = to_json(cell_.left_out());
  if (!call_.meeting_certificate.empty()) json["not_proved"] = not_proved(call_);
  return lines_.header(std::move(json), between_ ? "step" : "placement");
}

std::string RowRun::beginning(std::uint64_t some, std::uint64_t asked, std::string_view row_name,
                              std::string_view what) const {
  return fmt::format("{} of {} {} {}{}", some, count_of(asked, row_name), some == 1 || asked == 1 ? "has" : "have",
                     what, cell_.left_out().empty() ? "" : ", among the bodies read");
}

std::string RowRun::ending(std::string_view proofs, std::string_view why_none) const {
  std::string text = cell_.left_out().clause() + allowed_clause(allowed_) + "\n" +
                     file_line("JSON lines", call_.json_lines) + file_line("table", call_.csv);
  if (call_.meeting_certificate.empty()) return text;
  if (!files_.has_certificate()) return text + fmt::format("  no proofs are written, as {}\n", why_none);
  return text + file_line(fmt::format("proofs of {}", proofs), call_.meeting_certificate) +
         not_proved_line(not_proved(call_));
}

Origin RowRun::origin() const { return origin_of(talk_, inputs_, left_out_texts(cell_.left_out(), allowed_)); }

scene::SaidOfScene RowRun::said_of_rows() const {
  const auto file = std::find_if(inputs_.begin(), inputs_.end(),
                                 [&](const InputFile& input) { return io::one_line(input.name) == table_.file; });
  const auto number =
      file == inputs_.end() ? std::nullopt : std::optional(static_cast<std::size_t>(file - inputs_.begin()));
  return {said_of(cell_, inputs_), reason_of_each(allowed_),
          [this, number](std::size_t row) {
            std::vector<std::pair<std::string, double>> values;
            for (std::size_t c = 0; c < table_.columns; ++c) values.emplace_back(table_.joints[c], table_.row(row)[c]);
            return SaidNote::joint_values(values, row, number);
          },
          said_of(cell_, inputs_, true)};
}

}  // namespace sunder::ask
