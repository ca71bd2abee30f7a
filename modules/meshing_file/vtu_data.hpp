#pragma once
// Data arrays of VTK's XML files: text, base64 or appended, compressed or not.

#include <pugixml.hpp>

#include <string>
#include <vector>

#include "meshing_file/cursor.hpp"

namespace ashlar::meshing_file {

struct VtuEncoding {
  std::size_t header_bytes = 4;  ///< of counts in binary data: 4 or 8
  bool compressed = false;       ///< zlib
  bool appended_is_base64 = false;
  std::string_view appended;  ///< behind the underscore
};

/// All numbers of a data array. Integers up to 2⁵³ are exact. Fails naming the array.
std::vector<double> vtu_values(const pugi::xml_node& array, const VtuEncoding& encoding,
                               const Cursor& cursor);

}  // namespace ashlar::meshing_file
