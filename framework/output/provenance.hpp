#pragma once
// The /provenance group of results.h5: how these results came to be. Included by output/*.cpp only.

#include "output/hdf5.hpp"
#include "output/record.hpp"

namespace ashlar::output {

void write_provenance(const hdf5::Handle& group, const RunRecord& record, const std::string& date);

/// Versions of the libraries that write our files.
std::vector<std::pair<std::string, std::string>> output_versions();

}  // namespace ashlar::output
