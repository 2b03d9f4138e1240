// sunder boxes FILE: do any two boxes, whose sides are parallel to the axes, meet? Which? How many?
#include <sunder/ask/set/members_set.h>

#include <sunder/io/plane/lines.h>
#include <sunder/planar/boxes/boxes.h>

namespace sunder::ask {

namespace {

struct Boxes {
  using Members = planar::Boxes;
  static constexpr std::string_view verb = "boxes", noun = "box";
  static constexpr const char* about_verb =
      "Do any two boxes (rectangles with sides parallel to the axes) in a file meet?";
  static constexpr const char* file_help =
      "boxes: CSV, one in each row: x1,y1,x2,y2 (two opposite corners), and optionally a name";

  static MembersFile<Members> read(const SetCall& call, const Talk&, InputFiles* inputs) {
    io::LineFile file = io::read_lines(
        call.files[0], {.group = call.group, .name = call.name, .properties = call.properties, .inputs = inputs});
    if (file.format != "CSV") io::fail_file(call.files[0], "has no boxes; give CSV, x1,y1,x2,y2");
    std::vector<Box2> boxes;
    for (const planar::Segment& s : file.segments) boxes.push_back(hull(Box2{s.a, s.a}, Box2{s.b, s.b}));
    std::vector<std::string> names;
    std::vector<std::uint32_t> lines;
    for (const io::LineSource& source : file.source) {
      names.push_back(file.features[source.feature]);
      lines.push_back(source.line);
    }
    return {Members(std::move(boxes)), std::move(names),       std::move(lines),
            std::move(file.group),     std::move(file.groups), std::move(file.properties)};
  }

  static std::string about(const Box2& b) { return place_text(b.low) + " to " + place_text(b.high); }
  static Point2 place(const Box2& a, const Box2& b) { return common_part(a, b).low; }
  static void draw(PlanePicture& picture, const Box2& b, Ink ink) {
    picture.polygon(std::array{b.low, Point2{b.high.x, b.low.y}, b.high, Point2{b.low.x, b.high.y}}, ink);
  }
};

}  // namespace

Verb boxes_verb() { return members_verb<Boxes>(); }

}  // namespace sunder::ask
