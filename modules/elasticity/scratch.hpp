#pragma once
// An array on the stack for the usual cells, on the heap for cells of very many corners.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace ashlar::elasticity {

template <class T, std::size_t most = 32>
class Scratch {
 public:
  explicit Scratch(std::size_t size) : size_(size) {
    if (size > most) many_.resize(size);
  }
  T* data() { return size_ > most ? many_.data() : few_.data(); }
  const T* data() const { return size_ > most ? many_.data() : few_.data(); }
  T& operator[](std::size_t i) { return data()[i]; }
  const T& operator[](std::size_t i) const { return data()[i]; }
  std::size_t size() const { return size_; }
  operator std::span<T>() { return {data(), size_}; }
  operator std::span<const T>() const { return {data(), size_}; }

 private:
  std::size_t size_;
  std::array<T, most> few_;
  std::vector<T> many_;
};

}  // namespace ashlar::elasticity
