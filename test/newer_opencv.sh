#!/bin/bash
# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

# Tests the module with an OpenCV newer than the system's: newer_opencv.sh VERSION [standalone]
#
# VERSION is 4.10, 4.14, 5.0 or 5.1. The sources are PyPI's source packages, which carry OpenCV
# whole. First the library is built by itself against a reduced static OpenCV of that version, with
# warnings as errors, and README's first example runs on it. Without `standalone` the module is then
# built inside OpenCV's tree, and opencv_test_linespace and the Python test run there.
#
# OpenCV's sources and the static OpenCV are kept in $LINESPACE_NEWER_OPENCV/VERSION, by default
# under the user's cache folder; the rest is in build/newer-opencv-VERSION of the checkout. A second
# run builds what has changed. Exit status 77: the sources cannot be downloaded; it is 1 instead if
# LINESPACE_REQUIRE_BACKENDS is 1, as where every test must run.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
usage() {
    echo "newer_opencv.sh: $*" >&2
    echo "usage: newer_opencv.sh VERSION [standalone]; versions are 4.10, 4.14, 5.0 and 5.1" >&2
    exit 2
}
(($# == 1 || $# == 2)) || usage "one or two arguments are needed"
version=$1
scope=${2-all}
[[ $# == 1 || $scope == standalone ]] || usage "unknown second argument '$scope'"
case $version in
4.10)
    package=opencv-python-headless release=4.10.0.84
    hash=f2017c6101d7c2ef8d7bc3b414c37ff7f54d64413a1847d89970b6b7069b4e1a
    ;;
4.14)
    package=opencv-python-headless release=4.14.0.94
    hash=4afa2ea1214453648be88259f035712454faa9039b686de7753569ba8eec1577
    ;;
5.0)
    package=opencv-python-headless release=5.0.0.93
    hash=b82f9831daab90b725c7c1ee1b36cb5732c367096ac76d119e64e14eb70d5f3c
    ;;
5.1)
    package=opencv-contrib-python release=5.1.0.95
    hash=68e98c989685db112c28e7e921c783324cd3b14ffc0b188ae5ea59fbbfca9bfc
    ;;
*) usage "unknown version '$version'" ;;
esac
cache=${LINESPACE_NEWER_OPENCV:-${XDG_CACHE_HOME:-$HOME/.cache}/linespace-opencv}/$version
source=$cache/source-$release
build=$root/build/newer-opencv-$version
mkdir -p "$cache" "$build"

step() { echo "== $*"; }

# Two tests may want the same version at the same time.
exec 9>"$cache/lock"
flock --nonblock 9 || {
    echo "waiting for another run with OpenCV $version, which has locked $cache/lock"
    flock 9
}

fetch() {
    local download=$cache/download
    [[ -d $source ]] && return
    step "fetch $package $release"
    rm -rf "$download"
    /usr/bin/python3 -m venv "$download/python"
    echo "$package==$release --hash=sha256:$hash" >"$download/requirements.txt"
    # Only the package must be a source package: pip needs wheels of other packages to look into it.
    if ! "$download/python/bin/pip" download --quiet --no-deps --no-binary "$package" \
        --require-hashes --requirement "$download/requirements.txt" --dest "$download" \
        >"$download/pip.txt" 2>&1; then
        cat "$download/pip.txt" >&2
        if grep -q 'DO NOT MATCH THE HASHES' "$download/pip.txt"; then
            echo "FAILED: $package $release is not the package that this script knows" >&2
            exit 1
        fi
        if [[ ${LINESPACE_REQUIRE_BACKENDS:-} == 1 ]]; then
            echo "FAILED: pip cannot download $package $release" >&2
            exit 1
        fi
        echo "SKIPPED: pip cannot download $package $release, which takes a network the first time"
        exit 77
    fi
    mkdir "$download/tree"
    tar -xf "$download"/*.tar.gz -C "$download/tree" --strip-components=1
    mv "$download/tree/opencv" "$source"
    rm -rf "$download"
}

# Builds, once, what the library and the programs need of OpenCV: static libraries, which are
# installed to $cache/static/install.
build_static() {
    local options
    [[ -e $cache/static/finished-$release ]] && return
    step "a reduced static OpenCV $version"
    rm -rf "$cache/static"
    mapfile -t options < <(sed -nE 's/^ *OCV_OPTION\((WITH_[A-Z0-9_]+) .*/-D\1=OFF/p' \
        "$source/CMakeLists.txt" | grep -vE 'WITH_(PTHREADS_PF|OPENCL|JPEG|PNG)=')
    cmake -S "$source" -B "$cache/static" -G Ninja "${options[@]}" -DCMAKE_BUILD_TYPE=Release \
        "-DCMAKE_CXX_FLAGS_RELEASE=-O0 -DNDEBUG" -DBUILD_SHARED_LIBS=OFF \
        -DCMAKE_POSITION_INDEPENDENT_CODE=ON -DBUILD_LIST=core,imgproc,imgcodecs,videoio \
        -DBUILD_TESTS=OFF -DBUILD_PERF_TESTS=OFF -DBUILD_EXAMPLES=OFF -DBUILD_DOCS=OFF \
        -DBUILD_opencv_apps=OFF -DBUILD_JAVA=OFF -DBUILD_opencv_python3=OFF -DBUILD_ZLIB=OFF \
        -DCPU_BASELINE=SSE2 -DCPU_DISPATCH= -DOPENCL_INCLUDE_DIR=/usr/include/CL/ \
        -DOPENCV_GENERATE_PKGCONFIG=ON "-DCMAKE_INSTALL_PREFIX=$cache/static/install"
    cmake --build "$cache/static" --target install
    touch "$cache/static/finished-$release"
}

# Runs all tests of the module inside OpenCV's tree, in C++ and in Python.
test_in_tree() {
    step "OpenCV $version with the module inside"
    cmake --preset in-tree -B "$build/in-tree" -DOPENCV_SOURCE_DIR="$source"
    cmake --build "$build/in-tree"
    # As in test/CMakeLists.txt: OpenCV takes only GPUs by itself, and PoCL's largest work groups
    # lose memory.
    export OPENCV_OPENCL_DEVICE=${OPENCV_OPENCL_DEVICE:-:CPU:}
    export POCL_MAX_WORK_GROUP_SIZE=${POCL_MAX_WORK_GROUP_SIZE:-1024}
    export LINESPACE_REQUIRE_BACKENDS=${LINESPACE_REQUIRE_BACKENDS:-1}
    export LINESPACE_SAMPLES_DATA=$source/samples/data
    export LINESPACE_DIGESTS=$build/digests.txt # a test that is skipped without it writes this file
    step "opencv_test_linespace inside OpenCV $version"
    "$build/in-tree/opencv/bin/opencv_test_linespace" --gtest_color=no | tee "$build/tests.txt" ||
        failed=1
    step "the Python test inside OpenCV $version"
    PYTHONPATH=$build/in-tree/opencv/lib/python3 /usr/bin/python3 \
        modules/linespace/misc/python/test/test_linespace.py 2>&1 | tee "$build/python-test.txt" ||
        failed=1
}

# Builds the library and the programs by themselves, installs them and uses them as README says.
test_standalone() {
    step "the library by itself with OpenCV $version"
    test/install/run.sh "$build/standalone" -DBUILD_SHARED_LIBS=OFF \
        -DCMAKE_COMPILE_WARNING_AS_ERROR=ON \
        "-DOpenCV_DIR=$(dirname "$(find "$cache/static/install" -name OpenCVConfig.cmake)")"
}

cd "$root"
fetch
build_static
failed=0
test_standalone
[[ $scope == standalone ]] && exit
test_in_tree
step "OpenCV $version: the tests in C++ and in Python"
grep -E '^\[(==========|  PASSED  |  FAILED  | SKIPSTAT )\].* tests?' "$build/tests.txt" |
    tail -n +2 | grep -v 'TAG='
tail -n 3 "$build/python-test.txt"
exit "$failed"
