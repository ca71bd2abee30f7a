// The table as a page of text and as a page of HTML.

#include <algorithm>
#include <cstdio>
#include <sstream>

#include "stability/table.hpp"

namespace ashlar::stability {

namespace {

constexpr std::size_t width = 118;

/// Breaks text into lines of at most `most` bytes, later ones indented.
std::string wrapped(const std::string& label, const std::string& text, std::size_t most) {
  std::istringstream words(text);
  std::string all = label, word;
  const std::string indent(12, ' ');
  std::size_t line = label.size();
  while (words >> word) {
    if (line + word.size() + 1 > most) {
      all += "\n" + indent;
      line = indent.size();
    } else if (line > label.size() || !label.empty()) {
      all += all.back() == ' ' ? "" : " ";
      ++line;
    }
    all += word;
    line += word.size();
  }
  return all + "\n";
}

const char* const note =
    "The patch test's bounds: polynomials of degree 1 to k must come out exactly; displacements (u) to "
    "1e-12, 1e-11, "
    "1e-10 of the largest for orders 1, 2, 3, which is what some hundred unknowns leave in double precision; "
    "stresses "
    "(σ) differentiate over a cell: hundred times that. Plane strain, the default stabilisation. Three "
    "numbers side by side are those of "
    "orders 1, 2 and 3, each the worst of what the row ran.";

struct Counts {
  std::size_t holds = 0, known = 0, red = 0;
};

Counts count(const std::vector<Result>& results) {
  Counts counts;
  for (const Result& each : results) {
    const std::string said = verdict(each);
    ++(said == "RED" ? counts.red : said == "known" ? counts.known : counts.holds);
  }
  return counts;
}

std::string sentence(const std::vector<Result>& results, const std::vector<Planted>& planted) {
  const Counts counts = count(results);
  std::string text = std::to_string(results.size()) + " cases: " + std::to_string(counts.holds) + " hold, " +
                     std::to_string(counts.known) + " known, " + std::to_string(counts.red) + " red.";
  if (!planted.empty())
    text += " " + std::to_string(planted.size()) + " planted faults: " +
            std::to_string(std::ranges::count_if(planted, [](const Planted& p) { return p.red; })) +
            " turned their row red.";
  return text;
}

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '&')
      safe += "&amp;";
    else if (c == '<')
      safe += "&lt;";
    else if (c == '>')
      safe += "&gt;";
    else
      safe += c;
  }
  return safe;
}

const char* const style = R"(
body { font: 14px/1.4 system-ui, sans-serif; margin: 2em auto; max-width: 88em; padding: 0 1em; color: #222; }
h1 { font-size: 1.5em; } h2 { font-size: 1.1em; margin: 1.6em 0 .4em; }
table { border-collapse: collapse; width: 100%; }
th { text-align: left; font-weight: 600; border-bottom: 2px solid #888; padding: .3em .6em; }
td { vertical-align: top; border-bottom: 1px solid #ddd; padding: .35em .6em; }
td.name { font-weight: 600; width: 15%; } td.risk { width: 17%; } td.bound { width: 27%; color: #444; }
td.measured span { display: inline-block; white-space: nowrap; margin-right: 1em; font-variant-numeric: tabular-nums; }
td.measured .off { color: #a00; font-weight: 600; } td.measured .said { white-space: normal; font-style: italic; }
td.verdict { text-align: center; font-weight: 600; white-space: nowrap; }
.green { background: #e2f3e2; } .red { background: #f8d0d0; } .known { background: #fbeec2; }
@media print { body { font-size: 9px; margin: 0; } })";

std::string figures_html(const Outcome& outcome) {
  std::string html;
  for (const Line& each : lines(outcome))
    html += std::string("<span") + (each.holds ? "" : " class=off") + ">" + escaped(each.text) + "</span> ";
  if (!outcome.said.empty()) html += "<span class=said>“" + escaped(outcome.said) + "”</span> ";
  for (const std::string& each : outcome.missing)
    html += "<span class='off said'>" + escaped(each) + "</span> ";
  return html;
}

std::string row_html(const Result& result) {
  const std::string said = verdict(result);
  const char* colour = said == "RED" ? "red" : said == "known" ? "known" : "green";
  const Case& row = *result.row;
  return "<tr><td class=name>" + escaped(row.name) + "<td class=risk>" + escaped(row.risk) +
         "<td class=bound>" + escaped(row.bound) + "<td class=measured>" + figures_html(result.outcome) +
         (row.known.empty() ? "" : "<br>Known: " + escaped(row.known)) + "<td class='verdict " + colour +
         "'>" + said + "\n";
}

}  // namespace

std::string text_page(const std::vector<Result>& results, const std::vector<Planted>& planted) {
  std::string text = "Hard cases\n" + sentence(results, planted) + "\n\n" + wrapped("", note, width);
  std::string group;
  double seconds = 0;
  for (const Result& each : results) {
    const Case& row = *each.row;
    if (row.group != group) text += "\n" + (group = row.group) + "\n";
    seconds += each.seconds;
    const std::string said = verdict(each);
    text += "\n  " + std::string(said == "holds" ? "[ok]   " : "[" + said + "] ") + row.name + "\n";
    text += wrapped("    risk    ", row.risk, width);
    text += wrapped("    bound   ", row.bound, width);
    text += wrapped("    found   ", measured_text(each.outcome), width);
    if (!row.known.empty()) text += wrapped("    known   ", row.known, width);
  }
  if (!planted.empty()) text += "\nPlanted faults: each must turn its row red\n";
  for (const Planted& each : planted)
    text +=
        wrapped(each.red ? "  [red]   " : "  [GREEN] ", each.row->name + " — " + words(each.fault), width);
  char time[60];
  std::snprintf(time, sizeof time, "\n%.1f s\n", seconds);
  return text + time;
}

std::string html_page(const std::vector<Result>& results, const std::vector<Planted>& planted) {
  std::string html = "<!doctype html>\n<html lang=en><meta charset=utf-8><title>Hard cases</title>\n<style>" +
                     std::string(style) + "</style>\n<h1>Hard cases</h1>\n<p>" + sentence(results, planted) +
                     "</p>\n<p>" + note + "</p>\n";
  std::string group;
  for (const Result& each : results) {
    if (each.row->group != group) {
      html += (group.empty() ? "" : "</table>\n") + std::string("<h2>") + (group = each.row->group) +
              "</h2>\n<table><tr><th>case<th>what could go wrong<th>bound<th>measured<th>verdict\n";
    }
    html += row_html(each);
  }
  html += "</table>\n";
  if (planted.empty()) return html;
  html += "<h2>Planted faults</h2>\n<table><tr><th>case<th>fault<th>measured with it<th>row turned red\n";
  for (const Planted& each : planted)
    html += "<tr><td class=name>" + escaped(each.row->name) + "<td>" + words(each.fault) +
            "<td class=measured>" + escaped(each.measured) + "<td class='verdict " +
            (each.red ? "green'>yes" : "red'>NO") + "\n";
  return html + "</table>\n";
}

}  // namespace ashlar::stability
