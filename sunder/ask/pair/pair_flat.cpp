#include <sunder/ask/pair/pair_space.h>

#include <sunder/base/error.h>
#include <sunder/solid/line/flat_flat.h>

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string>

namespace sunder::ask {

namespace {

using FlatMethod = solid::FlatCommon(const solid::Flat&, const solid::Flat&);
constexpr std::array<Named<FlatMethod>, 1> flat_methods{{SUNDER_METHOD("automatic", solid::flat_flat)}};

// Two of lines, rays and planes.
class FlatPair : public PairQuestion {
 public:
  FlatPair(const PairCall& asked, const PlacedFlat& a, const PlacedFlat& b, const PairFiles& files)
      : PairQuestion(asked, a.object_of(asked), b.object_of(asked), files),
        method_(method_by(asked.method, flat_methods, " (of lines, rays and planes)")),
        of_a_(a),
        of_b_(b) {}

  void ask() {
    function_ = method_.function;
    common_ = method_(of_a_.flat, of_b_.flat);
    take(common_, common_.decided_by == DecidedBy::filter ? "signs, by floating-point filters alone"
                                                          : "signs, with the help of exact arithmetic");
    contact_ = common_.evidence.contact;
    facts_ = {{"common", common_json(), common_text()}};
    part_ = solid::common_part(of_a_.flat, of_b_.flat, common_);
    if (meet_ && !part_) not_proved_.emplace_back("the common part");
    state([this](auto& pairs, auto a, auto b) {
      add_claims(pairs, a, b, of_a_.flat, *of_a_.body, of_b_.flat, *of_b_.body, common_, call.classify);
      if (part_) add_common_part(pairs, a, b, of_a_.flat, *of_a_.body, of_b_.flat, *of_b_.body, *part_);
    });
  }

 private:
  Point3 point() const { return nearest(common_point(of_a_.flat, of_b_.flat, common_)); }

  Json common_json() const {
    Json json{{"kind", name_of(common_.evidence.kind)}};
    if (meet_) json["point"] = to_json(point());
    return json;
  }
  std::string common_text() const {
    if (!meet_) return "nothing";
    if (common_.evidence.kind == solid::FlatKind::point) return "one point, about " + about(point());
    return fmt::format("a {} through about {}", name_of(common_.evidence.kind), about(point()));
  }

  Named<FlatMethod> method_;
  const PlacedFlat &of_a_, &of_b_;
  solid::FlatCommon common_;
  std::optional<solid::FlatPart> part_;
};

// Option --support takes a line and a body: other objects are refused.
void require_line_and_body(const SpaceInput& a, const SpaceInput& b) {
  const auto refuse = [](const std::string& why) { throw Error(ErrorCode::bad_call, why, "--support"); };
  const auto quoted = [](const SpaceInput& input) { return io::quote(io::one_line(input.flat->file)); };
  if (a.flat && b.flat) {
    refuse(fmt::format("neither {} nor {} is a body; give a body with an inside, and a line", quoted(a), quoted(b)));
  }
  const SpaceInput& flat = a.flat ? a : b;
  if (std::holds_alternative<solid::Plane>(flat.flat->flat)) {
    refuse(fmt::format("{} is a plane; give a line, by two of its points", quoted(flat)));
  }
}

}  // namespace

Report run_flat_pair(const PairCall& call, const SpaceInput& a, const SpaceInput& b, const PairFiles& files) {
  require_pair_fit(call, {pair_kind::flats});
  if (call.support) require_line_and_body(a, b);
  if (a.flat && b.flat) {
    return answer(FlatPair(call, *a.flat, *b.flat, files), files.talk);
  }
  const bool body_is_a = a.bounded.has_value();
  const PlacedBody& body = body_is_a ? *a.bounded : *b.bounded;
  const PlacedFlat& flat = body_is_a ? *b.flat : *a.flat;
  const bool is_plane = std::holds_alternative<solid::Plane>(flat.flat);
  return (is_plane ? run_plane_pair : run_line_pair)(call, body, flat, body_is_a, files);
}

}  // namespace sunder::ask
