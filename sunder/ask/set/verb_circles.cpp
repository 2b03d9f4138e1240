// sunder circles FILE: do any two circles, with their insides, meet? Which? How many?
#include <sunder/ask/set/members_set.h>

#include <sunder/io/text/triples.h>
#include <sunder/planar/discs/discs_all.h>
#include <sunder/planar/discs/discs_any_claims.h>

namespace sunder::ask {

namespace {

using planar::Discs;

using DiscsAnyMethod = planar::DiscsAnswer(const Discs&, const SetOptions&);

struct Circles {
  using Members = Discs;
  static constexpr std::string_view verb = "circles", noun = "circle";
  static constexpr const char* about_verb = "Do any two discs (circles with their interiors) in a file meet?";
  static constexpr const char* file_help =
      "circles: CSV, one in each row: x,y,r (center and radius), and optionally a name";
  static constexpr std::array<Named<DiscsAnyMethod>, 4> any_methods{
      {SUNDER_METHOD("automatic", planar::discs_any), SUNDER_METHOD("grid", planar::discs_any_by_grid),
       SUNDER_METHOD("sweep", planar::discs_any_by_sweep), SUNDER_METHOD("scan", planar::discs_any_by_scan)}};
  static constexpr std::array<Named<planar::DiscsMethod>, 4> all_methods{
      {SUNDER_METHOD("automatic", planar::discs_visit), SUNDER_METHOD("grid", planar::discs_all_by_grid),
       SUNDER_METHOD("sweep", planar::discs_all_by_sweep), SUNDER_METHOD("scan", planar::discs_all_by_scan)}};

  static MembersFile<Discs> read(const SetCall& call, const Talk& talk, InputFiles* inputs) {
    auto [file, circles] = io::read_circles(call.files[0], {.group = call.group,
                                                            .name = call.name,
                                                            .properties = call.properties,
                                                            .progress = talk.progress("reading"),
                                                            .inputs = inputs});
    return {std::move(circles),    std::move(file.name),   std::move(file.line),
            std::move(file.group), std::move(file.groups), std::move(file.properties)};
  }

  static std::string about(const Disc& c) {
    return fmt::format("centre {}, radius {:.10g}", place_text(c.center), c.radius);
  }
  static Point2 place(const Disc& c, const Disc& d) { return planar::common_point_rounded(c, d); }
  static void draw(PlanePicture& picture, const Disc& c, Ink ink) { picture.circle(c, ink); }
};

}  // namespace

Verb circles_verb() { return members_verb<Circles>(); }

}  // namespace sunder::ask
