// sunder scene FILE...: which of these bodies meet?
#include <sunder/ask/list_stream.h>
#include <sunder/ask/outputs.h>
#include <sunder/ask/report.h>
#include <sunder/ask/scene/scene_input.h>
#include <sunder/ask/scene/scene_report.h>
#include <sunder/ask/verb.h>

#include <sunder/base/error.h>
#include <sunder/io/file.h>
#include <sunder/io/text.h>
#include <sunder/picture/scene.h>

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <string_view>

namespace sunder::ask {

namespace {

struct Call {
  std::vector<std::string> files, poses, joints, joints_files, allow;
  std::string method = "automatic";
  std::string certificate, svg, title;
  std::uint64_t svg_limit = 200'000;  // facets
  bool classify = false;
  bool require_convex = false;
  bool leave_out = false;
  bool json = false;
};

std::vector<Placement> placements_of(const Call& call, InputFiles* inputs) {
  std::vector<Placement> placements;
  for (const std::string& file : call.joints_files) placements.push_back(read_joints(file, inputs));
  for (const std::string& text : call.joints) placements.push_back(parse_joints(text));
  if (placements.empty()) placements.emplace_back();
  return placements;
}

Placed ask(const SceneInput& input, const Placement& placement, const std::string& title,
           const scene::Question& question) {
  Placed placed;
  placed.placement = placement;
  placed.title = title;
  placed.bodies = input.bodies(placement);
  const auto start = std::chrono::steady_clock::now();
  placed.answer = scene::meeting_pairs(placed.bodies, question);
  placed.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return placed;
}

// What the call names is compared before anything is read; what a robot's file names, here.
void require_apart(const Call& call, const SceneInput& input) {
  std::vector<NamedFile> meshes, outputs;
  for (const std::filesystem::path& mesh : input.robot_meshes()) meshes.push_back({"", mesh});
  if (!call.certificate.empty()) outputs.push_back({"--certificate", call.certificate});
  if (!call.svg.empty()) outputs.push_back({"--svg", call.svg});
  ask::require_apart(meshes, outputs);
}

// Throws Error bad_call where no pair was asked about: such a file would state nothing.
void write_certificate(const std::string& name, const SceneReport& report, const InputFiles& inputs) {
  const auto states_nothing = [](const Placed& placed) { return placed.answer.pairs.empty(); };
  if (std::all_of(report.placements.begin(), report.placements.end(), states_nothing)) {
    throw Error(ErrorCode::bad_call,
                "no pair is asked about, so there is nothing to prove; leave it out, or allow less", "--certificate");
  }
  io::OutputFile file(name);
  write_scene_certificate(report, inputs, [&](std::string_view text) { file.write(text); });
  file.commit();
}

std::vector<picture::ScenePanel> panels_of(const SceneReport& report) {
  std::vector<picture::ScenePanel> panels;
  for (const Placed& placed : report.placements) panels.push_back({placed.title, placed.bodies, placed.answer});
  return panels;
}

int run(const Call& call) {
  scene::Question question;
  question.method = pair_method(call.method);
  question.every_pair = !call.certificate.empty();
  question.contacts = call.classify;
  InputFiles files;
  InputFiles* const inputs = call.certificate.empty() ? nullptr : &files;
  const std::vector<Placement> placements = placements_of(call, inputs);
  const SceneInput input(call.files, call.poses, call.require_convex, call.leave_out, inputs);
  require_apart(call, input);
  if (!call.svg.empty()) {
    std::uint64_t facets = 0;
    for (const MeshBody* object : input.objects()) facets += object->hull.facet_count();
    require_drawable(facets * placements.size(), "facet", 0, call.svg_limit);
  }

  SceneReport report;
  report.method = call.method;
  report.left_out = &input.left_out();
  for (const std::string& word : call.allow) {
    if (word == "touch") {
      question.touching_allowed = question.contacts = true;
    } else {
      const auto pairs = input.allowed(word);
      question.allowed.insert(question.allowed.end(), pairs.begin(), pairs.end());
      report.allowed_because.push_back(word);
    }
  }
  report.allowed = question.allowed;
  report.contacts = question.contacts;
  report.touching_allowed = question.touching_allowed;
  report.colour = isatty(STDOUT_FILENO) == 1 && std::getenv("NO_COLOR") == nullptr;
  report.is_hull = input.are_hulls();
  for (const Placement& placement : placements) {
    const std::string number = placements.size() == 1 ? "as given" : std::to_string(report.placements.size() + 1);
    report.placements.push_back(ask(input, placement, placement.name.empty() ? number : placement.name, question));
  }

  if (!call.certificate.empty()) write_certificate(call.certificate, report, files);
  if (!call.svg.empty()) io::write_file_atomically(call.svg, picture::scene_svg(panels_of(report), call.title));
  note_hulls(input.objects());
  std::string text = call.json ? to_text(scene_json(report, input.objects())) : scene_text(report);
  if (!call.json && !call.certificate.empty()) {
    std::size_t pairs = 0;
    for (const Placed& placed : report.placements) pairs += placed.answer.pairs.size();
    text +=
        fmt::format("proofs of {}, all but the allowed: {}\n", count_of(pairs, "pair"), io::one_line(call.certificate));
  }
  if (!call.json && !call.svg.empty()) text += fmt::format("picture: {}\n", io::one_line(call.svg));
  call.json || report.colour ? print(text) : print_for_people(text);  // colours are control bytes
  return report.some_meet() ? exit_code::yes : exit_code::no;
}

}  // namespace

Verb scene_verb() {
  const auto call = std::make_shared<Call>();
  return {
      "scene",
      "Which of many bodies meet? Meshes, and the links of a robot.",
      codes_of_sets,
      {{"FILE", &call->files,
        "a mesh (its objects are the parts of one body) or one robot (URDF: its links are the bodies); FILE@POSE "
        "places it",
        "", true},
       {"--pose", &call->poses, std::string("place the file of this name: ") + pose_forms, "NAME=POSE"},
       {"--joints", &call->joints, "name=value,... or LABEL:name=value,...; again for another placement", "VALUES"},
       {"--joints-file", &call->joints_files, "the same from a file, one joint a line", "FILE"},
       {"--allow", &call->allow,
        "what may meet: adjacent (links joined by a joint), touch, NAME,NAME, or a file with two names a line", "WHAT"},
       {"--method", &call->method, "automatic, gjk, hierarchy, or scan", "NAME"},
       {"--classify", &call->classify, "tell touching from overlapping"},
       {"--require-convex", &call->require_convex, "a mesh that is not exactly convex is an error"},
       {"--leave-out", &call->leave_out, leave_out_help},
       certificate_option(call->certificate, "write the proofs of all pairs here"),
       {"--svg", &call->svg, "draw the placements here", "FILE"},
       {"--title", &call->title, "over the picture"},
       svg_limit_option(call->svg_limit),
       json_option(call->json)},
      [call] { return run(*call); }};
}

}  // namespace sunder::ask
