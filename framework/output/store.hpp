#pragma once
// results.h5: mesh, stages and provenance in one HDF5 file. Its layout is in README.md beside this file.

#include <filesystem>
#include <string>
#include <vector>

#include "output/record.hpp"

namespace ashlar::output {

/// Raised when the layout changes in a way that readers notice.
constexpr int store_format_version = 1;

/// The whole file as bytes; `date` (ISO 8601) is written as said. The same results give the same bytes, apart
/// from what /provenance/timings, memory and date hold.
std::string store_bytes(const RunRecord& record, const std::string& date);

/// Reading back, for tests and for runs that go on. They throw InputError with the file if it or the object
/// cannot be read. `object` is a full path such as "/stages/01 full/fields/displacement".
struct StoredNumbers {
  std::vector<double> values;
  std::size_t rows = 0, columns = 1;
};
StoredNumbers read_numbers(const std::filesystem::path& file, const std::string& object);
std::vector<std::string> read_texts(const std::filesystem::path& file, const std::string& object);
std::string read_text_attribute(const std::filesystem::path& file, const std::string& object,
                                const std::string& attribute);
double read_number_attribute(const std::filesystem::path& file, const std::string& object,
                             const std::string& attribute);
/// Names in a group, in ascending order.
std::vector<std::string> read_names(const std::filesystem::path& file, const std::string& group);

/// One setting of the scene as it was resolved.
struct SettingRow {
  std::string path, value, place;
  bool said = false;
};
/// Every setting of the scene, also inside objects, lists and maps.
std::vector<SettingRow> setting_rows(const core::Settings& root);

}  // namespace ashlar::output
