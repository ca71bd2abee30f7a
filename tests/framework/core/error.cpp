#include "core/error.hpp"

#include <gtest/gtest.h>

namespace ashlar::core {
namespace {

TEST(error, places_and_mistakes_read_well) {
  EXPECT_EQ(to_string(Place{"scene.lua", 12, "geometry.rock.E"}), "scene.lua:12: geometry.rock.E");
  EXPECT_EQ(to_string(Place{"scene.lua", 0, ""}), "scene.lua");
  EXPECT_EQ(to_string(Place{"", 0, "mesh"}), "mesh");
  EXPECT_EQ(to_string(Place{}), "");
  EXPECT_EQ(to_string(Mistake{{"a.lua", 3, "b"}, "is wrong", "valid: c"}),
            "a.lua:3: b: is wrong\n    valid: c");
  EXPECT_EQ(to_string(Mistake{{}, "is wrong", ""}), "is wrong");
}

TEST(error, mistakes_are_thrown_together_in_order) {
  Mistakes mistakes;
  EXPECT_NO_THROW(mistakes.throw_if_any());
  mistakes.add({"b.lua", 1, ""}, "third");
  mistakes.add({"a.lua", 10, ""}, "second");
  mistakes.add({"a.lua", 9, ""}, "first");
  try {
    mistakes.throw_if_any();
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "a.lua:9: first\na.lua:10: second\nb.lua:1: third");
  }
}

TEST(error, one_table_used_twice_is_one_mistake) {
  Mistakes mistakes;
  mistakes.add({"a.lua", 4, "geometry.rock.material.E"}, "is missing");
  mistakes.add({"a.lua", 4, "geometry.dam.material.E"}, "is missing");
  mistakes.add({"a.lua", 4, "geometry.dam.material.nu"}, "is missing");
  mistakes.add({"", 0, "x.E"}, "is missing");
  mistakes.add({"", 0, "y.E"}, "is missing");
  EXPECT_EQ(mistakes.list().size(), 4u);
}

TEST(error, the_nearest_word_is_one_that_was_meant) {
  const std::vector<std::string> kinds = {"structured", "gmsh", "voronoi", "file"};
  EXPECT_EQ(nearest("voronoy", kinds), "voronoi");
  EXPECT_EQ(nearest("Voronoi", kinds), "voronoi");
  EXPECT_EQ(nearest("gmhs", kinds), "gmsh");
  EXPECT_EQ(nearest("banana", kinds), "");
  EXPECT_EQ(nearest("x", {"y"}), "");
  EXPECT_EQ(nearest("", kinds), "");
  EXPECT_EQ(did_you_mean("voronoy", kinds), "did you mean 'voronoi'? valid: structured, gmsh, voronoi, file");
  EXPECT_EQ(did_you_mean("banana", {"a"}), "valid: a");
}

}  // namespace
}  // namespace ashlar::core
