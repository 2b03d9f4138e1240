// The verb scene.
#include <tests/support/program.h>

#include <algorithm>
#include <filesystem>
#include <vector>

namespace sunder::tests {

namespace {

TEST_F(Program, SceneOfTheArm) {
  const std::string call = "scene " + panda + ready + folded + " --allow adjacent --classify";
  const std::string proofs = in_folder("proofs.json"), svg = in_folder("arm.svg");
  const json j = report(call + " --certificate " + proofs + " --svg " + svg, 1);
  EXPECT_EQ(j["answer"], "some");
  EXPECT_EQ(j["bodies"].size(), 11u);
  ASSERT_EQ(j["placements"].size(), 2u);
  EXPECT_EQ(j["placements"][0]["name"], "ready");
  EXPECT_EQ(j["placements"][0]["answer"], "none");
  EXPECT_EQ(j["placements"][1]["answer"], "some");
  std::vector<json> meeting;
  for (const json& pair : j["pairs"]) {
    if (pair["answer"] == "meet") meeting.push_back(pair);
  }
  ASSERT_EQ(meeting.size(), 1u);
  EXPECT_EQ(meeting[0]["a"], "panda_link1");
  EXPECT_EQ(meeting[0]["b"], "panda_hand");
  EXPECT_EQ(meeting[0]["contact"], "overlapping");
  EXPECT_EQ(meeting[0]["placement"], 1);
  EXPECT_EQ(j["totals"]["pairs"].get<int>(), 248);
  EXPECT_EQ(j["pairs"].size(), j["totals"]["pairs"].get<std::size_t>() - j["totals"]["allowed"].get<std::size_t>());

  const json verified = report("verify " + proofs, 0);
  EXPECT_EQ(verified["objects"][0]["statements"], j["pairs"].size() + 2);  // and one of all pairs, for each placement
  EXPECT_EQ(verified["objects"][0]["accepted"]["meet"], 0);
  EXPECT_EQ(verified["objects"][0]["accepted"]["overlapping"], 1);

  const std::string picture = read_text(svg);
  EXPECT_TRUE(picture.starts_with("<svg ") && picture.ends_with("</svg>\n"));
  EXPECT_NE(picture.find("panda_link1 meets panda_hand"), std::string::npos);
  EXPECT_EQ(picture.find("nan"), std::string::npos);

  EXPECT_EQ(run("scene " + panda + ready + " --allow adjacent").code, 0);
  EXPECT_EQ(run("scene " + panda + ready).code, 1);  // neighbours meet
  EXPECT_EQ(run("scene " + panda + folded + " --allow adjacent --allow panda_hand,panda_link1").code, 0);
  write_text(in_folder("allow"), "# what may meet\npanda_link1 panda_hand\n");
  EXPECT_EQ(run("scene " + panda + folded + " --allow adjacent --allow " + in_folder("allow")).code, 0);
}

// Scene files: bodies of all kinds of parts, their pairs allowed, units; the certificate names every file.
TEST_F(Program, SceneOfASceneFile) {
  const std::string cell = "scene '" + cases + "/scene/workcell.json'", proof = in_folder("cell.json");
  const json j = report(cell + " --classify --certificate '" + proof + "'", 1);
  EXPECT_EQ(j["unit"], "m");
  ASSERT_EQ(j["bodies"].size(), 4u);
  EXPECT_EQ(j["bodies"][1]["name"], "crate");
  EXPECT_EQ(j["allowed_pairs"], json::parse(R"([["lamp", "hand"]])"));
  EXPECT_EQ(j["count"], 3);
  EXPECT_EQ(j["totals"]["undecided"], 0);
  EXPECT_EQ(j["objects"].back()["shape"], "points");
  EXPECT_EQ(j["objects"][7]["semi_axes"], json::parse("[0.0625, 0.0625, 0.25]"));
  EXPECT_EQ(j["objects"][7]["points"], json::parse("[[0.25, 0.0, 0.0]]"));
  const json certificate = json::parse(read_text(proof));
  ASSERT_EQ(certificate["inputs"].size(), 2u);
  EXPECT_TRUE(certificate["inputs"][0]["name"].get<std::string>().ends_with("workcell.json"));
  EXPECT_TRUE(certificate["inputs"][1]["name"].get<std::string>().ends_with("cube.obj"));
  EXPECT_EQ(run("verify '" + proof + "'").code, 0);
  EXPECT_TRUE(python_accepts(proof));

  EXPECT_EQ(run(cell + " --allow crate,table --allow hand,crate").code, 0);
  EXPECT_EQ(run(cell + " --pose workcell=5,0,0").code, 1);  // all of it is moved
  // Names stay as they are in the file; a body of another file with the same name is another one.
  EXPECT_EQ(
      report(cell + " '" + cases + "/scene/primitives.urdf@9,9,9' --allow crate,table --allow hand,crate", 1)["unit"],
      "m");
  expect_bad("scene '" + cases + "/scene/in-mm.json' '" + cases + "/scene/primitives.urdf'", "is in m, but");
  expect_bad(cell + " --joints turn=1", "there is no robot to move");
  // What is read is not written over.
  write_text(in_folder("s.json"), R"({"bodies": [{"name": "s", "parts": [{"mesh": "m.obj"}]}]})");
  write_text(in_folder("m.obj"), read_text(cases + "/mesh/cube.obj"));
  expect_bad("scene '" + in_folder("s.json") + "' --svg '" + in_folder("m.obj") + "'", "is the same file as the input");
  const json own = report("scene '" + in_folder("s.json") + "'", 0);
  EXPECT_EQ(own["bodies"][0]["name"], "s");  // though the file is named so, too
  EXPECT_FALSE(own.contains("unit"));
}

// The links of a group alone, which is told in text, JSON and certificate.
TEST_F(Program, SceneOfAGroup) {
  const std::string arm = "scene '" + cases + "/mesh/arm.urdf' --leave-out --srdf '" + cases + "/scene/arm.srdf'";
  const std::string proof = in_folder("group.json");
  const Run r = run(arm + " --group upper_arm --certificate '" + proof + "'");
  EXPECT_EQ(r.code, 1) << r.err;
  EXPECT_NE(r.out.find("2 bodies with 2 parts"), std::string::npos) << r.out;
  EXPECT_NE(r.out.find("left out: 1 ellipsoid of base; 1 shape of base"), std::string::npos) << r.out;
  EXPECT_NE(r.err.find("2 of 3 links with shapes are asked about, those of --group upper_arm"), std::string::npos);
  EXPECT_EQ(r.err.find("base"), std::string::npos) << r.err;  // it has a shape
  const json j = report(arm + " --group upper_arm", 1);
  EXPECT_EQ(j["bodies"].size(), 2u);
  EXPECT_EQ(j["left_out"][1]["kind"], "shape");
  EXPECT_EQ(j["left_out"][1]["of"], json{"base"});
  EXPECT_NE(read_text(proof).find("1 shape of base"), std::string::npos);
  EXPECT_EQ(run("verify '" + proof + "'").code, 0);
  EXPECT_EQ(report(arm + " --group upper_arm --group whole", 1)["bodies"].size(), 3u);
  // Neighbours stay neighbours, and others do not become such.
  write_text(in_folder("g.srdf"),
             "<robot name='arm'><group name='g'><link name='base'/><link name='lower'/></group></robot>");
  const std::string ends =
      "scene '" + cases + "/mesh/arm.urdf' --leave-out --srdf '" + in_folder("g.srdf") + "' --group g";
  EXPECT_EQ(report(ends + " --allow adjacent '" + cube + "'@90,0,0", 0)["allowed_pairs"], json::array());
  expect_bad(arm + " --group hand", "no link of the group has a shape");
  expect_bad(arm + " --group frob", "there is no group 'frob'; groups are whole, hand, upper_arm");
  expect_bad("scene '" + cases + "/mesh/arm.urdf' --group whole", "--srdf");
  expect_bad("scene '" + cube + "' --srdf '" + cases + "/scene/arm.srdf' --group whole", "there is no robot");
  // Bodies of scene files stay, with their pairs.
  write_text(in_folder("two.json"), R"({"bodies": [{"name": "p", "parts": [{"box": {"size": [1, 1, 1]}}]},
    {"name": "q", "parts": [{"box": {"size": [1, 1, 1]}}]}], "allowed": [["p", "q"]]})");
  EXPECT_EQ(report(arm + " --group upper_arm '" + in_folder("two.json") + "'@90,0,0", 1)["allowed_pairs"],
            json::parse(R"([["p", "q"]])"));
}

// For viewers: what was read comes back, by names; what is read is never written over.
TEST_F(Program, SceneAsGltf) {
  const std::string model = in_folder("m.glb"), text = in_folder("m.gltf"),
                    cell = "scene '" + cases + "/scene/workcell.json'";
  const Run r = run(cell + " --gltf '" + model + "'");
  EXPECT_EQ(r.code, 1);
  EXPECT_NE(r.out.find("model: "), std::string::npos);
  EXPECT_TRUE(read_text(model).starts_with("glTF"));
  EXPECT_EQ(run(cell + " --json --gltf '" + text + "'").code, 1);
  EXPECT_EQ(json::parse(read_text(text))["meshes"].size(), 9u);
  EXPECT_EQ(report("info '" + text + "'", 0)["objects"][0]["format"], "glTF (metres, Y up)");
  EXPECT_EQ(report("scene '" + text + "'", 0)["bodies"][0]["parts"].size(), 9u);
  const json two = report("scene " + panda + " --allow adjacent" + ready + folded + " --gltf '" + text + "'", 1);
  EXPECT_EQ(json::parse(read_text(text))["scenes"].size(), two["placements"].size());
  expect_bad("scene '" + text + "' --gltf '" + text + "'", "is the same file as the input");
  expect_bad(cell + " --gltf '" + text + "' --svg '" + text + "'", "is the same file as");
  const std::string table = in_folder("t.csv");
  write_text(table, "hoist\n0\n");
  const Run lines =
      run("scene '" + cases + "/scene/primitives.urdf' --placements '" + table + "' --json-lines '" + table + "'");
  EXPECT_EQ(lines.code, 2);
  EXPECT_NE(lines.err.find("is the same file as"), std::string::npos) << lines.err;
  EXPECT_EQ(read_text(table), "hoist\n0\n");
  expect_bad("scene '" + cases + "/scene/primitives.urdf' --placements '" + table + "' --first --gltf '" + text + "'",
             "--gltf");
}

// A robot without any collision shape: an answer for who says that he knows, and none otherwise.
TEST_F(Program, SceneOfNoShape) {
  const std::string ghost = "scene '" + cases + "/scene/ghost.urdf'";
  expect_bad(ghost, "not read: 1 visual shape of head");
  const Run r = run(ghost + " --leave-out");
  EXPECT_EQ(r.code, 0);
  EXPECT_NE(r.out.find("nothing can meet: no link has a collision shape; left out: 1 visual shape of head"),
            std::string::npos);
  EXPECT_NE(r.err.find("has a collision shape, so nothing can meet"), std::string::npos);
  const json j = report(ghost + " --leave-out --allow adjacent", 0);
  EXPECT_EQ(j["answer"], "none");
  EXPECT_EQ(j["bodies"], json::array());
  EXPECT_EQ(j["notes"].size(), 1u);
  EXPECT_EQ(j["left_out"][0]["of"], json{"head"});
  const Run unproved = run(ghost + " --leave-out --certificate '" + in_folder("p.json") + "'");
  EXPECT_EQ(unproved.code, 2);
  EXPECT_NE(unproved.err.find("there is nothing to prove"), std::string::npos);
  write_text(in_folder("t.csv"), "neck\n0\n1\n");
  EXPECT_EQ(run(ghost + " --leave-out --placements '" + in_folder("t.csv") + "'").code, 0);
  EXPECT_EQ(report("scene '" + cube + "' " + ghost.substr(6) + " --leave-out", 0)["bodies"].size(), 1u);
  // Shapes that cannot be read are no such robot: their absence is no answer.
  write_text(in_folder("lost.urdf"),
             "<robot name='r'><link name='a'><collision><geometry><mesh filename='gone.stl'/>"
             "</geometry></collision></link></robot>");
  expect_bad("scene '" + in_folder("lost.urdf") + "' --leave-out",
             "there is nothing to ask about; left out: 1 mesh of a");
  write_text(in_folder("plane.urdf"),
             "<robot name='r'><link name='a'><collision><geometry><plane/>"
             "</geometry></collision></link></robot>");
  expect_bad("scene '" + in_folder("plane.urdf") + "' --leave-out", "there is nothing to ask about");
  write_text(in_folder("bare.urdf"), "<robot name='r'><link name='a'/></robot>");
  expect_bad("scene '" + in_folder("bare.urdf") + "'", "or say that you know: --leave-out");
  EXPECT_EQ(run("scene '" + in_folder("bare.urdf") + "' --leave-out").code, 0);
}

TEST_F(Program, SceneFilesThatAreBroken) {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(cases + "/broken-scenes")) {
    if (entry.path().extension() != ".json") continue;
    const Run r = run("scene '" + entry.path().string() + "'");
    EXPECT_EQ(r.code, 2) << entry.path();
    EXPECT_EQ(std::count(r.err.begin(), r.err.end(), '\n'), 1) << r.err;
    EXPECT_NE(r.err.find("broken-scenes/"), std::string::npos) << r.err;
    ++count;
  }
  EXPECT_GE(count, 6u);
}

// Spheres, cylinders and capsules as what they are; every pair is proved.
TEST_F(Program, SceneOfBodiesWithARadius) {
  const std::string crane = "scene " + cases + "/scene/primitives.urdf", proof = in_folder("crane.json");
  for (const char* const options : {"", " --classify", " --allow touch", " --allow adjacent"}) {
    const Run r = run(crane + " --joints hoist=1.125" + options + " --certificate '" + proof + "'");
    EXPECT_EQ(r.code, 1) << r.out << r.err;
    EXPECT_NE(r.out.find("mast/foot and load meet"), std::string::npos) << r.out;
    EXPECT_EQ(run("verify '" + proof + "'").code, 0);
    EXPECT_TRUE(python_accepts(proof));
  }
  EXPECT_EQ(run(crane + " --allow adjacent").code, 0);
  const json j = report(crane + " --joints hoist=1.125 --classify", 1);
  EXPECT_EQ(j["objects"][1]["shape"], "cylinder");
  EXPECT_EQ(j["objects"][1]["radius"], 0.25);
  EXPECT_EQ(j["objects"][2]["shape"], "capsule");
  EXPECT_EQ(j["objects"][3]["shape"], "ball");
  EXPECT_EQ(j["totals"]["undecided"], 0);
  const std::string picture = in_folder("crane.svg");
  EXPECT_EQ(run(crane + " --svg '" + picture + "'").code, 1);
  EXPECT_NE(read_text(picture).find("are drawn by polyhedra inside of them"), std::string::npos);
  EXPECT_EQ(read_text(picture).find("nan"), std::string::npos);

  // Two cylinders at the same place.
  const std::string two = in_folder("two.urdf"), link =
                                                     "<collision><geometry><cylinder radius='1' length='1'/>"
                                                     "</geometry></collision></link>";
  write_text(two, "<robot name='r'><link name='a'>" + link + "<link name='b'>" + link +
                      "<joint name='j' type='fixed'><parent link='a'/><child link='b'/></joint></robot>");
  EXPECT_EQ(run("scene '" + two + "'").code, 1);
  EXPECT_NE(run("scene '" + two + "' --classify").out.find("a and b meet, overlapping"), std::string::npos);

  // Placement after placement.
  const std::string table = in_folder("table.csv"), lines = in_folder("lines");
  write_text(table, "turn,hoist\n0,0\n0,1.125\n");
  EXPECT_EQ(run(crane + " --allow adjacent --placements '" + table + "' --json-lines '" + lines + "'").code, 1);
  EXPECT_NE(read_text(lines).find("{\"placement\": 0, \"answer\": \"none\"}"), std::string::npos);
  EXPECT_NE(read_text(lines).find("\"evidence\": {\"point\": ["), std::string::npos) << read_text(lines);
  const std::string proofs = in_folder("proofs.json");
  EXPECT_EQ(run(crane + " --allow adjacent --placements '" + table + "' --meeting-certificate '" + proofs + "'").code,
            1);
  EXPECT_EQ(run("verify '" + proofs + "'").code, 0);
  EXPECT_TRUE(python_accepts(proofs));
}

// Two cylinders whose rims nearly touch: no verdict is said that is not known.
TEST_F(Program, SceneThatIsUndecided) {
  const std::string nearly = "scene " + cases + "/scene/nearly.urdf", joints = " --joints way=1.3853189754928872";
  const Run r = run(nearly + joints);
  EXPECT_EQ(r.code, 1);
  EXPECT_NE(r.out.find("undecided: one and other"), std::string::npos) << r.out;
  EXPECT_EQ(r.out.find("none meet"), std::string::npos);
  // A last bit nearer they are known to meet, but not how.
  const std::string nearer = nearly + " --joints way=1.3853189754928865";
  EXPECT_EQ(report(nearer + " --classify", 1)["pairs"][0]["contact_unknown"], true);
  const std::string loose = in_folder("loose.json");
  EXPECT_EQ(run(nearer + " --allow touch --certificate '" + loose + "'").code, 1);
  EXPECT_EQ(json::parse(read_text(loose))["left_out"], json{"one and other, undecided whether they touch or overlap"});
  EXPECT_EQ(run("verify '" + loose + "'").code, 0);
  const json j = report(nearly + joints, 1);
  EXPECT_EQ(j["answer"], "undecided");
  EXPECT_EQ(j["pairs"][0]["answer"], "undecided");
  EXPECT_EQ(j["pairs"][0]["evidence"]["direction_about"].size(), 3u);
  EXPECT_EQ(j["totals"]["undecided"], 1);
  expect_bad(nearly + joints + " --certificate '" + in_folder("no.json") + "'", "all pairs are undecided");
  const std::string proof = in_folder("proof.json");
  EXPECT_EQ(run(nearly + " " + cube + "@9,0,0" + joints + " --certificate '" + proof + "'").code, 1);
  EXPECT_EQ(json::parse(read_text(proof))["left_out"], json{"one and other, undecided whether they meet"});
  EXPECT_EQ(run("verify '" + proof + "'").code, 0);
  EXPECT_TRUE(python_accepts(proof));
  const std::string table = in_folder("table.csv"), lines = in_folder("lines");
  write_text(table, "way\n1.3853189754928872\n");
  const Run placed = run(nearly + " --placements '" + table + "'");
  EXPECT_EQ(placed.code, 1);
  EXPECT_NE(placed.out.find("0: one and other undecided\n"), std::string::npos) << placed.out;
  EXPECT_NE(placed.out.find("where that is undecided: 1"), std::string::npos) << placed.out;
}

TEST_F(Program, SceneOfMeshes) {
  EXPECT_EQ(run("scene " + cube + " " + cube + "@3,0,0").code, 0);
  EXPECT_EQ(run("scene " + cube + " " + cube + "@1,0,0").code, 1);
  EXPECT_EQ(run("scene " + cube + " " + cube + "@1,0,0 --allow touch").code, 0);
  EXPECT_EQ(run("scene " + cube + " " + cube + " --pose 'cube#2=1,0.5,3'").code, 0);
  const json j = report("scene " + cases + "/mesh/two_parts.obj " + tetrahedron + "@20,0,0 --leave-out", 0);
  EXPECT_EQ(j["bodies"][0]["parts"].size(), 2u);
  EXPECT_EQ(j["totals"]["pairs"], 2);
  EXPECT_EQ(j["pairs"].size(), 0u);
  const std::string loose = cases + "/mesh/points.off";
  const json points = report("scene " + loose + " " + loose + "@0,0,1 --allow touch", 0);
  EXPECT_EQ(points["bodies"].size(), 2u);
  EXPECT_EQ(points["allowed"], "touch");
  const json far = report("scene " + cube + " " + cube + "@3,0,0 --certificate " + in_folder("c.json"), 0);
  ASSERT_EQ(far["pairs"].size(), 1u);
  EXPECT_EQ(far["pairs"][0]["decided_by"], "boxes");
  EXPECT_EQ(run("verify " + in_folder("c.json")).code, 0);
  // Without one of its statements, the file proves less than it says.
  json top = json::parse(read_text(in_folder("c.json")));
  ASSERT_EQ(top["statements"].size(), 2u);
  top["statements"].erase(0);
  write_text(in_folder("c.json"), top.dump());
  EXPECT_EQ(run("verify " + in_folder("c.json")).code, 1);
  expect_bad("scene " + cube + " --certificate " + in_folder("c.json"), "--certificate: no pair is asked about");
  EXPECT_EQ(run("scene " + panda + ready + " --allow adjacent " + cube + "@0,0,-0.45").code, 1);  // under its base
}

TEST_F(Program, SceneByAnSrdf) {
  const std::string arm = "scene " + cases + "/mesh/arm.urdf --leave-out --srdf " + cases + "/scene/arm.srdf";
  const json j = report(arm + " --state up,hand/open --state hand/closed", 1);
  ASSERT_EQ(j["placements"].size(), 2u);
  EXPECT_EQ(j["placements"][0]["name"], "up,hand/open");
  EXPECT_EQ(j["placements"][0]["joints"], (json{{"shoulder", 1}, {"elbow", -1.5}, {"slide", 1.5}}));
  EXPECT_EQ(j["allowed_pairs"], json::array({json::array({"base", "upper"}), json::array({"base", "lower"})}));
  EXPECT_EQ(j["totals"]["allowed"], 4);
  std::string notes;
  for (const json& note : j["notes"]) notes += note.get<std::string>() + "\n";
  EXPECT_NE(notes.find("arm.srdf allows 2 pairs: 1 Adjacent, 1 Never\n"), std::string::npos) << notes;
  EXPECT_NE(notes.find("links without a shape are passed over: tool, finger\n"), std::string::npos) << notes;
  EXPECT_NE(notes.find("links that the robot does not have are passed over: gone\n"), std::string::npos) << notes;
  expect_bad(arm + " --state down", "there is no state 'down'");

  write_text(in_folder("allow"), "upper lower\nupper tool\nbase upper\nlower base\n");
  const json by_file = report("scene " + cases + "/mesh/arm.urdf --leave-out --allow " + in_folder("allow"), 0);
  EXPECT_EQ(by_file["totals"]["allowed"], 3);
  EXPECT_NE(by_file["notes"].dump().find("links without a shape are passed over: tool"), std::string::npos);
}

TEST_F(Program, SceneBeyondLimitsIsAskedAbout) {
  const json j = report("scene " + panda + " --allow adjacent --joints panda_joint1=9 --joints panda_joint1=-9", 1);
  EXPECT_EQ(j["placements"][0]["joints"]["panda_joint1"], 9);
  EXPECT_NE(
      j["notes"].dump().find("joint 'panda_joint1' is at 9, beyond its limits from -2.8973 to 2.8973; and 1 more"),
      std::string::npos)
      << j["notes"];
}

TEST_F(Program, SceneOfEveryFormat) {
  for (const char* ending : {"dae", "gltf", "glb", "wrl"}) {
    const std::string pair = cases + "/mesh/two_nodes." + (std::string(ending) == "glb" ? "gltf" : ending);
    const json j = report("scene " + pair + " " + cases + "/mesh/cube." + ending + "@10.5,0.5,0.5", 1);
    EXPECT_EQ(j["bodies"][0]["parts"].size(), 2u) << ending;
    EXPECT_EQ(j["count"], 1) << ending;
  }
  write_text(in_folder("g.obj"),
             "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 9 0 0\nv 8 0 0\nv 9 1 0\nv 9 0 1\n"
             "g a\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\ng b\nf 5 6 7\nf 5 8 6\nf 5 7 8\nf 6 8 7\n");
  const std::string between = in_folder("g.obj") + " " + cube + "@4.5,0,0";
  EXPECT_EQ(report("scene " + between, 1)["bodies"][0]["parts"].size(), 1u);
  EXPECT_EQ(report("scene --groups " + between, 0)["bodies"][0]["parts"].size(), 2u);
}

TEST_F(Program, BadScenes) {
  const std::string arm = "scene " + panda;
  expect_bad(arm + " --joints panda_joint1", "'panda_joint1' is no joint with a value");
  expect_bad(arm + " --joints panda_joint1=x", "'x' is not a number");
  expect_bad(arm + " --package panda", "--package: 'panda' is not of the form NAME=FOLDER");
  expect_bad(arm + " --package panda=/no/such", "'/no/such' is no folder");
  expect_bad(arm + " --state up", "--srdf");
  expect_bad("scene " + cube + " --srdf " + cases + "/scene/arm.srdf", "there is no robot that this could be about");
  expect_bad(arm + " --srdf " + cases + "/panda/panda.urdf", "this is a URDF, and an SRDF is expected");
  expect_bad(arm + " --joints elbow=1", "joint 'elbow'");
  expect_bad(arm + " --joints panda_joint1=0,panda_joint1=1", "comes twice");
  expect_bad(arm + " --joints-file " + in_folder("none"), "no such file");
  expect_bad(arm + " --allow neighbours", "give adjacent, touch, NAME,NAME, or a file");
  expect_bad(arm + " --allow panda_link1,elbow", "no body is named 'elbow'");
  expect_bad(arm + " " + panda, "a second robot");
  expect_bad("scene " + cube + " --joints a=1", "there is no robot");
  expect_bad("scene " + cube + " --allow adjacent", "there is no robot");
  expect_bad("scene " + cube + "@1,2", "a pose of 2 numbers");
  expect_bad("scene " + cube + " --pose sphere=1,2,3", "nothing is named 'sphere'; names are cube");
  expect_bad("scene " + cube + " --pose cube", "is not of the form NAME=POSE");
  expect_bad("scene " + cube + " --method frob", "choose one of automatic, gjk, hierarchy, polar, scan");
  write_text(in_folder("bad.joints"), "# fine\npanda_joint1 = 0.1\npanda_joint2 = far\n");
  expect_bad(arm + " --joints-file " + in_folder("bad.joints"), "bad.joints:3");
}

TEST_F(Program, SceneFilesAreToldByInfo) {
  const std::string file = cases + "/scene/workcell.json";
  const json told = report("info " + file, 0)["objects"][0];
  EXPECT_EQ(told["format"], "scene");
  EXPECT_EQ(told["unit"], "m");
  ASSERT_EQ(told["bodies"].size(), 4u);
  EXPECT_EQ(told["bodies"][1]["parts"][0]["mesh"], "../mesh/cube.obj");
  EXPECT_EQ(told["allowed_pairs"], json::parse(R"([["lamp", "hand"]])"));
  EXPECT_NE(run("info " + file).out.find("scene of 4 bodies and 9 parts, lengths in m"), std::string::npos);
  write_text(in_folder("s.json"),
             R"({"bodies": [{"name": "a", "parts": [{"ball": {"center": [0, 0], "radius": 1}}]}]})");
  expect_bad("info " + in_folder("s.json"), "bodies[0].parts[0].ball");
}

}  // namespace

}  // namespace sunder::tests
