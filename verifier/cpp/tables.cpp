#include <verifier/cpp/tables.h>

#include <algorithm>
#include <iterator>

namespace sunder_verifier {
namespace {

// Rows of so many doubles each.
Scaled read_rows(const std::vector<const json*>& rows, std::size_t count, const std::string& where) {
  Numbers flat;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    Numbers row = read_numbers(*rows[k], count, read_double, where + "[" + std::to_string(k) + "]");
    std::move(row.begin(), row.end(), std::back_inserter(flat));
  }
  Common scaled = common(flat);
  Scaled result;
  result.e = scaled.e;
  result.bits = bits(scaled.integers);
  for (auto at = scaled.integers.begin(); at != scaled.integers.end(); at += static_cast<std::ptrdiff_t>(count)) {
    const auto end = at + static_cast<std::ptrdiff_t>(count);
    result.rows.emplace_back(std::make_move_iterator(at), std::make_move_iterator(end));
  }
  return result;
}

Scaled read_row(const json& item, const char* key, std::size_t count, const std::string& where) {
  return read_rows({&list_member(item, key, where)}, count, where + "." + key);
}

std::vector<const json*> entries(const json& list) {
  std::vector<const json*> result;
  for (const json& entry : list) result.push_back(&entry);
  return result;
}

HullBody read_image(const json& item, const std::vector<HullBody>& bodies, const std::string& where) {
  require_members(item, {"name", "of", "linear", "translation"}, {}, where);
  const HullBody& of = bodies[index_member(item, "of", bodies.size(), where)];
  if (of.is_image()) refuse_form(where + " is of one that is placed itself");
  HullBody body = of;
  body.linear = read_row(item, "linear", of.dimension() * of.dimension(), where);
  body.translation = read_row(item, "translation", of.dimension(), where);
  return body;
}

// Points, then ways: vectors, or arrows of twice as many numbers from one point to another.
Scaled read_points_and_ways(const json& points, const json& ways, const std::string& where) {
  const std::size_t count = points.size(), d = points[0].size();
  const json zero(d, json("0x0p+0"));
  std::vector<json> ends;
  for (const json& way : ways) {
    const bool is_arrow = way.is_array() && way.size() == 2 * d;
    const auto middle = is_arrow ? way.begin() + static_cast<std::ptrdiff_t>(d) : way.end();
    ends.push_back(is_arrow ? json(json::array_t(way.begin(), middle)) : zero);
    ends.push_back(is_arrow ? json(json::array_t(middle, way.end())) : way);
  }
  std::vector<const json*> rows = entries(points);
  for (const json& end : ends) rows.push_back(&end);
  Scaled scaled = read_rows(rows, d, where + " row");
  for (std::size_t k = count; k < count + ways.size(); ++k) {
    const Integers &from = scaled.rows[2 * k - count], &to = scaled.rows[2 * k - count + 1];
    Integers way;
    for (std::size_t axis = 0; axis < d; ++axis) way.push_back(to[axis] - from[axis]);
    scaled.rows[k] = std::move(way);
  }
  scaled.rows.resize(count + ways.size());
  scaled.bits = 0;
  for (const Integers& row : scaled.rows) scaled.bits = std::max(scaled.bits, bits(row));
  return scaled;
}

HullBody read_body(const json& item, const std::vector<HullBody>& bodies, const std::string& where) {
  HullBody body;
  if (item.is_object() && item.contains("of")) {
    body = read_image(item, bodies, where);
  } else {
    require_members(item, {"name", "points"}, {"ways"}, where);
    const json& points = list_member(item, "points", where);
    if (points.empty() || !points[0].is_array() || (points[0].size() != 2 && points[0].size() != 3)) {
      refuse_form(where + ".points is not a list of points of 2 or 3 numbers");
    }
    body.count = points.size();
    const json no_ways = json::array();
    const json& ways = item.contains("ways") ? list_member(item, "ways", where) : no_ways;
    body.given = std::make_shared<const Scaled>(read_points_and_ways(points, ways, where));
  }
  body.name = text_member(item, "name", where);
  return body;
}

LinearConstraint read_constraint(const json& item, const std::string& where) {
  if (!item.is_array() || (item.size() != 3 && item.size() != 4)) refuse_form(where + " is not a list of 3 or 4");
  const Scaled row = read_rows({&item}, item.size(), where);
  const Integers& v = row.rows[0];
  LinearConstraint result;
  if (v.size() == 3) {
    result = {v[0], v[1], v[2], row.e};
  } else {  // a and b are in units of 2^e, c in units of their square
    const std::int64_t up = std::max<std::int64_t>(-row.e, 0), down = std::max<std::int64_t>(row.e, 0);
    result = {shifted(v[3] - v[1], up), shifted(v[0] - v[2], up), shifted(v[0] * v[3] - v[2] * v[1], down), row.e - up};
  }
  if (result.a == 0 && result.b == 0) refuse_form(where + " has no direction");
  return result;
}

void read_bodies(const json& list, Tables& tables) {
  for (const json& item : list) {
    tables.bodies.push_back(
        read_body(item, tables.bodies, "tables.bodies[" + std::to_string(tables.bodies.size()) + "]"));
  }
}

void read_segments(const json& list, Tables& tables) {
  Scaled scaled = read_rows(entries(list), 4, "tables.segments");
  tables.segment_exponent = scaled.e;
  tables.segment_bits = scaled.bits;
  for (Integers& v : scaled.rows) {
    if (v[0] > v[2] || (v[0] == v[2] && v[1] > v[3])) {
      refuse_form("tables.segments[" + std::to_string(tables.segments.size()) +
                  "] does not begin with its lexicographically first end");
    }
    tables.segments.push_back({{std::move(v[0]), std::move(v[1])}, {std::move(v[2]), std::move(v[3])}});
  }
}

void read_half_planes(const json& list, Tables& tables) {
  for (const json& item : list) {
    const std::string where = "tables.half_planes[" + std::to_string(tables.half_planes.size()) + "]";
    LinearConstraint h = read_constraint(item, where);
    tables.half_plane_bits = std::max({tables.half_plane_bits, bits(h.a), bits(h.b), bits(h.c)});
    tables.half_planes.push_back(std::move(h));
  }
}

}  // namespace

Integer dot(const Integers& u, const Integers& v) {
  Integer sum = 0;
  for (std::size_t k = 0; k < u.size(); ++k) sum += u[k] * v[k];
  return sum;
}

Integers projective(const Numbers& values) {
  Common scaled = common(values);
  const std::int64_t up = std::max<std::int64_t>(scaled.e, 0), down = std::max<std::int64_t>(-scaled.e, 0);
  for (Integer& n : scaled.integers) n = shifted(n, up);
  scaled.integers.push_back(shifted(scaled.d, down));
  return std::move(scaled.integers);
}

std::pair<Integers, std::int64_t> image(const HullBody& body, std::size_t k) {
  const Integers& v = body.rows()[k];
  if (!body.is_image()) return {v, body.given->e};
  const std::size_t d = body.dimension();
  const std::int64_t turned = body.linear.e + body.given->e, e = std::min(turned, body.translation.e);
  Integers result;
  for (std::size_t r = 0; r < d; ++r) {
    Integer sum = 0;
    for (std::size_t c = 0; c < d; ++c) sum += body.linear.rows[0][r * d + c] * v[c];
    result.push_back(shifted(sum, turned - e));
    if (!body.is_way(k)) result.back() += shifted(body.translation.rows[0][r], body.translation.e - e);
  }
  return {std::move(result), e};
}

std::pair<Integers, std::int64_t> products(const HullBody& body, const Integers& direction) {
  Integers row = direction, result;
  std::int64_t turned = body.given->e, e = turned;
  Integer moved = 0;
  if (body.is_image()) {
    const std::size_t d = body.dimension();
    take_steps(d * d, bits(direction), body.linear.bits);
    for (std::size_t c = 0; c < d; ++c) {
      row[c] = 0;
      for (std::size_t r = 0; r < d; ++r) row[c] += direction[r] * body.linear.rows[0][r * d + c];
    }
    turned += body.linear.e;
    e = std::min(turned, body.translation.e);
    moved = shifted(dot(direction, body.translation.rows[0]), body.translation.e - e);
  }
  take_steps(body.rows().size(), bits(row), body.given->bits);
  for (std::size_t k = 0; k < body.rows().size(); ++k) {
    result.push_back(shifted(dot(row, body.rows()[k]), turned - e));
    if (!body.is_way(k)) result.back() += moved;
  }
  return {std::move(result), e};
}

bool Tables::has(const std::string& name) const { return std::find(names.begin(), names.end(), name) != names.end(); }

Tables read_tables(const json& item) {
  static const std::map<std::string, void (*)(const json&, Tables&)> readers{
      {"bodies", read_bodies}, {"segments", read_segments}, {"half_planes", read_half_planes}};
  Tables tables;
  for (const auto& [name, reader] : readers) tables.names.push_back(name);
  require_members(item, {}, tables.names, "tables");
  tables.names.clear();
  for (const auto& [name, list] : item.items()) {
    readers.at(name)(list_member(item, name.c_str(), "tables"), tables);
    tables.names.push_back(name);
  }
  return tables;
}

void require_members(const json& item, const std::vector<std::string>& needed, const std::vector<std::string>& allowed,
                     const std::string& where) {
  if (!item.is_object()) refuse_form(where + " is not an object");
  const auto is_in = [](const std::vector<std::string>& keys, const std::string& key) {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
  };
  for (const auto& [key, value] : item.items()) {
    if (!is_in(needed, key) && !is_in(allowed, key)) refuse_form(where + " has \"" + key + "\", which means nothing");
  }
  for (const std::string& key : needed) {
    if (!item.contains(key)) refuse_form(where + " has no " + key);
  }
}

std::string text_member(const json& item, const char* key, const std::string& where) {
  std::string text = string_member(item, key, where);
  const std::size_t size = characters(text);
  if (size == 0 || size > most_name) {
    refuse_form(where + "." + key + " is not a text of 1 to " + std::to_string(most_name) + " characters");
  }
  return text;
}

}  // namespace sunder_verifier
