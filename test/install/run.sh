#!/bin/bash
# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

# Installs a build without tests as a user would, moves the tree, and uses it from there:
#   run.sh WORK_FOLDER [CMAKE_OPTION...]
# The options, such as -DOpenCV_DIR=FOLDER or -DBUILD_SHARED_LIBS=OFF, are for all of its builds.
# These things are checked:
# - no test package is needed, and only the public headers are installed;
# - a shared library exports cv::linespace alone and does not call cv::HoughLines;
# - a CMake project and a program with pkg-config build and run, and so does README's example;
# - the installed program runs;
# - nothing knows the place it was installed to first.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
work=${1:?usage: run.sh WORK_FOLDER [CMAKE_OPTION...]}
shift
prefix=$work/moved
shared=1
for option in "$@"; do
    case $option in
    -DBUILD_SHARED_LIBS=OFF | -DBUILD_SHARED_LIBS:BOOL=OFF) shared= ;;
    esac
done

fail() {
    echo "FAILED: $*" >&2
    exit 1
}
step() { echo "== $*"; }

step "build without tests, install, move"
rm -rf "$work/first" "$prefix" "$work/consumer" "$work/readme"
cmake -S "$root" -B "$work/build" -G Ninja -DBUILD_TESTS=OFF -DBUILD_PERF_TESTS=OFF \
    -DOPENCV_SOURCE_DIR=/nonexistent "$@"
cmake --build "$work/build"
cmake --install "$work/build" --prefix "$work/first"
mv "$work/first" "$prefix"
! grep -rIF --files-with-matches "$work" "$prefix" ||
    fail "these files contain a path of this machine"

step "installed headers"
diff <(cd "$root/modules/linespace/include" && find . -name '*.hpp' | sort) \
    <(cd "$prefix/include" && find . -type f | sort) || fail "not just the public headers"

if [[ $shared ]]; then
    library=$(find "$prefix" -name libopencv_linespace.so)
else
    library=$(find "$prefix" -name libopencv_linespace.a)
fi
[[ $library ]] || fail "no ${shared:+shared }library is installed"

check_symbols() {
    local ours
    step "symbols"
    nm -DC --undefined-only "$library" >"$work/undefined.txt"
    ! grep -E 'cv::HoughLines|cvHoughLines' "$work/undefined.txt" || fail "calls cv::HoughLines"
    nm -DC --defined-only "$library" >"$work/defined.txt"
    # C++ must share symbols of the types W, V and u (vtables, type information). The rest are ours.
    ours=' [WVu] | (T|B|D|R) cv::linespace::'
    ours+='| [A-Z] (vtable|typeinfo|typeinfo name) for cv::linespace::'
    ours+='| [BD] (__bss_start|_edata|_end)$'
    ! grep -vE "$ours" "$work/defined.txt" || fail "exports more than cv::linespace"
    grep -q 'T cv::linespace::HoughLines' "$work/defined.txt" || fail "does not export HoughLines"
}

# The pkg-config file requires that of the OpenCV of this build, which lies beside its CMake files.
use_pkg_config() {
    local file opencv_dir opencv standard=c++11 flags
    step "pkg-config"
    file=$(find "$prefix" -name opencv_linespace.pc)
    [[ $file ]] || fail "no opencv_linespace.pc is installed"
    opencv_dir=$(sed -nE 's/^OpenCV_DIR:[A-Z]+=//p' "$work/build/CMakeCache.txt")
    export PKG_CONFIG_PATH=$(dirname "$file"):$opencv_dir/../../pkgconfig
    opencv=$(sed -nE 's/^Requires: (opencv[0-9]+) .*/\1/p' "$file")
    if ! pkg-config --exists "$opencv"; then
        echo "SKIPPED: the OpenCV in $opencv_dir was built without its pkg-config file $opencv.pc"
        return
    fi
    [[ $opencv == opencv4 ]] || standard=c++17
    if [[ $shared ]]; then
        flags=$(pkg-config --cflags --libs opencv_linespace)
    else
        flags=$(pkg-config --static --cflags --libs opencv_linespace)
    fi
    # shellcheck disable=SC2086 # several flags
    c++ -std=$standard "$root/test/install/consumer/main.cpp" -o "$work/consumer/by_pkg_config" \
        $flags ${shared:+"-Wl,-rpath,$(dirname "$library")"}
    "$work/consumer/by_pkg_config"
}

# block LANGUAGE: README's first block of code in that language.
block() {
    awk -v first="\`\`\`$1" '$0 == first { inside = 1; next }
        inside && $0 == "```" { exit }
        inside' "$root/README.md"
}

step "a CMake project"
mkdir -p "$work/consumer" "$work/readme"
cmake -S "$root/test/install/consumer" -B "$work/consumer" -G Ninja \
    "-DCMAKE_PREFIX_PATH=$prefix" "$@"
cmake --build "$work/consumer"
"$work/consumer/consumer"

step "README's first example"
block cpp >"$work/readme/example.cpp"
block cmake >"$work/readme/example.cmake"
cmake -S "$root/test/install/readme_example" -B "$work/readme" -G Ninja \
    "-DCMAKE_PREFIX_PATH=$prefix" "-DEXAMPLE_CPP=$work/readme/example.cpp" \
    "-DEXAMPLE_CMAKE=$work/readme/example.cmake" "$@"
cmake --build "$work/readme"
cp "$root/doc/figures/building-lines.jpg" "$work/readme/house.jpg"
(cd "$work/readme" && ./app)
[[ -s $work/readme/lines.png ]] || fail "README's example wrote no lines.png"

if [[ $shared ]]; then
    check_symbols
else
    echo "SKIPPED: symbols, because a static library exports none"
fi
use_pkg_config

step "the program"
"$prefix/bin/linespace" --version
echo "All good."
