#!/bin/bash -eu
# SPDX-License-Identifier: Apache-2.0
# Builds the fuzz targets as OSS-Fuzz and ClusterFuzzLite ask for it: sources in $SRC/toolcomp, compiled by $CC and $CXX
# with $CFLAGS and $CXXFLAGS in $WORK, linked with $LIB_FUZZING_ENGINE, put into $OUT. Beside each target NAME stand its
# seeds (NAME_seed_corpus.zip), its dictionary (NAME.dict) and its options (NAME.options). Arguments are the targets to
# build; without them, all.
set -o pipefail
cd -P "$SRC/toolcomp"

# A build type of no other flags: $CFLAGS are all there are. Warnings of a compiler that is newer than ours are no errors.
cmake -S . -B "$WORK/build" -G Ninja -DCMAKE_BUILD_TYPE=Fuzzing -DTOOLCOMP_FUZZERS=ON -DTOOLCOMP_TESTS=OFF \
  -DTOOLCOMP_WERROR=OFF -DTOOLCOMP_FUZZING_ENGINE="$LIB_FUZZING_ENGINE" \
  -DCMAKE_C_COMPILER="$CC" -DCMAKE_CXX_COMPILER="$CXX" -DCMAKE_C_FLAGS="$CFLAGS" -DCMAKE_CXX_FLAGS="$CXXFLAGS" >/dev/null
[ $# -gt 0 ] || set -- toolcomp_fuzzers
# The programs that make sources on the way are sanitized too; what they leave to the system is no leak of ours.
ASAN_OPTIONS=detect_leaks=0 cmake --build "$WORK/build" --target "$@"

dictionary_of() { # NAME, with its dialect where it has one
  case $1 in
    read_setup | read_case) echo "${1#read_}" ;;
    fanuc/*) echo fanuc ;;
    heidenhain/*) echo klartext ;;
  esac
}

# Targets and their seeds have one path: fuzz/targets/X.cpp, corpus/seeds/X.
find fuzz/targets -name '*.cpp' -printf '%P\n' | sort | while read -r file; do
  path=${file%.cpp} name=$(basename "$file" .cpp)
  case " $* " in *" toolcomp_fuzzers "* | *" $name "*) ;; *) continue ;; esac
  cp "$WORK/build/$name" "$OUT/$name"
  rm -f "$OUT/${name}_seed_corpus.zip"
  (cd "corpus/seeds/$path" && zip -q -r -X "$OUT/${name}_seed_corpus.zip" .)
  cp "oss-fuzz/dictionaries/$(dictionary_of "$path").dict" "$OUT/$name.dict"
  cp oss-fuzz/target.options "$OUT/$name.options"
done
