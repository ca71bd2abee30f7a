#include "elasticity/layout.hpp"

namespace ashlar::elasticity {

Layout::Layout(const model::Model& model) : point{0}, history{0} {
  std::vector<Index> own;
  for (Index cell = 0; cell < model.mesh.cell_count(); ++cell) {
    own.clear();
    model.dofs.append_cell(model.mesh, cell, own);
    dofs.append(own);
    const auto points =
        static_cast<std::size_t>(model.element->point_count(model.mesh.cell_points[cell].size()));
    const model::Material& law = model.material(cell);
    point.push_back(point.back() + points);
    history.push_back(history.back() + points * static_cast<std::size_t>(law.internal_variables()));
    symmetric = symmetric && law.symmetric();
  }
}

std::size_t Layout::bytes() const {
  return sizeof(Index) * (dofs.offsets().size() + dofs.values().size()) +
         sizeof(std::size_t) * (point.size() + history.size());
}

}  // namespace ashlar::elasticity
