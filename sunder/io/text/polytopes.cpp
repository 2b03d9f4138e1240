#include <sunder/io/text/csv.h>
#include <sunder/io/text/file.h>
#include <sunder/io/text/foreign.h>
#include <sunder/io/text/npy.h>
#include <sunder/io/text/polytopes.h>
#include <sunder/io/text/text.h>

#include <fmt/format.h>

#include <fstream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace sunder::io {

namespace {

using polytope::Form;
using polytope::Polytope;

struct Columns {
  Form form = Form::points;
  std::size_t dimension = 0;
};

// Of a first record that names the columns of a polytope.
std::optional<Columns> named_columns(const CsvReader::Fields& fields) {
  const bool of_points = fields.back() != "b" && fields.back() != "B";
  const std::size_t d = fields.size() - (of_points ? 0 : 1);
  if (d < polytope::least_dimension || d > polytope::most_dimension) return std::nullopt;
  for (std::size_t c = 0; c < d; ++c) {
    if (in_small_letters(fields[c]) != fmt::format("{}{}", of_points ? 'x' : 'a', c + 1)) return std::nullopt;
  }
  return Columns{of_points ? Form::points : Form::half_spaces, d};
}

Polytope of_rows(Form form, std::size_t width, std::vector<double> numbers) {
  return form == Form::points ? Polytope::from_points(width, std::move(numbers))
                              : Polytope::from_half_spaces(width - 1, std::move(numbers));
}

// What is wrong with rows of so many numbers; empty where nothing is.
std::string wrong_width(Form form, std::size_t width) {
  const bool of_points = form == Form::points;
  const std::size_t d = width - (of_points ? 0 : 1);
  if (width > 0 && d >= polytope::least_dimension && d <= polytope::most_dimension) return "";
  return of_points ? fmt::format("a point of dimension {}; give points of dimension 2 to 6", width)
                   : fmt::format("of {}, and a half-space of 3 to 7, a1,..,ad,b; give such", count_of(width, "number"));
}

Polytope of_npy(std::string_view bytes, std::string_view place, Form form) {
  NpyArray array = parse_npy(bytes, place);
  if (const std::string wrong = wrong_width(form, array.columns); !wrong.empty()) {
    fail_file(place, "a row is " + wrong);
  }
  return of_rows(form, array.columns, std::move(array.values));
}

}  // namespace

bool names_polytope(const std::filesystem::path& path) {
  if (ending_of(path.string()) == ".npy") return true;
  if (ending_of(path.string()) != ".csv" || !is_file(path)) return false;
  std::string line(200, '\0');  // longer lines name others
  if (const GivenFiles* given = GivenFiles::now()) {
    line = given->bytes_of(path)->substr(0, line.size());
  } else {
    std::ifstream stream(path, std::ios::binary);
    stream.read(line.data(), static_cast<std::streamsize>(line.size()));
    line.resize(static_cast<std::size_t>(stream.gcount()));
  }
  std::string_view text = line;
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  const std::size_t first = text.find_first_not_of("\r\n");
  if (first == std::string_view::npos) return false;
  text.remove_prefix(first);
  text = text.substr(0, text.find_first_of("\r\n"));
  if (text.find('"') != std::string_view::npos) return false;
  CsvReader reader(text, "");
  return reader.next() && named_columns(reader.fields());
}

Polytope parse_polytope(std::string_view text, std::string_view place, Form unnamed) {
  if (is_npy(text)) return of_npy(text, place, unnamed);
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  refuse_foreign(text, place);
  CsvReader reader(text, place);
  std::optional<Columns> columns;
  std::vector<double> numbers;
  while (reader.next()) {
    const CsvReader::Fields& fields = reader.fields();
    if (reader.is_first()) {
      columns = named_columns(fields);
      if (columns) {
        if (columns->form == Form::points && unnamed == Form::half_spaces) {
          reader.fail("names points, and half-spaces were asked for; ask for points");
        }
        continue;
      }
      if (are_names(fields, fields.size())) {
        reader.fail("has names that are neither x1,..,xd nor a1,..,ad,b; name the columns so, for a d from 2 to 6");
      }
      if (const std::string wrong = wrong_width(unnamed, fields.size()); !wrong.empty()) reader.fail("is " + wrong);
      columns = {unnamed, fields.size() - (unnamed == Form::points ? 0 : 1)};
    }
    const std::size_t width = columns->dimension + (columns->form == Form::points ? 0 : 1);
    if (fields.size() != width) {
      reader.fail(
          fmt::format("has {}, others have {}; give rows of one dimension", count_of(fields.size(), "number"), width));
    }
    for (const std::string_view field : fields) {
      double value = 0;
      if (const char* const problem = parse_number(field, value)) {
        reader.fail(fmt::format("{} {}", quote(field), problem));
      }
      numbers.push_back(value);
    }
  }
  if (!columns || (columns->form == Form::points && numbers.empty())) {
    fail_file(place, "has no points; give lines x1,..,xd, or name the columns of half-spaces a1,..,ad,b");
  }
  return of_rows(columns->form, columns->dimension + (columns->form == Form::points ? 0 : 1), std::move(numbers));
}

Polytope read_polytope(const std::filesystem::path& path, InputFiles* inputs, Form unnamed) {
  return parse_polytope(read_file(path, inputs), path.string(), unnamed);
}

polytope::Pose polytope_pose(std::span<const double> numbers, std::size_t d, const std::string& place) {
  std::vector<double> linear(d * d), translation(d);
  const std::size_t width = numbers.size() == d ? 1 : d + 1;  // of a row
  if (numbers.size() != d * width) {
    throw Error(ErrorCode::bad_call,
                fmt::format("a pose of {}; of dimension {} give {}, a translation, or {}, a matrix row by row",
                            count_of(numbers.size(), "number"), d, d, d * (d + 1)),
                place);
  }
  for (std::size_t r = 0; r < d; ++r) {
    for (std::size_t c = 0; c < d; ++c) linear[r * d + c] = width > 1 ? numbers[r * width + c] : r == c;
    translation[r] = numbers[r * width + width - 1];
  }
  try {
    return polytope::Pose::from_matrix(d, linear, translation);
  } catch (const Error& error) {
    throw Error(error.code(), error.text(), place);
  }
}

std::vector<polytope::Pose> read_polytope_poses(const std::filesystem::path& path, std::size_t d, InputFiles* inputs) {
  const std::string text = read_file(path, inputs), name = path.string();
  std::vector<polytope::Pose> poses;
  const auto add = [&](std::span<const double> row, const std::string& place) {
    try {
      poses.push_back(polytope_pose(row, d, ""));
    } catch (const Error& error) {
      throw Error(ErrorCode::bad_file, error.what(), place);
    }
  };
  if (is_npy(text)) {
    const NpyArray array = parse_npy(text, name);
    for (std::size_t k = 0; k < array.rows; ++k) {
      add(std::span(array.values).subspan(k * array.columns, array.columns), fmt::format("{}: row {}", name, k));
    }
  } else {
    refuse_foreign(text, name);
    CsvReader reader(std::string_view(text).substr(text.starts_with("\xef\xbb\xbf") ? 3 : 0), name);
    while (reader.next()) {
      const CsvReader::Fields& fields = reader.fields();
      if (reader.is_first() && are_names(fields, fields.size())) {
        reader.fail("has names, and a pose is numbers alone; leave the names out");
      }
      std::vector<double> row;
      for (const std::string_view field : fields) {
        if (const char* const problem = parse_number(field, row.emplace_back())) {
          reader.fail(fmt::format("{} {}", quote(field), problem));
        }
      }
      add(row, fmt::format("{}:{}", name, reader.line()));
    }
  }
  if (poses.empty()) fail_file(name, "has no poses; give one in each line");
  return poses;
}

}  // namespace sunder::io
