#pragma once
// Where the entries of a legend stand: a stroke, then its name. Included by pictures/*.cpp only.

#include <string>
#include <vector>

#include "output/pictures/canvas.hpp"

namespace ashlar::output {

const TextStyle legend_style{7.5};
constexpr double legend_row = 11;     ///< from one row to the next, in units
constexpr double legend_stroke = 13;  ///< length of a stroke
constexpr double legend_text = 17;    ///< where the name begins

/// The left ends of the strokes, from `first` on in rows that do not reach beyond `right`; one a name.
std::vector<geometry::Point> legend_places(const std::vector<std::string>& names, geometry::Point first,
                                           double right);

}  // namespace ashlar::output
