#include "script/quantity.hpp"

#include <cmath>
#include <cstdlib>

#include "script/machine.hpp"
#include "script/sandbox.hpp"
#include "script/undefined.hpp"

namespace ashlar::script {

namespace {

constexpr const char* type_name = "quantity";
constexpr int largest_exponent = 30;

struct Held {
  double value;
  core::Dimension dimension;
};

std::string shown(const core::Quantity& q) {
  const std::string text = core::format_quantity(q.value, q.dimension);
  return q.bare || q.dimension == core::Dimension{} ? text + " (a pure number)" : text;
}

// A bare number is SI and fits every dimension.
bool agree(const core::Quantity& a, const core::Quantity& b) {
  return a.bare || b.bare || a.dimension == b.dimension;
}

int mismatch(lua_State* L, const char* verb, const core::Quantity& a, const core::Quantity& b) {
  return Machine::of(L).report(L, std::string("cannot ") + verb + " " + shown(a) + " and " + shown(b),
                               "their dimensions differ");
}

struct Pair {
  core::Quantity a, b;
};

// Nothing if an operand is undefined: the result then is undefined too.
std::optional<Pair> operands(lua_State* L) {
  if (is_undefined(L, 1) || is_undefined(L, 2)) return {};
  const auto a = to_quantity(L, 1), b = to_quantity(L, 2);
  if (!a || !b) luaL_error(L, "cannot calculate with a quantity and a %s", luaL_typename(L, a ? 2 : 1));
  return Pair{*a, *b};
}

int sum_with(lua_State* L, double sign, const char* verb) {
  const auto pair = operands(L);
  if (!pair) return push_undefined(L), 1;
  const auto& [a, b] = *pair;
  if (!agree(a, b)) return mismatch(L, verb, a, b);
  push_quantity(L, a.value + sign * b.value, a.bare ? b.dimension : a.dimension);
  return 1;
}

int add(lua_State* L) {
  return sum_with(L, 1, "add");
}
int subtract(lua_State* L) {
  return sum_with(L, -1, "subtract");
}

int checked_push(lua_State* L, double value, core::Dimension a, core::Dimension b, int sign) {
  auto within = [&](int x, int y) { return std::abs(x + sign * y) <= largest_exponent; };
  if (!within(a.length, b.length) || !within(a.mass, b.mass) || !within(a.time, b.time))
    return luaL_error(L, "a unit's exponent exceeds %d", largest_exponent);
  push_quantity(L, value, sign > 0 ? a * b : a / b);
  return 1;
}

int multiply(lua_State* L) {
  const auto pair = operands(L);
  if (!pair) return push_undefined(L), 1;
  return checked_push(L, pair->a.value * pair->b.value, pair->a.dimension, pair->b.dimension, 1);
}

int divide(lua_State* L) {
  const auto pair = operands(L);
  if (!pair) return push_undefined(L), 1;
  return checked_push(L, pair->a.value / pair->b.value, pair->a.dimension, pair->b.dimension, -1);
}

int push_power(lua_State* L, const core::Quantity& base, double exponent) {
  auto scaled = [exponent](int part) { return part * exponent; };
  const double l = scaled(base.dimension.length), m = scaled(base.dimension.mass),
               t = scaled(base.dimension.time);
  for (const double part : {l, m, t})
    if (part != std::round(part) || !(std::abs(part) <= largest_exponent))
      return luaL_error(L, "%s to the power %f has no whole unit exponents", shown(base).c_str(), exponent);
  auto whole = [](double x) { return static_cast<std::int8_t>(x); };
  push_quantity(L, std::pow(base.value, exponent), {whole(l), whole(m), whole(t)});
  return 1;
}

int power(lua_State* L) {
  const auto pair = operands(L);
  if (!pair) return push_undefined(L), 1;
  if (!pair->b.bare)
    return luaL_error(L, "an exponent must be a pure number, got %s", shown(pair->b).c_str());
  return push_power(L, pair->a, pair->b.value);
}

int negate(lua_State* L) {
  const auto q = to_quantity(L, 1);
  push_quantity(L, -q->value, q->dimension);
  return 1;
}

template <class Compare>
int compare_with(lua_State* L, Compare compare) {
  const auto pair = operands(L);
  const bool fit = pair && agree(pair->a, pair->b);
  if (pair && !fit) {
    mismatch(L, "compare", pair->a, pair->b);
    lua_pop(L, 1);
  }
  lua_pushboolean(L, fit && compare(pair->a.value, pair->b.value));
  return 1;
}

int equal(lua_State* L) {
  return compare_with(L, [](double a, double b) { return a == b; });
}
int less(lua_State* L) {
  return compare_with(L, [](double a, double b) { return a < b; });
}
int at_most(lua_State* L) {
  return compare_with(L, [](double a, double b) { return a <= b; });
}

int to_text(lua_State* L) {
  const auto q = to_quantity(L, 1);
  const std::string text = core::format_quantity(q->value, q->dimension);
  lua_pushlstring(L, text.data(), text.size());
  return 1;
}

int join(lua_State* L) {
  luaL_tolstring(L, 1, nullptr);
  luaL_tolstring(L, 2, nullptr);
  lua_concat(L, 2);
  return 1;
}

int no_field(lua_State* L) {
  const std::string key = luaL_tolstring(L, 2, nullptr);
  return luaL_error(L, "a quantity has no field '%s'; divide by a unit to get a number: q/units.m",
                    key.c_str());
}

// math.f for plain numbers stays Lua's own; upvalue 1.
int call_original(lua_State* L) {
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_call(L, lua_gettop(L) - 1, LUA_MULTRET);
  return lua_gettop(L);
}

bool any_quantity(lua_State* L) {
  for (int i = 1; i <= lua_gettop(L); ++i)
    if (luaL_testudata(L, i, type_name)) return true;
  return false;
}

int absolute(lua_State* L) {
  if (!any_quantity(L)) return call_original(L);
  const auto q = to_quantity(L, 1);
  push_quantity(L, std::abs(q->value), q->dimension);
  return 1;
}

int root(lua_State* L) {
  if (!any_quantity(L)) return call_original(L);
  return push_power(L, *to_quantity(L, 1), 0.5);
}

int extreme(lua_State* L, double sign) {
  if (!any_quantity(L)) return call_original(L);
  int best = 1;
  std::optional<core::Quantity> least;
  for (int i = 1; i <= lua_gettop(L); ++i) {
    const auto q = to_quantity(L, i);
    if (!q) return luaL_error(L, "cannot compare a quantity and a %s", luaL_typename(L, i));
    if (least && !agree(*least, *q)) return mismatch(L, "compare", *least, *q);
    if (least && sign * q->value >= sign * least->value) continue;
    least = q;
    best = i;
  }
  lua_pushvalue(L, best);
  return 1;
}

int smallest(lua_State* L) {
  return extreme(L, 1);
}
int largest(lua_State* L) {
  return extreme(L, -1);
}

}  // namespace

void make_quantities(lua_State* L) {
  luaL_newmetatable(L, type_name);
  const luaL_Reg events[] = {{"__add", guarded<add>},
                             {"__sub", guarded<subtract>},
                             {"__mul", guarded<multiply>},
                             {"__div", guarded<divide>},
                             {"__pow", guarded<power>},
                             {"__unm", guarded<negate>},
                             {"__eq", guarded<equal>},
                             {"__lt", guarded<less>},
                             {"__le", guarded<at_most>},
                             {"__tostring", guarded<to_text>},
                             {"__concat", guarded<join>},
                             {"__index", guarded<no_field>},
                             {nullptr, nullptr}};
  luaL_setfuncs(L, events, 0);
  lua_pushboolean(L, 0);
  lua_setfield(L, -2, "__metatable");
  lua_pop(L, 1);
}

void push_quantity(lua_State* L, double value, core::Dimension dimension) {
  if (dimension == core::Dimension{}) return lua_pushnumber(L, value);
  auto* held = static_cast<Held*>(lua_newuserdatauv(L, sizeof(Held), 0));
  *held = {value, dimension};
  luaL_setmetatable(L, type_name);
}

std::optional<core::Quantity> to_quantity(lua_State* L, int index) {
  if (lua_type(L, index) == LUA_TNUMBER) return core::Quantity{lua_tonumber(L, index), {}, true};
  const auto* held = static_cast<const Held*>(luaL_testudata(L, index, type_name));
  if (!held) return {};
  return core::Quantity{held->value, held->dimension, false};
}

void push_units(lua_State* L) {
  lua_newtable(L);
  for (const core::Unit& unit : core::unit_table()) {
    push_quantity(L, unit.factor, unit.dimension);
    lua_setfield(L, -2, unit.name.c_str());
  }
  seal(L, "units");
}

void extend_math(lua_State* L) {
  const luaL_Reg wrapped[] = {{"abs", guarded<absolute>},
                              {"sqrt", guarded<root>},
                              {"min", guarded<smallest>},
                              {"max", guarded<largest>},
                              {nullptr, nullptr}};
  for (const luaL_Reg* entry = wrapped; entry->name; ++entry) {
    lua_getfield(L, -1, entry->name);
    lua_pushcclosure(L, entry->func, 1);
    lua_setfield(L, -2, entry->name);
  }
}

}  // namespace ashlar::script
