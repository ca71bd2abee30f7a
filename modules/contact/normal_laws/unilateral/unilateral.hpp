#pragma once

#include "contact/joint_law.hpp"

namespace ashlar::contact {

/// Lips press but do not pull: g ≥ 0, p ≥ 0, g p = 0.
class Unilateral final : public NormalLaw {
 public:
  Form form() const override { return Form::rigid; }
};

}  // namespace ashlar::contact
