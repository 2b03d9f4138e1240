// What sunder pair is asked about two objects of any kind, and tells of them.
#pragma once

#include <sunder/ask/question.h>
#include <sunder/ask/said_of.h>

#include <sunder/base/error.h>
#include <sunder/certificate/direction.h>
#include <sunder/certificate/pair_claims.h>
#include <sunder/solid/round/round_body.h>

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::ask {

// What is given of A, or of B.
struct PairSide {
  std::string letter;  // "a"
  std::string file, pose;
  std::string feature;       // planar; empty: the only one
  std::string radius;        // of space: a number, by which the body is larger all around; empty: none
  std::string to{};          // of space: the pose at the end of a straight motion; empty: it rests
  std::string poses{};       // of polytopes: a file of poses, each of which is asked about; empty: none
  std::string body{};        // of a scene file: NAME, or NAME/PART; empty: the file is the object
  bool half_spaces = false;  // of polytopes: rows without names are half-spaces

  std::string option(const char* name) const { return std::string("--") + name + "-" + letter; }
};

// The options for pairs of all kinds.
struct PairCall : QuestionCall {
  PairSide a{"a", {}, {}, {}, {}}, b{"b", {}, {}, {}, {}};
  bool classify = false;
  bool distance = false;
  bool depth = false;     // of bounded objects
  bool support = false;   // of a body and a line: the planes through it that support the body
  std::string clearance;  // a number: is one that far from the other? Empty: it is not asked
  bool mend = false;      // planar: leave vertices out that are none of a convex polygon
  bool hull = false;      // what is not convex is replaced by its hull
  bool surface = false;   // of meshes as they are: what open pieces seem to enclose is not asked about
  bool drop_z = false, mixed_crs = false;
  std::string project;     // of space: a frame, nine numbers, that polygons are projected on; empty: none
  bool leave_out = false;  // what is no object here; of meshes, what is not read
  bool require_convex = false;
  bool polytopes = false;    // both are polytopes of any dimension
  bool hyperplanes = false;  // of polytopes, by trees: several hyperplanes are the evidence that they are apart
};

// What the files are, and what of them is left out.
struct PairFiles {
  PairFiles(const PairCall& call, Talk& told)
      : talk(told), left_out(call.leave_out), systems(call.mixed_crs), tells_inputs(call.proves()) {}

  Talk& talk;
  LeftOutList left_out;
  io::CoordinateSystems systems;  // planar
  bool tells_inputs;
  InputFiles read;
  InputFiles* inputs() { return tells_inputs ? &read : nullptr; }  // as of io::read_file
};

// A or B, as the answer tells of it.
struct PairObject {
  std::string file, name;
  std::string text;  // for people
  Json json;

  // As a body of certificates: in the plane z = 0, where it is planar. Ways: of an unbounded one.
  std::span<const Point3> vertices;
  Affine3 pose{};
  std::span<const Way3> ways{};
  Said said{};  // what it is made of, in proofs

  const solid::RoundBody* round = nullptr;  // of a body that may have a radius: that

  PlacedVertices in_space() const { return {vertices, pose, false}; }
};

// A part of an answer, to programs and to people: a feature of A or B, say.
struct Told {
  Json json;
  std::string text;
};

inline Fact fact_of(std::string key, Told told) { return {std::move(key), std::move(told.json), std::move(told.text)}; }

// What questions (question.h) about pairs share. ask() of each kind fills in what is protected here.
class PairQuestion {
 public:
  static constexpr const char *verb = "pair", *drawn_noun = "point";
  const PairCall& call;

  using Space = PairClaims::Space;
  PairQuestion(const PairCall& asked, PairObject a, PairObject b, const PairFiles& files, Space space = Space::solid)
      : call(asked), a_(std::move(a)), b_(std::move(b)), files_(files), space_(space) {}

  static std::uint64_t drawn() { return 0; }  // these two for planar pairs
  static std::string picture() { return ""; }
  std::string certificate() const;  // all that was stated. Throws Error for what is undecided
  Report report() const;

 protected:
  template <class Answer>
  void take(const Answer& answer, std::string decided_text) {
    meet_ = answer.meet();
    is_undecided_ = answer.undecided();
    is_yes_ = meet_ || is_undecided_;  // what is undecided is not known to be apart
    verdict_ = word_ = name_of(answer.verdict());
    decided_by_ = answer.decided_by;
    decided_text_ = std::move(decided_text);
    cost_ = answer.cost;
  }

  // A point, or a direction and a gap.
  Fact evidence(const PairCertificate& certificate) const;

  Origin origin() const { return origin_of(files_.talk, files_.read, files_.left_out.texts()); }

  // What the proof says of two bodies of its file, of these numbers. It is made when the proof is written.
  using Statement = std::function<void(PairClaims&, std::uint32_t first, std::uint32_t second)>;
  void state(Statement statement) { statements_.push_back(std::move(statement)); }
  void require_decided() const;

  PairObject a_, b_;
  const PairFiles& files_;
  bool meet_ = false, is_undecided_ = false, is_yes_ = false;  // is_yes_: is the exit code 1?
  std::string word_, verdict_, decided_text_;                  // word_: the answer; the others are for people
  Relation contact_ = Relation::none;
  DecidedBy decided_by_ = DecidedBy::filter;
  Cost cost_;
  std::string_view function_;  // of the library, that decided whether they meet
  std::vector<Fact> facts_;    // their texts stand under their keys
  std::vector<std::string> not_proved_;
  Space space_;
  bool is_b_first_ = false;  // in the proof
  std::vector<Statement> statements_;
};

// What two objects are: of which kinds options are (verb.h).
namespace pair_kind {
inline const std::string polytopes = "polytopes", planar = "planar objects that are bounded",
                         planar_lines = "planar lines, rays and half-planes", bodies = "bounded objects of space",
                         flats = "lines, rays and planes of space", round = "bodies with a radius",
                         moving = "moving bodies", meshes = "meshes that are not convex",
                         moving_meshes = "moving meshes that are not convex";
}  // namespace pair_kind

// Throws Error bad_call for an option that is for none of these kinds.
void require_pair_fit(const PairCall& call, const std::vector<std::string>& kinds);

// Who decided, in words.
std::string decided_text(DecidedBy decided_by);

std::string about(const Point2& p);  // "(x, y)", four digits

}  // namespace sunder::ask
