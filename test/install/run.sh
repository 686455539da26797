#!/bin/bash
# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

# Installs a build without tests as a user would, moves the tree, and uses it from there:
#   run.sh WORK_FOLDER [CMAKE_OPTION...]
# The options, such as -DOpenCV_DIR=FOLDER or -DBUILD_SHARED_LIBS=OFF, are for all of its builds.
# Checks: no test package is needed; only the public headers are installed; the library exports
# cv::linespace alone and does not call cv::HoughLines (of a shared library); a CMake project and one
# with pkg-config (of a shared library) build and run; README's example runs; the installed program
# runs; nothing knows the place it was installed to first.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
work=${1:?usage: run.sh WORK_FOLDER [CMAKE_OPTION...]}
shift
prefix=$work/moved

fail() {
    echo "FAILED: $*" >&2
    exit 1
}
step() { echo "== $*"; }

step "build without tests, install, move"
rm -rf "$work/first" "$prefix" "$work/consumer"
cmake -S "$root" -B "$work/build" -G Ninja -DBUILD_TESTS=OFF -DBUILD_PERF_TESTS=OFF \
    -DOPENCV_SOURCE_DIR=/nonexistent "$@"
cmake --build "$work/build"
cmake --install "$work/build" --prefix "$work/first"
mv "$work/first" "$prefix"
! grep -rI --files-with-matches "$work" "$prefix" || fail "these files contain a path of this machine"

step "installed headers"
diff <(cd "$root/modules/linespace/include" && find . -name '*.hpp' | sort) \
    <(cd "$prefix/include" && find . -type f | sort) || fail "not just the public headers"

library=$(find "$prefix" -name 'libopencv_linespace.so')

check_symbols() {
    step "symbols"
    nm -DC --undefined-only "$library" >"$work/undefined.txt"
    ! grep -E 'cv::HoughLines|cvHoughLines' "$work/undefined.txt" || fail "calls cv::HoughLines"
    # Types W, V and u are what C++ must share (vtables, type information); the rest are ours alone.
    nm -DC --defined-only "$library" >"$work/defined.txt"
    ! grep -vE ' [WVu] | (T|B|D|R) cv::linespace::| [A-Z] (vtable|typeinfo|typeinfo name) for cv::linespace::' \
        "$work/defined.txt" | grep -vE ' [BD] (__bss_start|_edata|_end)$' || fail "exports more than cv::linespace"
    grep -q 'T cv::linespace::HoughLines' "$work/defined.txt" || fail "does not export HoughLines"
}

use_pkg_config() {
    step "pkg-config"
    export PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name opencv_linespace.pc)")
    # shellcheck disable=SC2046 # several flags
    c++ -std=c++11 "$root/test/install/consumer/main.cpp" -o "$work/consumer/by_pkg_config" \
        $(pkg-config --cflags --libs opencv_linespace) -Wl,-rpath,"$(dirname "$library")"
    "$work/consumer/by_pkg_config"
}

step "a CMake project, with README's first example"
mkdir -p "$work/consumer"
sed -n '/^```cpp$/,/^```$/p;/^```$/q' "$root/README.md" | grep -v '^```' >"$work/consumer/readme.cpp"
cmake -S "$root/test/install/consumer" -B "$work/consumer" -G Ninja \
    -DCMAKE_PREFIX_PATH="$prefix" -DREADME_EXAMPLE="$work/consumer/readme.cpp" "$@"
cmake --build "$work/consumer"
"$work/consumer/consumer"
cp "$root/doc/figures/building-lines.jpg" "$work/consumer/house.jpg"
rm -f "$work/consumer/lines.png"
(cd "$work/consumer" && ./readme_example)
[[ -s $work/consumer/lines.png ]] || fail "README's example wrote no lines.png"

if [[ $library ]]; then
    check_symbols
    use_pkg_config
fi

step "the program"
"$prefix/bin/linespace" --version
echo "All good."
