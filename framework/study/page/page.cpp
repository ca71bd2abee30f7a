#include "study/page/page.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>
#include <thread>

#include "output/text_table.hpp"
#include "study/cases.hpp"
#include "study/page/parts.hpp"
#include "study/page/plot.hpp"

namespace ashlar::study {

namespace {

constexpr const char* style = R"css(
:root { --ink: #1d2733; --soft: #5b6672; --rule: #d9dee4; --paper: #ffffff; --tint: #f4f6f8; --accent: #0b4f86; }
* { box-sizing: border-box; }
body { margin: 0; background: var(--paper); color: var(--ink); font: 16px/1.55 "Source Serif 4", Charter, Georgia,
  "DejaVu Serif", serif; }
main { max-width: 68rem; margin: 0 auto; padding: 2.5rem 1.5rem 4rem; }
h1, h2, h3, table, .legend, svg, .facts { font-family: "Source Sans 3", "Helvetica Neue", Arial, "DejaVu Sans", sans-serif; }
h1 { font-size: 2rem; line-height: 1.2; margin: 0 0 .5rem; }
h2 { font-size: 1.35rem; margin: 2.6rem 0 .4rem; padding-top: 1.2rem; border-top: 1px solid var(--rule); }
h2 small { color: var(--soft); font-weight: 400; }
h3 { font-size: .95rem; margin: 1.2rem 0 .4rem; }
.facts { color: var(--soft); font-size: .92rem; margin: 0; }
.answer { background: var(--tint); border-left: 4px solid var(--accent); padding: .9rem 1.2rem; margin: 1.4rem 0; }
.answer p { margin: .35rem 0; font-size: 1.08rem; }
.plots { display: grid; grid-template-columns: repeat(auto-fill, minmax(20rem, 1fr)); gap: 1rem 1.4rem; }
.plots svg { width: 100%; height: auto; max-width: 34rem; }
.tables { display: flex; flex-wrap: wrap; gap: .4rem 3rem; }
.wide { overflow-x: auto; } .wide table { font-size: .8rem; } .wide th, .wide td { padding: .2rem .5rem; }
table { border-collapse: collapse; font-size: .86rem; font-variant-numeric: tabular-nums; }
th { text-align: right; font-weight: 600; border-bottom: 1.5px solid var(--ink); padding: .25rem .7rem; }
td { text-align: right; border-bottom: 1px solid var(--rule); padding: .22rem .7rem; white-space: nowrap; }
th.left, td.left { text-align: left; }
.bars table { width: 100%; } .bars td:last-child { width: 60%; } td small { color: var(--soft); }
.bar { display: block; width: 100%; height: 14px; } .bar.short { width: 7rem; height: 10px; background: var(--tint); }
.legend { font-size: .88rem; margin: .6rem 0; } .legend span { margin-right: 1.4rem; white-space: nowrap; }
.legend i { display: inline-block; width: .8rem; height: .8rem; margin-right: .4rem; vertical-align: -.08rem; }
.key { width: 26px; height: 12px; margin-right: .4rem; vertical-align: -1px; }
.note { color: var(--soft); font-size: .9rem; max-width: 48rem; }
.failed { color: #a02020; } code { font-size: .88em; background: var(--tint); padding: .05em .3em; }
.plot-title { font-size: 13px; font-weight: 600; fill: var(--ink); } .label { font-size: 11.5px; fill: var(--soft); }
.tick { font-size: 10.5px; fill: var(--soft); } .grid { stroke: #e8ecf0; } .axis { stroke: var(--soft); fill: none; }
.line { fill: none; stroke-width: 1.6; } .front { fill: none; stroke: #0b4f86; stroke-opacity: .16; stroke-width: 9;
  stroke-linecap: round; stroke-linejoin: round; }
.ring { fill: none; stroke: #1d2733; stroke-width: 1.3; } .doubt { fill: #eef0f2; }
.slope { fill: none; stroke: var(--soft); } .level { stroke: var(--ink); stroke-dasharray: 5 4; fill: none; }
@media print { body { font-size: 11pt; } main { padding: 0; max-width: none; } section { break-inside: auto; }
  .plots svg, table { break-inside: avoid; } }
)css";

std::string machine() {
  std::ifstream file("/proc/cpuinfo");
  std::string model = "an unknown processor";
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) {
      model = line.substr(line.find(':') + 2);
      break;
    }
  return std::to_string(std::max(1U, std::thread::hardware_concurrency())) + " cores, " + model;
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  char text[16];
  std::strftime(text, sizeof text, "%Y-%m-%d", &parts);
  return text;
}

std::string counted(std::size_t count, const std::string& word) {
  return std::to_string(count) + " " + word + (count == 1 ? "" : "s");
}

/// "mesh: voronoi, quads; cells: 500, 1000".
std::string varied(const Study& study) {
  std::vector<std::pair<std::string, std::vector<std::string>>> all;
  for (const Case& one : study.cases)
    for (const Setting& setting : one.settings) {
      auto found =
          std::ranges::find(all, setting.key, &std::pair<std::string, std::vector<std::string>>::first);
      if (found == all.end()) found = all.insert(all.end(), {setting.key, {}});
      if (const std::string text = shown(setting.value); std::ranges::count(found->second, text) == 0)
        found->second.push_back(text);
    }
  std::string text;
  for (const auto& [key, values] : all) {
    text += (text.empty() ? "" : "; ") + ("<b>" + escaped(key) + "</b> ");
    for (std::size_t i = 0; i < values.size(); ++i) text += (i > 0 ? ", " : "") + escaped(values[i]);
  }
  return text;
}

std::string joined(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& sentence : sentences) text += (text.empty() ? "" : " ") + sentence;
  return text;
}

std::string opening(const PageData& data, const std::string& command) {
  const std::size_t failed = static_cast<std::size_t>(std::ranges::count(data.outcomes, false, &Outcome::ok));
  std::string html = "<h1>" + escaped(data.study.title) + "</h1>\n<p class=\"facts\">" +
                     counted(data.study.cases.size(), "case") + " of <code>" +
                     escaped(data.study.scene.filename().string()) + "</code>: " + varied(data.study) + ". " +
                     (failed > 0 ? "<b class=\"failed\">" + counted(failed, "case") + " failed.</b> " : "") +
                     "Each run as a process of its own on " +
                     counted(static_cast<std::size_t>(data.study.threads), "thread") + ".<br>" +
                     escaped(machine()) + ". " + today() + ". Made by <code>" + escaped(command) +
                     "</code></p>\n";
  std::string sentences;
  for (const Finding& finding : data.analysis.findings)
    if (!finding.sentences.empty()) sentences += "<p>" + escaped(joined(finding.sentences)) + "</p>\n";
  return html + (sentences.empty() ? "" : "<div class=\"answer\">\n" + sentences + "</div>\n");
}

constexpr const char* reading_help = R"html(<section>
<h2>How to read this page</h2>
<p class="note">An error is the distance to the reference, over the reference's own size. Where the reference is a
limit, value(h) = limit + c h<sup>p</sup> is fitted to the runs of one series by least squares (Richardson), and its
uncertainty is a grid convergence index: 1.25 times the step from the finest run to the limit plus the scatter of the
fit, or three times that step where the order p is not between 0.5 and 4.5; where the runs do not come from one side,
three times the spread of the last three. Costs between runs are interpolated on the front of best bargains, log over
log; costs beyond it are extrapolated with the slope of its last three runs and are a guess. Wall time is that of the
whole process, best of the repeats, with other runs beside it where the machine has room.</p>
</section>
)html";

}  // namespace

std::string study_page(const Study& study, const std::vector<Outcome>& outcomes, const Analysis& analysis,
                       const std::string& command) {
  const PageData data{study, outcomes, analysis};
  std::string html =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\">\n<title>" +
      escaped(study.title) + "</title>\n<style>" + style + "</style>\n</head>\n<body>\n<main>\n";
  html += opening(data, command);
  for (const Finding& finding : analysis.findings) html += finding_section(data, finding);
  return html + cost_section(data) + case_section(data) + reading_help + "</main>\n</body>\n</html>\n";
}

std::string html_table(const std::vector<std::vector<std::string>>& rows, std::size_t left) {
  std::string html = "<table>\n";
  for (std::size_t r = 0; r < rows.size(); ++r) {
    html += "<tr>";
    const std::string tag = r == 0 ? "th" : "td";
    for (std::size_t c = 0; c < rows[r].size(); ++c)
      html += "<" + tag + (c < left ? " class=\"left\"" : "") + ">" + rows[r][c] + "</" + tag + ">";
    html += "</tr>\n";
  }
  return html + "</table>\n";
}

std::string value_text(double value, const std::string& unit) {
  if (std::isnan(value)) return "–";
  std::string text = output::short_quantity(value, unit);
  if (text.starts_with("-")) text.replace(0, 1, "−");
  return text;
}

std::string memory_text(double bytes) {
  return bytes < 1e9 ? printed("%.0f MB", bytes / 1e6) : printed("%.2f GB", bytes / 1e9);
}

}  // namespace ashlar::study
