#include <cli/left_out.h>
#include <cli/set_verb.h>

#include <sunder/io/text.h>

#include <CLI/App.hpp>

namespace sunder::cli {

CLI::App* add_set_verb(CLI::App& program, SetCall& call, const SetHelp& help, const std::function<void()>& run) {
  CLI::App* verb = program.add_subcommand(help.verb, help.about);
  auto* file = verb->add_option("FILE", call.files, help.file)->required();
  if (!help.two_files) file->expected(1);
  auto* any = verb->add_flag("--any", call.any, "does any pair meet? (unless told otherwise)");
  auto* all = verb->add_flag("--all", call.all, "list all pairs that meet");
  auto* count = verb->add_flag("--count", call.count, "count the pairs that meet, by kind");
  any->excludes(all)->excludes(count);
  all->excludes(count);
  verb->add_option("--allow", call.allow, fmt::format("what does not count: {}", help.allow))->type_name("KIND");
  verb->add_option("--group", call.group, help.group)->type_name("FIELD");
  verb->add_option("--name", call.name, help.name)->type_name("FIELD");
  verb->add_option("--method", call.method, help.method)->type_name("NAME");
  verb->add_option("--certificate", call.certificate, "write the proof here")->type_name("FILE");
  verb->add_option("--geojson", call.geojson, "write all contacts here, to lay over a map")->type_name("FILE");
  verb->add_option("--csv", call.csv, "write all contacts here, as a table")->type_name("FILE");
  auto* svg = verb->add_option("--svg", call.svg, fmt::format("draw the {} and the pairs that meet here", help.noun))
                  ->type_name("FILE");
  verb->add_option("--title", call.title, "of the picture")->needs(svg);
  add_svg_limit(*verb, call.svg_limit);
  verb->add_flag("--json", call.json, "print a report in JSON");
  verb->callback(run);
  return verb;
}

void add_file_options(CLI::App& verb, SetCall& call) {
  verb.add_flag("--leave-out", call.leave_out, leave_out_help);
  verb.add_flag("--drop-z", call.drop_z, "ignore third coordinates");
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

}  // namespace sunder::cli
