#pragma once
// One Lua state with its limits, its sources and the places of its tables. Internal to script/.

#include <lauxlib.h>
#include <lua.h>
#include <lualib.h>

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "script/lexer.hpp"
#include "script/script.hpp"

namespace ashlar::script {

struct Source {
  std::filesystem::path path;
  std::string name;   ///< as shown to the user
  std::string chunk;  ///< as Lua names it: the name, shortened where Lua would cut it
  std::string text;
};

struct Params;

/// Why a protected run ended early.
struct Failure {
  core::Place place;
  std::string what;
  std::string advice;
};

class Machine : public std::enable_shared_from_this<Machine> {
 public:
  Machine(double seconds, std::size_t memory);
  ~Machine();
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;

  lua_State* state() const { return state_; }
  static Machine& of(lua_State* L);

  /// Runs `work` under the limits, with every Lua error caught. Exceptions of `work` pass through.
  std::optional<Failure> protect(const std::function<void(lua_State*)>& work);

  /// Raises a Lua error if the time is over or a stop was asked for. Long work in C++ must call this.
  void check_limits(lua_State* L);

  /// Compiles a source and leaves its chunk on the stack; false leaves nothing and has reported why.
  bool compile(lua_State* L, const std::filesystem::path& path, const std::string& name, std::string text);
  /// Runs the chunk on top of the stack; leaves one result.
  void run_chunk(lua_State* L);

  /// While this is set, mistakes are collected and the script goes on; else they end the call.
  core::Mistakes* mistakes = nullptr;
  /// A mistake at the script's present line. Pushes the undefined value, or raises a Lua error.
  int report(lua_State* L, const std::string& what, const std::string& advice = {});
  int report_at(lua_State* L, core::Place place, const std::string& what, const std::string& advice = {});

  /// The line that runs now.
  core::Place here(lua_State* L) const;
  /// The mark of the table at `index`: its number, or nothing if it was not written as `{…}`.
  std::optional<std::size_t> mark(lua_State* L, int index) const;
  core::Place place_of_mark(std::size_t mark) const;
  const TableLines& lines_of_mark(std::size_t mark) const { return marks_[mark].lines; }
  /// Gives an unmarked table the present line.
  void mark_here(lua_State* L, int index);
  /// The constructor's word of the table at `index`; "" for a plain one.
  std::string word(lua_State* L, int index) const;
  void set_word(lua_State* L, int index, const std::string& word);
  core::Place place_of_function(lua_State* L, int index) const;

  /// True once a limit was hit: nothing may catch that error.
  bool stopped() const { return stopped_; }
  std::vector<Source>& sources() { return sources_; }

  std::vector<std::filesystem::path> require_from;  ///< the scene's folder, then the libraries
  std::shared_ptr<Params> params;

 private:
  struct Mark {
    std::size_t source;
    TableLines lines;
  };
  struct Budget {
    std::size_t used = 0, most = 0;
  };

  static void* allocate(void* budget, void* block, std::size_t old_size, std::size_t new_size);
  static void watch(lua_State* L, lua_Debug* activation);
  static int run_work(lua_State* L);
  static int describe_error(lua_State* L);
  static int mark_table(lua_State* L);
  core::Place split_place(std::string& message, core::Place otherwise) const;
  core::Place place_of(const char* chunk, int line) const;
  Failure failure(lua_State* L, int status);

  Budget budget_;
  lua_State* state_ = nullptr;
  double seconds_;
  std::chrono::steady_clock::time_point deadline_;
  bool stopped_ = false;
  std::vector<Source> sources_;
  std::vector<Mark> marks_;
  Failure error_;
  core::Place last_;
};

/// Wraps a C function of the script: C++ exceptions become Lua errors.
template <int (*function)(lua_State*)>
int guarded(lua_State* L) {
  std::string what;
  try {
    return function(L);
  } catch (const std::exception& error) {
    what = error.what();
  }
  return luaL_error(L, "%s", what.c_str());
}

/// Reads a file whole. Throws InputError.
std::string read_text(const std::filesystem::path& path);

/// The text that a table in Lua's registry holds for the value at `index`; empty if it holds none.
std::string text_of(lua_State* L, const void* registry_key, int index);

}  // namespace ashlar::script
