#!/bin/bash -eu
# SPDX-License-Identifier: Apache-2.0
# libraries.sh SOURCES PREFIX: what the fuzz targets are linked with, static, by $CC and $CXX (with $CXXFLAGS: their C++
# library) from the sources of Debian packages unpacked in SOURCES. They are not instrumented: what is fuzzed is toolcomp.
set -o pipefail
sources=$(cd "$1" && pwd)
mkdir -p "$2"
prefix=$(cd "$2" && pwd)
jobs=$(nproc)
export CFLAGS='-O2 -fPIC'

# These decide by themselves what the processor can do, at run time: targets run elsewhere than they are built.
(cd "$sources"/gmp-* && ./configure --prefix="$prefix" --disable-shared --enable-fat --with-pic && make -j"$jobs" && make install)
(cd "$sources"/mpfr4-* && ./configure --prefix="$prefix" --disable-shared --with-pic --with-gmp="$prefix" && make -j"$jobs" && make install)
(cd "$sources"/mpfi-* && ./configure --prefix="$prefix" --disable-shared --with-pic --with-gmp="$prefix" --with-mpfr="$prefix" && make -j"$jobs" && make install)
(cd "$sources"/flint-2* && ./configure --prefix="$prefix" --disable-shared --with-gmp="$prefix" --with-mpfr="$prefix" CC="$CC" AR=ar && make -j"$jobs" library && make install)
(cd "$sources"/flint-arb-* && ./configure --prefix="$prefix" --disable-shared --with-gmp="$prefix" --with-mpfr="$prefix" --with-flint="$prefix" CC="$CC" AR=ar && make -j"$jobs" library && make install)

static() { # FOLDER [OPTION…]
  local folder=$1
  shift
  cmake -S "$folder" -B "$folder/build" -DCMAKE_INSTALL_PREFIX="$prefix" -DCMAKE_BUILD_TYPE=Release \
    -DBUILD_SHARED_LIBS=OFF -DCMAKE_POSITION_INDEPENDENT_CODE=ON -DBUILD_TESTING=OFF "$@"
  cmake --build "$folder/build" -j "$jobs"
  cmake --install "$folder/build"
}
static "$sources"/fmtlib-* -DFMT_TEST=OFF -DFMT_DOC=OFF
static "$sources"/tomlplusplus-*
static "$sources"/nlohmann-json3-* -DJSON_BuildTests=OFF
static "$sources"/eigen3-* -DEIGEN_BUILD_DOC=OFF -DEIGEN_BUILD_TESTING=OFF
