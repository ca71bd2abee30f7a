#include "output/hdf5.hpp"

#include <stdexcept>

namespace ashlar::output::hdf5 {

namespace {

constexpr std::size_t growth = std::size_t{4} << 20;  ///< of files in memory [bytes]

void demand(herr_t status, const std::string& what) {
  if (status < 0) throw std::runtime_error("HDF5 failed at '" + what + "'");
}

Handle space(std::span<const hsize_t> sizes, const std::string& name) {
  return {H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr), H5Sclose, name};
}

Handle text_type(const std::string& name) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, name);
  demand(H5Tset_size(type.id(), H5T_VARIABLE), name);
  demand(H5Tset_cset(type.id(), H5T_CSET_UTF8), name);
  return type;
}

std::vector<const char*> pointers(const std::vector<std::string>& texts) {
  std::vector<const char*> list;
  for (const std::string& text : texts) list.push_back(text.c_str());
  return list;
}

// Times in object headers would make equal results differ.
Handle dataset(const Handle& parent, const std::string& name, hid_t type, const Handle& extent) {
  const Handle settings(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, name);
  demand(H5Pset_obj_track_times(settings.id(), false), name);
  return {H5Dcreate2(parent.id(), name.c_str(), type, extent.id(), H5P_DEFAULT, settings.id(), H5P_DEFAULT),
          H5Dclose, name};
}

void write_rows(const Handle& parent, const std::string& name, const void* data, std::size_t count,
                std::size_t columns, std::pair<hid_t, hid_t> types) {
  const std::vector<hsize_t> sizes =
      columns == 1 ? std::vector<hsize_t>{count} : std::vector<hsize_t>{count / columns, columns};
  const Handle extent = space(sizes, name);
  const Handle set = dataset(parent, name, types.first, extent);
  if (count > 0) demand(H5Dwrite(set.id(), types.second, H5S_ALL, H5S_ALL, H5P_DEFAULT, data), name);
}

// A null extent would read badly elsewhere, so a list of one is a vector of one and only `scalar` is scalar.
void write_attribute(const Handle& group, const std::string& name, const std::string& of, hid_t type,
                     hid_t memory, const Handle& extent, const void* data) {
  const Handle made(H5Acreate_by_name(group.id(), of.c_str(), name.c_str(), type, extent.id(), H5P_DEFAULT,
                                      H5P_DEFAULT, H5P_DEFAULT),
                    H5Aclose, name);
  demand(H5Awrite(made.id(), memory, data), name);
}

Handle scalar(const std::string& name) {
  return {H5Screate(H5S_SCALAR), H5Sclose, name};
}

}  // namespace

Handle::Handle(hid_t id, Close close, const std::string& what) : id_(id), close_(close) {
  if (id < 0) throw std::runtime_error("HDF5 failed at '" + what + "'");
}

Handle::~Handle() {
  if (id_ >= 0) close_(id_);
}

Handle memory_file() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "file access");
  demand(H5Pset_fapl_core(access.id(), growth, false), "file in memory");
  return {H5Fcreate("results.h5", H5F_ACC_TRUNC, H5P_DEFAULT, access.id()), H5Fclose, "file in memory"};
}

std::string image(const Handle& file) {
  demand(H5Fflush(file.id(), H5F_SCOPE_GLOBAL), "flush");
  const ssize_t size = H5Fget_file_image(file.id(), nullptr, 0);
  demand(size < 0 ? -1 : 0, "file image");
  std::string bytes(static_cast<std::size_t>(size), '\0');
  demand(H5Fget_file_image(file.id(), bytes.data(), bytes.size()) < 0 ? -1 : 0, "file image");
  return bytes;
}

Handle make_group(const Handle& parent, const std::string& name) {
  const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose, name);
  demand(H5Pset_create_intermediate_group(links.id(), 1), name);
  demand(H5Pset_char_encoding(links.id(), H5T_CSET_UTF8), name);
  return {H5Gcreate2(parent.id(), name.c_str(), links.id(), H5P_DEFAULT, H5P_DEFAULT), H5Gclose, name};
}

void write(const Handle& parent, const std::string& name, std::span<const double> values, std::size_t columns,
           const std::string& unit) {
  write_rows(parent, name, values.data(), values.size(), columns, {H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE});
  if (!unit.empty()) attribute(parent, "unit", unit, name);
}

void write(const Handle& parent, const std::string& name, std::span<const std::int32_t> values,
           std::size_t columns) {
  write_rows(parent, name, values.data(), values.size(), columns, {H5T_STD_I32LE, H5T_NATIVE_INT32});
}

void write(const Handle& parent, const std::string& name, const std::vector<std::string>& texts) {
  const Handle type = text_type(name);
  const auto list = pointers(texts);
  write_rows(parent, name, list.data(), list.size(), 1, {type.id(), type.id()});
}

void attribute(const Handle& group, const std::string& name, const std::string& text, const std::string& of) {
  const Handle type = text_type(name);
  const char* data = text.c_str();
  write_attribute(group, name, of, type.id(), type.id(), scalar(name), static_cast<const void*>(&data));
}

void attribute(const Handle& group, const std::string& name, const std::vector<std::string>& texts,
               const std::string& of) {
  const Handle type = text_type(name);
  const auto list = pointers(texts);
  const std::vector<hsize_t> sizes = {list.size()};
  write_attribute(group, name, of, type.id(), type.id(), space(sizes, name), list.data());
}

void attribute(const Handle& group, const std::string& name, std::span<const double> values,
               const std::string& of) {
  const std::vector<hsize_t> sizes = {values.size()};
  write_attribute(group, name, of, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, space(sizes, name), values.data());
}

void attribute(const Handle& group, const std::string& name, double value, const std::string& of) {
  write_attribute(group, name, of, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, scalar(name), &value);
}

void attribute(const Handle& group, const std::string& name, int value, const std::string& of) {
  write_attribute(group, name, of, H5T_STD_I32LE, H5T_NATIVE_INT, scalar(name), &value);
}

std::string link_name(const std::string& name) {
  std::string text = name;
  for (char& c : text)
    if (c == '/') c = '_';
  return text.empty() || text == "." || text == ".." ? "_" + text : text;
}

}  // namespace ashlar::output::hdf5
