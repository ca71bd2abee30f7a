#pragma once
// An array on the stack for the usual cells, on the heap for cells of very many corners. Its entries have no
// values at first: filling all the room that a cell might need would cost as much as the element.

#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

namespace ashlar::elasticity {

template <class T, std::size_t most = 32>
class Scratch {
  // Bytes become such entries by being assigned.
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

 public:
  explicit Scratch(std::size_t size) : size_(size) {
    if (size > most) many_.resize(size);
  }
  T* data() { return size_ > most ? many_.data() : reinterpret_cast<T*>(few_); }
  const T* data() const { return size_ > most ? many_.data() : reinterpret_cast<const T*>(few_); }
  T& operator[](std::size_t i) { return data()[i]; }
  const T& operator[](std::size_t i) const { return data()[i]; }
  std::size_t size() const { return size_; }
  operator std::span<T>() { return {data(), size_}; }
  operator std::span<const T>() const { return {data(), size_}; }

 private:
  std::size_t size_;
  alignas(T) std::byte few_[most * sizeof(T)];
  std::vector<T> many_;
};

}  // namespace ashlar::elasticity
