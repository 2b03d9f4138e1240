#include <sunder/ask/left_out.h>
#include <sunder/ask/set/set_verb.h>

#include <sunder/io/text.h>

namespace sunder::ask {

std::vector<Option> set_options(SetCall& call, const SetHelp& help) {
  return {
      {.name = "FILE", .value = &call.files, .help = help.file, .type = "", .required = true, .most = help.most_files},
      {.name = "--any",
       .value = &call.any,
       .help = "does any pair meet? (unless told otherwise)",
       .excludes = {"--all", "--count"}},
      {.name = "--all", .value = &call.all, .help = "list all pairs that meet", .excludes = {"--count"}},
      {"--count", &call.count, "count the pairs that meet, by kind"},
      {"--allow", &call.allow, fmt::format("what does not count: {}", help.allow), "KIND"},
      {"--group", &call.group, help.group, "FIELD"},
      {"--name", &call.name, help.name, "FIELD"},
      {"--method", &call.method, help.method, "NAME"},
      certificate_option(call.certificate),
      {"--geojson", &call.geojson, "write all contacts here, to lay over a map", "FILE"},
      {"--csv", &call.csv, "write all contacts here, as a table", "FILE"},
      {"--svg", &call.svg, fmt::format("draw the {} and the pairs that meet here", help.noun), "FILE"},
      title_option(call.title),
      svg_limit_option(call.svg_limit),
      json_option(call.json),
  };
}

void add_file_options(Verb& verb, SetCall& call) {
  verb.options.push_back({"--leave-out", &call.leave_out, leave_out_help});
  verb.options.push_back({"--drop-z", &call.drop_z, "ignore third coordinates"});
}

void write_proof(const Proof& proof, const Origin& origin) {
  io::OutputFile file(proof.path);
  ClaimsWriter claims([&](std::string_view text) { file.write(text); });
  claims.add_origin(origin);
  proof.write(claims);
  claims.end();
  file.commit();
}

std::string file_line(std::string_view what, const std::string& file) {
  return file.empty() ? "" : fmt::format("  {:<12}{}\n", what, io::one_line(file));
}

}  // namespace sunder::ask
