#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/registry.hpp"

namespace ashlar::core {
namespace {

Registry with_library(const std::string& library) {
  Registry registry;
  registry.set_opener(shared_object_opener());
  registry.add_module({"spring", "", library, false});
  registry.add_schema({"law", "spring", "law.spring", "", {}}, "spring");
  return registry;
}

std::string library(const std::string& name) {
  return std::string(LOADER_DIR) + "/loader_" + name + ".so";
}

std::string message_of(const std::string& library) {
  Registry registry = with_library(library);
  try {
    registry.make<double(double)>("law", "spring");
  } catch (const InputError& error) {
    EXPECT_TRUE(registry.open_modules().empty());
    return error.what();
  }
  return "no error";
}

TEST(loader, a_good_library_is_opened_on_the_first_call) {
  Registry registry = with_library(library("good"));
  EXPECT_TRUE(registry.open_modules().empty());
  EXPECT_EQ(registry.make<double(double)>("law", "spring")(2), 6);
  EXPECT_EQ(registry.open_modules(), std::vector<std::string>{"spring"});
}

TEST(loader, an_old_library_is_refused_before_it_registers) {
  EXPECT_NE(message_of(library("old")).find("was built for interface version"), std::string::npos);
}

TEST(loader, failures_are_told_in_the_loaders_own_words) {
  EXPECT_NE(message_of(library("unversioned")).find("undefined symbol: ashlar_module_version"),
            std::string::npos);
  EXPECT_NE(message_of(library("undefined")).find("nobody_provides_this"), std::string::npos);
  EXPECT_NE(message_of(library("nowhere")).find("No such file or directory"), std::string::npos);
  const auto text = std::filesystem::temp_directory_path() / "ashlar_no_library.so";
  std::ofstream(text)
      << "this is a text, not a library, and long enough to be read as a header of one ......";
  EXPECT_NE(message_of(text.string()).find("invalid ELF header"), std::string::npos);
  std::filesystem::remove(text);
}

}  // namespace
}  // namespace ashlar::core
