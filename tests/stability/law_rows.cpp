#include "stability/table.hpp"
namespace ashlar::stability {
std::vector<Case> law_rows() {
  return {};
}
}  // namespace ashlar::stability
