#include "model/term.hpp"

namespace ashlar::model {

void JumpResponse::resize(Index size, int width) {
  jump.setZero(size);
  traction.setZero(size);
  jump_by.setZero(size, width);
  traction_by.setZero(size, width);
}

}  // namespace ashlar::model
