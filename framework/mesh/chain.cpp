#include "mesh/chain.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace ashlar::mesh {

std::vector<Link> chained(std::vector<Link> links, const std::vector<Point>& points) {
  auto order = [&](const Link& a, const Link& b) {
    const Point p = points[a.start], q = points[b.start];
    return std::tuple(p.x, p.y, a.number) < std::tuple(q.x, q.y, b.number);
  };
  std::sort(links.begin(), links.end(), order);
  std::multimap<Index, std::size_t> by_start;
  std::set<Index> ends;
  for (std::size_t i = 0; i < links.size(); ++i) {
    by_start.emplace(links[i].start, i);
    ends.insert(links[i].end);
  }
  std::vector<bool> taken(links.size(), false);
  std::vector<Link> result;
  auto follow = [&](std::size_t i) {
    while (!taken[i]) {
      taken[i] = true;
      result.push_back(links[i]);
      const auto [first, last] = by_start.equal_range(links[i].end);
      const auto next = std::find_if(first, last, [&](const auto& entry) { return !taken[entry.second]; });
      if (next != last) i = next->second;
    }
  };
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (!ends.contains(links[i].start)) follow(i);
  }
  for (std::size_t i = 0; i < links.size(); ++i) follow(i);
  return result;
}

}  // namespace ashlar::mesh
