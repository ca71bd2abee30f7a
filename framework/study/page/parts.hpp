#pragma once
// The sections of a study's page. Internal to study/page.

#include <string>

#include "study/analysis.hpp"

namespace ashlar::study {

struct PageData {
  const Study& study;
  const std::vector<Outcome>& outcomes;
  const Analysis& analysis;
};

/// A measure in one problem: reference, plots, what accuracy costs, orders.
std::string finding_section(const PageData& data, const Finding& finding);

/// Where the time goes: parts, and effects.
std::string cost_section(const PageData& data);

/// All cases, then those that failed.
std::string case_section(const PageData& data);

/// A table of HTML cells; the first row is the head. Cells of the first `left` columns are set left.
std::string html_table(const std::vector<std::vector<std::string>>& rows, std::size_t left);

/// A number in a readable unit, signs as typographers set them.
std::string value_text(double value, const std::string& unit);

/// "12 MB".
std::string memory_text(double bytes);

}  // namespace ashlar::study
