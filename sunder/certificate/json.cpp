#include <sunder/certificate/claims.h>
#include <sunder/certificate/direction.h>
#include <sunder/certificate/json.h>
#include <sunder/predicate/common_point.h>

#include <array>
#include <charconv>
#include <cmath>

namespace sunder {

namespace {

std::string number(double x) {
  std::array<char, 40> digits;
  const auto end =
      std::to_chars(digits.data(), digits.data() + digits.size(), std::fabs(x), std::chars_format::hex).ptr;
  return (std::signbit(x) ? "\"-0x" : "\"0x") + std::string(digits.data(), end) + '"';
}

std::string number(const Dyadic& x) { return '"' + x.hexadecimal() + '"'; }

// "[..., ...]" of what `item` makes of each element.
template <class Range, class Item>
std::string list(const Range& range, const Item& item, const char* between = ", ") {
  std::string out = "[";
  for (const auto& element : range) {
    if (out.size() > 1) out += between;
    out += item(element);
  }
  return out + ']';
}

std::string doubles(std::span<const double> numbers) {
  return list(numbers, [](double x) { return number(x); });
}

std::string direction_text(const Direction& direction, const PlacedVertices& a, const PlacedVertices& b) {
  if (direction.kind == Direction::Kind::given) {
    return doubles(std::array{direction.given.x, direction.given.y, direction.given.z});
  }
  const Vector3<Dyadic> d = world_direction(direction, a, b).exact();
  return list(std::array{d.x, d.y, d.z}, [](const Dyadic& x) { return number(x); });
}

std::string meet_text(const PairCertificate& c, const PlacedVertices& a, const PlacedVertices& b) {
  std::array<Posed, 5> points{};
  const std::size_t n = std::size_t{c.count_a} + c.count_b;
  for (std::size_t i = 0; i < n; ++i) points[i] = i < c.count_a ? a[c.vertices[i]] : b[c.vertices[i]];
  const std::span<const Posed> all(points.data(), n);
  const CommonPointWeights w = common_point_weights(all.first(c.count_a), all.subspan(c.count_a));
  const auto fraction = [&](const Dyadic& x) { return '"' + fraction_text(x, w.denominator) + '"'; };
  const auto weights = [&](std::size_t first, std::size_t count) {
    std::string out = "[";
    for (std::size_t i = first; i < first + count; ++i) {
      if (i > first) out += ", ";
      out += '[' + std::to_string(c.vertices[i]) + ", " + fraction(w.numerators[i]) + ']';
    }
    return out + ']';
  };
  return "\"verdict\": \"meet\", \"point\": " + list(w.point, fraction) + ", \"weights_a\": " + weights(0, c.count_a) +
         ", \"weights_b\": " + weights(c.count_a, c.count_b);
}

}  // namespace

std::string with_note(std::string certificate, const std::string& note) {
  if (note.empty()) return certificate;
  const std::string claims = "{\"sunder_certificate\": 2";
  if (certificate.starts_with(claims)) {
    certificate.insert(claims.size(), ",\n \"left_out\": [" + json_string(cut_text(note)) + "]");
    return certificate;
  }
  const std::string version = "certificate\": 1,";
  certificate.insert(certificate.find(version) + version.size(), " \"note\": " + json_string(cut_text(note)) + ",");
  return certificate;
}

std::uint32_t CertificateWriter::add_body(const std::string& name, std::span<const Point3> vertices) {
  bodies_.push_back({name, {vertices.begin(), vertices.end()}});
  return static_cast<std::uint32_t>(bodies_.size() - 1);
}

std::uint32_t CertificateWriter::add_placed(const std::string& name, std::uint32_t body, const Affine3& pose) {
  placed_.push_back({name, body, pose});
  return static_cast<std::uint32_t>(placed_.size() - 1);
}

void CertificateWriter::add_pair(std::uint32_t a, std::uint32_t b, const PairCertificate& c) {
  const auto view = [&](std::uint32_t i) {
    return PlacedVertices{bodies_[placed_[i].body].vertices, placed_[i].pose, false};
  };
  const PlacedVertices in_a = view(a), in_b = view(b);
  std::string text = "{\"a\": " + std::to_string(a) + ", \"b\": " + std::to_string(b) + ", ";
  if (c.verdict == Verdict::apart) {
    text += "\"verdict\": \"apart\", \"direction\": " + direction_text(c.direction, in_a, in_b) +
            ", \"extreme_a\": " + std::to_string(c.extreme_a) + ", \"extreme_b\": " + std::to_string(c.extreme_b);
  } else {
    text += meet_text(c, in_a, in_b);
  }
  pairs_.push_back(text + '}');
}

std::string CertificateWriter::text() const {
  const auto body = [](const Body& b) {
    return "\n    {\"name\": " + json_string(b.name) + ", \"vertices\": " +
           list(b.vertices, [](const Point3& p) { return "\n      " + doubles(std::array{p.x, p.y, p.z}); }, ",") + '}';
  };
  const auto placed = [](const Placed& p) {
    return "\n    {\"name\": " + json_string(p.name) + ", \"body\": " + std::to_string(p.body) +
           ", \"linear\": " + doubles(p.pose.linear) + ", \"translation\": " + doubles(p.pose.translation) + '}';
  };
  const auto pair = [](const std::string& p) { return "\n    " + p; };
  return "{\n  \"sunder_certificate\": 1,\n  \"bodies\": " + list(bodies_, body, ",") +
         ",\n  \"placed\": " + list(placed_, placed, ",") + ",\n  \"pairs\": " + list(pairs_, pair, ",") + "\n}\n";
}

}  // namespace sunder
