#include "core/units.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <stdexcept>

namespace ashlar::core {
namespace {

const Dimension none{}, metre{1, 0, 0}, pascal{-1, 1, -2}, newton{1, 1, -2};

const Unit& unit(const std::string& name) {
  for (const Unit& u : unit_table())
    if (u.name == name) return u;
  throw std::out_of_range(name);
}

TEST(units, the_table_agrees_with_the_definitions) {
  EXPECT_DOUBLE_EQ(unit("deg").factor, std::numbers::pi / 180);
  EXPECT_EQ(unit("deg").dimension, none);
  EXPECT_DOUBLE_EQ(unit("year").factor, 31557600.0);
  EXPECT_EQ(unit("GPa").factor, 1e9);
  EXPECT_EQ(unit("GPa").dimension, pascal);
  EXPECT_EQ(unit("J").dimension, newton * metre);
  EXPECT_EQ(unit("W").dimension, unit("J").dimension / unit("s").dimension);
}

TEST(units, dimensions_are_parsed) {
  EXPECT_EQ(parse_dimension("Pa"), pascal);
  EXPECT_EQ(parse_dimension("kN/m^3"), newton / power(metre, 3));
  EXPECT_EQ(parse_dimension("m / s^2"), (Dimension{1, 0, -2}));
  EXPECT_EQ(parse_dimension("1/m"), power(metre, -1));
  EXPECT_EQ(parse_dimension("m^-2"), power(metre, -2));
  EXPECT_EQ(parse_dimension("kg/m/s"), (Dimension{-1, 1, -1}));
  EXPECT_EQ(parse_dimension(""), none);
  EXPECT_EQ(parse_dimension("1"), none);
  for (const char* wrong : {"Pascal", "m^", "m^x", "m//s", "m^1.5", "m^99", "*"})
    EXPECT_THROW(parse_dimension(wrong), std::invalid_argument) << wrong;
}

TEST(units, every_name_of_a_dimension_reads_back) {
  for (int l = -4; l <= 4; ++l)
    for (int m = -2; m <= 2; ++m)
      for (int t = -4; t <= 4; ++t) {
        const Dimension d{static_cast<std::int8_t>(l), static_cast<std::int8_t>(m),
                          static_cast<std::int8_t>(t)};
        EXPECT_EQ(parse_dimension(to_string(d)), d) << to_string(d);
      }
  EXPECT_EQ(to_string(pascal), "Pa");
  EXPECT_EQ(to_string(pascal / metre), "N/m^3");
  EXPECT_EQ(to_string(Dimension{1, 0, -2}), "m/s^2");
  EXPECT_EQ(to_string(Dimension{-3, 1, 0}), "kg/m^3");
  EXPECT_EQ(to_string(Dimension{-1, 0, 0}), "1/m");
}

TEST(units, quantities_get_readable_prefixes) {
  EXPECT_EQ(format_quantity(1e10, pascal), "10 GPa");
  EXPECT_EQ(format_quantity(0.0032, metre), "3.2 mm");
  EXPECT_EQ(format_quantity(-5, pascal), "-5 Pa");
  EXPECT_EQ(format_quantity(0.3, none), "0.3");
  EXPECT_EQ(format_quantity(0, metre), "0 m");
  EXPECT_EQ(format_quantity(24e3, parse_dimension("N/m^3")), "24 kN/m^3");
  EXPECT_EQ(format_quantity(999.9999999999999, metre), "1 km");
  EXPECT_EQ(format_quantity(9.81, Dimension{1, 0, -2}), "9.81 m/s^2");
}

}  // namespace
}  // namespace ashlar::core
