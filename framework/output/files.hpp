#pragma once
// Small things that every writer of files needs.

#include <filesystem>
#include <string>
#include <string_view>

namespace ashlar::output {

/// Writes a file in one go. Throws InputError with the path and the system's reason.
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// Throws the InputError for a path that cannot be written; `error` is an errno.
[[noreturn]] void fail_to_write(const std::filesystem::path& path, int error);

/// `name` as part of a file name: letters, digits, "-", "_", "." and non-ASCII stay, the rest becomes "_".
std::string file_name(const std::string& name);

/// "01_self-weight": stages sort by file name. `number` counts from 1.
std::string stage_file_name(std::size_t number, const std::string& name);

/// The shortest text that reads back as the same number; "nan", "inf", "-inf" for what is no number.
std::string shortest(double value);

}  // namespace ashlar::output
