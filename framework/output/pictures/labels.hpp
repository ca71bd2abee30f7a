#pragma once
// Where the labels inside a plot stand, so that they neither leave it nor cover each other. Included by
// pictures/*.cpp only.

#include <array>
#include <vector>

#include "output/pictures/frame.hpp"

namespace ashlar::output {

class Labels {
 public:
  /// `image` says where the plot is white; a label is best on white, or wholly on colour.
  Labels(const Frame& frame, const Image& image) : frame_(frame), image_(image) {}
  /// Labels shun this place, but may take it where all others are worse.
  void shun(const Box& box) { shunned_.push_back(box); }
  /// Labels shun to cross these lines, in units of the page.
  void shun(geometry::Point a, geometry::Point b) { lines_.push_back({a, b}); }
  /// The best of some boxes of one size, given by their upper left corners and moved into the plot; earlier
  /// ones win. It is taken from then on.
  Box place(const std::vector<geometry::Point>& corners, double width, double height);
  /// Beside, above or below a mark.
  Box beside(geometry::Point mark, double off, double width, double height);
  /// Anywhere in the plot, near `wish`.
  Box near(geometry::Point wish, double width, double height);

 private:
  Box inside(geometry::Point corner, double width, double height) const;
  double cost(const Box& box) const;
  double covered(const Box& box) const;
  const Frame& frame_;
  const Image& image_;
  std::vector<Box> taken_, shunned_;
  std::vector<std::array<geometry::Point, 2>> lines_;
};

}  // namespace ashlar::output
