#pragma once
// Lloyd's iteration: each interior site moves to (and a little past) its cell's centroid.

#include "cover.hpp"

namespace ashlar::meshing_voronoi {

/// Moves the sites from `fixed` on; they stay outside all balls, hence inside their faces.
void relax(std::vector<Site>& sites, std::size_t fixed, const mesh::Domain& domain,
           const mesh::SizeField& sizes, const Cover& cover, int iterations);

}  // namespace ashlar::meshing_voronoi
