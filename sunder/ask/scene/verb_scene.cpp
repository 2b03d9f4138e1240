// sunder scene FILE...: which of these bodies meet?
#include <sunder/ask/mesh_memory_option.h>
#include <sunder/ask/outputs.h>
#include <sunder/ask/packages_option.h>
#include <sunder/ask/question.h>
#include <sunder/ask/scene/between.h>
#include <sunder/ask/scene/placements.h>
#include <sunder/ask/scene/scene_report.h>
#include <sunder/ask/verb.h>

#include <sunder/base/error.h>
#include <sunder/io/robot/joint_values.h>
#include <sunder/io/text/file.h>
#include <sunder/io/text/text.h>
#include <sunder/picture/gltf.h>
#include <sunder/picture/scene.h>
#include <sunder/scene/scene_claims.h>

#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <string_view>

namespace sunder::ask {

namespace {

struct SceneCall : QuestionCall {
  SceneCall() { svg_limit = 200'000; }  // facets

  std::vector<std::string> files, poses, joints, joints_files, allow, states, packages, groups_of_links, srdf, attach;
  std::string gltf;
  bool classify = false;
  bool check_allowed = false, no_check_allowed = false;
  bool groups = false;
  bool require_convex = false;
  bool leave_out = false;
  bool hull = false, surface = false;  // of meshes that are not convex
  ClearanceCall clearance;
  bool between = false;
  PlacementsCall placements;  // none where it names no table
};

// Reports, proofs and pictures hold all placements at once.
constexpr std::size_t most_held = 10'000;
constexpr std::uint64_t most_facets = 5'000'000;  // in a file of --gltf: some hundred MB

bool wants_lines(const SceneCall& call) {
  return !call.json && !call.proves() && call.svg.empty() && call.gltf.empty();
}

// table: what --placements names, to be held; cell: for --state.
std::vector<io::JointValues> joints_of(Talk& talk, const SceneCall& call, const io::JointTable& table,
                                       const robot::Cell& cell, InputFiles* inputs) {
  if (table.rows() > most_held) {
    throw Error(ErrorCode::bad_call,
                fmt::format("{} are too many for --json, --certificate and --svg, which hold at most {}; leave these "
                            "out, or ask about some",
                            count_of(table.rows(), "placement"), most_held),
                "--placements");
  }
  std::vector<io::JointValues> all = joint_values_of(table);
  for (const std::string& file : call.joints_files) all.push_back(io::read_joint_values(file, inputs));
  for (const std::string& text : call.joints) all.push_back(io::parse_joint_values(text, "--joints"));
  for (const std::string& text : call.states) {
    all.push_back(noting(talk, [&](auto& remarks) { return cell.state(text, "--state", remarks); }));
  }
  if (all.empty()) all.emplace_back();
  note_limits(talk, cell, all);
  return all;
}

Placed ask(const SceneReport& report, const io::JointValues& joints, const std::string& number) {
  const scene::Question& question = report.question;
  if (!joints.values.empty()) (void)report.cell.robot("--joints");
  Placed placed{joints.values, joints.name.empty() ? number : joints.name, report.cell.place(joints.values), {}};
  const auto start = std::chrono::steady_clock::now();
  placed.answer = scene::meeting_pairs(placed.bodies, question);
  if (report.checks_allowed) {
    scene::Question of_allowed = question;
    of_allowed.allowed_alone = true;
    of_allowed.every_pair = false;
    placed.of_allowed = scene::meeting_pairs(placed.bodies, of_allowed);
  }
  if (report.clearance) placed.near.clearance = scene::closer_pairs(placed.bodies, *report.clearance);
  if (report.asks_for_nearest) placed.near.nearest = scene::nearest_parts(placed.bodies, question.allowed);
  placed.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return placed;
}

// What the call names is compared before anything is read; what a robot's file names, here.
void require_apart(Talk& talk, const SceneCall& call, const robot::Cell& cell) {
  std::vector<NamedFile> meshes, outputs;
  for (const std::filesystem::path& mesh : cell.meshes_read()) meshes.push_back({"", mesh});
  if (!call.certificate.empty()) outputs.push_back({"--certificate", call.certificate});
  if (!call.svg.empty()) outputs.push_back({"--svg", call.svg});
  if (!call.gltf.empty()) outputs.push_back({"--gltf", call.gltf});
  if (!call.placements.json_lines.empty()) outputs.push_back({"--json-lines", call.placements.json_lines});
  if (!call.placements.csv.empty()) outputs.push_back({"--csv", call.placements.csv});
  if (!call.placements.meeting_certificate.empty()) {
    outputs.push_back({"--meeting-certificate", call.placements.meeting_certificate});
  }
  ask::require_apart(talk, meshes, outputs);
}

void require_drawable(const SceneCall& call, const robot::Cell& cell, std::size_t placements) {
  if (call.svg.empty() && call.gltf.empty()) return;
  std::uint64_t facets = 0;
  for (const io::BodyPart* part : cell.parts()) facets += drawn_as(part->shape()).polyhedron.facet_count();
  facets *= placements;
  if (!call.svg.empty()) ask::require_drawable(facets, "facet", 0, call.svg_limit);
  if (!call.gltf.empty() && facets > most_facets) {
    throw Error(ErrorCode::bad_call,
                fmt::format("{} facets in all placements: more than {}; ask about fewer", facets, most_facets),
                "--gltf");
  }
}

// The joint values that the call gives; nothing where it gives none.
std::optional<SaidNote> joint_values_note(const std::map<std::string, double>& joints) {
  if (joints.empty()) return std::nullopt;
  return SaidNote::joint_values({joints.begin(), joints.end()});
}

// Of all pairs but the allowed and the undecided; returns how many. Throws Error bad_call where there is none: such a
// file would state nothing.
std::size_t write_certificate(const Talk& talk, const std::string& name, const SceneReport& report,
                              const InputFiles& inputs) {
  std::vector<scene::Placement> placements;
  std::size_t pairs = 0, undecided = 0;
  for (const Placed& placed : report.placements) {
    const auto& [clearance, nearest] = placed.near;
    placements.push_back(
        {placed.title, placed.bodies, placed.answer, clearance ? &*clearance : nullptr, nearest ? &*nearest : nullptr});
    pairs += placed.answer.pairs.size() - placed.answer.counts.undecided;
    undecided += placed.answer.counts.undecided;
  }
  if (pairs == 0) {
    throw Error(ErrorCode::bad_call,
                undecided > 0 ? "all pairs are undecided, so there is nothing to prove; leave it out"
                              : "no pair is asked about, so there is nothing to prove; leave it out, or allow less",
                "--certificate");
  }
  const scene::SaidOfScene said{
      said_of(report.cell, inputs), reason_of_each(report.allowed),
      [&](std::size_t placement) { return joint_values_note(report.placements[placement].joints); },
      said_of(report.cell, inputs, true)};
  io::OutputFile file(name, talk.instead(name));
  scene::write_certificate(
      placements, report.question, origin_of(talk, inputs, left_out_texts(report.cell.left_out(), report.allowed)),
      [&](std::string_view text) { file.write(text); }, report.clearance.value_or(scene::ClearanceQuestion()), said);
  file.commit();
  return pairs;
}

void draw(const Talk& talk, const SceneCall& call, const SceneReport& report) {
  std::vector<picture::ScenePanel> panels;
  const auto is_hull = [&](std::uint32_t body, std::uint32_t part) { return report.cell.is_hull(body, part); };
  for (const Placed& placed : report.placements) {
    panels.push_back({placed.title, placed.bodies, placed.answer, is_hull, picture_notes(report, placed)});
  }
  if (!call.svg.empty()) talk.write_file(call.svg, picture::scene_svg(panels, call.title));
  if (call.gltf.empty()) return;
  const bool is_binary = io::ending_of(call.gltf) == ".glb";
  talk.write_file(call.gltf,
                  picture::scene_gltf(panels, is_binary ? picture::GltfForm::binary : picture::GltfForm::json));
}

void note_meshes(Talk& talk, const SceneCall& call, const SceneReport& report) {
  (call.hull ? note_hulls : note_remarks)(talk, meshes_of(report.cell));
}

Report run(const SceneCall& call, Talk& talk) {
  const PairMethod method = pair_method(call.method);
  const io::MeshMemory limit = limit_of(call);
  InputFiles files;
  InputFiles* const inputs = call.proves() || !call.placements.meeting_certificate.empty() ? &files : nullptr;
  std::vector<io::Srdf> srdfs;
  for (const std::string& word : call.srdf) srdfs.push_back(io::read_srdf(file_word(word).file, inputs));
  robot::Cell cell = read_cell(talk, call.files, call.poses,
                               {call.require_convex, call.hull, call.leave_out, packages_of(talk, call.packages),
                                call.groups ? io::PartsOf::objects_and_groups : io::PartsOf::objects},
                               inputs);
  for (std::size_t k = 0; k < srdfs.size(); ++k) {
    const FileWord word = file_word(call.srdf[k]);
    cell.add_srdf(std::move(srdfs[k]), word.file, word.name, "--srdf");
  }
  attach(call.attach, cell);
  if (!call.groups_of_links.empty()) {
    noting(talk, [&](auto& remarks) { cell.keep_groups(call.groups_of_links, "--group", remarks); });
  }
  require_apart(talk, call, cell);
  io::JointTable table;
  if (!call.placements.table.empty()) table = read_placements(talk, call.placements, cell, inputs);
  const bool is_by_lines = table.rows() > 0 && wants_lines(call);
  std::vector<io::JointValues> placements;
  if (!is_by_lines) placements = joints_of(talk, call, table, cell, inputs);
  require_drawable(call, cell, placements.size());

  SceneReport report{cell, call.method};
  scene::Question& question = report.question;
  question.method = method;
  question.every_pair = call.proves();
  question.contacts = call.classify;
  for (const std::string& word : call.allow) {
    if (word == "touch") {
      question.touching_allowed = question.contacts = true;
    } else {
      add_allowed(allowed_by_word(talk, cell, word, inputs), report.allowed);
      report.allowed_because.push_back(word);
    }
  }
  add_allowed(noting(talk, [&](auto& remarks) { return cell.allowed(remarks); }), report.allowed);
  for (const std::string& word : call.srdf) report.allowed_because.push_back(file_word(word).file);
  if (!call.attach.empty()) report.allowed_because.emplace_back("attached");
  question.allowed = bodies_of(report.allowed);
  for (const std::string& file : cell.scene_files()) report.allowed_because.push_back(io::one_line(file));
  report.clearance = clearance_question(talk, call.clearance, cell, question.allowed);
  report.asks_for_nearest = call.clearance.nearest;
  report.surfaces_consented = call.surface;
  const bool is_one = !is_by_lines && placements.size() == 1;
  report.checks_allowed = !report.allowed.empty() && !call.no_check_allowed && (call.check_allowed || is_one);
  if (is_by_lines) {
    if (call.check_allowed) {
      throw Error(ErrorCode::bad_call,
                  fmt::format("a line a placement does not tell of pairs that are allowed to meet; give --json, which "
                              "does, for up to {} placements, or leave it out",
                              most_held),
                  "--check-allowed");
    }
    if (call.clearance.nearest && !call.placements.meeting_certificate.empty()) {
      throw Error(ErrorCode::bad_call,
                  "proves what meets, and what is closer than --clearance, and not which are the nearest: leave out "
                  "--distance, or give --certificate, for all",
                  "--meeting-certificate");
    }
    note_limits(talk, cell, extremes_of(table));
    note_meshes(talk, call, report);
    const scene::NearnessQuestion near{report.clearance, report.asks_for_nearest, question.allowed};
    const RowsAsked asked{talk, call.placements, cell, question, near, table, files, report.allowed, call.surface};
    return told(call.between ? answer_between(asked) : answer_placements(asked).code(call.surface));
  }
  report.colour = talk.sinks().has_colours;
  for (const io::JointValues& joints : placements) {
    const std::string number = placements.size() == 1 ? "as given" : std::to_string(report.placements.size() + 1);
    report.placements.push_back(ask(report, joints, number));
  }

  const std::size_t proved = call.proves() ? write_certificate(talk, call.certificate, report, files) : 0;
  draw(talk, call, report);
  note_meshes(talk, call, report);
  Report result = report_of(report);
  result.method = report.method;
  result.function = method.function;
  result.notes = talk.notes();
  if (call.proves()) {
    const std::vector<std::string> unproved = not_proved(report);
    std::string text;
    for (const std::string& words : unproved) text += fmt::format("not proved: {}\n", words);
    result.tell(fmt::format("proofs of {}, all but the allowed{}: {}\n", count_of(proved, "pair"),
                            report.none_undecided() ? "" : " and the undecided", io::one_line(call.certificate)));
    result.add("not_proved", unproved, std::move(text));
  }
  if (!call.svg.empty()) result.tell(fmt::format("picture: {}\n", io::one_line(call.svg)));
  if (!call.gltf.empty()) result.tell(fmt::format("model: {}\n", io::one_line(call.gltf)));
  return result;
}

}  // namespace

Verb scene_verb() {
  const auto call = std::make_shared<SceneCall>();
  return {
      "scene",
      "Which of many bodies meet? Meshes, scenes, and the links of a robot.",
      codes_of_sets,
      {{"FILE", &call->files,
        "a mesh (one body; the objects in the file are its parts), a scene (JSON: named bodies made of parts), or a "
        "robot (URDF: its links are the bodies). FILE@POSE also sets the pose, and NAME=FILE the name (default: the "
        "file's name without folder and ending). Links and joints that several robots have are named ROBOT/LINK and "
        "ROBOT/JOINT",
        "", true},
       {"--pose", &call->poses,
        std::string("set the pose of the file NAME (its name without folder and ending): ") + pose_forms, "NAME=POSE"},
       {"--attach", &call->attach,
        "move NAME (a mesh, a body or all bodies of a scene file, or a robot) with this link of a robot; its pose is "
        "then "
        "in the frame of the link. The two may meet",
        "NAME=LINK[@POSE]"},
       {"--joints", &call->joints,
        "joint values of the robot: name=value,... or LABEL:name=value,... (radians, or metres for sliding joints). "
        "Each --joints is one placement",
        "VALUES"},
       {"--joints-file", &call->joints_files, "the same from a file, one joint on each line", "FILE"},
       {"--srdf", &call->srdf,
        "read this SRDF file: the pairs that it disables may meet, and --state and --group use its names. Of several "
        "robots it is about those whose URDF has its robot's name; NAME=FILE is about the robot NAME",
        "FILE"},
       {"--state", &call->states,
        "use the joint values of this state of --srdf: NAME, GROUP/NAME, ROBOT/NAME, or several separated by commas",
        "NAME", false, "--srdf"},
       {"--group", &call->groups_of_links, "ask only about the links of this group of --srdf", "NAME", false, "--srdf"},
       package_option(call->packages),
       {.name = "--placements",
        .value = &call->placements.table,
        .help = "read joint values, one placement in each row: CSV with joint names in the first line, or NPY",
        .type = "FILE",
        .excludes = {"--joints", "--joints-file"}},
       {.name = "--joint-names",
        .value = &call->placements.joint_names,
        .help = "the joints of the columns of an NPY file (default: all movable joints, in the order of sunder info)",
        .type = "A,B,...",
        .needs = "--placements"},
       {.name = "--first",
        .value = &call->placements.first,
        .help = "stop at the first placement where bodies meet, or are closer than --clearance",
        .needs = "--placements",
        .excludes = {"--json", "--certificate", "--svg", "--gltf"}},
       {.name = "--between",
        .value = &call->between,
        .help = "what meets during the motion from each placement to the next? Pairs of parts that move straight and "
                "do not "
                "turn are decided for the whole motion, other pairs only at its two ends; the output lists these",
        .needs = "--placements",
        .excludes = {"--json", "--certificate", "--svg", "--gltf", "--clearance", "--margin", "--distance"}},
       {.name = "--json-lines",
        .value = &call->placements.json_lines,
        .help = "write one line of JSON for each placement to FILE",
        .type = "FILE",
        .needs = "--placements",
        .excludes = {"--json", "--certificate", "--svg", "--gltf"}},
       {.name = "--csv",
        .value = &call->placements.csv,
        .help = "write a table with one row for each placement to FILE",
        .type = "FILE",
        .needs = "--placements",
        .excludes = {"--json", "--certificate", "--svg", "--gltf"}},
       {.name = "--meeting-certificate",
        .value = &call->placements.meeting_certificate,
        .help = "write proofs of all pairs that meet, or are closer than --clearance or --margin, to FILE",
        .type = "FILE",
        .needs = "--placements",
        .excludes = {"--json", "--certificate", "--svg", "--gltf"}},
       {.name = "--parted",
        .value = &call->placements.parted,
        .help = "also prove which pairs are apart",
        .needs = "--meeting-certificate"},
       {.name = "--threads",
        .value = &call->placements.threads,
        .help = "use N threads (default: one for each core); the output does not depend on N",
        .type = "N",
        .needs = "--placements",
        .excludes = {"--json", "--certificate", "--svg", "--gltf"}},
       {"--allow", &call->allow,
        "contacts that do not count: adjacent (links joined by a joint), touch (without overlap), NAME,NAME (two "
        "bodies), "
        "or a file with two names on each line",
        "WHAT"},
       {.name = "--check-allowed",
        .value = &call->check_allowed,
        .help = "also decide allowed pairs and list those that meet; they do not count (default for one placement)"},
       {.name = "--no-check-allowed",
        .value = &call->no_check_allowed,
        .help = "do not decide allowed pairs (default for several placements)",
        .excludes = {"--check-allowed"}},
       {"--method", &call->method, pair_method_names(), "NAME"},
       {"--groups", &call->groups, "treat each group (g) of an OBJ file as a part, like each object (o)"},
       {"--clearance", &call->clearance.least,
        "list parts of different bodies that are closer than NUMBER; if there are any, the exit code is 1", "NUMBER"},
       {"--margin", &call->clearance.margins, "the clearance for these two bodies, instead of --clearance",
        "NAME,NAME=NUMBER"},
       {"--distance", &call->clearance.nearest,
        "find the two parts of different bodies that are nearest to each other, and their distance"},
       {"--classify", &call->classify, "also tell whether two bodies only touch or their interiors overlap"},
       {"--require-convex", &call->require_convex,
        "refuse a mesh that is not exactly convex (default: it is asked about as it is)"},
       {.name = "--hull",
        .value = &call->hull,
        .help = "replace each mesh that is not convex by its convex hull",
        .excludes = {"--require-convex"}},
       {"--surface", &call->surface,
        "of meshes that are not closed: ask about the surfaces alone, so that the exit code is 0 if none meet, "
        "whatever an "
        "open one seems to enclose"},
       {"--leave-out", &call->leave_out, leave_out_help},
       certificate_option(call->certificate, "write the proofs of all pairs to FILE"),
       {"--svg", &call->svg, "draw the placements to FILE (SVG)", "FILE"},
       {"--gltf", &call->gltf,
        "write the placements for 3D viewers to FILE, as .gltf or .glb; what meets is red, and bodies with a radius "
        "are "
        "drawn as polyhedra",
        "FILE"},
       {"--title", &call->title, "the title written on the picture"},
       svg_limit_option(call->svg_limit),
       memory_option(call->memory),
       json_option(call->json)},
      [call](Talk& talk) { return run(*call, talk); }};
}

}  // namespace sunder::ask
