#pragma once
// The picture of examples/hertz: pressure along the contact, and its difference to the reference.

#include <string>

namespace ashlar::test {

/// Runs the scene at all its sizes and returns the bytes of a PNG file.
std::string hertz_picture();

}  // namespace ashlar::test
