// Long lists that are written as they come: text in pieces.
#pragma once

#include <sunder/ask/report.h>

#include <sunder/io/text/file.h>

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

namespace sunder::ask {

// A list whose items stand one on a line. Memory: about 64 KB, and the longest item.
class ListStream {
 public:
  // What stands before the list, "[" included; `margin` before each item.
  ListStream(std::string opening, std::string margin, TextSink sink);

  void add(std::string_view item);

  // More of the last item.
  void append(std::string_view more);
  std::uint64_t count() const { return count_; }

  // What stands behind the list, "]" included. Nothing is added after this.
  void close(std::string_view closing);

 private:
  std::string text_, margin_;
  TextSink sink_;
  std::uint64_t count_ = 0;
};

// A report that is printed with a list: in the place of the member of that name, or else last. Nothing is printed
// before the first 64 KB, or close().
class ListReport {
 public:
  ListReport(Talk& talk, const Json& report, std::string_view list);
  void add(std::string_view item) { list_.add(item); }

  // An item that ends with a list, which `fill` adds to.
  void add_list(const Json& head, std::string_view key, const std::function<void(ListStream&)>& fill);
  void close();

 private:
  ListReport(Talk& talk, std::pair<std::string, std::string> around);

  ListStream list_;
  std::string closing_;
};

// A file that is a GeoJSON FeatureCollection, one feature on each line; whole, or not there. It has a "crs" where the
// inputs declare one system, and it has a code; else a note tells that it has none. Where nothing is declared, or CRS84
// is GeoJSON's own, it needs none.
class GeojsonFile {
 public:
  GeojsonFile(Talk& talk, const std::string& name, const io::CoordinateSystems& systems);
  void add(std::string_view feature) { list_.add(feature); }
  std::uint64_t count() const { return list_.count(); }
  void close();

 private:
  io::OutputFile file_;
  ListStream list_;
};

// As in JSON: in quotes; bytes that are no UTF-8 become U+FFFD.
std::string quoted_json(std::string_view text);
void add_quoted_json(std::string& to, std::string_view text);

}  // namespace sunder::ask
