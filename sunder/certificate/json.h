// The JSON form of certificates (docs/certificates.md): self-contained, numbers exact.
#pragma once

#include <sunder/certificate/pair.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace sunder {

// A note of a file has at most this many characters (code points of UTF-8).
inline constexpr std::size_t max_note = 4000;

// The text of a certificate file of either form, with a note: what of its input the file does not speak of, because it
// was left out, skipped or simplified ("The note" of docs/certificates.md). An empty note is none. A longer one than
// max_note is cut, and then ends in "...". Requires a text as the writers make it, without a note. Cost: linear.
std::string with_note(std::string certificate, const std::string& note);

// Collects placed bodies and answers about pairs of them, then writes one certificate file.
class CertificateWriter {
 public:
  // Adds a body's table of vertices; returns its index. The points are copied.
  std::uint32_t add_body(const std::string& name, std::span<const Point3> vertices);

  // Adds a placement of a body; returns its index. Requires body < number of bodies.
  std::uint32_t add_placed(const std::string& name, std::uint32_t body, const Affine3& pose);

  // Adds an answer about placements a and b. The certificate must be true: its exact weights are computed here.
  void add_pair(std::uint32_t a, std::uint32_t b, const PairCertificate& certificate);

  // The whole file as text.
  std::string text() const;

 private:
  struct Body {
    std::string name;
    std::vector<Point3> vertices;
  };
  struct Placed {
    std::string name;
    std::uint32_t body;
    Affine3 pose;
  };
  std::vector<Body> bodies_;
  std::vector<Placed> placed_;
  std::vector<std::string> pairs_;
};

}  // namespace sunder
