#pragma once
// A place in a file's text. Every read checks that there is something to read.

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace ashlar::meshing_file {

class Cursor {
 public:
  Cursor(std::string file, std::string_view text) : file_(std::move(file)), text_(text) {}

  /// Throws InputError naming the file and the line here (the byte while reading binary data).
  [[noreturn]] void fail(const std::string& what) const { fail_at(position_, what); }
  [[noreturn]] void fail_at(std::size_t position, const std::string& what) const;

  bool at_end();  ///< only white space is left
  std::string_view word();
  std::int64_t integer();
  double real();
  /// The rest of this line, without its end.
  std::string_view line();
  /// Text between the next two double quotes on this line.
  std::string quoted();
  /// Goes behind the next occurrence of `text`.
  void skip_behind(std::string_view text);

  template <class T>
  T raw() {
    need(sizeof(T));
    T value;
    std::memcpy(&value, text_.data() + position_, sizeof(T));
    position_ += sizeof(T);
    return value;
  }
  /// A count of things that take at least `bytes` each: more than the file can hold is a mistake.
  std::size_t count(std::int64_t claimed, std::size_t bytes) const;
  void set_binary(bool binary) { binary_ = binary; }
  /// From now on messages name the file only.
  void forget_lines() { lines_ = false; }
  std::size_t position() const { return position_; }
  const std::string& file() const { return file_; }

 private:
  void need(std::size_t bytes) const;
  void skip_space();
  std::string file_;
  std::string_view text_;
  std::size_t position_ = 0;
  bool binary_ = false;
  bool lines_ = true;
};

}  // namespace ashlar::meshing_file
