#include <sunder/ask/set/set_verb.h>

#include <sunder/base/error.h>

namespace sunder::ask {

std::vector<Option> set_options(SetCall& call, const SetHelp& help) {
  return {
      {.name = "FILE", .value = &call.files, .help = help.file, .type = "", .required = true, .most = help.most_files},
      {.name = "--any",
       .value = &call.any,
       .help = "find one pair that meets, or prove that there is none (the default)",
       .excludes = {"--all", "--count"}},
      {.name = "--all", .value = &call.all, .help = "list all pairs that meet", .excludes = {"--count"}},
      {"--count", &call.count, "count the pairs that meet, by kind"},
      {"--allow", &call.allow, fmt::format("contacts that do not count: {}", help.allow), "KIND"},
      {"--group", &call.group, help.group, "FIELD"},
      {"--name", &call.name, help.name, "FIELD"},
      property_option(call.properties, "of both members of a pair"),
      {"--method", &call.method, help.method, "NAME"},
      certificate_option(call.certificate),
      {"--geojson", &call.geojson, "write all contacts to FILE, as features for a map", "FILE"},
      {"--csv", &call.csv, "write all contacts to FILE, as a table", "FILE"},
      {"--svg", &call.svg, fmt::format("draw the {} and their contacts to FILE", help.noun), "FILE"},
      title_option(call.title),
      svg_limit_option(call.svg_limit),
      json_option(call.json),
  };
}

void add_file_options(Verb& verb, SetCall& call) {
  verb.options.push_back({"--leave-out", &call.leave_out, leave_out_help});
  verb.options.push_back({"--drop-z", &call.drop_z, "ignore the third coordinate of each point"});
  verb.options.push_back({"--mixed-crs", &call.mixed_crs, mixed_crs_help});
}

void require_provable(std::uint64_t contacts) {
  constexpr std::uint64_t bytes_each = 24;  // [1234567,1234567,"inside"],
  if (contacts <= most_proved) return;
  throw Error(ErrorCode::bad_call,
              fmt::format("the proof of a list is as long as the list: {} contacts, about {} MB; ask for --count",
                          contacts, contacts * bytes_each / 1'000'000),
              "--certificate");
}

void require_other_than_scan(const SetCall& call) {
  if (!call.proves() || call.method != "scan") return;
  throw Error(ErrorCode::bad_call, "scan writes no certificates; give automatic or sweep", "--method");
}

}  // namespace sunder::ask
