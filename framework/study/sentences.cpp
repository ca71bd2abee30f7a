// What an engineer wants to read: what an accuracy costs, and what the next digit would.

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "output/text_table.hpp"
#include "study/analysis.hpp"
#include "study/cases.hpp"

namespace ashlar::study {

namespace {

constexpr int most_rungs = 5;

std::string format(const char* pattern, double value) {
  char text[64];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}

class Teller {
 public:
  Teller(const Study& study, const Finding& finding, const std::vector<Outcome>& outcomes)
      : study_(study), finding_(finding), measure_(study.measures[finding.measure]) {
    for (const std::size_t r : finding.front) {
      const Reading& reading = finding.readings[r];
      front_.push_back(
          {outcomes[reading.one].best().record.wall, reading.sure < floor_of_errors ? 0 : reading.sure});
    }
  }

  std::vector<Rung> ladder() const {
    std::vector<Rung> rungs;
    std::vector<Bargain> positive;
    for (const Bargain& bargain : front_)
      if (bargain.error > 0) positive.push_back(bargain);
    if (positive.empty()) return rungs;
    const double best = ten_above(positive.back().error);
    for (double error = ten_above(positive.front().error); error > 0.05 * best; error /= 10)
      rungs.push_back(rung(error));
    if (rungs.size() > most_rungs) rungs.erase(rungs.begin(), rungs.end() - most_rungs);
    return rungs;
  }

  /// Where all runs are of one size, their costs do not differ but by chance: only errors are told.
  std::vector<std::string> tell_errors() const {
    std::vector<Reading> known;
    for (const Reading& reading : finding_.readings)
      if (!std::isnan(reading.relative)) known.push_back(reading);
    if (known.empty()) return {};
    const auto [best, worst] = std::ranges::minmax_element(known, {}, &Reading::relative);
    const auto off = [&](const Reading& r) {
      return (r.relative < floor_of_errors ? "exact to round-off ("
                                           : "off by " + accuracy(r.relative) + " (") +
             label(study_.cases[r.one]) + ")";
    };
    std::string text = opening(measure_.title) + " is " + (known.size() > 1 ? "at best " : "") + off(*best);
    if (known.size() > 1) text += ", at worst " + off(*worst);
    return {text + "."};
  }

  /// What is not compared with anything has a least and a greatest value.
  std::vector<std::string> tell_spread() const {
    if (finding_.readings.empty()) return {};
    const auto [least, most] = std::ranges::minmax_element(finding_.readings, {}, &Reading::value);
    const auto value = [&](const Reading& r) { return output::short_quantity(r.value, unit_of(measure_)); };
    std::string text = opening(measure_.title) + ": " + value(*least);
    if (value(*least) == value(*most))
      return {text + (finding_.readings.size() > 1 ? " in every case." : ".")};
    text += " (" + label(study_.cases[least->one]) + ") to " + value(*most);
    return {text + " (" + label(study_.cases[most->one]) + ")."};
  }

  std::vector<std::string> tell() const {
    if (front_.empty()) return {};
    if (front_.back().error == 0)
      return {opening(measure_.title) + " comes out exact to round-off for " + time_text(front_.back().cost) +
              with(name_of(front_.size() - 1)) + "."};
    // No accuracy is claimed that the reference itself does not have.
    const double doubt = known_to();
    const double reached = ten_above(std::max(front_.back().error, doubt));
    if (!finding_.absolute && doubt > front_.back().error && reached >= 1)
      return {opening("What an accuracy of ") + measure_.title +
              " costs cannot be told: its reference is only known to " + accuracy(two_digits(doubt)) + "."};
    const Rung now = rung(reached), next = rung(reached / 10);
    std::string text = opening(accuracy(reached)) + " of " + measure_.title + " costs " + cost(now) +
                       with(now.with) + " (" + now.from + ")";
    if (next.price.known != Price::Known::unknown)
      text += "; the next factor of ten costs " + cost(next) + " (" + next.from + ")";
    std::vector<std::string> all = {text + "."};
    if (next.price.known == Price::Known::unknown)
      all.push_back("What the next factor of ten costs cannot be told from these runs.");
    else if (doubt > reached / 10)
      all.push_back("Take the second figure with care: the reference itself is only known to " +
                    accuracy(two_digits(doubt)) + ".");
    return all;
  }

 private:
  std::string opening(const std::string& words) const {
    if (!finding_.problem.empty()) return "For " + finding_.problem + ": " + words;
    std::string text = words;
    text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
    return text;
  }

  std::string accuracy(double error) const {
    return accuracy_text(error, finding_.absolute, unit_of(measure_));
  }

  /// Relative uncertainty of the reference; 0 where it is not known.
  double known_to() const {
    const double scale = finding_.absolute ? 1 : std::abs(finding_.reference.value);
    const double doubt = finding_.reference.uncertainty / scale;
    return std::isfinite(doubt) ? doubt : 0;
  }

  static std::string with(const std::string& series) { return series.empty() ? "" : " with " + series; }

  static std::string cost(const Rung& rung) {
    return (rung.price.known == Price::Known::at_most ? "at most " : "") + time_text(rung.price.cost);
  }

  const Case& case_of(std::size_t place) const {
    return study_.cases[finding_.readings[finding_.front[place]].one];
  }

  std::string name_of(std::size_t place) const {
    std::vector<std::string> but = study_.problem;
    but.push_back(study_.refine);
    return series_label(case_of(place), but);
  }

  std::string refined(std::size_t place) const {
    const core::Value* value = find(case_of(place), study_.refine);
    return value ? study_.refine + " = " + shown(*value) : label(case_of(place), study_.problem);
  }

  Rung rung(double error) const {
    Rung made{error, price_of(front_, error), "", "not told by these runs"};
    const Price& price = made.price;
    if (price.known == Price::Known::unknown) return made;
    made.with = name_of(price.right);
    if (price.known == Price::Known::at_most) made.from = "the run with " + refined(price.right);
    if (price.known == Price::Known::between) {
      const std::string left =
          name_of(price.left) == made.with ? refined(price.left) : label(case_of(price.left), study_.problem);
      made.from = "interpolated between " + left + " and " + refined(price.right);
    }
    if (price.known == Price::Known::beyond) made.from = "extrapolated beyond " + refined(price.right);
    return made;
  }

  const Study& study_;
  const Finding& finding_;
  const Measure& measure_;
  std::vector<Bargain> front_;
};

}  // namespace

std::vector<std::string> sentences_of(const Study& study, Finding& finding,
                                      const std::vector<Outcome>& outcomes, bool sizes_differ) {
  const Teller teller(study, finding, outcomes);
  if (study.measures[finding.measure].compared_with("none")) return teller.tell_spread();
  if (!sizes_differ) return teller.tell_errors();
  finding.ladder = teller.ladder();
  return teller.tell();
}

std::string accuracy_text(double error, bool absolute, const std::string& unit) {
  if (absolute) return output::short_quantity(error, unit);
  const double percent = 100 * error;
  if (percent >= 0.999e-3 && percent < 1e4) return format("%.3g %%", percent);
  return format("%.1e %%", percent);
}

double two_digits(double value) {
  return std::strtod(format("%.1e", value).c_str(), nullptr);
}

std::string time_text(double seconds) {
  if (seconds < 0.0995) return format("%.0f ms", std::max(1.0, 1e3 * seconds));
  if (seconds < 0.995) return format("%.2f s", seconds);
  if (seconds < 9.95) return format("%.1f s", seconds);
  if (seconds < 120) return format("%.0f s", seconds);
  if (seconds < 7200) return format("%.0f min", seconds / 60);
  if (seconds < 200 * 3600.0) return format("%.0f h", seconds / 3600);
  return format("%.0f days", seconds / 86400);
}

}  // namespace ashlar::study
