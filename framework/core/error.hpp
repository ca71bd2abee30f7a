#pragma once
// A user's mistake has a place. Mistakes are collected, so that one run reports them all.

#include <stdexcept>
#include <string>
#include <vector>

namespace ashlar::core {

/// Where a value was written: file, line (1-based, 0 = unknown) and the path inside the scene's table,
/// such as "geometry.rock.material.E".
struct Place {
  std::string file;
  int line = 0;
  std::string path;
};

/// "scene.lua:12: geometry.rock.material.E" with the parts that are known.
std::string to_string(const Place& place);

/// One mistake: what is wrong, and what would be valid (may be empty).
struct Mistake {
  Place place;
  std::string what;
  std::string advice;
};

/// "scene.lua:12: geometry.rock.E: must be above 0 Pa, got -5 Pa\n    valid: …"
std::string to_string(const Mistake& mistake);

/// Thrown once, with every mistake found. The program turns it into exit code 2.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<Mistake> mistakes);
  explicit InputError(Mistake mistake);
  const std::vector<Mistake>& mistakes() const { return mistakes_; }

 private:
  std::vector<Mistake> mistakes_;
};

/// Collects mistakes while checking goes on.
class Mistakes {
 public:
  void add(Place place, std::string what, std::string advice = {});
  void add(const InputError& error);
  bool empty() const { return list_.empty(); }
  const std::vector<Mistake>& list() const { return list_; }
  /// Throws InputError with all mistakes, ordered by file and line, if there are any.
  void throw_if_any() const;

 private:
  std::vector<Mistake> list_;
};

/// The nearest of `valid` to `word` by edit distance; empty if none is near enough to be meant.
std::string nearest(const std::string& word, const std::vector<std::string>& valid);

/// "did you mean 'voronoi'? valid: structured, gmsh, voronoi": the advice for a wrong word.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& valid);

}  // namespace ashlar::core
