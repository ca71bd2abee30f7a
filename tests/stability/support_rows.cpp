#include "stability/table.hpp"
namespace ashlar::stability {
std::vector<Case> support_rows() {
  return {};
}
}  // namespace ashlar::stability
