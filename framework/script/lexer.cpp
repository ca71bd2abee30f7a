#include "script/lexer.hpp"

#include <algorithm>
#include <cctype>

namespace ashlar::script {

namespace {

enum class Kind { name, number, text, sign };

struct Token {
  Kind kind;
  std::string_view text;  // of a quoted string with its quotes; of a sign one character, or "=="-like pairs
  int line;
};

class Lexer {
 public:
  explicit Lexer(std::string_view source) : source_(source) {
    if (source_.starts_with("\xEF\xBB\xBF")) at_ = 3;
    if (at_ < source_.size() && source_[at_] == '#') skip_line();
  }

  std::size_t start() const { return at_; }

  std::vector<Token> tokens() {
    std::vector<Token> list;
    while (skip_blanks()) list.push_back(next());
    return list;
  }

 private:
  char peek(std::size_t ahead = 0) const {
    return at_ + ahead < source_.size() ? source_[at_ + ahead] : '\0';
  }

  // "\r\n" and "\n\r" are one line end, as in Lua.
  void step() {
    const char c = source_[at_++];
    if (c != '\n' && c != '\r') return;
    if ((peek() == '\n' || peek() == '\r') && peek() != c) ++at_;
    ++line_;
  }

  void skip_line() {
    while (at_ < source_.size() && peek() != '\n' && peek() != '\r') ++at_;
  }

  bool skip_blanks() {
    while (at_ < source_.size()) {
      if (std::isspace(static_cast<unsigned char>(peek()))) {
        step();
      } else if (peek() == '-' && peek(1) == '-') {
        at_ += 2;
        if (!skip_long()) skip_line();
      } else {
        return true;
      }
    }
    return false;
  }

  // [[…]] or [==[…]==]; false if none starts here
  bool skip_long() {
    if (peek() != '[') return false;
    std::size_t level = 0;
    while (peek(1 + level) == '=') ++level;
    if (peek(1 + level) != '[') return false;
    const std::string closing = "]" + std::string(level, '=') + "]";
    at_ += level + 2;
    while (at_ < source_.size() && source_.substr(at_, closing.size()) != closing) step();
    at_ = std::min(source_.size(), at_ + closing.size());
    return true;
  }

  void skip_quoted() {
    const char quote = source_[at_++];
    while (at_ < source_.size() && peek() != quote) {
      if (peek() == '\\' && at_ + 1 < source_.size()) ++at_;
      step();
    }
    if (at_ < source_.size()) ++at_;
  }

  void skip_number() {
    const bool hex = peek() == '0' && (peek(1) == 'x' || peek(1) == 'X');
    while (std::isalnum(static_cast<unsigned char>(peek())) || peek() == '.') {
      const char c = static_cast<char>(std::tolower(static_cast<unsigned char>(peek())));
      ++at_;
      if (c == (hex ? 'p' : 'e') && (peek() == '+' || peek() == '-')) ++at_;
    }
  }

  Token next() {
    const std::size_t begin = at_;
    const int line = line_;
    Kind kind = Kind::sign;
    const char c = peek();
    const auto is_word = [](char x) { return std::isalnum(static_cast<unsigned char>(x)) || x == '_'; };
    const auto is_digit = [](char x) { return std::isdigit(static_cast<unsigned char>(x)) != 0; };
    if (is_digit(c) || (c == '.' && is_digit(peek(1)))) {
      kind = Kind::number;
      skip_number();
    } else if (is_word(c)) {
      kind = Kind::name;
      while (is_word(peek())) ++at_;
    } else if (c == '"' || c == '\'') {
      kind = Kind::text;
      skip_quoted();
    } else if (skip_long()) {
      kind = Kind::text;
    } else {
      at_ += (c == '=' || c == '~' || c == '<' || c == '>') && peek(1) == '=' ? 2 : 1;
    }
    return {kind, source_.substr(begin, at_ - begin), line};
  }

  std::string_view source_;
  std::size_t at_ = 0;
  int line_ = 1;
};

bool opens_block(const Token& token) {
  if (token.kind != Kind::name) return false;
  return token.text == "function" || token.text == "do" || token.text == "if" || token.text == "repeat";
}

bool closes_block(const Token& token) {
  return token.kind == Kind::name && (token.text == "end" || token.text == "until");
}

bool is_sign(const Token& token, std::string_view sign) {
  return token.kind == Kind::sign && token.text == sign;
}

class Marker {
 public:
  Marker(std::string_view source, std::size_t first) : source_(source), first_(first), lexer_(source) {}

  MarkedSource run() {
    const std::size_t start = lexer_.start();
    const std::vector<Token> tokens = lexer_.tokens();
    copied_ = start;
    out_ = "local " + std::string(marker) + "=...;";
    bool balanced = true;
    for (std::size_t i = 0; i < tokens.size() && balanced; ++i) balanced = take(tokens, i);
    if (!balanced || !open_.empty()) return {std::string(source_.substr(start)), {}};
    out_ += source_.substr(copied_);
    return {std::move(out_), std::move(tables_)};
  }

 private:
  struct Open {
    char closing;           // '}' ')' ']', or 'e' for a block
    std::size_t table = 0;  // of '}'
  };

  bool in_table() const { return !open_.empty() && open_.back().closing == '}'; }

  bool take(const std::vector<Token>& tokens, std::size_t i) {
    const Token& token = tokens[i];
    if (field_starts_) {
      field_starts_ = false;
      if (!is_sign(token, "}")) note_field(tokens, i);
    }
    if (opens_block(token)) {
      open_.push_back({'e'});
    } else if (closes_block(token)) {
      return close('e');
    } else if (token.kind == Kind::sign) {
      return take_sign(token);
    }
    return true;
  }

  bool take_sign(const Token& token) {
    switch (token.text[0]) {
      case '{':
        copy_before(token);
        out_ += "(" + std::string(marker) + "(" + std::to_string(first_ + tables_.size()) + ",{";
        open_.push_back({'}', tables_.size()});
        tables_.push_back({token.line, {}, {}});
        field_starts_ = true;
        return true;
      case '}':
        if (!close('}')) return false;
        copy_before(token);
        out_ += "}))";
        return true;
      case '(':
        open_.push_back({')'});
        return true;
      case '[':
        open_.push_back({']'});
        return true;
      case ')':
      case ']':
        return close(token.text[0]);
      case ',':
      case ';':
        field_starts_ = in_table();
        return true;
      default:
        return true;
    }
  }

  bool close(char closing) {
    if (open_.empty() || open_.back().closing != closing) return false;
    open_.pop_back();
    return true;
  }

  void note_field(const std::vector<Token>& tokens, std::size_t i) {
    TableLines& table = tables_[open_.back().table];
    auto sign_at = [&](std::size_t at, std::string_view sign) {
      return at < tokens.size() && is_sign(tokens[at], sign);
    };
    if (tokens[i].kind == Kind::name && sign_at(i + 1, "=")) {
      table.keys.emplace_back(tokens[i].text, tokens[i].line);
    } else if (is_sign(tokens[i], "[")) {
      const bool plain = i + 1 < tokens.size() && tokens[i + 1].kind == Kind::text && sign_at(i + 2, "]");
      const std::string_view text = plain ? tokens[i + 1].text : std::string_view();
      // Keys with escapes or in long brackets are rare; they fall back to the table's line.
      if (plain && text[0] != '[' && text.find('\\') == std::string_view::npos && text.size() >= 2)
        table.keys.emplace_back(text.substr(1, text.size() - 2), tokens[i].line);
    } else {
      table.items.push_back(tokens[i].line);
    }
  }

  // Copies up to the token and drops the token itself.
  void copy_before(const Token& token) {
    const std::size_t at = static_cast<std::size_t>(token.text.data() - source_.data());
    out_ += source_.substr(copied_, at - copied_);
    copied_ = at + token.text.size();
  }

  std::string_view source_;
  std::size_t first_;
  Lexer lexer_;
  std::string out_;
  std::size_t copied_ = 0;
  std::vector<Open> open_;
  std::vector<TableLines> tables_;
  bool field_starts_ = false;
};

}  // namespace

std::string_view without_head(std::string_view source) {
  return source.substr(Lexer(source).start());
}

MarkedSource mark_tables(std::string_view source, std::size_t first) {
  return Marker(source, first).run();
}

}  // namespace ashlar::script
