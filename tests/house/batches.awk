# Sorts .cpp files into batches that compile as one file each: reads "key<TAB>file" lines and puts "batch<TAB>"
# before each. A batch holds files of one key, at most `most` of them. What one file names in an anonymous
# namespace, no other file of its batch names so or hears of in a header.

# Of a file and the headers it includes: the words it keeps to itself, and those it shares. `roots` are where
# headers are looked for beside the file's own folder.
function read_names(file, own, shared,    line, inside, folder) {
  folder = file
  sub(/[^\/]*$/, "", folder)
  while ((getline line < file) > 0) {
    if (line ~ /^#include "/) include(folder, line, shared)
    else if (line ~ /^namespace \{/) inside = 1
    else if (line ~ /^}  \/\/ namespace$/) inside = 0
    else if (line ~ /^#define /) own[substr(line, 9)]
    else if (line ~ /^(int main\(|ASHLAR_MODULE\(|extern "C")/) own["a program or module has one"]
    else if (line ~ /^[A-Za-z_]/ && line !~ /^TEST/) {
      if (inside || line ~ /^static/) names_of(line, own)
      else names_of(line, shared)
    }
  }
  close(file)
}
function include(folder, line, shared,    part, header, i, place, other) {
  split(line, part, "\"")
  for (i = 0; i <= places; ++i) {
    header = (i ? roots[i] "/" : folder) part[2]
    if (header in shared) return
    if ((getline other < header) >= 0) {
      close(header)
      shared[header]
      read_names(header, shared, shared)
      return
    }
  }
}
# The word before a bracket, an equals sign or a line's end may be a name, until a body or a value begins.
function names_of(line, names,    word, rest) {
  if (line ~ /^(using|namespace|extern|#)/) return
  if (match(line, /^(class|struct|enum( class)?|union) +[A-Za-z_0-9]+/)) {
    word = substr(line, RSTART, RLENGTH)
    sub(/.* /, "", word)
    names[word]
    return
  }
  # Constants may share a line: a = 1, b = 2.
  if (line ~ /^((static|inline) )?const/) {
    rest = line
    while (match(rest, /[A-Za-z_][A-Za-z_0-9]* = /)) {
      names[substr(rest, RSTART, RLENGTH - 3)]
      rest = substr(rest, RSTART + RLENGTH)
    }
  }
  if (match(line, /[={]/)) line = substr(line, 1, RSTART)
  while (match(line, /[A-Za-z_][A-Za-z_0-9]* *(\(|=|\[|\{|;|$)/)) {
    word = substr(line, RSTART, RLENGTH)
    sub(/[^A-Za-z_0-9].*/, "", word)
    names[word]
    line = substr(line, RSTART + RLENGTH)
  }
}
function clashes(batch,    name) {
  for (name in own)
    if ((batch, name) in owned || (batch, name) in known) return 1
  for (name in shared)
    if ((batch, name) in owned) return 1
  return 0
}
BEGIN {
  FS = "\t"
  places = split("framework modules tests", roots, " ")
}
{
  delete own
  delete shared
  read_names($2, own, shared)
  for (batch = first[$1] ? first[$1] : 1; batch <= batches; ++batch)
    if (key[batch] == $1 && count[batch] < most && !clashes(batch)) break
  if (batch > batches) {
    key[++batches] = $1
    if (!first[$1]) first[$1] = batches
  }
  ++count[batch]
  for (name in own) owned[batch, name]
  for (name in shared) known[batch, name]
  print batch "\t" $0
}
