#include "stability/table.hpp"

#include <algorithm>
#include <cstdio>
#include <exception>

namespace ashlar::stability {

bool Outcome::green() const {
  return missing.empty() && (!figures.empty() || !said.empty()) &&
         std::ranges::all_of(figures, [](const Figure& each) { return each.holds(); });
}

void Outcome::add(std::string label, double value, double bound) {
  figures.push_back({std::move(label), value, bound});
}

void Outcome::worst(const std::string& label, double value, double bound) {
  for (Figure& each : figures) {
    if (each.label != label) continue;
    // Nearest to its bound, or beyond it; what is not a number is worst.
    if (!(value / bound <= each.value / each.bound)) each = {label, value, bound};
    return;
  }
  add(label, value, bound);
}

void Outcome::must_say(const std::string& message, const std::vector<std::string>& words) {
  said = message;
  for (const std::string& each : words)
    if (message.find(each) == std::string::npos) missing.push_back("does not say '" + each + "'");
}

Outcome run(const Case& row, Fault fault) {
  try {
    return row.run(fault);
  } catch (const std::exception& error) {
    Outcome outcome;
    outcome.missing.push_back(std::string("stopped: ") + error.what());
    return outcome;
  }
}

std::string measured_text(const Outcome& outcome) {
  std::string text;
  const auto join = [&](const std::string& part) { text += (text.empty() ? "" : "; ") + part; };
  for (const Figure& each : outcome.figures) {
    char number[80];
    std::snprintf(number, sizeof number, "%s %.1e ≤ %.1e", each.holds() ? "" : " NOT", each.value,
                  each.bound);
    join(each.label + number);
  }
  if (!outcome.said.empty()) join("“" + outcome.said + "”");
  for (const std::string& each : outcome.missing) join(each);
  return text;
}

std::string verdict(const Result& result) {
  if (result.outcome.green()) return result.row->known.empty() ? "holds" : "holds, though known as red";
  return result.row->known.empty() ? "RED" : "known";
}

}  // namespace ashlar::stability
