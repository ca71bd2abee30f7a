#include "meshing_file/cursor.hpp"

#include <algorithm>
#include <charconv>

#include "core/error.hpp"

namespace ashlar::meshing_file {

namespace {

bool is_space(char c) {
  return c == ' ' || c == '\n' || c == '\t' || c == '\r';
}

// What stands in a file may be anything: only what can be printed is shown.
std::string shown(std::string_view word) {
  std::string text(word.substr(0, 24));
  for (char& c : text) c = c >= 32 && c < 127 ? c : '?';
  return "'" + text + "'";
}

}  // namespace

void Cursor::fail_at(std::size_t position, const std::string& what) const {
  core::Mistake mistake;
  mistake.place.file = file_;
  mistake.what = what;
  const std::size_t here = std::min(position, text_.size());
  if (binary_) {
    mistake.what += " (at byte " + std::to_string(here) + ")";
  } else if (lines_) {
    mistake.place.line = 1 + static_cast<int>(std::count(
                                 text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(here), '\n'));
  }
  throw core::InputError(std::move(mistake));
}

void Cursor::need(std::size_t bytes) const {
  if (text_.size() - position_ < bytes) fail_at(text_.size(), "the file ends too early");
}

void Cursor::skip_space() {
  while (position_ < text_.size() && is_space(text_[position_])) ++position_;
}

bool Cursor::at_end() {
  skip_space();
  return position_ == text_.size();
}

std::string_view Cursor::word() {
  skip_space();
  need(1);
  const std::size_t start = position_;
  while (position_ < text_.size() && !is_space(text_[position_])) ++position_;
  return text_.substr(start, position_ - start);
}

std::int64_t Cursor::integer() {
  const std::string_view text = word();
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) {
    fail_at(position_ - text.size(), "a whole number is expected, got " + shown(text));
  }
  return value;
}

double Cursor::real() {
  std::string_view text = word();
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  // Numbers too small for a double are zero to us.
  if ((error != std::errc{} && error != std::errc::result_out_of_range) || end != text.data() + text.size()) {
    fail_at(position_ - text.size(), "a number is expected, got " + shown(text));
  }
  return value;
}

std::string_view Cursor::line() {
  const std::size_t end = std::min(text_.find('\n', position_), text_.size());
  std::string_view text = text_.substr(position_, end - position_);
  position_ = std::min(end + 1, text_.size());
  if (text.ends_with('\r')) text.remove_suffix(1);
  return text;
}

std::string Cursor::quoted() {
  const std::string_view text = line();
  const std::size_t first = text.find('"'), last = text.rfind('"');
  if (first == std::string_view::npos || last == first) fail("a name in double quotes is expected");
  return std::string(text.substr(first + 1, last - first - 1));
}

void Cursor::skip_behind(std::string_view text) {
  const std::size_t found = text_.find(text, position_);
  if (found == std::string_view::npos)
    fail_at(text_.size(), "the file ends too early: " + shown(text) + " is missing");
  position_ = found + text.size();
}

std::size_t Cursor::count(std::int64_t claimed, std::size_t bytes) const {
  if (claimed < 0) fail("a count is negative: " + std::to_string(claimed));
  if (static_cast<std::uint64_t>(claimed) > (text_.size() - position_) / bytes + 1) {
    fail("the file is too short for a count of " + std::to_string(claimed));
  }
  return static_cast<std::size_t>(claimed);
}

}  // namespace ashlar::meshing_file
