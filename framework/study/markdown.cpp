// The study as a table to be read, as READMEs have it.

#include <algorithm>
#include <cstdio>

#include "output/text_table.hpp"
#include "study/cases.hpp"
#include "study/tables.hpp"

namespace ashlar::study {

namespace {

std::string line(const std::vector<std::string>& cells) {
  std::string text = "|";
  for (const std::string& cell : cells) text += " " + cell + " |";
  return text + "\n";
}

std::vector<std::string> differing_keys(const Study& study) {
  std::vector<std::string> keys;
  for (const Case& one : study.cases)
    for (const Setting& setting : one.settings)
      if (setting.differs && std::ranges::find(keys, setting.key) == keys.end()) keys.push_back(setting.key);
  return keys;
}

std::string value_text(double value, const std::string& unit) {
  if (unit != "s" || value >= 0.0995) return output::short_quantity(value, unit);
  char text[32];
  std::snprintf(text, sizeof text, "%.2g ms", 1e3 * value);
  return text;
}

}  // namespace

std::string study_markdown(const Study& study, const std::vector<Outcome>& outcomes) {
  const std::vector<std::string> keys = differing_keys(study);
  std::vector<std::string> heading = keys;
  for (const Measure& measure : study.measures) heading.push_back(measure.title);
  heading.emplace_back("wall time");
  std::string text = line(heading) + line(std::vector<std::string>(heading.size(), "---"));
  for (std::size_t c = 0; c < outcomes.size(); ++c) {
    const Case& one = study.cases[c];
    std::vector<std::string> row;
    for (const std::string& key : keys) {
      const core::Value* value = find(one, key);
      row.push_back(value ? shown(*value) : "");
    }
    if (!one.without.empty()) row.front() += " without " + one.without;
    for (std::size_t m = 0; m < study.measures.size(); ++m) {
      const bool known = outcomes[c].ok && outcomes[c].values[m];
      row.push_back(known ? value_text(*outcomes[c].values[m], unit_of(study.measures[m])) : "");
    }
    row.push_back(outcomes[c].ok ? time_text(outcomes[c].best().record.wall) : "failed");
    text += line(row);
  }
  return text;
}

}  // namespace ashlar::study
