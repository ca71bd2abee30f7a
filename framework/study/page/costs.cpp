// Where the time goes, and the table of all cases.

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "output/text_table.hpp"
#include "study/cases.hpp"
#include "study/page/parts.hpp"
#include "study/page/plot.hpp"

namespace ashlar::study {

namespace {

constexpr std::array<const char*, part_count> part_colours = {"#3b6ea5", "#86b6d9", "#d55e00",
                                                              "#f2b56b", "#009e73", "#c9ccd1"};
constexpr std::size_t most_bars = 40;

std::string part_legend() {
  std::string html = "<p class=\"legend\">";
  for (std::size_t p = 0; p < part_count; ++p)
    html +=
        std::string("<span><i style=\"background:") + part_colours[p] + "\"></i>" + part_names[p] + "</span>";
  return html + "</p>\n";
}

/// One bar over its full width: shares of a run's wall time.
std::string bar(const Run& run) {
  std::string svg = "<svg class=\"bar\" viewBox=\"0 0 400 14\" preserveAspectRatio=\"none\">";
  double at = 0;
  for (std::size_t p = 0; p < part_count; ++p) {
    const double share = 400 * run.wall[p] / run.record.wall;
    svg += "<rect x=\"" + printed("%.2f", at) + "\" y=\"0\" width=\"" + printed("%.2f", share) +
           "\" height=\"14\" fill=\"" + part_colours[p] + "\"><title>" + part_names[p] + ": " +
           time_text(run.wall[p]) + "</title></rect>";
    at += share;
  }
  return svg + "</svg>";
}

/// The finest run of every series.
std::vector<std::size_t> finest(const PageData& data) {
  std::vector<std::size_t> cases;
  for (const Series& series : data.analysis.series)
    if (!series.cases.empty()) cases.push_back(series.cases.back());
  if (cases.size() > 6) cases.resize(6);
  return cases;
}

std::string effect_bar(double share) {
  return "<svg class=\"bar short\" viewBox=\"0 0 100 10\" preserveAspectRatio=\"none\"><rect width=\"" +
         printed("%.2f", 100 * share) + "\" height=\"10\" fill=\"#3b6ea5\"/></svg>";
}

std::string effect_tables(const PageData& data) {
  std::string html;
  for (const std::size_t c : finest(data)) {
    const Run& run = data.outcomes[c].best();
    if (run.effects.empty()) continue;
    std::vector<std::pair<double, std::string>> effects;
    double own = 0;
    for (const auto& [effect, wall] : run.effects) effects.emplace_back(wall, effect), own += wall;
    std::ranges::sort(effects, std::greater());
    std::vector<std::vector<std::string>> rows = {{"effect", "own time", "share", ""}};
    const double all = run.record.wall;
    for (const auto& [wall, effect] : effects)
      rows.push_back({escaped(effect), wall < 1e-3 ? printed("%.2f ms", 1e3 * wall) : time_text(wall),
                      printed("%.1f %%", 100 * wall / all), effect_bar(wall / all)});
    rows.push_back({"shared by all", time_text(std::max(0.0, all - own)),
                    printed("%.1f %%", 100 * std::max(0.0, 1 - own / all)), effect_bar(1 - own / all)});
    html += "<div><h3>" + escaped(label(data.study.cases[c])) + "</h3>" + html_table(rows, 1) + "</div>";
  }
  if (html.empty()) return {};
  return "<p>What each effect of the scene adds for itself, in the finest run of a series. Meshing, "
         "factorisation and "
         "solving serve all of them.</p>\n<div class=\"tables\">" +
         html + "</div>\n";
}

std::string spread(const Outcome& outcome) {
  const double best = outcome.best().record.wall, worst = outcome.worst_wall();
  return time_text(best) + (outcome.runs.size() > 1
                                ? " <small>+" + printed("%.0f", 100 * (worst / best - 1)) + " %</small>"
                                : "");
}

std::vector<std::string> keys_of(const Study& study) {
  std::vector<std::string> keys;
  for (const Case& one : study.cases)
    for (const Setting& setting : one.settings)
      if (std::ranges::find(keys, setting.key) == keys.end()) keys.push_back(setting.key);
  return keys;
}

/// The last case against the same without one effect at a time.
std::string left_out(const PageData& data) {
  const auto first =
      std::ranges::find_if(data.study.cases, [](const Case& one) { return !one.without.empty(); });
  if (first == data.study.cases.begin() || first == data.study.cases.end()) return {};
  const auto whole = static_cast<std::size_t>(first - data.study.cases.begin()) - 1;
  if (!data.outcomes[whole].ok) return {};
  // CPU time: runs side by side disturb each other's wall time more.
  const double all = data.outcomes[whole].best_cpu();
  std::vector<std::vector<std::string>> rows = {
      {"left out", "wall time", "CPU time", "less CPU time by", "share", ""},
      {"nothing", spread(data.outcomes[whole]), time_text(all), "", "", ""}};
  for (std::size_t c = whole + 1; c < data.outcomes.size(); ++c) {
    const Outcome& outcome = data.outcomes[c];
    const std::string name = escaped(data.study.cases[c].without);
    if (!outcome.ok) {
      rows.push_back({name, "failed: " + escaped(outcome.reason), "", "", "", ""});
      continue;
    }
    const double cpu = outcome.best_cpu(), less = std::max(0.0, all - cpu);
    rows.push_back({name, spread(outcome), time_text(cpu), less > 0 ? time_text(less) : "nothing that shows",
                    printed("%.1f %%", 100 * less / all), effect_bar(less / all)});
  }
  return "<h3>What effects cost: " + escaped(label(data.study.cases[whole])) +
         ", and once more without each</h3>" + html_table(rows, 1);
}

std::vector<std::string> case_row(const PageData& data, std::size_t c, const std::vector<std::string>& keys) {
  const Outcome& outcome = data.outcomes[c];
  std::vector<std::string> row;
  for (const std::string& key : keys) {
    const core::Value* value = find(data.study.cases[c], key);
    row.push_back(value ? escaped(shown(*value)) : "");
  }
  for (const double x : {outcome.cells, outcome.unknowns}) row.push_back(printed("%.0f", x));
  row.insert(row.end(), {output::short_quantity(outcome.h, "m"), spread(outcome),
                         time_text(outcome.best_cpu()), memory_text(outcome.memory())});
  for (std::size_t m = 0; m < data.study.measures.size(); ++m) {
    const std::string unit = unit_of(data.study.measures[m]);
    row.push_back(outcome.values[m] ? value_text(*outcome.values[m], unit) : "missing");
    std::string error = "–";
    for (const Finding& finding : data.analysis.findings)
      for (const Reading& reading : finding.readings)
        if (finding.measure == m && reading.one == c && !std::isnan(reading.relative))
          error = accuracy_text(reading.relative, finding.absolute, unit) + (reading.on_front ? " ●" : "");
    row.push_back(error);
  }
  return row;
}

std::string failures(const PageData& data) {
  std::vector<std::vector<std::string>> rows = {{"case", "what happened"}};
  for (std::size_t c = 0; c < data.outcomes.size(); ++c) {
    const Outcome& outcome = data.outcomes[c];
    if (!outcome.ok) rows.push_back({escaped(label(data.study.cases[c])), escaped(outcome.reason)});
    for (const std::string& missing : outcome.missing)
      rows.push_back({escaped(label(data.study.cases[c])), escaped(missing)});
  }
  return rows.size() < 2 ? "" : "<h3 class=\"failed\">Runs that failed</h3>" + html_table(rows, 2);
}

}  // namespace

std::string cost_section(const PageData& data) {
  std::vector<std::vector<std::string>> rows = {{"case", "wall time", "shares"}};
  for (std::size_t c = 0; c < data.outcomes.size() && rows.size() <= most_bars; ++c)
    if (data.outcomes[c].ok)
      rows.push_back({escaped(label(data.study.cases[c])), time_text(data.outcomes[c].best().record.wall),
                      bar(data.outcomes[c].best())});
  if (rows.size() < 2) return {};
  return "<section>\n<h2>Where the time goes</h2>\n" + part_legend() + "<div class=\"bars\">" +
         html_table(rows, 1) +
         "</div>\n<p class=\"note\">Other: starting the program, opening its modules, reading and checking "
         "the scene, "
         "and its end.</p>\n" +
         effect_tables(data) + left_out(data) + "</section>\n";
}

std::string case_section(const PageData& data) {
  const std::vector<std::string> keys = keys_of(data.study);
  std::vector<std::string> head;
  for (const std::string& key : keys) head.push_back(escaped(key));
  head.insert(head.end(), {"mesh cells", "unknowns", "h", "wall", "CPU", "memory"});
  for (const Measure& measure : data.study.measures) {
    head.push_back(escaped(measure.name));
    head.emplace_back("error");
  }
  std::vector<std::vector<std::string>> rows = {head};
  for (std::size_t c = 0; c < data.outcomes.size(); ++c)
    if (data.outcomes[c].ok) rows.push_back(case_row(data, c, keys));
  return "<section>\n<h2>All runs</h2>\n<div class=\"wide\">" + html_table(rows, keys.size()) + "</div>\n" +
         "<p class=\"note\">Times are the best of " + std::to_string(data.study.repeats) + " " +
         (data.study.repeats == 1 ? "run" : "runs, and how much longer the slowest took") +
         ". ● is on the front of best bargains.</p>\n" + failures(data) + "</section>\n";
}

}  // namespace ashlar::study
