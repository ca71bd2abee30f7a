#include "study/analysis.hpp"

#include <algorithm>
#include <cmath>

#include "study/cases.hpp"

namespace ashlar::study {

namespace {

std::string problem_of(const Study& study, const Case& one) {
  Case only;
  for (const Setting& setting : one.settings)
    if (std::ranges::find(study.problem, setting.key) != study.problem.end())
      only.settings.push_back(setting);
  return only.settings.empty() ? "" : label(only);
}

std::vector<Series> make_series(const Study& study, const std::vector<Outcome>& outcomes) {
  std::vector<std::string> apart = study.problem;
  apart.push_back(study.refine);
  std::vector<Series> all;
  for (std::size_t c = 0; c < outcomes.size(); ++c) {
    if (!outcomes[c].ok || !study.cases[c].without.empty()) continue;
    const std::string name = series_label(study.cases[c], apart), problem = problem_of(study, study.cases[c]);
    auto found = std::ranges::find_if(
        all, [&](const Series& series) { return series.label == name && series.problem == problem; });
    if (found == all.end()) found = all.insert(all.end(), {name, problem, {}});
    found->cases.push_back(c);
  }
  for (Series& series : all)
    std::ranges::stable_sort(series.cases, std::greater(), [&](std::size_t c) { return outcomes[c].h; });
  return all;
}

class Examiner {
 public:
  Examiner(const Study& study, const std::vector<Outcome>& outcomes, const std::vector<Series>& series,
           const Exact& exact, bool sizes_differ)
      : study_(study), outcomes_(outcomes), series_(series), exact_(exact), sizes_differ_(sizes_differ) {}

  Finding examine(std::size_t measure, const std::string& problem) {
    Finding finding;
    finding.measure = measure;
    finding.problem = problem;
    for (const Series& series : series_)
      if (series.problem == problem)
        for (const std::size_t c : series.cases)
          if (value(measure, c)) finding.readings.push_back({c, *value(measure, c)});
    find_limits(finding);
    find_reference(finding);
    find_errors(finding);
    find_front(finding);
    for (Limit& limit : finding.limits) limit.observed = observed_slope(finding, limit.series);
    return finding;
  }

 private:
  std::optional<double> value(std::size_t measure, std::size_t c) const {
    return outcomes_[c].values[measure];
  }

  void find_limits(Finding& finding) const {
    if (study_.refine.empty() || study_.measures[finding.measure].compared_with("none")) return;
    for (const Series& series : series_) {
      if (series.problem != finding.problem) continue;
      std::vector<Refined> runs;
      for (const std::size_t c : series.cases)
        if (const auto v = value(finding.measure, c)) runs.push_back({outcomes_[c].h, *v});
      if (!runs.empty()) finding.limits.push_back({series.label, extrapolate(runs)});
    }
  }

  void find_reference(Finding& finding) const {
    const Measure& measure = study_.measures[finding.measure];
    Reference& reference = finding.reference;
    if (finding.readings.empty() || measure.compared_with("none")) return;
    if (measure.compared_with("finest")) return take_finest(finding);
    if (measure.compared_with("richardson")) return take_limit(finding);
    reference.value = exact_(measure, study_.cases[finding.readings.front().one]);
    reference.how = measure.reference.function() ? "the study's function" : "the study's number";
  }

  void take_finest(Finding& finding) const {
    const auto finest = std::ranges::max_element(
        finding.readings, {}, [&](const Reading& reading) { return outcomes_[reading.one].unknowns; });
    finding.reference = {finest->value, unknown, "the finest run, " + label(study_.cases[finest->one]),
                         finest->one};
    for (const Limit& limit : finding.limits)
      if (in_series(finest->one, limit.series, finding.problem) && limit.found.uncertainty > 0)
        finding.reference.uncertainty = limit.found.uncertainty + std::abs(limit.found.limit - finest->value);
  }

  bool in_series(std::size_t c, const std::string& name, const std::string& problem) const {
    for (const Series& series : series_)
      if (series.label == name && series.problem == problem)
        return std::ranges::find(series.cases, c) != series.cases.end();
    return false;
  }

  void take_limit(Finding& finding) const {
    const Limit* best = nullptr;
    for (const Limit& limit : finding.limits) {
      const auto rank = [](const Limit& l) { return std::pair(!l.found.sound, l.found.uncertainty); };
      if (enough(limit, finding.problem) && (!best || rank(limit) < rank(*best))) best = &limit;
    }
    if (!best) {
      finding.reference.how = "no series has three runs of different size";
      return;
    }
    char order[32] = "";
    if (!std::isnan(best->found.order)) std::snprintf(order, sizeof order, ", order %.2f", best->found.order);
    finding.reference = {
        best->found.limit,
        best->found.uncertainty,
        "the limit of the runs" + (best->series.empty() ? "" : " with " + best->series) + order,
        {}};
    if (!best->found.sound) finding.reference.how += "; a wide bracket, because " + best->found.why;
    if (!best->found.sound && std::isnan(best->found.order)) take_finest_of(finding, best->series);
    widen_by_others(finding, *best);
  }

  // Without an order the finest value stands for the limit: that run cannot be judged by itself.
  void take_finest_of(Finding& finding, const std::string& name) const {
    for (const Reading& reading : finding.readings)
      if (in_series(reading.one, name, finding.problem)) finding.reference.itself = reading.one;
  }

  // Series that tend to different limits tell that one of them is wrong.
  void widen_by_others(Finding& finding, const Limit& best) const {
    for (const Limit& other : finding.limits) {
      if (&other == &best || !other.found.sound) continue;
      const double apart = std::abs(other.found.limit - best.found.limit);
      if (apart <= other.found.uncertainty + best.found.uncertainty) continue;
      finding.reference.uncertainty = std::max(finding.reference.uncertainty, apart);
      finding.reference.how +=
          "; the limit with " + other.series + " lies outside both brackets, so they are widened";
    }
  }

  bool enough(const Limit& limit, const std::string& problem) const {
    for (const Series& series : series_)
      if (series.label == limit.series && series.problem == problem) {
        std::vector<double> sizes;
        for (const std::size_t c : series.cases) sizes.push_back(outcomes_[c].h);
        const auto twins = [](double a, double b) { return a < 1.02 * b; };
        return std::distance(sizes.begin(), std::unique(sizes.begin(), sizes.end(), twins)) >= 3;
      }
    return false;
  }

  void find_errors(Finding& finding) const {
    const Measure& measure = study_.measures[finding.measure];
    finding.absolute = finding.reference.value == 0;
    for (Reading& reading : finding.readings) {
      double right = finding.reference.value;
      if (measure.reference.function()) right = exact_(measure, study_.cases[reading.one]);
      if (finding.reference.itself == reading.one || std::isnan(right)) continue;
      reading.error = std::abs(reading.value - right);
      reading.relative = reading.error / (finding.absolute || right == 0 ? 1 : std::abs(right));
      reading.sure = reading.relative;
    }
    if (study_.refine.empty()) return;
    for (const Series& series : series_) {
      double worst = 0;
      for (auto c = series.cases.rbegin(); c != series.cases.rend(); ++c)
        for (Reading& reading : finding.readings)
          if (reading.one == *c && !std::isnan(reading.relative))
            reading.sure = worst = std::max(worst, reading.relative);
    }
  }

  void find_front(Finding& finding) const {
    if (!sizes_differ_) return;
    std::vector<Bargain> bargains;
    std::vector<std::size_t> of;
    for (std::size_t r = 0; r < finding.readings.size(); ++r) {
      if (std::isnan(finding.readings[r].sure)) continue;
      const double error = finding.readings[r].sure < floor_of_errors ? 0 : finding.readings[r].sure;
      bargains.push_back({outcomes_[finding.readings[r].one].best().record.wall, error});
      of.push_back(r);
    }
    for (const std::size_t i : pareto_front(bargains)) {
      finding.front.push_back(of[i]);
      finding.readings[of[i]].on_front = true;
    }
  }

  double observed_slope(const Finding& finding, const std::string& name) const {
    std::vector<std::pair<double, double>> points;
    for (const Reading& reading : finding.readings)
      if (reading.relative > floor_of_errors && in_series(reading.one, name, finding.problem))
        points.emplace_back(outcomes_[reading.one].h, reading.relative);
    return points.size() < 2 ? unknown : slope(points);
  }

  const Study& study_;
  const std::vector<Outcome>& outcomes_;
  const std::vector<Series>& series_;
  const Exact& exact_;
  bool sizes_differ_;
};

// Where every problem has but one run, the study is one of problems, and all are one finding.
bool join_problems(std::vector<Series>& series) {
  const bool single = std::ranges::all_of(series, [](const Series& s) { return s.cases.size() == 1; });
  const bool several = std::ranges::any_of(series, [](const Series& s) { return !s.problem.empty(); });
  if (!single || !several) return false;
  std::vector<Series> joined;
  for (Series& one : series) {
    const auto same = std::ranges::find(joined, one.label, &Series::label);
    if (same == joined.end())
      joined.push_back({one.label, "", one.cases});
    else
      same->cases.insert(same->cases.end(), one.cases.begin(), one.cases.end());
  }
  series = std::move(joined);
  return true;
}

}  // namespace

Analysis analyse(const Study& study, const std::vector<Outcome>& outcomes, const Exact& exact) {
  Analysis analysis;
  analysis.series = make_series(study, outcomes);
  const bool exact_only = std::ranges::none_of(
      study.measures, [](const Measure& m) { return m.reference.text() && !m.compared_with("none"); });
  const bool joined = study.refine.empty() && exact_only && join_problems(analysis.series);
  double least = 1e300, most = 0;
  for (const Outcome& outcome : outcomes) {
    if (!outcome.ok) continue;
    least = std::min(least, outcome.unknowns);
    most = std::max(most, outcome.unknowns);
  }
  analysis.sizes_differ = !joined && most > 1.05 * least;
  std::vector<std::string> problems;
  for (const Series& series : analysis.series)
    if (std::ranges::find(problems, series.problem) == problems.end()) problems.push_back(series.problem);
  Examiner examiner(study, outcomes, analysis.series, exact, analysis.sizes_differ);
  for (std::size_t m = 0; m < study.measures.size(); ++m)
    for (const std::string& problem : problems) {
      Finding finding = examiner.examine(m, problem);
      finding.sentences = sentences_of(study, finding, outcomes, analysis.sizes_differ);
      analysis.findings.push_back(std::move(finding));
    }
  return analysis;
}

}  // namespace ashlar::study
