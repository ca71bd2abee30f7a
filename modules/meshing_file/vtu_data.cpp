#include "meshing_file/vtu_data.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>

namespace ashlar::meshing_file {

namespace {

// zlib packs at most 1032 : 1; what claims more is not honest.
constexpr std::size_t best_compression = 1100;
constexpr std::size_t largest_array = std::size_t{1} << 28;  // bytes

class ArrayReader {
 public:
  ArrayReader(const pugi::xml_node& array, const VtuEncoding& encoding, const Cursor& cursor)
      : array_(array), encoding_(encoding), cursor_(cursor), type_(array.attribute("type").value()) {}

  std::vector<double> read() {
    const std::string format = array_.attribute("format").as_string("ascii");
    if (format == "ascii") return from_text();
    if (format == "binary") return from_bytes(unpacked(base64(array_.text().get())));
    if (format == "appended") return from_bytes(unpacked(appended()));
    fail("has the unknown format '" + format + "'");
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    cursor_.fail("data array '" + std::string(array_.attribute("Name").value()) + "' " + what);
  }

  std::vector<double> from_text() const {
    Cursor text(cursor_.file(), array_.text().get());
    std::vector<double> values;
    try {
      while (!text.at_end()) values.push_back(text.real());
    } catch (const std::exception&) {
      fail("holds something that is no number");
    }
    return values;
  }

  std::string appended() const {
    const std::size_t offset = array_.attribute("offset").as_ullong(std::string_view::npos);
    if (offset >= encoding_.appended.size()) fail("starts behind the end of the file");
    const std::string_view rest = encoding_.appended.substr(offset);
    return encoding_.appended_is_base64 ? base64(rest) : std::string(rest);
  }

  // Parts that were padded on their own may follow each other. Ends at what is not base64.
  static std::string base64(std::string_view text) {
    static const std::array<int, 256> digit = [] {
      std::array<int, 256> table{};
      table.fill(-1);
      const std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
      for (std::size_t i = 0; i < digits.size(); ++i)
        table[static_cast<unsigned char>(digits[i])] = static_cast<int>(i);
      return table;
    }();
    std::string bytes;
    unsigned bits = 0;
    int filled = 0, padding = 0;
    for (const char c : text) {
      if (c == ' ' || c == '\n' || c == '\r' || c == '\t') continue;
      const int value = digit[static_cast<unsigned char>(c)];
      if (value < 0 && c != '=') break;
      padding += c == '=';
      bits = (bits << 6 | static_cast<unsigned>(std::max(value, 0))) & 0xffffffU;
      if (++filled < 4) continue;
      for (int k = 0; k < 3 - std::min(padding, 3); ++k)
        bytes.push_back(static_cast<char>(bits >> (16 - 8 * k) & 0xffU));
      bits = 0, filled = 0, padding = 0;
    }
    return bytes;
  }

  std::size_t header(const std::string& bytes, std::size_t number) const {
    const std::size_t width = encoding_.header_bytes;
    if (bytes.size() < (number + 1) * width) fail("is too short");
    std::uint64_t value = 0;
    std::memcpy(&value, bytes.data() + number * width, width);
    return value;
  }

  std::string unpacked(const std::string& bytes) const {
    const std::size_t width = encoding_.header_bytes;
    const std::size_t first = header(bytes, 0);
    if (!encoding_.compressed) {
      if (first > bytes.size() - width) fail("is too short");
      return bytes.substr(width, first);
    }
    if (first == 0) return {};
    if (first > bytes.size() / width) fail("has a wrong count of blocks");
    const std::size_t block = header(bytes, 1), last = header(bytes, 2);
    if (block > best_compression * bytes.size() || last > best_compression * bytes.size())
      fail("has a wrong size of blocks");
    std::string result;
    std::size_t at = (3 + first) * width;
    if (at > bytes.size()) fail("is too short");
    for (std::size_t b = 0; b < first; ++b) {
      const std::size_t packed = header(bytes, 3 + b), size = b + 1 == first && last > 0 ? last : block;
      if (packed > bytes.size() - at || size > best_compression * std::max<std::size_t>(packed, 1))
        fail("has a block of wrong size");
      if (result.size() + size > largest_array) fail("is larger than 256 MB");
      inflate(bytes, at, packed, size, result);
      at += packed;
    }
    return result;
  }

  void inflate(const std::string& bytes, std::size_t at, std::size_t packed, std::size_t size,
               std::string& result) const {
    const std::size_t before = result.size();
    result.resize(before + size);
    uLongf made = size;
    const int status = uncompress(reinterpret_cast<Bytef*>(result.data() + before), &made,
                                  reinterpret_cast<const Bytef*>(bytes.data() + at), packed);
    if (status != Z_OK || made != size) fail("cannot be uncompressed");
  }

  template <class T>
  std::vector<double> numbers(const std::string& bytes) const {
    if (bytes.size() % sizeof(T) != 0) fail("ends within a number");
    std::vector<double> values(bytes.size() / sizeof(T));
    for (std::size_t i = 0; i < values.size(); ++i) {
      T value;
      std::memcpy(&value, bytes.data() + i * sizeof(T), sizeof(T));
      values[i] = static_cast<double>(value);
    }
    return values;
  }

  std::vector<double> from_bytes(const std::string& bytes) const {
    if (type_ == "Float64") return numbers<double>(bytes);
    if (type_ == "Float32") return numbers<float>(bytes);
    if (type_ == "Int64") return numbers<std::int64_t>(bytes);
    if (type_ == "UInt64") return numbers<std::uint64_t>(bytes);
    if (type_ == "Int32") return numbers<std::int32_t>(bytes);
    if (type_ == "UInt32") return numbers<std::uint32_t>(bytes);
    if (type_ == "Int16") return numbers<std::int16_t>(bytes);
    if (type_ == "UInt16") return numbers<std::uint16_t>(bytes);
    if (type_ == "Int8") return numbers<std::int8_t>(bytes);
    if (type_ == "UInt8") return numbers<std::uint8_t>(bytes);
    fail("has the unknown type '" + type_ + "'");
  }

  const pugi::xml_node& array_;
  const VtuEncoding& encoding_;
  const Cursor& cursor_;
  std::string type_;
};

}  // namespace

std::vector<double> vtu_values(const pugi::xml_node& array, const VtuEncoding& encoding,
                               const Cursor& cursor) {
  return ArrayReader(array, encoding, cursor).read();
}

}  // namespace ashlar::meshing_file
