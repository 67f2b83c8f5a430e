# SPDX-License-Identifier: Apache-2.0
# Sourced by scripts: the fuzz targets of a build, from the list that its configure step writes (fuzz/CMakeLists.txt).

# target_names BUILD: prints the names of all targets, one per line.
target_names() {
  cut -f 1 "$1/fuzz_targets.txt"
}

# find_target BUILD NAME: sets `corpus` (the folder of its seeds), `longest` (bytes of an input), `dictionary` (a file, or
# empty) and `options` (a file, or empty).
find_target() {
  local name folder
  corpus=
  while IFS=$'\t' read -r name folder corpus; do
    [ "$name" != "$2" ] || break
    corpus=
  done <"$1/fuzz_targets.txt"
  [ -n "$corpus" ] || { echo "$1 has no fuzz target \"$2\"; there are: $(target_names "$1" | tr '\n' ' ')" >&2; return 2; }
  longest=512
  dictionary=$folder/$2.dict
  [ -e "$dictionary" ] || dictionary=
  options=$folder/$2.options
  [ -e "$options" ] || options=
  [ -z "$options" ] || longest=$(sed -n 's/^max_len *= *//p' "$options")
}
