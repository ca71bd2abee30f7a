#pragma once
// A schema is the one list of a kind's parameters. Reading, checking, did-you-mean, `describe`
// and the generated reference all come from it.

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/value.hpp"

namespace ashlar::core {

class Registry;

/// The forms a parameter may take. Several may be allowed at once (`number | function`).
enum class Form : unsigned {
  boolean = 1,
  number = 2,
  integer = 4,
  text = 8,
  point = 16,      ///< two numbers {x, y}, all with the parameter's dimension
  list = 32,       ///< positional items only
  map = 64,        ///< keyed entries only; keys are the user's own names
  object = 128,    ///< an entry of a registered kind: `name` or `kind.name { … }`
  function = 256,  ///< a Lua function
  table = 512,     ///< any table; whoever reads it checks it
};
constexpr unsigned operator|(Form a, Form b) {
  return static_cast<unsigned>(a) | static_cast<unsigned>(b);
}
constexpr unsigned operator|(unsigned a, Form b) {
  return a | static_cast<unsigned>(b);
}
constexpr bool allows(unsigned forms, Form form) {
  return (forms & static_cast<unsigned>(form)) != 0;
}

/// An interval; an open end excludes the limit itself.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false;
  bool high_open = false;
  bool contains(double x) const;
  bool unbounded() const;
};

struct Schema;

struct Parameter {
  std::string key;  ///< "" for the positional items of a list-like kind
  unsigned forms = 0;
  Dimension dimension;  ///< of numbers, points, and what functions return
  bool required = false;
  std::optional<Value> fallback;     ///< the default; absent: optional without a default
  Range range;                       ///< outside: an error
  Range usual;                       ///< outside: a warning ("did you forget a unit?")
  std::vector<std::string> choices;  ///< allowed words, if not empty
  std::string refers;  ///< the word (or the map's keys) names an "edge", "region", "joint", "lip", "probe"
                       ///< or "stage" of the scene, or a "file" that must be there (from the script's folder)
  std::string kind;    ///< for objects (and objects inside lists and maps): the registered kind
  std::shared_ptr<const Parameter> each;  ///< what every item of a list, map or point must be
  bool numerical = false;                 ///< a numerical knob: its default is logged
  std::string doc;
};

/// Keys that say the same thing in different ways: from `least` to `most` of them may be said.
struct Alternative {
  std::vector<std::string> keys;
  int least = 1, most = 1;
};

/// "exactly one of size and cells", "at most one of factor and stiffness".
std::string to_string(const Alternative& alternative);

/// The parameters of one registered entry, such as mesh.voronoi.
struct Schema {
  std::string kind;         ///< "mesh"
  std::string name;         ///< "voronoi"
  std::string constructor;  ///< the word in scripts: "mesh.voronoi", "Polygon"
  std::string doc;
  std::vector<Parameter> parameters;
  std::vector<Alternative> alternatives = {};
  bool usual = false;  ///< the one taken where a scene names none of its kind
  const Parameter* find(const std::string& key) const;
  std::vector<std::string> keys() const;
};

/// A table checked against a schema: every parameter typed, defaults filled in and marked.
class Settings {
 public:
  struct Entry {
    std::string key;
    Value value;        ///< nothing if it was not said and has no default
    bool said = false;  ///< false: the default
    Dimension dimension;
    std::shared_ptr<const Settings> object;  ///< for objects: their own settings
    std::vector<std::pair<std::string, Settings>>
        objects;  ///< objects inside a list (names "1", "2" …) or map
  };

  // Settings hold settings: compilers need these declared before Entry's copies are asked for.
  Settings();
  ~Settings();
  Settings(const Settings& other);
  Settings(Settings&& other) noexcept;
  Settings& operator=(const Settings& other);
  Settings& operator=(Settings&& other) noexcept;

  std::string kind;
  std::string name;
  Place place;
  std::vector<Entry> entries;
  std::vector<Value> items;  ///< positional items

  bool has(const std::string& key) const;  ///< it was said, or has a default
  bool said(const std::string& key) const;
  const Entry* find(const std::string& key) const;   ///< null if there is no such entry
  const Entry& entry(const std::string& key) const;  ///< asserts that the schema has this key
  const Value& value(const std::string& key) const;
  double number(const std::string& key) const;
  double number(const std::string& key,
                double otherwise) const;  ///< if nothing was said and no default exists
  int integer(const std::string& key) const;
  bool flag(const std::string& key) const;
  std::string text(const std::string& key) const;
  std::pair<double, double> point(const std::string& key) const;
  const Settings& object(const std::string& key) const;
  const std::vector<std::pair<std::string, Settings>>& objects(const std::string& key) const;
  Place place_of(const std::string& key) const;
  /// Every required parameter of `schema` is there and sound.
  bool complete(const Schema& schema) const;
};

/// Checks `value` against `schema`. Every mistake goes to `mistakes` with its place; values that are wrong
/// are left at nothing. `registry` gives the schemas of objects. Warnings (usual ranges) go to the log.
Settings check(const Value& value, const Schema& schema, const Registry& registry, Mistakes& mistakes);

/// Numbers of a point-like value {x, y}; reports to `mistakes` and returns nothing if it is not one.
std::optional<std::pair<double, double>> read_point(const Value& value, Dimension dimension,
                                                    Mistakes& mistakes);

/// One number of the given dimension; reports to `mistakes` and returns nothing if it is not one. A value
/// that is nothing was reported where it became so.
std::optional<double> read_number(const Value& value, Dimension dimension, Mistakes& mistakes);

/// "a number (Pa) or a function": the forms a parameter takes.
std::string forms_text(const Parameter& parameter);

/// "above 0 Pa and at most 10 GPa"; "" if unbounded.
std::string to_string(const Range& range, Dimension dimension);

/// What `ashlar describe` prints for a schema.
std::string describe(const Schema& schema);

}  // namespace ashlar::core
