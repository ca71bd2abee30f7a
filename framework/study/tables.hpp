#pragma once
// The study as tables, for machines and for a page of text.

#include <string>

#include "study/analysis.hpp"

namespace ashlar::study {

/// One row a case, SI units; failed cases too, with their reason.
std::string study_csv(const Study& study, const std::vector<Outcome>& outcomes, const Analysis& analysis);

/// One row a case in Markdown: the parameters that differ, the measures rounded to four digits, wall time.
std::string study_markdown(const Study& study, const std::vector<Outcome>& outcomes);

/// Everything: cases with all their runs, findings with references, orders, fronts and ladders.
std::string study_json(const Study& study, const std::vector<Outcome>& outcomes, const Analysis& analysis);

}  // namespace ashlar::study
