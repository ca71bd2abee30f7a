#include <algorithm>
#include <stdexcept>

#include "core/error.hpp"
#include "output/hdf5.hpp"
#include "output/store.hpp"

namespace ashlar::output {

using hdf5::Handle;

namespace {

namespace fs = std::filesystem;

// The readers say which file and object was meant, not which HDF5 call stumbled.
template <class Read>
auto reading(const fs::path& file, const std::string& object, Read read) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  try {
    const Handle opened(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, file.string());
    return read(opened);
  } catch (const std::runtime_error&) {
    throw core::InputError(core::Mistake{{file.string(), 0, object}, "cannot be read as Ashlar results", ""});
  }
}

void demand(herr_t status, const std::string& what) {
  if (status < 0) throw std::runtime_error(what);
}

std::vector<std::string> copy_texts(std::vector<char*>& raw, hid_t type, hid_t space) {
  std::vector<std::string> texts;
  for (const char* text : raw) texts.emplace_back(text ? text : "");
  H5Dvlen_reclaim(type, space, H5P_DEFAULT, raw.data());
  return texts;
}

Handle open_set(const Handle& file, const std::string& object) {
  return {H5Dopen2(file.id(), object.c_str(), H5P_DEFAULT), H5Dclose, object};
}

Handle open_attribute(const Handle& file, const std::string& object, const std::string& name) {
  return {H5Aopen_by_name(file.id(), object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose, name};
}

}  // namespace

StoredNumbers read_numbers(const fs::path& file, const std::string& object) {
  return reading(file, object, [&](const Handle& opened) {
    const Handle set = open_set(opened, object);
    const Handle space(H5Dget_space(set.id()), H5Sclose, object);
    hsize_t sizes[2] = {0, 1};
    const int rank = H5Sget_simple_extent_ndims(space.id());
    if (rank < 1 || rank > 2) throw std::runtime_error(object);
    H5Sget_simple_extent_dims(space.id(), sizes, nullptr);
    StoredNumbers numbers;
    numbers.rows = sizes[0];
    numbers.columns = sizes[1];
    numbers.values.resize(numbers.rows * numbers.columns);
    demand(H5Dread(set.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.values.data()),
           object);
    return numbers;
  });
}

std::vector<std::string> read_texts(const fs::path& file, const std::string& object) {
  return reading(file, object, [&](const Handle& opened) {
    const Handle set = open_set(opened, object);
    const Handle space(H5Dget_space(set.id()), H5Sclose, object);
    const Handle type(H5Dget_type(set.id()), H5Tclose, object);
    std::vector<char*> raw(
        static_cast<std::size_t>(std::max<hssize_t>(0, H5Sget_simple_extent_npoints(space.id()))));
    if (raw.empty()) return std::vector<std::string>();
    demand(H5Tis_variable_str(type.id()) > 0 ? 0 : -1, object);
    demand(H5Dread(set.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, raw.data()), object);
    return copy_texts(raw, type.id(), space.id());
  });
}

std::string read_text_attribute(const fs::path& file, const std::string& object,
                                const std::string& attribute) {
  return reading(file, object, [&](const Handle& opened) {
    const Handle found = open_attribute(opened, object, attribute);
    const Handle space(H5Aget_space(found.id()), H5Sclose, attribute);
    const Handle type(H5Aget_type(found.id()), H5Tclose, attribute);
    if (H5Sget_simple_extent_npoints(space.id()) != 1 || H5Tis_variable_str(type.id()) <= 0)
      throw std::runtime_error(attribute);
    std::vector<char*> raw(1);
    demand(H5Aread(found.id(), type.id(), raw.data()), attribute);
    return copy_texts(raw, type.id(), space.id()).front();
  });
}

double read_number_attribute(const fs::path& file, const std::string& object, const std::string& attribute) {
  return reading(file, object, [&](const Handle& opened) {
    const Handle found = open_attribute(opened, object, attribute);
    const Handle space(H5Aget_space(found.id()), H5Sclose, attribute);
    if (H5Sget_simple_extent_npoints(space.id()) != 1) throw std::runtime_error(attribute);
    double value = 0;
    demand(H5Aread(found.id(), H5T_NATIVE_DOUBLE, &value), attribute);
    return value;
  });
}

std::vector<std::string> read_names(const fs::path& file, const std::string& group) {
  return reading(file, group, [&](const Handle& opened) {
    const Handle found(H5Gopen2(opened.id(), group.c_str(), H5P_DEFAULT), H5Gclose, group);
    H5G_info_t info{};
    demand(H5Gget_info(found.id(), &info), group);
    std::vector<std::string> names;
    for (hsize_t i = 0; i < info.nlinks; ++i) {
      const auto length =
          H5Lget_name_by_idx(found.id(), ".", H5_INDEX_NAME, H5_ITER_INC, i, nullptr, 0, H5P_DEFAULT);
      demand(length < 0 ? -1 : 0, group);
      std::string name(static_cast<std::size_t>(length), '\0');
      H5Lget_name_by_idx(found.id(), ".", H5_INDEX_NAME, H5_ITER_INC, i, name.data(), name.size() + 1,
                         H5P_DEFAULT);
      names.push_back(name);
    }
    return names;
  });
}

}  // namespace ashlar::output
