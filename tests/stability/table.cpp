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

Case make_case(std::string group, std::string name, std::string risk, std::string bound,
               std::vector<Fault> plants) {
  Case row;
  row.group = std::move(group);
  row.name = std::move(name);
  row.risk = std::move(risk);
  row.bound = std::move(bound);
  row.plants = std::move(plants);
  return row;
}

Case must_stop(Case row, std::function<std::string(Fault)> said, std::vector<std::string> words) {
  row.run = [said = std::move(said), words = std::move(words)](Fault fault) {
    Outcome outcome;
    outcome.must_say(said(fault), words);
    return outcome;
  };
  return row;
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

namespace {

/// "u" of "order 2 u"; all of any other label.
std::string quantity(const std::string& label) {
  if (!label.starts_with("order ")) return label;
  return label.size() > 8 ? label.substr(8) : "difference";
}

std::string short_number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.2g", value);
  return text;
}

}  // namespace

std::vector<Line> lines(const Outcome& outcome) {
  std::vector<Line> all;
  std::vector<std::string> done;
  for (const Figure& first : outcome.figures) {
    const std::string name = quantity(first.label);
    if (std::ranges::count(done, name) > 0) continue;
    done.push_back(name);
    std::string found, bounds;
    bool holds = true, same = true;
    for (const Figure& each : outcome.figures) {
      if (quantity(each.label) != name) continue;
      const std::string comma = found.empty() ? "" : ", ";
      found += comma + short_number(each.value) + (each.holds() ? "" : "!");
      bounds += comma + short_number(each.bound);
      holds = holds && each.holds();
      same = same && each.bound == first.bound;
    }
    all.push_back(
        {name + " " + found + (holds ? " ≤ " : " NOT ≤ ") + (same ? short_number(first.bound) : bounds),
         holds});
  }
  return all;
}

std::string measured_text(const Outcome& outcome) {
  std::string text;
  const auto join = [&](const std::string& part) { text += (text.empty() ? "" : "; ") + part; };
  for (const Line& each : lines(outcome)) join(each.text);
  if (!outcome.said.empty()) join("“" + outcome.said + "”");
  for (const std::string& each : outcome.missing) join(each);
  return text;
}

std::string verdict(const Result& result) {
  if (result.outcome.green()) return result.row->known.empty() ? "holds" : "holds, though known as red";
  return result.row->known.empty() ? "RED" : "known";
}

}  // namespace ashlar::stability
