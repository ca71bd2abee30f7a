#include "output/pictures/legend.hpp"

namespace ashlar::output {

std::vector<geometry::Point> legend_places(const std::vector<std::string>& names, geometry::Point first,
                                           double right) {
  std::vector<geometry::Point> places;
  geometry::Point at = first;
  for (const std::string& name : names) {
    const double width = legend_text + measured(name, legend_style);
    if (at.x > first.x && at.x + width > right) at = {first.x, at.y + legend_row};
    places.push_back(at);
    at.x += width + 14;
  }
  return places;
}

}  // namespace ashlar::output
