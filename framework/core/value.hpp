#pragma once
// What a script said, as plain data: the only thing that travels from the script to the rest.

#include <memory>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/error.hpp"
#include "core/units.hpp"

namespace ashlar::core {

/// A number, with the dimension it was written with. A bare number (15, not 15*u.m) fits every dimension.
struct Quantity {
  double value = 0;
  Dimension dimension;
  bool bare = true;
};

/// A table of numbers, to and from a script's function: keyed if it has names (as many as values), else a
/// list. One value of the empty name is no table but that number.
struct NumberTable {
  std::vector<std::string> names;
  std::vector<double> values;
};

/// A function from the script. Calls may come one at a time, from any thread.
class Function {
 public:
  virtual ~Function() = default;
  /// Returns the numbers that the script's function returns for these arguments (SI).
  /// Throws InputError naming the place and the arguments if it fails or gives something else.
  virtual std::vector<double> call(std::span<const double> arguments) const = 0;
  /// The one number that it returns, of this dimension if it was written with one. Throws as `call` does.
  virtual double number(std::span<const double> arguments, Dimension dimension) const;
  /// Calls with tables and reads the tables that it returns: as many as `results`, with their names, or lists
  /// of their lengths. Throws as `call` does.
  virtual void call_tables(std::span<const NumberTable> arguments, std::span<NumberTable> results) const;
};

struct Table;

/// One value of the scene, with its place.
struct Value {
  Place place;
  std::variant<std::monostate, bool, Quantity, std::string, std::shared_ptr<const Table>,
               std::shared_ptr<const Function>>
      data;

  bool is_nothing() const { return std::holds_alternative<std::monostate>(data); }
  const bool* boolean() const { return std::get_if<bool>(&data); }
  const Quantity* quantity() const { return std::get_if<Quantity>(&data); }
  const std::string* text() const { return std::get_if<std::string>(&data); }
  const Table* table() const;
  std::shared_ptr<const Function> function() const;
  /// "a number", "a table", …: for messages.
  std::string type_name() const;
};

/// A table: positional items, and keyed entries in the order of their lines (then of their names).
/// `constructor` is the word it was made with: "Polygon", "mesh.voronoi"; empty for a plain table.
struct Table {
  std::string constructor;
  std::vector<Value> items;
  std::vector<std::pair<std::string, Value>> entries;

  /// Null if there is no such entry.
  const Value* find(const std::string& key) const;
};

Value make_value(double number, Place place = {});
Value make_value(std::string text, Place place = {});
Value make_value(bool flag, Place place = {});
Value make_value(Table table, Place place = {});

}  // namespace ashlar::core
