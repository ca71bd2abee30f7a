#pragma once
// The few HDF5 calls that the store needs, each checked. Included by output/*.cpp only.
// A failing call throws std::runtime_error naming the object: files are made in memory, so no call here can
// fail for want of disk.

#include <hdf5.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace ashlar::output::hdf5 {

/// Closes its HDF5 object when it goes.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle(hid_t id, Close close, const std::string& what);
  ~Handle();
  Handle(Handle&& other) noexcept : id_(other.id_), close_(other.close_) { other.id_ = -1; }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  hid_t id() const { return id_; }

 private:
  hid_t id_;
  Close close_;
};

/// A new file that lives in memory until `image` gives its bytes.
Handle memory_file();
std::string image(const Handle& file);

Handle make_group(const Handle& parent, const std::string& name);

/// Datasets of rows × columns; one column gives a plain vector. An empty unit writes no attribute.
void write(const Handle& parent, const std::string& name, std::span<const double> values,
           std::size_t columns = 1, const std::string& unit = {});
void write(const Handle& parent, const std::string& name, std::span<const std::int32_t> values,
           std::size_t columns = 1);
void write(const Handle& parent, const std::string& name, const std::vector<std::string>& texts);

/// Attributes of a group, or of the dataset `of` in it.
void attribute(const Handle& group, const std::string& name, const std::string& text,
               const std::string& of = ".");
void attribute(const Handle& group, const std::string& name, const std::vector<std::string>& texts,
               const std::string& of = ".");
void attribute(const Handle& group, const std::string& name, std::span<const double> values,
               const std::string& of = ".");
void attribute(const Handle& group, const std::string& name, double value, const std::string& of = ".");
void attribute(const Handle& group, const std::string& name, int value, const std::string& of = ".");

/// A user's name as a link name: "/" becomes "_".
std::string link_name(const std::string& name);

}  // namespace ashlar::output::hdf5
