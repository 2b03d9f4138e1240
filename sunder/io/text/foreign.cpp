#include <sunder/io/text/foreign.h>
#include <sunder/io/text/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>

namespace sunder::io {

namespace {

using namespace std::string_view_literals;

constexpr std::string_view by_ogr = "ogr2ogr -f GeoJSON OUT.geojson {}";

struct Foreign {
  std::string_view magic, what;
  std::string_view way;  // out, in the plane; {} is the file; empty: save it as CSV, WKT or GeoJSON
};

constexpr std::array foreign{
    Foreign{"\x00\x00\x27\x0a"sv, "a Shapefile", by_ogr},
    Foreign{"SQLite format 3"sv, "a GeoPackage, or another SQLite database", by_ogr},
    Foreign{"fgb\x03"sv, "FlatGeobuf", by_ogr},
    Foreign{"PAR1"sv, "Parquet", by_ogr},
    Foreign{"AutoCAD Binary DXF"sv, "binary DXF", by_ogr},
    Foreign{"AC10"sv, "DWG", "save it as DXF, then ogr2ogr -f GeoJSON OUT.geojson OUT.dxf"},
    Foreign{"\x00\x06\x00\x02"sv, "GDSII", "write its polygons as WKT or GeoJSON (KLayout can, by a script)"},
    Foreign{"%SEMI-OASIS"sv, "OASIS", "write its polygons as WKT or GeoJSON (KLayout can, by a script)"},
    Foreign{"\x1f\x8b"sv, "a gzip archive", "unpack it first: gunzip -k {}"},
    Foreign{"PK\x03\x04"sv, "a zip archive (KMZ, USDZ and office files are such)", "unpack it first: unzip {}"},
    Foreign{"BZh"sv, "a bzip2 archive", "unpack it first: bunzip2 -k {}"},
    Foreign{"\xfd\x37zXZ"sv, "an xz archive", "unpack it first: unxz -k {}"},
    Foreign{"\x28\xb5\x2f\xfd"sv, "a zstd archive", "unpack it first: unzstd {}"},
    Foreign{"\xff\xfe\x00\x00"sv, "UTF-32 text (save it as UTF-8)", "iconv does: iconv -f UTF-32 -t UTF-8 {} > OUT"},
    Foreign{"\x00\x00\xfe\xff"sv, "UTF-32 text (save it as UTF-8)", "iconv does: iconv -f UTF-32 -t UTF-8 {} > OUT"},
    Foreign{"\xff\xfe"sv, "UTF-16 text (save it as UTF-8)", "iconv does: iconv -f UTF-16 -t UTF-8 {} > OUT"},
    Foreign{"\xfe\xff"sv, "UTF-16 text (save it as UTF-8)", "iconv does: iconv -f UTF-16 -t UTF-8 {} > OUT"},
    Foreign{"\x89PNG"sv, "a PNG image", ""},
    Foreign{"\xff\xd8\xff"sv, "a JPEG image", ""},
    Foreign{"GIF8"sv, "a GIF image", ""},
    Foreign{"BM"sv, "a BMP image", ""},
    Foreign{"%PDF"sv, "a PDF document", ""},
    Foreign{"\x7f\x45LF"sv, "a program", ""},
    Foreign{"glTF"sv, "binary glTF", ""},
    Foreign{"#VRML"sv, "VRML", ""},
    Foreign{"Kaydara FBX"sv, "FBX", ""},
    Foreign{"; FBX"sv, "FBX", ""},
    Foreign{"ISO-10303-21"sv, "STEP", ""},
    Foreign{"version https://git-lfs"sv, "a Git LFS pointer (fetch the file: git lfs pull)", "git lfs pull fetches it"},
};

const Foreign* find_foreign(std::string_view bytes) {
  const auto found =
      std::find_if(foreign.begin(), foreign.end(), [&](const Foreign& f) { return bytes.starts_with(f.magic); });
  return found != foreign.end() ? &*found : nullptr;
}

// A group code 0 with SECTION, after comments (999) at most.
bool is_dxf(std::string_view text) {
  for (int pair = 0; pair < 100; ++pair) {
    std::array<std::string_view, 2> lines;
    for (std::string_view& line : lines) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      line = trimmed(text.substr(0, end));
      text.remove_prefix(std::min(end + 1, text.size()));
    }
    if (lines[0] != "999") return lines[0] == "0" && lines[1] == "SECTION";
  }
  return false;
}

constexpr std::string_view by_board = "open it in KiCad, and ask about the board that it saves (.kicad_pcb)";
constexpr std::string_view by_polygons = "write its polygons as WKT or GeoJSON (KLayout can, by a script)";

// Text of other programs, by the words that it begins with. It is trimmed on the left.
Foreign text_format(std::string_view text) {
  text = text.substr(0, 4096);
  const auto begins = [&](auto... words) { return (text.starts_with(words) || ...); };
  const auto has = [&](std::string_view words) { return text.find(words) != std::string_view::npos; };
  if (begins("%FS", "%MO", "%TF", "%TA", "%AM", "%AD", "G04 ") && has("*")) {
    return {"", "a Gerber file",
            "ask about the board that it was made of (KiCad: .kicad_pcb), or write WKT or GeoJSON"};
  }
  if (begins("M48") && trimmed(text.substr(0, text.find_first_of("\r\n"))) == "M48") {
    return {"", "an Excellon drill file", "ask about the board that it was made of (KiCad: .kicad_pcb)"};
  }
  if (begins("VERSION ") && has(";")) {
    if (has("DESIGN ")) return {"", "DEF", by_polygons};
    if (has("LAYER ") || has("MACRO ") || has("BUSBITCHARS")) return {"", "LEF", by_polygons};
  }
  if (is_hexadecimal_wkb(text.substr(0, text.find_first_of(" \t\r\n,;\"")))) {
    return {"", "hexadecimal WKB", "write WKT: SELECT ST_AsEWKT(geom)"};
  }
  return {};
}

// XML, by its root.
Foreign xml(std::string_view text) {
  text = text.substr(0, 4096);
  const auto has = [&](std::string_view root) { return text.find(root) != std::string_view::npos; };
  if (has("<kml")) return {"", "KML", by_ogr};
  if (has("<gpx")) return {"", "GPX", by_ogr};
  if (has("<osm")) return {"", "OpenStreetMap XML", "ogr2ogr -f GeoJSON OUT.geojson {} multipolygons"};
  if (has("opengis.net/gml") || has("FeatureCollection")) return {"", "GML", by_ogr};
  if (has("<eagle")) return {"", "an Eagle board or schematic", by_board};
  if (has("<svg")) return {"", "an SVG picture", "give the data that it shows"};
  if (has("<robot")) return {"", "a robot (URDF)", "ask sunder scene or sunder info"};
  return {"", "XML (COLLADA, X3D and URDF are such)", ""};
}

// A mesh by its first word, or by its ending.
bool is_mesh(std::string_view text, std::string_view place) {
  const std::string ending = ending_of(place);
  if (ending == ".obj" || ending == ".stl" || ending == ".ply" || ending == ".3mf") return true;
  const std::string_view first = trimmed(text.substr(0, text.find_first_of("\r\n")));
  return first == "ply" || first == "OFF" || first.starts_with("solid ") || first.starts_with("v ") ||
         first.starts_with("mtllib ") || ending == ".off";
}

[[noreturn]] void refuse(const Foreign& f, std::string_view place) {
  const std::string name = one_line(std::filesystem::path(place).filename().string());
  const std::string way = f.way.empty() ? std::string("give CSV, WKT or GeoJSON") : [&] {
    std::string text(f.way);
    if (const std::size_t at = text.find("{}"); at != std::string::npos) text.replace(at, 2, name);
    return text;
  }();
  fail_file(place, fmt::format("this is {}, which is not read here; {}", f.what, way));
}

}  // namespace

std::string_view foreign_format(std::string_view bytes) {
  const Foreign* const found = find_foreign(bytes);
  return found != nullptr ? found->what : std::string_view();
}

ForeignBody foreign_body(std::string_view bytes) {
  constexpr std::string_view to_urdf =
      "convert it to URDF and ask sunder scene, or name its meshes one by one (OBJ, STL, PLY, OFF, COLLADA, glTF, "
      "VRML, 3MF), each with @POSE";
  constexpr std::string_view meshes = "export its meshes as OBJ, STL or glTF (Blender can)";
  if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3);
  if (bytes.starts_with("#usda")) return {"USD", meshes};
  if (bytes.starts_with("PXR-USDC")) return {"USD (binary)", meshes};
  const std::string_view text = trimmed(bytes.substr(0, 1 << 16));
  const auto has = [&](std::string_view word) { return text.find(word) != std::string_view::npos; };
  if (text.starts_with('{')) {
    if (has("\"sunder_certificate\"")) return {"a certificate", "ask sunder verify"};
    if (has("\"bodies\"")) return {"a scene of several bodies", "ask sunder scene"};
    return {};
  }
  if (!text.starts_with('<')) return {};
  if (has("<sdf")) return {"SDF (a robot or a world of Gazebo)", to_urdf};
  if (has("<mujoco")) return {"MJCF (a model of MuJoCo)", to_urdf};
  if (has("<xacro:") || has("xmlns:xacro")) {
    return {"xacro that is not expanded", "run xacro {} > robot.urdf, and ask sunder scene about robot.urdf"};
  }
  if (has("<disable_collisions") || has("<group_state")) {
    return {"an SRDF", "give it by --srdf {}, with the robot's URDF as the file"};
  }
  if (has("<robot")) return {"a robot (URDF)", "give its name the ending .urdf, and ask sunder scene or sunder info"};
  if (has("<X3D")) return {"X3D", "export it as VRML 2, OBJ or glTF"};
  return {};
}

std::string foreign_text(const ForeignBody& body, std::string_view place) {
  std::string way(body.way);
  if (const std::size_t at = way.find("{}"); at != std::string::npos) {
    way.replace(at, 2, one_line(std::filesystem::path(place).filename().string()));
  }
  return fmt::format("this is {}, which is not read here; {}", body.what, way);
}

bool is_hexadecimal_wkb(std::string_view word) {
  // The order of bytes, a type, and a point at least.
  return word.size() >= 42 && (word.starts_with("00") || word.starts_with("01")) &&
         word.find_first_not_of("0123456789abcdefABCDEF") == std::string_view::npos;
}

void refuse_foreign(std::string_view bytes, std::string_view place) {
  const bool is_package_of_mesh = is_zip(bytes) && ending_of(place) == ".3mf";
  if (const Foreign* const found = find_foreign(bytes); found != nullptr && !is_package_of_mesh) refuse(*found, place);
  const std::size_t begin = std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size());
  const std::string_view text = bytes.substr(begin);
  if (text.starts_with('<')) refuse(xml(text), place);
  if (const Foreign f = text_format(text); !f.what.empty()) refuse(f, place);
  if (is_dxf(text)) refuse({"", "DXF", by_ogr}, place);
  if (is_mesh(text, place)) refuse({"", "a mesh", "ask sunder pair, scene, hull or info"}, place);
  if (ending_of(place) == ".dbf")
    refuse({"", "the table of a Shapefile", "give the .shp to ogr2ogr -f GeoJSON OUT.geojson"}, place);
  if (bytes.substr(0, 4096).find('\0') != std::string_view::npos) {
    refuse({"", "a binary file, or text that is not UTF-8", ""}, place);
  }
}

}  // namespace sunder::io
