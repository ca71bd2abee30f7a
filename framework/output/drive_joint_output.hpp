#pragma once
// What the laws of a joint did along their path: a table for the terminal, a CSV file, a picture.

#include "output/pictures/pictures.hpp"
#include "solve/drive_joint.hpp"

namespace ashlar::output {

/// One row a point: leg, step, opening, slip, pressure, shear, dilation, status, iterations, variables.
std::string drive_csv(const model::Drive& drive, const solve::JointDriveResult& result);
/// At most about 20 rows, the ends of legs among them.
std::string drive_table(const solve::JointDriveResult& result);
/// Shear over slip, pressure over opening, and dilation over slip: those that move. Refers to both.
Picture drive_picture(const model::Drive& drive, const solve::JointDriveResult& result);

}  // namespace ashlar::output
