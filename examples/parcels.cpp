// Parcels of land: neighbours may share a border, but no two may overlap. And is each of them valid?
#include <sunder/planar/polygons/polygon_valid.h>
#include <sunder/planar/polygons/polygons_all.h>

#include <iostream>
#include <vector>

using sunder::planar::Polygon;
using Ring = std::vector<sunder::Point2>;

int main() {
  const std::vector<Ring> west{{{0, 0}, {5, 0}, {5, 4}, {0, 4}}};
  const std::vector<Ring> east{{{5, 0}, {9, 0}, {9, 4}, {5, 4}}, {{6, 1}, {7, 1}, {7, 2}, {6, 2}}};  // around a pond
  const std::vector<Ring> north{{{2, 3}, {6, 5}, {2, 6}}};
  const std::vector<Ring> hourglass{{{20, 0}, {24, 4}, {24, 0}, {20, 4}}};

  const std::vector<Polygon> parcels{Polygon(west), Polygon(east), Polygon(north)};
  for (const auto& c : sunder::planar::polygons_all(parcels).found) {
    std::cout << "parcels " << c.i << " and " << c.j << ": " << name_of(c.contact) << '\n';
  }
  sunder::SetOptions options;
  options.allowed = sunder::Allowed::touch;
  const auto overlaps = sunder::planar::polygons_count(parcels, options);
  std::cout << "pairs that overlap: " << overlaps.count.overlapping << '\n';

  const auto defects = sunder::planar::polygon_defects(Polygon(hourglass)).found;
  for (const auto& defect : defects) std::cout << "the hourglass is not valid: " << name_of(defect.kind) << '\n';
  return overlaps.count.overlapping == 1 && !defects.empty() ? 0 : 1;
}
