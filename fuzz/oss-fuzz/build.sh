#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# Builds the fuzz targets as OSS-Fuzz and ClusterFuzzLite require: with $CXX, $CXXFLAGS and $LIB_FUZZING_ENGINE, into $OUT, each with
# its seeds, dictionary and options. The build is in $WORK. TARGETS="sdo_server pdo" selects targets.
set -eu
cd "$(dirname "$(readlink -f "$0")")"
cd -P "${SRC:-/nowhere}/canproof" 2>/dev/null || cd ../..  # physical path: CMake does not accept a path through a link
source fuzz/targets.sh

# The libraries come from the distribution, which builds them with libstdc++: they are not compatible with libc++.
flags=${CXXFLAGS//-stdlib=libc++/}
build=${WORK:-build}/oss-fuzz
cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE= -DCMAKE_CXX_COMPILER="$CXX" -DCMAKE_CXX_FLAGS="$flags" -DCANPROOF_FUZZER=ON \
  -DCANPROOF_FUZZ_FLAGS= -DCANPROOF_FUZZ_LINK_FLAGS= -DCANPROOF_FUZZ_ENGINE="$LIB_FUZZING_ENGINE" \
  -DCMAKE_BUILD_WITH_INSTALL_RPATH=ON -DCMAKE_INSTALL_RPATH='$ORIGIN/lib'
targets=()
for name in $(target_names "$build"); do
  [ -n "${TARGETS:-}" ] && [[ " $TARGETS " != *" $name "* ]] || targets+=("$name")
done
cmake --build "$build" --target "${targets[@]/%/_fuzz}" ${BUILD_JOBS:+-- -j"$BUILD_JOBS"}

mkdir -p "$OUT/lib"
for name in "${targets[@]}"; do
  find_target "$build" "$name"
  cp "$build/${name}_fuzz" "$OUT/"
  # The machine that runs the fuzzers has none of these libraries, so they are copied.
  ldd "$build/${name}_fuzz" | awk '$3 ~ /lib(fmt|pugixml|tomlplusplus|socketcan|stdc\+\+|gcc_s)/ {print $3}' |
    xargs -r cp -L -n -t "$OUT/lib"
  [ ! -d "$corpus" ] || python3 - "$corpus" "$OUT/${name}_fuzz_seed_corpus.zip" <<'PYTHON'
import pathlib, sys, zipfile
with zipfile.ZipFile(sys.argv[2], "w", zipfile.ZIP_DEFLATED) as archive:
    for seed in sorted(pathlib.Path(sys.argv[1]).iterdir()):
        archive.write(seed, seed.name)
PYTHON
  [ -z "$dictionary" ] || cp "$dictionary" "$OUT/${name}_fuzz.dict"
  printf '[libfuzzer]\nmax_len = 512\n' >"$OUT/${name}_fuzz.options"
  [ -z "$options" ] || cp "$options" "$OUT/${name}_fuzz.options"
done
