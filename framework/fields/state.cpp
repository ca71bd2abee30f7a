#include "fields/state.hpp"

#include <cassert>

namespace ashlar::fields {

State::Id State::add(const std::string& name, std::size_t size) {
  if (const Id known = find(name); known >= 0) {
    assert(arrays_[known].trial.size() == size);
    return known;
  }
  arrays_.push_back({name, std::vector<double>(size), std::vector<double>(size)});
  return static_cast<Id>(arrays_.size()) - 1;
}

State::Id State::find(const std::string& name) const {
  for (std::size_t i = 0; i < arrays_.size(); ++i)
    if (arrays_[i].name == name) return static_cast<Id>(i);
  return -1;
}

void State::commit() {
  for (Array& array : arrays_) array.committed = array.trial;
}

void State::revert() {
  for (Array& array : arrays_) array.trial = array.committed;
}

std::size_t State::bytes() const {
  std::size_t sum = 0;
  for (const Array& array : arrays_) sum += 2 * sizeof(double) * array.trial.size();
  return sum;
}

std::vector<std::string> State::names() const {
  std::vector<std::string> list;
  for (const Array& array : arrays_) list.push_back(array.name);
  return list;
}

}  // namespace ashlar::fields
