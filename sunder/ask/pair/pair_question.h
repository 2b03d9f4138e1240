// What sunder pair tells of two objects of any kind.
#pragma once

#include <sunder/ask/evidence.h>
#include <sunder/ask/question.h>

#include <sunder/certificate/pair_claims.h>
#include <sunder/planar/set/contact_rule.h>

#include <functional>
#include <string>
#include <string_view>

namespace sunder::ask {

// The options for pairs of all kinds.
struct PairCall : QuestionCall {
  std::string file_a, file_b;
  std::string feature_a, feature_b;  // planar; empty: the only one
  std::string pose_a, pose_b;
  bool classify = false;
  bool distance = false;
  std::string clearance;            // a number: is one that far from the other? Empty: it is not asked
  bool mend = false, hull = false;  // planar: what to do with vertices that are not those of a convex polygon
  bool drop_z = false;
  bool leave_out = false;  // what is no object here; of meshes, what is not read
  bool require_convex = false;
};

// What questions (question.h) about pairs share. Each kind asks, and fills in what is protected here.
class PairQuestion {
 public:
  static constexpr const char *verb = "pair", *drawn_noun = "point";
  const PairCall& call;

  PairQuestion(const PairCall& asked, const LeftOutList& left_out, Origin origin)
      : call(asked), left_out_(left_out), origin_(std::move(origin)) {
    origin_.left_out = left_out.texts();
  }

  const char* answer() const { return meet_ ? "meet" : "apart"; }
  const Cost& cost() const { return cost_; }
  std::string cost_text() const;
  const char* proof_clause() const { return ""; }

 protected:
  // "a.obj and b.obj: meet (touching)". verdict: "meet"
  std::string head(const std::string& a, const std::string& b, std::string_view verdict) const;
  void add_head(Json& json, const Json& a, const Json& b) const;

  // A certificate of two bodies: write adds the statements.
  std::string certificate_of(PairClaims::Space space, const std::function<void(PairClaims&)>& write) const;

  const LeftOutList& left_out_;
  Origin origin_;
  bool meet_ = false;
  Contact contact_ = Contact::none;
  DecidedBy decided_by_ = DecidedBy::filter;
  Cost cost_;
};

}  // namespace sunder::ask
