#pragma once
// What a law did along its path: a table for the terminal, a CSV file, a picture.

#include <array>
#include <string>

#include "output/pictures/pictures.hpp"
#include "solve/drive.hpp"

namespace ashlar::output {

/// Principal stresses in space, s1 ≥ s2 ≥ s3.
std::array<double, 3> principal_stresses(const model::Voigt& stress);

/// One row a point: leg, step, strains, stresses, principal stresses, iterations, internal variables v1 …
std::string drive_csv(const solve::DriveResult& result);
/// At most about 20 rows, the ends of legs among them.
std::string drive_table(const solve::DriveResult& result);
/// Stresses over the strain that moves most, and the path of (s1 + s3)/2 and (s1 − s3)/2. Refers to both.
Picture drive_picture(const model::Drive& drive, const solve::DriveResult& result);

}  // namespace ashlar::output
