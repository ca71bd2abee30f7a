#pragma once
// Cases as text: for people, for --set, and as names of folders.

#include <string>
#include <vector>

#include "study/study.hpp"

namespace ashlar::study {

/// "500", "12 m", "voronoi", "true".
std::string shown(const core::Value& value);

/// What `--set key=` must be given for this value.
std::string set_text(const core::Value& value);

/// "mesh = voronoi, cells = 500"; without the parameters in `but`. "as it stands" for no parameters.
std::string label(const Case& one, const std::vector<std::string>& but = {});

/// The same, but "" for no parameters: a study of one series needs no name for it.
std::string series_label(const Case& one, const std::vector<std::string>& but);

/// Null if the case does not say the parameter.
const core::Value* find(const Case& one, const std::string& key);

/// One folder name for each case, none twice, the same for the same cases in any order.
std::vector<std::string> folder_names(const std::vector<Case>& cases);

/// All combinations; the last key changes fastest.
std::vector<Case> combinations(const std::vector<std::pair<std::string, std::vector<core::Value>>>& lists);

/// 16 digits that change when the text does.
std::string hash_text(const std::string& text);

}  // namespace ashlar::study
