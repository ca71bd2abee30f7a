#include "core/error.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace ashlar::core {

namespace {

std::string joined(const std::vector<Mistake>& mistakes) {
  std::string text;
  for (const Mistake& mistake : mistakes) {
    if (!text.empty()) text += '\n';
    text += to_string(mistake);
  }
  return text;
}

std::string last_part(const std::string& path) {
  const auto dot = path.find_last_of('.');
  return dot == std::string::npos ? path : path.substr(dot + 1);
}

// A table used twice (one material for two regions) is one mistake, though it has two paths.
bool same(const Mistake& a, const Mistake& b) {
  return a.place.line > 0 && a.place.line == b.place.line && a.place.file == b.place.file &&
         a.what == b.what && last_part(a.place.path) == last_part(b.place.path);
}

}  // namespace

std::string to_string(const Place& place) {
  std::string text = place.file;
  if (place.line > 0) text += (text.empty() ? "line " : ":") + std::to_string(place.line);
  if (!place.path.empty()) text += (text.empty() ? "" : ": ") + place.path;
  return text;
}

std::string to_string(const Mistake& mistake) {
  std::string text = to_string(mistake.place);
  if (!text.empty()) text += ": ";
  text += mistake.what;
  if (!mistake.advice.empty()) text += "\n    " + mistake.advice;
  return text;
}

InputError::InputError(std::vector<Mistake> mistakes)
    : std::runtime_error(joined(mistakes)), mistakes_(std::move(mistakes)) {}

InputError::InputError(Mistake mistake) : InputError(std::vector<Mistake>{std::move(mistake)}) {}

void Mistakes::add(Place place, std::string what, std::string advice) {
  Mistake mistake{std::move(place), std::move(what), std::move(advice)};
  for (const Mistake& known : list_)
    if (same(known, mistake)) return;
  list_.push_back(std::move(mistake));
}

void Mistakes::add(const InputError& error) {
  for (const Mistake& mistake : error.mistakes()) add(mistake.place, mistake.what, mistake.advice);
}

void Mistakes::throw_if_any() const {
  if (list_.empty()) return;
  std::vector<Mistake> sorted = list_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Mistake& a, const Mistake& b) {
    return std::tie(a.place.file, a.place.line) < std::tie(b.place.file, b.place.line);
  });
  throw InputError(std::move(sorted));
}

namespace {

// Edit distance with neighbouring letters swapped counting as one (optimal string alignment).
std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), now(b.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    now[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      now[j] = std::min({last[j] + 1, now[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) now[j] = std::min(now[j], before[j - 2] + 1);
    }
    std::swap(before, last);
    std::swap(last, now);
  }
  return last[b.size()];
}

std::string lower(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

}  // namespace

std::string nearest(const std::string& word, const std::vector<std::string>& valid) {
  constexpr std::size_t longest = 100;  // distance is quadratic; nobody misspells a novel
  if (word.size() > longest) return {};
  std::string best;
  std::size_t best_distance = std::max<std::size_t>(1, word.size() / 3) + 1;
  for (const std::string& candidate : valid) {
    if (candidate.size() > longest) continue;
    const std::size_t d = distance(lower(word), lower(candidate));
    if (d < best_distance && d < candidate.size()) {
      best = candidate;
      best_distance = d;
    }
  }
  return best;
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& valid) {
  std::string text;
  const std::string guess = nearest(word, valid);
  if (!guess.empty()) text = "did you mean '" + guess + "'?";
  if (valid.empty()) return text;
  text += text.empty() ? "valid: " : " valid: ";
  for (std::size_t i = 0; i < valid.size(); ++i) text += (i ? ", " : "") + valid[i];
  return text;
}

}  // namespace ashlar::core
