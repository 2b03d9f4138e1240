// The verbs circles and polygons.
#include <tests/support/program.h>

#include <algorithm>

namespace sunder::tests {

namespace {

TEST_F(Program, Discs) {
  const std::string moon = cases + "/circles/moon.csv";
  const Run count = run("circles " + moon + " --count --json");
  EXPECT_EQ(count.code, 1) << count.err;
  const json report = json::parse(count.out);
  EXPECT_EQ(report["count"], 86);
  EXPECT_EQ(report["counts"]["overlapping"], 74);
  for (const std::string method : {"grid", "sweep", "scan"}) {
    EXPECT_EQ(json::parse(run("circles " + moon + " --all --json --method " + method).out)["contacts"].size(), 86u);
  }
  const std::string apart = in_folder("apart.csv"), proof = in_folder("proof.json");
  write_text(apart, "0,0,1\n2,0,1\n");
  EXPECT_EQ(run("circles " + apart).code, 1);
  EXPECT_EQ(run("circles " + apart + " --allow touch --certificate " + proof).code, 0);
  EXPECT_EQ(run("verify " + proof + " --against " + apart).code, 0);
  EXPECT_EQ(run("circles " + moon + " --svg " + in_folder("moon.svg")).code, 1);
  EXPECT_NE(read_text(in_folder("moon.svg")).find("inside 12"), std::string::npos);
  write_text(apart, "0,0,1\n2,0,-1\n");
  const Run negative = run("circles " + apart);
  EXPECT_EQ(negative.code, 2);
  EXPECT_NE(negative.err.find("apart.csv:2: has a negative radius"), std::string::npos) << negative.err;
  // Each answer proved; the same by a method that looks at all pairs.
  for (const std::string how : {"", "--all", "--count", "--count --method scan", "--all --allow touch --method scan"}) {
    EXPECT_EQ(run("circles " + moon + " " + how + " --certificate " + proof).code, 1) << how;
    EXPECT_EQ(run("verify " + proof).code, 0) << how;
    const json statement = json::parse(read_text(proof))["statements"][0];
    EXPECT_EQ(statement.value("number", 86), 86) << how;
    EXPECT_EQ(statement.contains("contacts") ? statement["contacts"].size() : 86u, 86u) << how;
    EXPECT_EQ(statement["verdict"], how.empty() ? "some" : how[2] == 'c' ? "count" : "these") << how;
  }
}

TEST_F(Program, Polygons) {
  const std::string tracts = cases + "/tracts/tracts.wkt";
  const Run count = run("polygons " + tracts + " --count --json");
  EXPECT_EQ(count.code, 1) << count.err;
  EXPECT_EQ(json::parse(count.out)["counts"]["touching"], 607);
  EXPECT_EQ(run("polygons " + tracts + " --allow touch").code, 0);
  const std::string proof = in_folder("proof.json");
  for (const std::string rule : {"nothing", "shared-endpoint", "touch"}) {
    EXPECT_EQ(run("polygons " + tracts + " --certificate " + proof + " --allow " + rule).code, rule == "touch" ? 0 : 1);
    EXPECT_EQ(run("verify " + proof).code, 0) << rule;
    EXPECT_TRUE(python_accepts(proof)) << rule;
  }
  for (const std::string what : {"--all", "--count", "--allow shared-endpoint --all", "--allow touch --count"}) {
    EXPECT_LT(run("polygons " + tracts + " --certificate " + proof + " " + what).code, 2) << what;
    EXPECT_EQ(run("verify " + proof).code, 0) << what;
    EXPECT_TRUE(python_accepts(proof)) << what;
    json top = json::parse(read_text(proof));
    json& said = top["statements"][0];
    if (said["verdict"] == "these") {
      EXPECT_EQ(said["contacts"].size(), report("polygons " + tracts + " " + what, 1)["contacts"].size());
      said["contacts"].erase(3);
    } else {
      said["number"] = said["number"].get<int>() + 1;
    }
    write_text(proof, top.dump());
    EXPECT_EQ(run("verify " + proof).code, 1) << what;
    EXPECT_FALSE(python_accepts(proof)) << what;
  }
  expect_bad("polygons " + tracts + " --method scan --certificate " + in_folder("none.json"), "scan writes no");
  const std::string two = in_folder("two.wkt");
  write_text(two, "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))\nPOLYGON ((1 1, 2 1, 2 2, 1 1))\n");
  for (const std::string method : {"automatic", "grid", "sweep", "scan"}) {
    const Run inside = run("polygons " + two + " --allow touch --method " + method);
    EXPECT_EQ(inside.code, 1) << inside.err;
    EXPECT_NE(inside.out.find("overlapping: 1 (line 1) and 2 (line 2): a vertex inside"), std::string::npos)
        << inside.out;
  }
  EXPECT_EQ(run("polygons " + two + " --svg " + in_folder("two.svg")).code, 1);
  write_text(two, "POLYGON ((0 0, 4 4, 4 0, 0 4, 0 0))\n");
  const Run crossed = run("polygons " + two);
  EXPECT_EQ(crossed.code, 2);
  EXPECT_NE(crossed.err.find("feature 1: is not valid: ring 0 crosses itself at about (2, 2): edges 0 and 2"),
            std::string::npos)
      << crossed.err;
}

// Pads of one net may meet; the one pair of two nets is found.
TEST_F(Program, DiscsOfGroups) {
  const std::string pads = in_folder("pads.csv");
  write_text(pads, "x,y,r,net,name\n0,0,2,GND,a\n3,0,2,GND,b\n6,0,2,VCC,c\n20,0,1,VCC,d\n");
  EXPECT_EQ(run("circles " + pads).code, 1);
  for (const std::string method : {"automatic", "grid", "sweep", "scan"}) {
    const json all = report("circles " + pads + " --all --group net --method " + method, 1);
    ASSERT_EQ(all["count"], 1) << method;
    EXPECT_EQ(all["contacts"][0]["names"], (json{"b", "c"}));
    EXPECT_EQ(all["contacts"][0]["groups"], (json{"GND", "VCC"}));
    EXPECT_EQ(report("circles " + pads + " --group net --method " + method, 1)["contacts"].size(), 1u);
  }
  EXPECT_EQ(report("circles " + pads + " --count --group name", 1)["count"], 2);
  const Run text = run("circles " + pads + " --group net");
  EXPECT_NE(text.out.find(", 2 groups"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("circle b of GND, line 3: "), std::string::npos) << text.out;
  expect_bad("circles " + pads + " --group layer", "no column 'layer' to group by; there are net, name");
  const std::string proof = in_folder("proof.json");
  for (const std::string how : {" --group net", " --all --group net", " --count --group name"}) {
    EXPECT_EQ(run("circles " + pads + how + " --certificate " + proof).code, 1) << how;
    EXPECT_EQ(run("verify " + proof).code, 0) << how;
  }
  write_text(pads, "x,y,r,net\n0,0,2,GND\n3,0,2,GND\n20,0,1,VCC\n");
  EXPECT_EQ(run("circles " + pads + " --group net --certificate " + proof).code, 0);
  EXPECT_EQ(run("verify " + proof).code, 0);
  const json statement = json::parse(read_text(proof))["statements"][0];
  EXPECT_EQ(statement["verdict"], "none");
  EXPECT_EQ(statement["groups"], (json{0, 0, 1}));
}

// Two layers of a map: parcels may meet one another, and zones too; the one parcel in a zone is found.
TEST_F(Program, PolygonsOfGroups) {
  const std::string map = in_folder("map.geojson");
  const auto feature = [](const std::string& layer, const std::string& rings) {
    return R"({"type": "Feature", "properties": {"layer": ")" + layer + R"("}, "geometry": {"type": "MultiPolygon", )" +
           R"("coordinates": [)" + rings + "]}}";
  };
  const std::string left = "[[[0,0],[4,0],[4,4],[0,4],[0,0]]]", right = "[[[4,4],[8,4],[8,6],[4,6],[4,4]]]",
                    zone = "[[[6,3],[9,3],[9,9],[6,9],[6,3]]]", other = "[[[7,8],[10,8],[10,10],[7,10],[7,8]]]";
  write_text(map, R"({"type": "FeatureCollection", "features": [)" + feature("parcels", left + "," + right) + "," +
                      feature("zones", zone) + "," + feature("zones", other) + "]}");
  const json all = report("polygons " + map + " --all", 1),
             by_layer = report("polygons " + map + " --all --group layer", 1);
  EXPECT_EQ(all["count"], 2);  // the parts of the first feature belong together
  EXPECT_EQ(by_layer["count"], 1);
  EXPECT_EQ(by_layer["contacts"][0]["i"], 0);
  EXPECT_EQ(by_layer["contacts"][0]["j"], 1);
  EXPECT_EQ(by_layer["contacts"][0]["parts"], (json{1, 0}));
  EXPECT_EQ(by_layer["contacts"][0]["groups"], (json{"parcels", "zones"}));
  const Run text = run("polygons " + map + " --group layer");
  EXPECT_NE(text.out.find(", 2 groups"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find(" of parcels, part 1 and "), std::string::npos) << text.out;
  expect_bad("polygons " + map + " --group colour", "has no property 'colour'; give it one\n");
  expect_bad("polygons " + map + " --group ring", "rings belong to polygons");
  expect_bad("polygons " + map + " --group feature",
             "--group: each feature is one polygon, and its parts are not "
             "compared; leave it out, or group by a property");
  // With groups all is proved, and of two files, too; that a parcel is in a zone is not what the members of one do.
  const std::string proof = in_folder("map.json"), certificate = " --certificate " + proof;
  for (const std::string what : {"", "--all", "--count", "--allow touch", "--allow touch --count"}) {
    EXPECT_EQ(run("polygons " + map + " --group layer " + what + certificate).code, 1) << what;
    EXPECT_EQ(run("verify " + proof).code, 0) << what;
    EXPECT_TRUE(python_accepts(proof)) << what;
  }
  const std::string west = in_folder("west.wkt"), east = in_folder("east.wkt");
  write_text(west, "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))\nPOLYGON ((3 3, 5 3, 5 5, 3 5, 3 3))\n");
  write_text(east, "POLYGON ((6 0, 8 0, 8 4, 6 4, 6 0))\nPOLYGON ((7 3, 9 3, 9 5, 7 5, 7 3))\n");
  EXPECT_EQ(run("polygons " + west + " " + east + certificate).code, 0);
  EXPECT_EQ(run("verify " + proof).code, 0);
  EXPECT_TRUE(python_accepts(proof));
  json top = json::parse(read_text(proof));
  top["statements"][0].erase("groups");
  write_text(proof, top.dump());
  EXPECT_EQ(run("verify " + proof).code, 1);
  EXPECT_FALSE(python_accepts(proof));
}

TEST_F(Program, Boxes) {
  const std::string rooms = cases + "/outcomes/boxes.csv", proof = in_folder("proof.json");
  const json all = report("boxes " + rooms + " --all --certificate " + proof + " --svg " + in_folder("b.svg"), 1);
  EXPECT_EQ(all["counts"], (json{{"overlapping", 1}, {"inside", 1}, {"touching", 1}}));
  EXPECT_EQ(all["contacts"][0]["names"], (json{"hall", "porch"}));
  EXPECT_EQ(run("verify " + proof + " --against " + rooms).code, 0);
  EXPECT_TRUE(python_accepts(proof));
  EXPECT_NE(read_text(in_folder("b.svg")).find("Which of these boxes meet?"), std::string::npos);
  EXPECT_EQ(report("boxes " + rooms + " --all --method scan", 1)["contacts"], all["contacts"]);
  EXPECT_EQ(report("boxes " + rooms + " --count --group owner", 1)["count"], 2);
  json forged = json::parse(read_text(proof));
  forged["statements"][0]["contacts"][0][2] = "inside";
  write_text(proof, forged.dump());
  EXPECT_EQ(run("verify " + proof).code, 1);
  EXPECT_FALSE(python_accepts(proof));
  const std::string turned = in_folder("turned.csv");
  write_text(turned, "4,2,0,0\n4,0,6,2\n");  // any two opposite corners
  EXPECT_EQ(report("boxes " + turned, 1)["contacts"][0]["contact"], "touching");
  expect_bad("boxes " + cases + "/outcomes/square.wkt", "has no boxes; give CSV, x1,y1,x2,y2");
  expect_bad("boxes " + rooms + " --allow shared-endpoint", "there is nothing named 'shared-endpoint' to allow");
}

// Each list is a report, a map and a table too, of the same contacts.
TEST_F(Program, ListsAsMapsAndTables) {
  const std::string map = in_folder("map.geojson"), table = in_folder("table.csv");
  for (const std::string& of :
       {"circles " + cases + "/circles/moon.csv", "boxes " + cases + "/outcomes/boxes.csv",
        "polygons " + cases + "/tracts/tracts.wkt", "segments " + cases + "/outcomes/segments.csv"}) {
    const json contacts = report(of + " --all --geojson " + map + " --csv " + table, 1)["contacts"];
    const json features = json::parse(read_text(map))["features"];
    const std::string rows = read_text(table);
    ASSERT_GT(contacts.size(), 0u) << of;
    ASSERT_EQ(features.size(), contacts.size()) << of;
    EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), static_cast<std::ptrdiff_t>(contacts.size()) + 1) << of;
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      json properties = features[k]["properties"];
      EXPECT_EQ(properties["number"], k + 1);
      properties.erase("number");
      json contact = contacts[k];
      contact.erase("point");
      EXPECT_EQ(properties, contact) << of;
    }
    const std::string first = "\r\n" + contacts[0]["i"].dump() + "," + contacts[0]["j"].dump() + "," +
                              contacts[0]["contact"].get<std::string>() + ",";
    EXPECT_NE(rows.find(first), std::string::npos) << of;
  }
  expect_bad("circles " + cases + "/circles/moon.csv --csv " + table + " --geojson " + table, "is the same file as");
}

}  // namespace

}  // namespace sunder::tests
