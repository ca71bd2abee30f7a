#pragma once
// The wished size of cells as a function of place, shared by the generators: a base size (number, per region,
// or function), finer near sources, and nowhere growing faster than the grading allows.

#include <limits>
#include <vector>

#include "core/schema.hpp"
#include "mesh/domain.hpp"

namespace ashlar::mesh {

/// Size `size` on the segment a–b (a == b: a point) and up to `radius` from it; farther off it may grow.
struct SizeSource {
  Point a, b;
  double size = 0;
  double radius = 0;
};

class SizeField {
 public:
  /// One size for every region of the domain [m]. `grading` is the greatest slope |∇h|.
  SizeField(const Domain& domain, double size, double grading);
  SizeField(const Domain& domain, std::vector<double> region_sizes, double grading);

  /// Reads checked settings: `size` (number, map with every region, function of x and y), `grading` and the
  /// list `refine` of kind "refinement". Without `size` the base is `otherwise`. A script function is sampled
  /// once on a grid; call from the main thread. Throws InputError where the function gives no size.
  static SizeField read(const Domain& domain, const core::Settings& settings, double otherwise);

  void add(const SizeSource& source) { sources_.push_back(source); }
  /// Must be called after `add` and before `at`.
  void prepare();

  /// Wished size at p, which lies in a face of `region` (-1: the least of all regions) [m].
  double at(Point p, Index region) const;
  /// Size from the base alone, without sources.
  double base(Point p, Index region) const;
  double grading() const { return grading_; }
  double least_base() const { return least_; }
  bool has_sources() const { return !sources_.empty(); }

 private:
  struct Grid {
    Point origin;
    double step = 0;
    Index columns = 0, rows = 0;
    std::vector<double> values;
  };
  struct Node {
    Index child = -1;  ///< first of four, or -1
    Index begin = 0, end = 0;
  };
  void set_box(const Domain& domain);
  void add_region_steps(const Domain& domain);
  void sample(const core::Function& function, const core::Place& place);
  void limit_grid();
  double grid_value(Point p) const;
  double value_of(const SizeSource& source, Point p) const;
  std::vector<Index> relevant(const std::vector<Index>& candidates, Point center, double half) const;
  void build(Index node, Point center, double half, const std::vector<Index>& candidates, int depth);

  std::vector<double> region_sizes_;
  double least_ = 0, greatest_ = 0;
  double grading_ = 0.3;
  Grid grid_;
  std::vector<SizeSource> sources_;
  Point center_;
  double half_ = 0;
  Point low_, high_;
  std::vector<Node> nodes_;
  std::vector<Index> lists_;
};

}  // namespace ashlar::mesh
