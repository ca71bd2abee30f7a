#include "model/read_sections.hpp"

#include <algorithm>

#include "core/schema.hpp"

namespace ashlar::model {

namespace {

void read_path(const core::Settings& section, SectionData& data, core::Mistakes& mistakes) {
  for (const core::Value& item : section.items) {
    if (item.is_nothing()) return;  // reported by its schema
    const auto point = core::read_point(item, {1, 0, 0}, mistakes);
    if (!point) return;
    const Point p{point->first, point->second};
    if (!data.path.empty() && data.path.back() == p)
      mistakes.add(item.place, "two neighbouring points of the section coincide");
    data.path.push_back(p);
  }
  if (data.path.size() < 2)
    mistakes.add(data.place, "a section needs at least 2 points, got " + std::to_string(data.path.size()),
                 "Section { {x1, y1}, {x2, y2} }");
  else if (data.path.size() > 2 && data.path.front() == data.path.back())
    mistakes.add(data.place, "the section ends where it begins: it has no sides and no direction");
}

}  // namespace

std::vector<SectionData> read_sections(const core::Settings& outputs, core::Mistakes& mistakes) {
  std::vector<SectionData> sections;
  for (const auto& [name, settings] : outputs.objects("sections")) {
    SectionData data{name, {}, settings.text("edge"), settings.place};
    if (data.edge.empty() && settings.items.empty() && !settings.said("edge"))
      mistakes.add(data.place, "a section needs two points or more, or an edge",
                   "Section { {x1, y1}, {x2, y2} } or Section { edge = \"region.edge\" }");
    else if (settings.said("edge") && !settings.items.empty())
      mistakes.add(settings.place_of("edge"), "a section is given by points or by an edge, not by both");
    else if (!settings.said("edge"))
      read_path(settings, data, mistakes);
    sections.push_back(std::move(data));
  }
  return sections;
}

}  // namespace ashlar::model
