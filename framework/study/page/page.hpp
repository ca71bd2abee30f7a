#pragma once
// The study as one page that needs nothing else: HTML with its style and plots inside.

#include <string>

#include "study/analysis.hpp"

namespace ashlar::study {

/// `command` regenerates it; machine and date are told as found.
std::string study_page(const Study& study, const std::vector<Outcome>& outcomes, const Analysis& analysis,
                       const std::string& command);

}  // namespace ashlar::study
