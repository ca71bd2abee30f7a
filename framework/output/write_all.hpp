#pragma once
// The last verb of the straight line: everything that a run found goes into files.

#include <filesystem>
#include <vector>

#include "output/record.hpp"

namespace ashlar::output {

/// Writes all files that the scene's outputs ask for into `out` and returns their places, results.h5 first.
/// Results of a run that did not converge go to out/unconverged, so that earlier results stay; a later run
/// that converges removes them. Fields, vtu files and pictures are those of the stages that converged; of the
/// one that failed only its reason and iterations are kept. Throws InputError if the folder cannot be
/// written: nothing has changed then.
std::vector<std::filesystem::path> write_results(const RunRecord& record, const std::filesystem::path& out);

/// True if outputs.formats has this word ("hdf5", "vtu", "csv", "png", "svg"). What a scene without
/// outputs.formats writes: all but svg.
bool has_format(const model::Scene& scene, const std::string& format);

}  // namespace ashlar::output
