#pragma once
// Lua tables carry no lines. Each table constructor in a source is therefore wrapped into a call that tells
// the table's number; the lines of its fields are noted here under that number.

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ashlar::script {

/// Lines (1-based) of one table constructor.
struct TableLines {
  int line = 0;                                   ///< of `{`
  std::vector<int> items;                         ///< of each positional item
  std::vector<std::pair<std::string, int>> keys;  ///< of each `key = …` and `["key"] = …`
};

struct MarkedSource {
  std::string text;  ///< the same lines, with `{…}` → `(MARKER(number,{…}))`
  std::vector<TableLines> tables;
};

/// Name of the marking function: the source's first upvalue, given to the chunk as its argument.
inline constexpr const char* marker = "__ashlar_at";

/// Numbers start at `first`. A source whose brackets do not match is returned without any marks:
/// Lua's own message then tells what is wrong.
MarkedSource mark_tables(std::string_view source, std::size_t first);

/// The source without a byte-order mark and a first line that starts with '#'.
std::string_view without_head(std::string_view source);

}  // namespace ashlar::script
