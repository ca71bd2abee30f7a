#include "script/convert.hpp"

#include <algorithm>
#include <climits>
#include <map>

#include "script/function.hpp"
#include "script/quantity.hpp"
#include "script/sandbox.hpp"
#include "script/undefined.hpp"

namespace ashlar::script {

namespace {

constexpr std::size_t deepest = 60;
constexpr std::size_t most_values = 3'000'000;

class Converter {
 public:
  Converter(const std::shared_ptr<Machine>& machine, lua_State* L, core::Mistakes& mistakes)
      : machine_(machine), state_(L), mistakes_(mistakes) {}

  core::Value convert(int index, core::Place place);

 private:
  struct Keyed {
    std::string key;
    int order;  // the line, or the largest number where it is unknown
    core::Value value;
  };

  core::Value convert_table(int index, core::Place place);
  void collect(int index, const core::Place& place, const TableLines* lines, core::Table& table);
  void collect_item(lua_Integer position, const core::Place& place, const TableLines* lines,
                    std::map<lua_Integer, core::Value>& items);
  void check_holes(const std::map<lua_Integer, core::Value>& items, const core::Place& place);
  void check_repeated(const TableLines& lines, const core::Place& place);
  void add(core::Place place, const std::string& what, const std::string& advice = {}) {
    mistakes_.add(std::move(place), what, advice);
  }

  const std::shared_ptr<Machine>& machine_;
  lua_State* state_;
  core::Mistakes& mistakes_;
  std::vector<const void*> around_;  // the tables that the present value is in
  std::size_t count_ = 0;
};

core::Value Converter::convert(int index, core::Place place) {
  lua_State* L = state_;
  if (++count_ % 1024 == 0) machine_->check_limits(L);
  if (count_ > most_values)
    luaL_error(L, "the scene holds more than %d values", static_cast<int>(most_values));
  if (const auto quantity = to_quantity(L, index)) return {std::move(place), *quantity};
  switch (lua_type(L, index)) {
    case LUA_TNIL:
      return {std::move(place), {}};
    case LUA_TBOOLEAN:
      return core::make_value(lua_toboolean(L, index) != 0, std::move(place));
    case LUA_TSTRING: {
      std::size_t size = 0;
      const char* text = lua_tolstring(L, index, &size);
      return core::make_value(std::string(text, size), std::move(place));
    }
    case LUA_TTABLE:
      return convert_table(index, std::move(place));
    case LUA_TFUNCTION:
      if (const std::string word = constructor_word(L, index); !word.empty()) {
        add(place, word + " needs a table", "write " + word + " { … }; braces may be empty");
        return {std::move(place), {}};
      }
      return {place, make_function(machine_, L, index, place)};
    default:
      if (!is_undefined(L, index)) add(place, std::string("a ") + luaL_typename(L, index) + " is no data");
      return {std::move(place), {}};
  }
}

core::Value Converter::convert_table(int index, core::Place place) {
  lua_State* L = state_;
  index = lua_absindex(L, index);
  const auto mark = machine_->mark(L, index);
  if (mark) {
    const core::Place own = machine_->place_of_mark(*mark);
    place.file = own.file;
    place.line = own.line;
  }
  const void* address = lua_topointer(L, index);
  if (std::find(around_.begin(), around_.end(), address) != around_.end()) {
    add(place, "the table contains itself");
    return {std::move(place), {}};
  }
  if (around_.size() >= deepest || !lua_checkstack(L, 10)) {
    add(place, "tables are nested deeper than " + std::to_string(deepest));
    return {std::move(place), {}};
  }
  around_.push_back(address);
  core::Table table;
  table.constructor = machine_->word(L, index);
  const TableLines* lines = mark ? &machine_->lines_of_mark(*mark) : nullptr;
  if (lines) check_repeated(*lines, place);
  collect(index, place, lines, table);
  around_.pop_back();
  return core::make_value(std::move(table), std::move(place));
}

int line_of_key(const TableLines* lines, const std::string& key) {
  if (lines)
    for (const auto& [name, line] : lines->keys)
      if (name == key) return line;
  return 0;
}

void Converter::collect(int index, const core::Place& place, const TableLines* lines, core::Table& table) {
  lua_State* L = state_;
  std::map<lua_Integer, core::Value> items;
  std::vector<Keyed> keyed;
  for (lua_pushnil(L); lua_next(L, index); lua_pop(L, 1)) {
    if (lua_isinteger(L, -2) && lua_tointeger(L, -2) >= 1) {
      collect_item(lua_tointeger(L, -2), place, lines, items);
    } else if (lua_type(L, -2) == LUA_TSTRING) {
      const std::string key = lua_tostring(L, -2);
      const int line = line_of_key(lines, key);
      const std::string path = place.path.empty() ? key : place.path + "." + key;
      core::Value value = convert(-1, {place.file, line > 0 ? line : place.line, path});
      keyed.push_back({key, line > 0 ? line : INT_MAX, std::move(value)});
    } else if (!is_undefined(L, -2)) {
      lua_pushvalue(L, -2);
      const std::string shown = luaL_tolstring(L, -1, nullptr);
      const bool number = lua_type(L, -2) == LUA_TNUMBER;
      lua_pop(L, 2);
      add(place, "keys must be names or 1, 2, 3, …; got " +
                     (number ? "the key " + shown : "a " + std::string(luaL_typename(L, -2)) + " as a key"));
    }
  }
  check_holes(items, place);
  for (auto& [position, value] : items) table.items.push_back(std::move(value));
  std::sort(keyed.begin(), keyed.end(), [](const Keyed& a, const Keyed& b) {
    return std::tie(a.order, a.key) < std::tie(b.order, b.key);
  });
  for (Keyed& entry : keyed) table.entries.emplace_back(std::move(entry.key), std::move(entry.value));
}

void Converter::collect_item(lua_Integer position, const core::Place& place, const TableLines* lines,
                             std::map<lua_Integer, core::Value>& items) {
  int line = place.line;
  if (lines && !lines->items.empty()) {
    const auto known = static_cast<lua_Integer>(lines->items.size());
    line = lines->items[static_cast<std::size_t>(std::min(position, known) - 1)];
  }
  items.emplace(position, convert(-1, {place.file, line, place.path + "[" + std::to_string(position) + "]"}));
}

void Converter::check_holes(const std::map<lua_Integer, core::Value>& items, const core::Place& place) {
  lua_Integer expected = 1;
  for (const auto& [position, value] : items) {
    if (position != expected) {
      add(place,
          "item " + std::to_string(expected) + " is nil, but item " + std::to_string(position) + " is there");
      return;
    }
    ++expected;
  }
}

// Lua itself keeps the last of two equal keys without a word.
void Converter::check_repeated(const TableLines& lines, const core::Place& place) {
  std::map<std::string, int> first;
  for (const auto& [key, line] : lines.keys) {
    const auto [entry, is_new] = first.emplace(key, line);
    if (!is_new)
      add({place.file, line, place.path.empty() ? key : place.path + "." + key},
          "is given twice, first in line " + std::to_string(entry->second));
  }
}

}  // namespace

core::Value convert(const std::shared_ptr<Machine>& machine, lua_State* L, int index, core::Place place,
                    core::Mistakes& mistakes) {
  return Converter(machine, L, mistakes).convert(lua_absindex(L, index), std::move(place));
}

}  // namespace ashlar::script
