#include "script/machine.hpp"

#include <atomic>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fstream>
#include <sstream>

#include "script/undefined.hpp"

namespace ashlar::script {

namespace {

std::atomic<bool> stop_wanted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "the flag is set from a signal handler");

// Addresses of these are keys in Lua's own registry.
const char marks_key = 0, words_key = 0;

constexpr int steps_between_looks = 10000;      // about 0.1 ms
constexpr std::size_t longest_chunk_name = 55;  // Lua cuts at 60
constexpr std::size_t most_mistakes = 200;
constexpr std::uintmax_t largest_source = 64u << 20;

void make_weak_table(lua_State* L, const void* key) {
  lua_newtable(L);
  lua_newtable(L);
  lua_pushliteral(L, "k");
  lua_setfield(L, -2, "__mode");
  lua_setmetatable(L, -2);
  lua_rawsetp(L, LUA_REGISTRYINDEX, key);
}

std::string seconds_text(double seconds) {
  std::ostringstream out;
  out << seconds << " s";
  return out.str();
}

}  // namespace

void request_stop() noexcept {
  stop_wanted = true;
}
void clear_stop() noexcept {
  stop_wanted = false;
}

std::string read_text(const std::filesystem::path& path) {
  std::error_code error;
  auto fail = [&](const std::string& why) {
    return core::InputError(core::Mistake{{path.string(), 0, {}}, "cannot be read: " + why, {}});
  };
  if (!std::filesystem::exists(path, error)) throw fail("there is no such file");
  if (!std::filesystem::is_regular_file(path, error)) throw fail("it is no file");
  if (std::filesystem::file_size(path, error) > largest_source) throw fail("it is larger than 64 MiB");
  std::ifstream in(path, std::ios::binary);
  if (!in) throw fail(std::strerror(errno));
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

Machine::Machine(double seconds, std::size_t memory) : budget_{0, memory}, seconds_(seconds) {
  state_ = lua_newstate(allocate, &budget_);
  if (!state_) throw std::bad_alloc();
  *static_cast<Machine**>(lua_getextraspace(state_)) = this;
  lua_sethook(state_, watch, LUA_MASKCOUNT, steps_between_looks);
  protect([](lua_State* L) {
    make_weak_table(L, &marks_key);
    make_weak_table(L, &words_key);
    make_undefined(L);
  });
}

Machine::~Machine() {
  lua_close(state_);
}

Machine& Machine::of(lua_State* L) {
  return **static_cast<Machine**>(lua_getextraspace(L));
}

void* Machine::allocate(void* data, void* block, std::size_t old_size, std::size_t new_size) {
  Budget& budget = *static_cast<Budget*>(data);
  const std::size_t held = block ? old_size : 0;  // without a block old_size is a type tag
  if (new_size == 0) {
    std::free(block);
    budget.used -= held;
    return nullptr;
  }
  if (new_size > held && new_size - held > budget.most - std::min(budget.most, budget.used)) return nullptr;
  void* moved = std::realloc(block, new_size);
  if (moved) budget.used += new_size - held;
  return moved;
}

void Machine::watch(lua_State* L, lua_Debug*) {
  Machine& machine = of(L);
  machine.last_ = machine.here(L);
  machine.check_limits(L);
}

void Machine::check_limits(lua_State* L) {
  const bool late = std::chrono::steady_clock::now() > deadline_;
  if (!late && !stop_wanted) return;
  stopped_ = true;
  if (stop_wanted) luaL_error(L, "the script was interrupted");
  luaL_error(L, "the script did not end within %s", seconds_text(seconds_).c_str());
}

namespace {

struct Work {
  const std::function<void(lua_State*)>* run;
  std::exception_ptr thrown;
};

}  // namespace

int Machine::run_work(lua_State* L) {
  Work& work = *static_cast<Work*>(lua_touserdata(L, 1));
  lua_settop(L, 0);
  try {
    (*work.run)(L);
  } catch (const std::exception&) {
    work.thrown = std::current_exception();
  }
  return 0;
}

std::optional<Failure> Machine::protect(const std::function<void(lua_State*)>& work) {
  using clock = std::chrono::steady_clock;
  deadline_ =
      clock::now() + std::chrono::duration_cast<clock::duration>(std::chrono::duration<double>(seconds_));
  stopped_ = false;
  error_ = {};
  Work data{&work, nullptr};
  const int top = lua_gettop(state_);
  lua_pushcfunction(state_, describe_error);
  lua_pushcfunction(state_, run_work);
  lua_pushlightuserdata(state_, &data);
  const int status = lua_pcall(state_, 1, 0, top + 1);
  std::optional<Failure> result;
  if (status != LUA_OK) result = failure(state_, status);
  lua_settop(state_, top);
  if (data.thrown) std::rethrow_exception(data.thrown);
  return result;
}

// Runs where the error arose, while the stack still tells the line.
int Machine::describe_error(lua_State* L) {
  Machine& machine = of(L);
  std::string what;
  if (lua_type(L, 1) == LUA_TSTRING || lua_type(L, 1) == LUA_TNUMBER || luaL_getmetafield(L, 1, "__tostring"))
    what = luaL_tolstring(L, 1, nullptr);
  else
    what = std::string("the script raised an error with a ") + luaL_typename(L, 1) + " instead of a text";
  machine.error_.place = machine.split_place(what, machine.here(L));
  machine.error_.what = what;
  return 1;
}

Failure Machine::failure(lua_State* L, int status) {
  if (status == LUA_ERRMEM)
    return {last_, "the script needs more than " + std::to_string(budget_.most >> 20) + " MiB of memory", {}};
  if (status == LUA_ERRERR && error_.what.empty()) {
    const char* text = lua_tostring(L, -1);
    error_.what = text ? text : "error inside an error";
  }
  if (error_.place.line == 0) error_.place = last_;
  return error_;
}

// "scene.lua:12: text" → its place and "text"
core::Place Machine::split_place(std::string& message, core::Place otherwise) const {
  for (const Source& source : sources_) {
    if (!message.starts_with(source.chunk + ":")) continue;
    const std::size_t digits = source.chunk.size() + 1;
    const std::size_t end = message.find_first_not_of("0123456789", digits);
    if (end == digits || end == std::string::npos || message.compare(end, 2, ": ") != 0) continue;
    otherwise = {source.name, std::atoi(message.c_str() + digits), {}};
    message.erase(0, end + 2);
    break;
  }
  return otherwise;
}

core::Place Machine::place_of(const char* chunk, int line) const {
  for (const Source& source : sources_)
    if (chunk[0] == '=' && source.chunk == chunk + 1) return {source.name, line, {}};
  return {chunk[0] == '=' ? chunk + 1 : "", line, {}};
}

core::Place Machine::here(lua_State* L) const {
  lua_Debug activation;
  for (int level = 0; lua_getstack(L, level, &activation); ++level) {
    lua_getinfo(L, "Sl", &activation);
    if (activation.currentline > 0) return place_of(activation.source, activation.currentline);
  }
  return {};
}

core::Place Machine::place_of_function(lua_State* L, int index) const {
  lua_Debug function;
  lua_pushvalue(L, index);
  lua_getinfo(L, ">S", &function);
  return function.linedefined > 0 ? place_of(function.source, function.linedefined) : core::Place{};
}

bool Machine::compile(lua_State* L, const std::filesystem::path& path, const std::string& name,
                      std::string text) {
  std::string chunk = name;
  if (chunk.size() > longest_chunk_name) chunk = "…" + chunk.substr(chunk.size() - longest_chunk_name + 3);
  sources_.push_back({path, name, chunk, text});
  MarkedSource marked = mark_tables(text, marks_.size());
  for (TableLines& lines : marked.tables) marks_.push_back({sources_.size() - 1, std::move(lines)});
  const std::string shown = "=" + chunk;
  if (luaL_loadbufferx(L, marked.text.data(), marked.text.size(), shown.c_str(), "t") == LUA_OK) return true;
  // The message must quote what the user wrote, not our marks.
  std::string what = "the tables are nested too deep";
  const std::string_view plain = without_head(text);
  if (luaL_loadbufferx(L, plain.data(), plain.size(), shown.c_str(), "t") != LUA_OK)
    what = lua_tostring(L, -1);
  lua_pop(L, 2);
  const core::Place place = split_place(what, {name, 0, {}});
  const bool comma = what.find("expected (to close '{'") != std::string::npos;
  report_at(L, place, what, comma ? "is a comma missing before it?" : "");
  lua_pop(L, 1);
  return false;
}

void Machine::run_chunk(lua_State* L) {
  lua_pushcfunction(L, mark_table);
  lua_call(L, 1, 1);
}

int Machine::mark_table(lua_State* L) {
  luaL_checkinteger(L, 1);
  luaL_checktype(L, 2, LUA_TTABLE);
  lua_settop(L, 2);
  lua_rawgetp(L, LUA_REGISTRYINDEX, &marks_key);
  lua_pushvalue(L, 2);
  lua_pushvalue(L, 1);
  lua_rawset(L, -3);
  lua_settop(L, 2);
  return 1;
}

int Machine::report(lua_State* L, const std::string& what, const std::string& advice) {
  return report_at(L, here(L), what, advice);
}

int Machine::report_at(lua_State* L, core::Place place, const std::string& what, const std::string& advice) {
  if (!mistakes)
    return luaL_error(L, "%s", core::to_string(core::Mistake{std::move(place), what, advice}).c_str());
  mistakes->add(std::move(place), what, advice);
  if (mistakes->list().size() > most_mistakes) {
    stopped_ = true;
    return luaL_error(L, "too many mistakes; reading ends here");
  }
  push_undefined(L);
  return 1;
}

std::optional<std::size_t> Machine::mark(lua_State* L, int index) const {
  index = lua_absindex(L, index);
  lua_rawgetp(L, LUA_REGISTRYINDEX, &marks_key);
  lua_pushvalue(L, index);
  lua_rawget(L, -2);
  std::optional<std::size_t> found;
  const lua_Integer number = lua_tointeger(L, -1);
  if (lua_isinteger(L, -1) && number >= 0 && static_cast<std::size_t>(number) < marks_.size())
    found = static_cast<std::size_t>(number);
  lua_pop(L, 2);
  return found;
}

core::Place Machine::place_of_mark(std::size_t mark) const {
  return {sources_[marks_[mark].source].name, marks_[mark].lines.line, {}};
}

void Machine::mark_here(lua_State* L, int index) {
  const core::Place place = here(L);
  for (std::size_t i = 0; i < sources_.size(); ++i)
    if (sources_[i].name == place.file) {
      index = lua_absindex(L, index);
      marks_.push_back({i, {place.line, {}, {}}});
      lua_rawgetp(L, LUA_REGISTRYINDEX, &marks_key);
      lua_pushvalue(L, index);
      lua_pushinteger(L, static_cast<lua_Integer>(marks_.size() - 1));
      lua_rawset(L, -3);
      lua_pop(L, 1);
      return;
    }
}

std::string text_of(lua_State* L, const void* registry_key, int index) {
  index = lua_absindex(L, index);
  lua_rawgetp(L, LUA_REGISTRYINDEX, registry_key);
  lua_pushvalue(L, index);
  lua_rawget(L, -2);
  const char* text = lua_tostring(L, -1);
  std::string word = text ? text : "";
  lua_pop(L, 2);
  return word;
}

std::string Machine::word(lua_State* L, int index) const {
  return text_of(L, &words_key, index);
}

void Machine::set_word(lua_State* L, int index, const std::string& word) {
  index = lua_absindex(L, index);
  lua_rawgetp(L, LUA_REGISTRYINDEX, &words_key);
  lua_pushvalue(L, index);
  lua_pushlstring(L, word.data(), word.size());
  lua_rawset(L, -3);
  lua_pop(L, 1);
}

}  // namespace ashlar::script
