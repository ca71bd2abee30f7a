#pragma once
// Aligned columns and wrapped lines for the terminal.

#include <string>
#include <vector>

#include "core/units.hpp"

namespace ashlar::output {

/// Rows of cells as lines, indented by two; the first `left` columns are set left, the others right.
std::string aligned(const std::vector<std::vector<std::string>>& rows, std::size_t left = 1);

/// `text` in lines of at most `width` columns; every line but the first starts with `indent` spaces.
std::string wrapped(const std::string& text, std::size_t width, std::size_t indent);

/// Columns that a UTF-8 text takes.
std::size_t columns(const std::string& text);

/// A value rounded to four digits, with unit: "1.234 MPa". `unit` as in results: "Pa", "m", "".
std::string short_quantity(double value, const std::string& unit);

/// "(12.3, 4.5)": metres.
std::string place_text(double x, double y);

}  // namespace ashlar::output
