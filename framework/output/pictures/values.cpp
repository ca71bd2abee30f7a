#include "output/pictures/values.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "geometry/polygon.hpp"

namespace ashlar::output {

using geometry::Point;
using mesh::Index;
using model::FieldResult;
using model::StageResult;

namespace {

/// One number for each point or cell.
struct Series {
  FieldResult::On on = FieldResult::On::points;
  std::vector<double> values;
  std::string unit;
};

struct Meaning {
  std::string field, component;  ///< component "": the magnitude of a vector, or the only one
};

const FieldResult* find(const StageResult& stage, const std::string& name) {
  for (const FieldResult& field : stage.fields)
    if (field.name == name) return &field;
  return nullptr;
}

int component_index(const FieldResult& field, const std::string& component) {
  const auto found = std::find(field.components.begin(), field.components.end(), component);
  return found == field.components.end() ? -1 : static_cast<int>(found - field.components.begin());
}

Meaning meaning(const std::string& quantity) {
  if (quantity == "ux" || quantity == "uy") return {"displacement", quantity.substr(1)};
  if (quantity == "sxx" || quantity == "syy" || quantity == "sxy" || quantity == "szz")
    return {"stress", quantity.substr(1)};
  if (quantity == "s1" || quantity == "s3") return {"principal_stress", quantity.substr(1)};
  const std::size_t dot = quantity.rfind('.');
  if (dot == std::string::npos) return {quantity, ""};
  return {quantity.substr(0, dot), quantity.substr(dot + 1)};
}

std::string title_of(const std::string& quantity) {
  static const std::map<std::string, std::string> titles = {
      {"displacement", "Displacement |*u*|"},
      {"ux", "Horizontal displacement *u*_{x}"},
      {"uy", "Vertical displacement *u*_{y}"},
      {"sxx", "Horizontal stress *σ*_{xx}"},
      {"syy", "Vertical stress *σ*_{yy}"},
      {"sxy", "Shear stress *τ*_{xy}"},
      {"szz", "Out-of-plane stress *σ*_{zz}"},
      {"s1", "Major principal stress *σ*_{1}"},
      {"s3", "Minor principal stress *σ*_{3}"},
      {"tmax", "Greatest shear stress in the plane *τ*_{max}"},
      {"von_mises", "Equivalent stress of von Mises *σ*_{v}"},
      {"utilisation", "Utilisation of the strength, 1 at its limit"},
      {"principal_angle", "Direction of *σ*_{1}, from *x*"},
      {"strain.xx", "Horizontal strain *ε*_{xx}"},
      {"strain.yy", "Vertical strain *ε*_{yy}"},
      {"strain.gamma_xy", "Shear strain *γ*_{xy}"}};
  const auto found = titles.find(quantity);
  if (found != titles.end()) return found->second;
  std::string text = quantity;
  // Underscores would read as subscripts, dots as the script's paths.
  std::replace(text.begin(), text.end(), '_', ' ');
  std::replace(text.begin(), text.end(), '.', ' ');
  return text;
}

std::vector<double> magnitudes(const FieldResult& field) {
  std::vector<double> values(field.values.size() / field.width);
  for (std::size_t i = 0; i < values.size(); ++i) {
    double squares = 0;
    for (int c = 0; c < field.width; ++c) squares += std::pow(field.values[i * field.width + c], 2);
    values[i] = field.width == 1 ? field.values[i] : std::sqrt(squares);
  }
  return values;
}

std::optional<Series> pick(const FieldResult* field, const std::string& component) {
  if (!field) return {};
  if (component.empty()) return Series{field->on, magnitudes(*field), field->unit};
  const int c = component_index(*field, component);
  if (c < 0) return {};
  std::vector<double> values(field->values.size() / field->width);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = field->values[i * field->width + c];
  return Series{field->on, std::move(values), field->unit};
}

// What follows from the stress, for runs whose outputs name it alone.
std::optional<Series> from_stress(const FieldResult* stress, const std::string& quantity) {
  const auto xx = pick(stress, "xx"), yy = pick(stress, "yy"), xy = pick(stress, "xy"),
             zz = pick(stress, "zz");
  if (!xx || !yy || !xy || !zz) return {};
  Series result = *xx;
  for (std::size_t i = 0; i < result.values.size(); ++i) {
    const double x = xx->values[i], y = yy->values[i], z = zz->values[i], shear = xy->values[i];
    const double middle = (x + y) / 2, radius = std::hypot((x - y) / 2, shear);
    double& value = result.values[i];
    if (quantity == "s1") value = middle + radius;
    if (quantity == "s3") value = middle - radius;
    if (quantity == "tmax") value = radius;
    if (quantity == "von_mises")
      value = std::sqrt(((x - y) * (x - y) + (y - z) * (y - z) + (z - x) * (z - x)) / 2 + 3 * shear * shear);
  }
  return result;
}

bool follows_from_stress(const std::string& quantity) {
  return quantity == "s1" || quantity == "s3" || quantity == "tmax" || quantity == "von_mises";
}

std::optional<Series> series(const StageResult& stage, const std::string& quantity, bool prefer_nodes) {
  const Meaning wanted = meaning(quantity);
  const std::string ends[] = {prefer_nodes ? "_nodes" : "", prefer_nodes ? "" : "_nodes"};
  for (const std::string& end : ends)
    if (auto found = pick(find(stage, wanted.field + end), wanted.component)) return found;
  if (!follows_from_stress(quantity)) return {};
  for (const std::string& end : ends)
    if (auto found = from_stress(find(stage, "stress" + end), quantity)) return found;
  return {};
}

double largest_in(const StageResult& stage, const std::string& name) {
  double largest = 0;
  for (const FieldResult* field : {find(stage, name), find(stage, name + "_nodes")})
    if (field)
      for (const double size : magnitudes(*field)) largest = std::max(largest, std::abs(size));
  return largest;
}

// The largest vector or tensor of the field that the quantity is taken from: the measure of its round-off.
// Strains and stresses end in the round-off of the displacements: what a body of the model's size would have
// if it were strained by them.
double whole_field(const PictureSource& source, const std::string& quantity) {
  const std::string field = meaning(quantity).field;
  double largest = largest_in(source.stage, field);
  const bool stress = follows_from_stress(quantity) || field == "stress";
  if (stress) largest = std::max(largest, largest_in(source.stage, "stress"));
  const double strain = largest_in(source.stage, "displacement") / source.model.length;
  double modulus = 0;
  for (const auto& material : source.model.materials)
    if (material) modulus = std::max(modulus, material->plane_modulus());
  if (stress) return std::max(largest, modulus * strain);
  return field == "strain" ? std::max(largest, strain) : largest;
}

std::vector<double> averaged_corners(const mesh::Mesh& mesh, const std::vector<int>& groups,
                                     const std::vector<double>& cell_values) {
  std::vector<Index> order(mesh.cell_count());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return groups[a] < groups[b]; });
  std::vector<double> sum(mesh.points.size()), corners(mesh.cell_points.values().size());
  std::vector<int> count(mesh.points.size());
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    while (end < order.size() && groups[order[end]] == groups[order[begin]]) ++end;
    for (std::size_t i = begin; i < end; ++i)
      for (const Index p : mesh.cell_points[order[i]]) {
        sum[p] += cell_values[order[i]];
        ++count[p];
      }
    for (std::size_t i = begin; i < end; ++i) {
      const auto ring = mesh.cell_points[order[i]];
      for (std::size_t c = 0; c < ring.size(); ++c)
        corners[mesh.cell_points.offsets()[order[i]] + c] = sum[ring[c]] / count[ring[c]];
    }
    for (std::size_t i = begin; i < end; ++i)
      for (const Index p : mesh.cell_points[order[i]]) sum[p] = count[p] = 0;
  }
  return corners;
}

void find_extremes(const mesh::Mesh& mesh, const Series& series, DrawnField& field) {
  const auto [least, greatest] = std::minmax_element(series.values.begin(), series.values.end());
  std::vector<Point> ring;
  auto place = [&](auto entity) {
    const auto index = static_cast<Index>(entity - series.values.begin());
    if (series.on == FieldResult::On::points) return mesh.points[index];
    ring.clear();
    for (const Index p : mesh.cell_points[index]) ring.push_back(mesh.points[p]);
    return geometry::centroid(ring);
  };
  field.least = *least;
  field.greatest = *greatest;
  field.least_at = place(least);
  field.greatest_at = place(greatest);
}

// Where the field's area lies between `low` and `high`: the share of each of `bins` equal steps. Values are
// spread evenly over each triangle about its cell's middle.
std::vector<double> area_by_value(const mesh::Mesh& mesh, const DrawnField& field, int bins) {
  std::vector<double> rise(bins + 1);  // differences between neighbours: a triangle touches two
  double total = 0;
  const auto bin = [&](double value) {
    const double t = std::clamp((value - field.low) / (field.high - field.low), 0.0, 1.0);
    return std::min(bins - 1, static_cast<int>(t * bins));
  };
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    const auto ring = mesh.cell_points[cell];
    const double* value = field.corners.data() + mesh.cell_points.offsets()[cell];
    const double middle = std::accumulate(value, value + ring.size(), 0.0) / static_cast<double>(ring.size());
    Point center;
    for (const Index p : ring) center = center + (1.0 / static_cast<double>(ring.size())) * mesh.points[p];
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::size_t next = (i + 1) % ring.size();
      const double area =
          std::abs(geometry::cross(mesh.points[ring[i]] - center, mesh.points[ring[next]] - center));
      const auto [least, most] = std::minmax({middle, value[i], value[next]});
      const int first = bin(least), last = bin(most);
      rise[first] += area / (last - first + 1);
      rise[last + 1] -= area / (last - first + 1);
      total += area;
    }
  }
  rise.pop_back();
  std::partial_sum(rise.begin(), rise.end(), rise.begin());
  for (double& share : rise) share /= total;
  return rise;
}

// Stresses peak without bound at corners and tips; a scale that follows the peak shows nothing else.
void find_range(const mesh::Mesh& mesh, DrawnField& field) {
  constexpr int bins = 2000;
  constexpr double outermost = 0.005;
  field.low = field.least;
  field.high = field.greatest;
  // A second look inside the first one's range: the bins are too coarse when the peak is far out.
  for (int look = 0; look < 2 && field.high > field.low; ++look) {
    const std::vector<double> share = area_by_value(mesh, field, bins);
    const double width = (field.high - field.low) / bins;
    int first = 0, last = bins - 1;
    for (double sum = share[0]; first < last && sum < outermost; sum += share[++first]) {
    }
    for (double sum = share[last]; last > first && sum < outermost; sum += share[--last]) {
    }
    const double low = field.low;
    field.low = low + first * width;
    field.high = low + (last + 1) * width;
  }
  // Little beyond it: then the scale may as well hold everything.
  if (field.high - field.low > 0.7 * (field.greatest - field.least)) {
    field.low = field.least;
    field.high = field.greatest;
  }
}

// Round-off is told from values by the whole field's size.
void find_kind(DrawnField& field) {
  const double noise = roundoff * field.whole;
  for (double* extreme : {&field.least, &field.greatest})
    if (std::abs(*extreme) <= noise) *extreme = 0;
  if (field.greatest - field.least > noise) return;
  field.kind = field.least == 0 && field.greatest == 0 ? DrawnField::Kind::zero : DrawnField::Kind::uniform;
}

}  // namespace

std::vector<int> material_groups(const model::Scene& scene, const mesh::Mesh& mesh) {
  std::vector<int> of_region(mesh.regions.size());
  std::map<std::string, int> seen;
  for (std::size_t r = 0; r < mesh.regions.size(); ++r) {
    // One table in the script is one material, however many regions use it.
    std::string key = "region " + std::to_string(r);
    for (const model::RegionData& region : scene.regions)
      if (region.name == mesh.regions[r] && region.material.place.line > 0)
        key = region.material.place.file + ":" + std::to_string(region.material.place.line);
    of_region[r] = seen.emplace(key, static_cast<int>(seen.size())).first->second;
  }
  std::vector<int> groups;
  groups.reserve(mesh.cell_region.size());
  for (const Index region : mesh.cell_region) groups.push_back(of_region[region]);
  return groups;
}

std::optional<DrawnField> drawn_field(const PictureSource& source, const std::string& quantity) {
  const mesh::Mesh& mesh = source.model.mesh;
  const std::vector<int> groups = material_groups(source.scene, mesh);
  const bool one_material = std::all_of(groups.begin(), groups.end(), [](int g) { return g == 0; });
  const auto found = series(source.stage, quantity, one_material);
  if (!found || found->values.empty()) return {};
  DrawnField field;
  field.title = title_of(quantity);
  field.unit = found->unit;
  field.stress = meaning(quantity).field.find("stress") != std::string::npos;
  if (found->on == FieldResult::On::cells) {
    field.corners = averaged_corners(mesh, groups, found->values);
  } else {
    field.corners.reserve(mesh.cell_points.values().size());
    for (const Index p : mesh.cell_points.values()) field.corners.push_back(found->values[p]);
  }
  if (!std::all_of(found->values.begin(), found->values.end(), [](double v) { return std::isfinite(v); }))
    return {};
  find_extremes(mesh, *found, field);
  field.whole = whole_field(source, quantity);
  find_kind(field);
  find_range(mesh, field);
  return field;
}

std::vector<std::string> quantities_of(const StageResult& stage, const std::string& word) {
  if (word == "stress") return {"sxx", "syy", "sxy", "szz"};
  if (word == "principal_stress") return {"s1", "s3"};
  if (word == "displacement") return {word};
  const FieldResult* field = find(stage, word);
  if (!field) field = find(stage, word + "_nodes");
  if (!field || field->width == 1) return {word};
  std::vector<std::string> words;
  for (const std::string& component : field->components) words.push_back(word + "." + component);
  return words;
}

}  // namespace ashlar::output
