#include "script/function.hpp"

#include <cmath>
#include <sstream>

#include "script/quantity.hpp"

namespace ashlar::script {

namespace {

class ScriptFunction : public core::Function {
 public:
  ScriptFunction(std::shared_ptr<Machine> machine, int reference, core::Place place)
      : machine_(std::move(machine)), reference_(reference), place_(std::move(place)) {}

  ~ScriptFunction() override { luaL_unref(machine_->state(), LUA_REGISTRYINDEX, reference_); }

  std::vector<double> call(std::span<const double> arguments) const override {
    std::vector<double> values;
    for (const core::Quantity& each : results(arguments)) values.push_back(each.value);
    return values;
  }

  void call_tables(std::span<const core::NumberTable> arguments,
                   std::span<core::NumberTable> results) const override {
    std::vector<double> shown;
    for (const core::NumberTable& argument : arguments)
      if (shown.empty() || is_number(argument))
        shown.insert(shown.end(), argument.values.begin(), argument.values.end());
    const auto failure = machine_->protect([&](lua_State* L) {
      luaL_checkstack(L, static_cast<int>(arguments.size()) + 4, "too many arguments");
      lua_rawgeti(L, LUA_REGISTRYINDEX, reference_);
      for (const core::NumberTable& argument : arguments) push(L, argument);
      lua_call(L, static_cast<int>(arguments.size()), static_cast<int>(results.size()));
      for (std::size_t i = 0; i < results.size(); ++i) read(L, static_cast<int>(i) + 1, results[i], shown);
    });
    if (failure) throw error(failure->place, "fails: " + failure->what, shown);
  }

  double number(std::span<const double> arguments, core::Dimension dimension) const override {
    const std::vector<core::Quantity> all = results(arguments);
    if (all.size() != 1)
      throw error(place_, "must return one number, but returns " + std::to_string(all.size()), arguments);
    if (!all[0].bare && !(all[0].dimension == dimension))
      throw error(place_,
                  "must return " + unit_words(dimension) + ", but returns " +
                      core::format_quantity(all[0].value, all[0].dimension),
                  arguments);
    return all[0].value;
  }

  core::Quantity call_with(const std::vector<std::pair<std::string, core::Value>>& named,
                           const std::string& what) const {
    std::optional<core::Quantity> result;
    const auto fails = [&](const std::string& how) {
      core::Place place = place_;
      return core::InputError(core::Mistake{place, "the function, called for " + what + ", " + how, {}});
    };
    const auto failure = machine_->protect([&](lua_State* L) {
      lua_rawgeti(L, LUA_REGISTRYINDEX, reference_);
      lua_newtable(L);
      for (const auto& [key, value] : named) {
        push(L, value);
        lua_setfield(L, -2, key.c_str());
      }
      lua_call(L, 1, 1);
      result = to_quantity(L, -1);
      if (!result) throw fails(std::string("must return a number, but returns a ") + luaL_typename(L, -1));
    });
    if (failure) throw fails("fails: " + failure->what);
    if (!std::isfinite(result->value)) throw fails("returns " + core::format_quantity(result->value, {}));
    return *result;
  }

 private:
  static void push(lua_State* L, const core::Value& value) {
    const core::Quantity* quantity = value.quantity();
    if (quantity && quantity->bare)
      lua_pushnumber(L, quantity->value);
    else if (quantity)
      push_quantity(L, quantity->value, quantity->dimension);
    else if (const std::string* text = value.text())
      lua_pushlstring(L, text->data(), text->size());
    else
      lua_pushboolean(L, value.boolean() && *value.boolean());
  }

  static std::string unit_words(core::Dimension dimension) {
    const std::string unit = core::to_string(dimension);
    return unit.empty() ? "a pure number" : "a number in " + unit;
  }

  static bool is_number(const core::NumberTable& table) {
    return table.names.size() == 1 && table.names[0].empty();
  }

  static void push(lua_State* L, const core::NumberTable& table) {
    if (is_number(table)) return lua_pushnumber(L, table.values[0]);
    lua_newtable(L);
    for (std::size_t i = 0; i < table.values.size(); ++i) {
      lua_pushnumber(L, table.values[i]);
      if (table.names.empty())
        lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
      else
        lua_setfield(L, -2, table.names[i].c_str());
    }
  }

  // A list that should be empty need not be returned at all.
  void read(lua_State* L, int index, core::NumberTable& table, std::span<const double> arguments) const {
    if (table.values.empty() && lua_isnoneornil(L, index)) return;
    if (is_number(table)) {
      table.values[0] = result(L, index, arguments).value;
      return;
    }
    if (!lua_istable(L, index))
      throw error(place_,
                  std::string("must return tables, but returns ") +
                      (lua_isnil(L, index) ? "nothing" : std::string("a ") + luaL_typename(L, index)),
                  arguments);
    for (std::size_t i = 0; i < table.values.size(); ++i) {
      const std::string name = table.names.empty() ? "[" + std::to_string(i + 1) + "]" : "." + table.names[i];
      lua_pushvalue(L, index);
      if (table.names.empty())
        lua_rawgeti(L, -1, static_cast<lua_Integer>(i) + 1);
      else
        lua_getfield(L, -1, table.names[i].c_str());
      const auto quantity = to_quantity(L, -1);
      if (!quantity || !std::isfinite(quantity->value))
        throw error(place_,
                    "must return a finite number at " + name + ", but returns " +
                        (quantity ? core::format_quantity(quantity->value, {})
                                  : std::string("a ") + luaL_typename(L, -1)),
                    arguments);
      table.values[i] = quantity->value;
      lua_pop(L, 2);
    }
  }

  std::vector<core::Quantity> results(std::span<const double> arguments) const {
    std::vector<core::Quantity> results;
    const auto failure = machine_->protect([&](lua_State* L) {
      luaL_checkstack(L, static_cast<int>(arguments.size()) + 2, "too many arguments");
      lua_rawgeti(L, LUA_REGISTRYINDEX, reference_);
      for (const double argument : arguments) lua_pushnumber(L, argument);
      lua_call(L, static_cast<int>(arguments.size()), LUA_MULTRET);
      for (int i = 1; i <= lua_gettop(L); ++i) results.push_back(result(L, i, arguments));
      if (results.empty()) throw error(place_, "returns nothing", arguments);
    });
    if (failure) throw error(failure->place, "fails: " + failure->what, arguments);
    return results;
  }

  core::Quantity result(lua_State* L, int index, std::span<const double> arguments) const {
    const auto quantity = to_quantity(L, index);
    if (!quantity) {
      const std::string got = lua_isnil(L, index) ? "nothing" : std::string("a ") + luaL_typename(L, index);
      throw error(place_, "must return numbers, but returns " + got, arguments);
    }
    if (!std::isfinite(quantity->value))
      throw error(place_, "returns " + core::format_quantity(quantity->value, {}), arguments);
    return *quantity;
  }

  core::InputError error(core::Place place, const std::string& what,
                         std::span<const double> arguments) const {
    std::ostringstream text;
    text << "the function";
    if (place.line != place_.line || place.file != place_.file)
      text << " of " << place_.file << ":" << place_.line;
    text << ", called with (";
    for (std::size_t i = 0; i < arguments.size(); ++i) text << (i > 0 ? ", " : "") << arguments[i];
    text << "), " << what;
    place.path = place_.path;
    return core::InputError(core::Mistake{std::move(place), text.str(), {}});
  }

  std::shared_ptr<Machine> machine_;
  int reference_;
  core::Place place_;
};

}  // namespace

std::shared_ptr<const core::Function> make_function(const std::shared_ptr<Machine>& machine, lua_State* L,
                                                    int index, core::Place place) {
  const core::Place own = machine->place_of_function(L, index);
  if (own.line > 0) {
    place.file = own.file;
    place.line = own.line;
  }
  lua_pushvalue(L, index);
  return std::make_shared<ScriptFunction>(machine, luaL_ref(L, LUA_REGISTRYINDEX), std::move(place));
}

core::Quantity call_with(const core::Function& function,
                         const std::vector<std::pair<std::string, core::Value>>& named,
                         const std::string& what) {
  return dynamic_cast<const ScriptFunction&>(function).call_with(named, what);
}

}  // namespace ashlar::script
