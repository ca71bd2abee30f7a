#pragma once
// The table of hard cases: what each is, what it found, and the page that says so.

#include <functional>
#include <string>
#include <vector>

#include "stability/fault.hpp"

namespace ashlar::stability {

/// A number that must not exceed its bound.
struct Figure {
  std::string label;
  double value = 0, bound = 0;
  bool holds() const { return value <= bound; }  // not a number: does not hold
};

/// What one run of a case found.
struct Outcome {
  std::vector<Figure> figures;
  std::string said;                  ///< by a case that must stop: its message
  std::vector<std::string> missing;  ///< what it should have said, or another breach in words
  bool green() const;

  void add(std::string label, double value, double bound);
  /// The worst of the figures of one label counts.
  void worst(const std::string& label, double value, double bound);
  /// The message must hold these words: place and cure among them.
  void must_say(const std::string& message, const std::vector<std::string>& words);
};

struct Case {
  std::string group, name;
  std::string risk;   ///< what could go wrong
  std::string bound;  ///< and why it is what it is
  std::function<Outcome(Fault)> run;
  std::vector<Fault> plants;  ///< faults that must turn it red
  std::string known;          ///< why a red row is known; empty: it must be green
};

/// A row without what it runs.
Case make_case(std::string group, std::string name, std::string risk, std::string bound,
               std::vector<Fault> plants);
/// The row of a case that must stop: what it said must hold these words.
Case must_stop(Case row, std::function<std::string(Fault)> said, std::vector<std::string> words);

struct Result {
  const Case* row = nullptr;
  Outcome outcome;
  double seconds = 0;
};

/// A fault planted in a row.
struct Planted {
  const Case* row = nullptr;
  Fault fault = Fault::none;
  bool red = false;
  std::string measured;
};

/// Runs a case; an exception is a red outcome with its words.
Outcome run(const Case& row, Fault fault);
/// Figures in words: those of orders 1, 2, 3 together, "u 1.8e-16, 2.7e-15, 4.5e-15 ≤ 1e-12, 1e-11, 1e-10".
struct Line {
  std::string text;
  bool holds = true;
};
std::vector<Line> lines(const Outcome& outcome);
/// The lines, and what was said or is missing.
std::string measured_text(const Outcome& outcome);
std::string verdict(const Result& result);

std::string text_page(const std::vector<Result>& results, const std::vector<Planted>& planted);
/// Self-contained: opens in a browser without a network.
std::string html_page(const std::vector<Result>& results, const std::vector<Planted>& planted);

// The rows, by subject.
std::vector<Case> mesh_rows();
std::vector<Case> law_rows();
std::vector<Case> copy_rows();
std::vector<Case> solve_rows();
std::vector<Case> load_rows();
std::vector<Case> support_rows();
std::vector<Case> contact_rows();
std::vector<Case> crossing_rows();
std::vector<Case> friction_rows();
std::vector<Case> cycle_rows();
std::vector<Case> sliding_rows();

}  // namespace ashlar::stability
