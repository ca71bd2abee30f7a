#include "study/cases.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>

#include "output/files.hpp"

namespace ashlar::study {

std::string shown(const core::Value& value) {
  if (const core::Quantity* q = value.quantity())
    return q->bare ? output::shortest(q->value) : core::format_quantity(q->value, q->dimension);
  if (const bool* flag = value.boolean()) return *flag ? "true" : "false";
  return value.text() ? *value.text() : value.type_name();
}

std::string set_text(const core::Value& value) {
  if (const std::string* text = value.text()) return '"' + *text + '"';
  const core::Quantity* q = value.quantity();
  if (!q || q->bare) return shown(value);
  const auto factor = [](const char* unit, int exponent) {
    return exponent == 0 ? std::string() : "*u." + std::string(unit) + "^" + std::to_string(exponent);
  };
  return output::shortest(q->value) + factor("m", q->dimension.length) + factor("kg", q->dimension.mass) +
         factor("s", q->dimension.time);
}

std::string series_label(const Case& one, const std::vector<std::string>& but) {
  std::string text = one.without.empty() ? "" : "without " + one.without;
  for (const Setting& setting : one.settings)
    if (setting.differs && std::ranges::find(but, setting.key) == but.end())
      text += (text.empty() ? "" : ", ") + setting.key + " = " + shown(setting.value);
  return text;
}

std::string label(const Case& one, const std::vector<std::string>& but) {
  const std::string text = series_label(one, but);
  return text.empty() ? "as it stands" : text;
}

const core::Value* find(const Case& one, const std::string& key) {
  for (const Setting& setting : one.settings)
    if (setting.key == key) return &setting.value;
  return nullptr;
}

namespace {

std::string exact_text(const Case& one) {
  std::string text;
  for (const Setting& setting : one.settings) text += setting.key + "=" + set_text(setting.value) + ";";
  return text;
}

}  // namespace

std::vector<std::string> folder_names(const std::vector<Case>& cases) {
  std::vector<std::string> names;
  for (const Case& one : cases) {
    std::string text = one.without.empty() ? "" : "without-" + one.without;
    for (const Setting& setting : one.settings)
      text += (text.empty() ? "" : "_") + setting.key + "-" + shown(setting.value);
    names.push_back(text.empty() ? "case" : output::file_name(text));
  }
  // What is written alike, or cut at the end, is told apart by its exact values.
  const std::vector<std::string> plain = names;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (std::ranges::count(plain, plain[i]) > 1)
      names[i] = plain[i].substr(0, 100) + "_" + hash_text(exact_text(cases[i]));
  return names;
}

std::vector<Case> combinations(const std::vector<std::pair<std::string, std::vector<core::Value>>>& lists) {
  std::vector<Case> cases(1);
  for (const auto& [key, values] : lists) {
    std::vector<Case> longer;
    for (const Case& one : cases)
      for (const core::Value& value : values) {
        longer.push_back(one);
        longer.back().settings.push_back({key, value});
        longer.back().place = value.place;
      }
    cases = std::move(longer);
  }
  return cases;
}

std::string hash_text(const std::string& text) {
  // FNV-1a, 64 bit: the same on every machine
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
  return digits;
}

}  // namespace ashlar::study
