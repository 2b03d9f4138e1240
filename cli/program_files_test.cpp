// Files as the world has them: features and their names, what is invalid, of another kind, empty, foreign, or in two
// files.
#include <tests/support/program.h>

namespace sunder::tests {

namespace {

const std::string square = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))", far = "POLYGON ((9 9, 10 9, 9 10, 9 9))",
                  bow_tie = "POLYGON ((20 0, 24 4, 24 0, 20 4, 20 0))";

std::string feature(const std::string& properties, const std::string& type, const std::string& coordinates) {
  return R"({"type": "Feature", "properties": {)" + properties + R"(}, "geometry": {"type": ")" + type +
         R"(", "coordinates": )" + coordinates + "}}";
}

std::string collection(const std::vector<std::string>& features) {
  std::string list;
  for (const std::string& f : features) list += (list.empty() ? "" : ",\n") + f;
  return R"({"type": "FeatureCollection", "features": [)" + list + "]}";
}

// A feature is one object: its parts belong to it, and its name is told.
TEST_F(Program, PolygonsAreFeatures) {
  const std::string map = in_folder("map.geojson");
  const std::string two = "[[[[0,0],[4,0],[4,4],[0,4],[0,0]]], [[[4,4],[8,4],[8,8],[4,8],[4,4]]]]",
                    on_second = "[[[8,4],[9,4],[9,5],[8,5],[8,4]]]";
  write_text(map, collection({R"({"type": "Feature", "properties": null, "geometry": null})",
                              feature(R"("NAME": "Chad", "iso": "TD")", "MultiPolygon", two),
                              feature(R"("NAME": "Mali", "iso": "ML")", "Polygon", on_second)}));
  const json all = report("polygons " + map + " --all", 1);
  EXPECT_EQ(all["objects"][0]["features"], 3);
  EXPECT_EQ(all["objects"][0]["polygons"], 2);
  ASSERT_EQ(all["contacts"].size(), 1u);
  EXPECT_EQ(all["contacts"][0]["i"], 1);
  EXPECT_EQ(all["contacts"][0]["j"], 2);
  EXPECT_EQ(all["contacts"][0]["names"], (json{"Chad", "Mali"}));
  EXPECT_EQ(all["contacts"][0]["parts"], (json{1, 0}));
  EXPECT_EQ(all["remarks"], json{"geometries that are null or empty: 1, the first of '1'; they hold nothing"});
  const Run text = run("polygons " + map + " --name iso");
  EXPECT_NE(text.out.find("touching: TD, part 1 and ML: "), std::string::npos) << text.out;
  expect_bad("polygons " + map + " --name use", "no feature has a property 'use'");
  EXPECT_EQ(run("polygons " + map + " --allow touch --certificate " + in_folder("proof.json")).code, 0);
  EXPECT_EQ(run("verify " + in_folder("proof.json")).code, 0);
}

// --property: what else the file says of both, for people and in every list; a field's name may be any.
TEST_F(Program, PropertiesOfBoth) {
  const std::string map = in_folder("map.geojson"), out = in_folder("contacts");
  const std::string low = "[[[0,0],[4,0],[4,4],[0,4],[0,0]]]", high = "[[[1,1],[2,1],[2,2],[1,1]]]";
  write_text(map, collection({feature(R"("NAME": "Chad", "people": 17.5, "i": "N'Djamena")", "Polygon", low),
                              feature(R"("NAME": "Mali", "i": null, "tags": [1, "a"])", "Polygon", high)}));
  const std::string asked = " --all " + map + " --property people --property i";
  const json expected = {{"people", {17.5, nullptr}}, {"i", {"N'Djamena", nullptr}}};
  for (const std::string verb : {"polygons", "segments --group feature"}) {
    const json all = report(verb + asked, verb == "polygons" ? 1 : 0);
    for (const json& contact : all["contacts"]) EXPECT_EQ(contact["properties"], expected);
    EXPECT_EQ(all["contacts"].size(), verb == "polygons" ? 1u : 0u);
  }
  EXPECT_EQ(report("polygons --all " + map + " --property tags", 1)["contacts"][0]["properties"]["tags"],
            (json{nullptr, R"([1,"a"])"}));
  const Run text = run("polygons" + asked + " --geojson " + out + ".geojson --csv " + out + ".csv");
  EXPECT_NE(text.out.find("overlapping: Chad, people 17.5, i N'Djamena and Mali, people null, i null: "),
            std::string::npos)
      << text.out;
  EXPECT_EQ(json::parse(read_text(out + ".geojson"))["features"][0]["properties"]["properties"], expected);
  EXPECT_EQ(read_text(out + ".csv"),
            "i,j,contact,x,y,shown_by,name_i,name_j,part_i,part_j,people_i,people_j,i_i,i_j\r\n"
            "0,1,overlapping,1,1,a vertex inside,Chad,Mali,,0,17.5,,N'Djamena,\r\n");

  const json valid = report("simple " + map + " --property people", 0)["objects"];
  EXPECT_EQ(valid[0]["properties"], (json{{"people", 17.5}}));
  EXPECT_EQ(valid[1]["properties"], (json{{"people", nullptr}}));

  const std::string table = in_folder("table.csv");
  write_text(table, "x1,y1,x2,y2,name,use\n0,0,2,2,a,pad\n1,1,3,3,b,\"text, big\"\n");
  for (const std::string verb : {"segments", "boxes"}) {
    EXPECT_EQ(report(verb + " --property use " + table, 1)["contacts"][0]["properties"],
              (json{{"use", {"pad", "text, big"}}}));
    EXPECT_NE(run(verb + " --property use " + table).out.find("line 3, use text, big: "), std::string::npos);
  }
  write_text(table, "x,y,r,use\n0,0,2,pad\n1,1,3,7\n");
  EXPECT_EQ(report("circles --property use " + table, 1)["contacts"][0]["properties"], (json{{"use", {"pad", "7"}}}));

  expect_bad("polygons " + map + " --property use",
             "map.geojson: there is no property 'use' to tell of; there are NAME, i, people, tags");
  expect_bad("circles " + table + " --property colour",
             "table.csv: there is no column 'colour' to tell of; there are use");
  expect_bad("polygons " + map + " --property i --property i", "--property: 'i' is asked for twice; give it once");
  write_text(map + ".wkt", square);
  expect_bad("simple " + map + ".wkt --property use", "WKT has no properties to tell of; leave them out");
  expect_bad("segments --centre-lines " + cases + "/boards/two_nets.kicad_pcb --property net",
             "a board has no properties to tell of");
}

TEST_F(Program, ContactsOfPolygonsOnAMap) {
  const std::string file = in_folder("two.wkt"), out = in_folder("contacts.geojson");
  write_text(file, square + "\n" + far + "\nPOLYGON ((1 1, 2 1, 1 2, 1 1))\n");
  EXPECT_EQ(run("polygons " + file + " --geojson " + out).code, 1);
  const json map = json::parse(read_text(out));
  ASSERT_EQ(map["features"].size(), 1u);
  EXPECT_EQ(map["features"][0]["geometry"]["type"], "Point");
  const json& properties = map["features"][0]["properties"];
  EXPECT_EQ(properties["number"], 1);
  EXPECT_EQ(properties["contact"], "overlapping");
  EXPECT_EQ(properties["i"], 0);
  EXPECT_EQ(properties["j"], 2);
  EXPECT_EQ(properties["lines"], (json{1, 3}));
  write_text(file, square + "\n" + far + "\n");
  EXPECT_EQ(run("polygons " + file + " --geojson " + out).code, 0);
  EXPECT_EQ(json::parse(read_text(out))["features"].size(), 0u);
}

TEST_F(Program, InvalidFeatures) {
  const std::string file = in_folder("map.wkt"), proof = in_folder("proof.json");
  write_text(file, square + "\n" + bow_tie + "\n" + far + "\nPOLYGON ((0 0, 1 0, 1 1))\n");
  expect_bad(
      "polygons " + file,
      "map.wkt:2: feature 2: is not valid: ring 0 crosses itself at about (22, 2): edges 0 and 2; nor is 1 "
      "other feature; mend it (sunder simple tells more; --mend does what is safe), or give --skip-invalid to ask "
      "about the others");
  const json skipped = report("polygons " + file + " --skip-invalid", 0);
  ASSERT_EQ(skipped["skipped"].size(), 2u);
  EXPECT_EQ(skipped["skipped"][0]["feature"], 1);
  EXPECT_EQ(skipped["skipped"][0]["why"], "ring 0 crosses itself at about (22, 2): edges 0 and 2");
  EXPECT_EQ(skipped["skipped"][1]["why"], "ring 0: does not end where it began");
  EXPECT_EQ(skipped["objects"][0]["polygons"], 2);
  const Run text = run("polygons " + file + " --skip-invalid --certificate " + proof);
  EXPECT_NE(text.out.find("none meet, said of the 2 features only: skipped: 2 invalid features\n"), std::string::npos)
      << text.out;
  EXPECT_NE(text.out.find("  skipped     feature 4: ring 0: does not end where it began\n"), std::string::npos);
  EXPECT_EQ(json::parse(read_text(proof))["left_out"][0], "skipped: 2 invalid features");
  EXPECT_EQ(run("verify " + proof).code, 0);
  EXPECT_TRUE(python_accepts(proof));
  write_text(file, bow_tie + "\n");
  expect_bad("polygons --skip-invalid " + file, "map.wkt: no polygon is valid, so nothing is left to ask about");
  // A hole outside of its shell, parts with a common border; but points may be shared, and vertices repeated.
  write_text(file, "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (8 8, 9 8, 9 9, 8 8))\n");
  expect_bad("polygons " + file,
             "map.wkt:1: feature 1: is not valid: ring 1 is a hole outside of its shell, at (8, 8): edge 0");
  write_text(file, "MULTIPOLYGON (((0 0, 4 0, 4 4, 0 4, 0 0)), ((4 0, 8 0, 8 4, 4 4, 4 0)))\n");
  expect_bad(
      "polygons " + file,
      "feature 1: is not valid: part 0, ring 0 and part 1, ring 0 have a piece in common from about (4, 0) to (4, 4)");
  write_text(file, "POLYGON ((0 0, 4 0, 4 0, 4 4, 0 4, 0 0), (0 0, 2 1, 1 2, 0 0))\n" + far + "\n");
  EXPECT_EQ(run("polygons " + file).code, 0);
  write_text(file, "POLYGON ((0 0, 4 0, 2 2, 6 4, 2 2, 0 0))\n" + far + "\n");
  expect_bad("polygons " + file, "feature 1: is not valid: ring 0 runs along itself");
}

TEST_F(Program, RingsThatTouchThemselves) {
  const std::string file = in_folder("keyhole.wkt");
  write_text(file, "POLYGON ((0 0, 6 0, 6 6, 0 6, 0 0, 1 2, 2 2, 2 1, 0 0))\n" + far + "\n");
  expect_bad("polygons " + file, "feature 1: is not valid: ring 0 touches itself at about (0, 0)");
  EXPECT_EQ(run("polygons --self-touch " + file).code, 0);
}

// What is safe to mend is mended, and told.
TEST_F(Program, Mending) {
  const std::string file = in_folder("map.wkt"), proof = in_folder("proof.json");
  write_text(file, "POLYGON ((0 0, 4 0, 9 0, 4 0, 4 4, 4 4, 0 4), (1 1, 2 1, 1 1))\n" + far + "\n");
  expect_bad("polygons " + file, "feature 1: is not valid");
  const json mended = report("polygons --mend " + file + " --certificate " + proof, 0);
  EXPECT_EQ(mended["mended"], (json{{{"file", file},
                                     {"feature", 0},
                                     {"name", "1"},
                                     {"repeated_vertices", 2},
                                     {"spikes", 1},
                                     {"closed_rings", 1},
                                     {"rings_left_out", 1}}}));
  EXPECT_EQ(json::parse(read_text(proof))["left_out"][0], "mended: 1 feature");
  EXPECT_NE(
      run("polygons --mend " + file)
          .out.find("  mended      feature 1: 2 repeated vertices left out, 1 spike cut off, 1 ring closed, 1 ring "
                    "without area left out\n"),
      std::string::npos)
      << run("polygons --mend " + file).out;
  write_text(file, "POLYGON ((0 0, 0 4, 4 4, 4 0, 4 0, 0 0))\n");
  expect_bad("region --of polygons " + file, "feature 1: ");
  const Run region = run("region --of polygons --mend " + file);
  EXPECT_EQ(region.code, 0) << region.err;
  EXPECT_NE(region.out.find("feature 1: mended: turned round"), std::string::npos) << region.out;
  expect_bad("kernel " + file,
             "feature 1: is not strictly simple: ring 0: vertices 3 and 4 are the same, (4, 0); mend it (sunder simple "
             "--strict "
             "tells more; --mend does what is safe)");
  EXPECT_EQ(run("kernel --mend " + file).code, 0);
  write_text(file, bow_tie + "\n");
  expect_bad("polygons --mend " + file, "feature 1: is not valid: ring 0 crosses itself");
}

// Only pairs across the files are asked about.
TEST_F(Program, TwoFiles) {
  const std::string a = in_folder("a.wkt"), b = in_folder("b.geojson");
  write_text(a, square + "\nPOLYGON ((4 0, 8 0, 8 4, 4 4, 4 0))\n");
  write_text(b, collection({feature(R"("name": "pond")", "Polygon", "[[[6,1],[7,1],[7,2],[6,1]]]"),
                            feature(R"("name": "lake")", "Polygon", "[[[6,1],[7,1],[7,2],[6,1]]]")}));
  for (const std::string method : {"automatic", "boxes", "grid", "sweep", "scan"}) {
    const json all = report("polygons " + a + " " + b + " --all --method " + method, 1);
    ASSERT_EQ(all["count"], 2) << method;
    EXPECT_EQ(all["objects"].size(), 2u);
    EXPECT_EQ(all["contacts"][1]["i"], 1);
    EXPECT_EQ(all["contacts"][1]["j"], 1);
    EXPECT_EQ(all["contacts"][1]["files"], (json{0, 1}));
    EXPECT_EQ(all["contacts"][1]["names"], (json{"2", "lake"}));
  }
  const Run text = run("polygons --all " + a + " " + b);
  EXPECT_NE(text.out.find("some meet (those of one file may meet): 2 pairs: 2 overlapping\n"), std::string::npos)
      << text.out;
  EXPECT_NE(text.out.find("overlapping: 2 (" + a + ", line 2) and pond (" + b + ")"), std::string::npos) << text.out;
  write_text(in_folder("bad.wkt"), bow_tie + "\n");
  expect_bad("polygons --skip-invalid " + a + " " + in_folder("bad.wkt"), "bad.wkt: no polygon is valid");
  expect_bad("polygons " + a + " " + b + " --group name", "two files are two groups");
  expect_bad("polygons " + a + " " + b + " " + a, "three files or more");
}

// Nothing that a verb cannot use is dropped in silence.
TEST_F(Program, OfAnotherKind) {
  const std::string file = in_folder("mixed.wkt"), proof = in_folder("proof.json");
  write_text(file, "POINT (1 1)\nLINESTRING (0 0, 1 1)\n" + far + "\n");
  expect_bad("polygons " + file,
             "mixed.wkt:1: a point is not what is asked about; give a file without such, or ask "
             "without them: --leave-out");
  expect_bad("segments " + file, "mixed.wkt:1: a point is not what is asked about");
  expect_bad("kernel " + file, "mixed.wkt:1: a point is not what is asked about");
  expect_bad("region --of polygons " + file, "mixed.wkt:1: a point is not what is asked about");
  const json polygons = report("polygons --leave-out " + file + " --certificate " + proof, 0);
  EXPECT_EQ(polygons["left_out"], (json{{{"kind", "point"}, {"count", 1}, {"of", {"line 1"}}},
                                        {{"kind", "line"}, {"count", 1}, {"of", {"line 2"}}}}));
  EXPECT_EQ(json::parse(read_text(proof))["left_out"], (json{"1 point of line 1", "1 line of line 2"}));
  EXPECT_EQ(run("verify " + proof).code, 0);
  const Run text = run("segments --leave-out --allow shared-endpoint " + file + " --certificate " + proof);
  EXPECT_EQ(text.code, 0) << text.err;
  EXPECT_NE(text.out.find("none meet (shared-endpoint allowed); left out: 1 point of line 1\n"), std::string::npos)
      << text.out;
  EXPECT_EQ(json::parse(read_text(proof))["left_out"][0], "1 point of line 1");
  EXPECT_EQ(report("segments --leave-out " + file, 1)["left_out"][0]["count"], 1);
  EXPECT_EQ(run("kernel --leave-out " + file).code, 0);
  expect_bad("simple " + file, "mixed.wkt:1: a point is not what is asked about");
  EXPECT_EQ(report("simple --leave-out " + file, 0)["left_out"][0]["kind"], "point");
  EXPECT_NE(run("region --leave-out --of polygons " + file).out.find("of the 1 polygon read (left out: 1 point of"),
            std::string::npos);
}

TEST_F(Program, TablesOfNamedColumns) {
  const std::string file = in_folder("table.csv");
  write_text(file, "width,x1,y1,x2,y2,\"street, or way\"\n1,0,0,4,4,\"High \"\"B\"\" St, West\"\n1,0,4,4,0,Low\n");
  const json wires = report("segments " + file, 1);
  EXPECT_EQ(wires["contacts"][0]["names"], (json{"1", "1"}));
  EXPECT_EQ(report("segments --name 'street, or way' " + file, 1)["contacts"][0]["names"],
            (json{"High \"B\" St, West", "Low"}));
  write_text(file, "r,y,x,of\n1,0,0,a\n1,0,1,b\n");
  EXPECT_EQ(report("circles " + file, 1)["contacts"][0]["names"], (json{"a", "b"}));
  // Discs are not half-planes, nor segments, nor vertices.
  write_text(file, "x,y,r,name\n0,0,1,a\n3,0,1,b\n");
  expect_bad("region " + file,
             "table.csv:1: the columns are named x,y,r,name, but half-planes have a,b,c; name them so");
  expect_bad("segments " + file, "but segments have x1,y1,x2,y2");
  expect_bad("pair " + file + " " + file, "but vertices have x,y");
  write_text(file, "a,b,c\n1,0,1\n");
  expect_bad("circles " + file, "table.csv:1: the columns are named a,b,c, but circles have x,y,r");
  EXPECT_EQ(run("region " + file).code, 0);
}

// A question about nothing has no answer.
TEST_F(Program, NothingToAskAbout) {
  const std::string csv = in_folder("none.csv"), map = in_folder("none.geojson"), wkt = in_folder("none.wkt");
  write_text(csv, "x1,y1,x2,y2\n");
  expect_bad("segments " + csv, "none.csv: has no segments");
  write_text(csv, "x,y,r\n");
  expect_bad("circles " + csv, "none.csv: has no circles");
  expect_bad("region --of circles " + csv, "none.csv: has no circles");
  write_text(csv, "a,b,c\n");
  expect_bad("region " + csv, "none.csv: has no half-planes");
  write_text(map, R"({"type": "FeatureCollection", "features": []})");
  write_text(wkt, "POLYGON EMPTY\nGEOMETRYCOLLECTION EMPTY\n");
  for (const std::string verb : {"polygons ", "simple ", "kernel ", "region --of polygons ", "segments "}) {
    expect_bad(verb + map, "none.geojson: has no ");
    expect_bad(verb + wkt, "none.wkt: has no ");
  }
}

TEST_F(Program, ForeignFiles) {
  const std::string shape = in_folder("tracts.shp"), map = in_folder("map.geojson");
  write_text(shape, std::string("\x00\x00\x27\x0a\x00\x00", 6));
  for (const std::string verb : {"polygons ", "segments ", "circles ", "info "}) {
    expect_bad(verb + shape,
               "tracts.shp: this is a Shapefile, which is not read here; ogr2ogr -f GeoJSON OUT.geojson tracts.shp");
  }
  expect_bad("segments " + cube, "cube.obj: this is a mesh, which is not read here; ask sunder pair");
  write_text(map, collection({feature(R"("name": "pond")", "Polygon", "[[[6,1],[7,1],[7,2],[6,1]]]"),
                              feature(R"("name": "mast")", "Point", "[3, 4]")}));
  const Run text = run("info " + map);
  EXPECT_EQ(text.code, 0) << text.err;
  EXPECT_NE(text.out.find("map.geojson: GeoJSON\n  holds   2 features: 1 polygon of 1 ring and 3 edges, 1 point\n"),
            std::string::npos)
      << text.out;
  EXPECT_NE(text.out.find("  ask     sunder polygons, simple, kernel, region, segments\n"), std::string::npos)
      << text.out;
  const json r = report("info " + map, 0);
  EXPECT_EQ(r["objects"][0]["features"], 2);
  EXPECT_EQ(r["objects"][0]["polygons"], 1);
  EXPECT_EQ(r["objects"][0]["box"], (json{{3.0, 1.0}, {7.0, 4.0}}));
  EXPECT_NE(run("info " + cases + "/circles/moon.csv").out.find("323 rows of x,y,r"), std::string::npos);
  EXPECT_NE(run("info " + cases + "/half-planes/co2.csv").out.find("rows of a,b,c"), std::string::npos);
  EXPECT_NE(run("info " + cases + "/planar-pair/paths.csv").out.find("ask     sunder pair\n"), std::string::npos);
}

}  // namespace

}  // namespace sunder::tests
