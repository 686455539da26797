#!/bin/bash
# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

# Tests the module with an OpenCV newer than the system's: newer_opencv.sh VERSION [standalone]
#
# VERSION is 4.10, 4.14, 5.0 or 5.1. The sources are PyPI's source packages, which carry OpenCV whole. Without
# `standalone` the module is built inside OpenCV's tree, and opencv_test_linespace and the Python
# test run there. Then the library is built by itself against a reduced static OpenCV of that
# version, with warnings as errors, and README's first example runs on it.
#
# Everything is kept in $LINESPACE_NEWER_OPENCV/VERSION, by default under the user's cache folder,
# so that a second run builds what has changed.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
version=${1:?usage: newer_opencv.sh VERSION [standalone]}
scope=${2:-all}
case $version in
4.10) package=opencv-python-headless release=4.10.0.84 ;;
4.14) package=opencv-python-headless release=4.14.0.94 ;;
5.0) package=opencv-python-headless release=5.0.0.93 ;;
5.1) package=opencv-contrib-python release=5.1.0.95 ;;
*)
    echo "newer_opencv.sh: unknown version '$version'; known are 4.10, 4.14, 5.0 and 5.1" >&2
    exit 2
    ;;
esac
work=${LINESPACE_NEWER_OPENCV:-${XDG_CACHE_HOME:-$HOME/.cache}/linespace-opencv}/$version
source=$work/source-$release
mkdir -p "$work"

step() { echo "== $*"; }

# Two tests may want the same version at the same time.
exec 9>"$work/lock"
flock 9

fetch() {
    [[ -d $source ]] && return
    step "fetch $package $release"
    rm -rf "$work/download"
    /usr/bin/python3 -m venv "$work/download/python"
    # Of the package itself no wheel; of what pip needs to look into it, wheels.
    "$work/download/python/bin/pip" download --quiet --no-deps --no-binary "$package" \
        --dest "$work/download" "$package==$release"
    mkdir "$work/download/tree"
    tar -xf "$work"/download/*.tar.gz -C "$work/download/tree" --strip-components=1
    mv "$work/download/tree/opencv" "$source"
    rm -rf "$work/download"
}

# What the library and the programs need of OpenCV, as static libraries in $work/static/install, once.
build_static() {
    local options
    [[ -e $work/static/finished-$release ]] && return
    step "a reduced static OpenCV $version"
    rm -rf "$work/static"
    mapfile -t options < <(sed -nE 's/^ *OCV_OPTION\((WITH_[A-Z0-9_]+) .*/-D\1=OFF/p' \
        "$source/CMakeLists.txt" | grep -vE 'WITH_(PTHREADS_PF|OPENCL|JPEG|PNG)=')
    cmake -S "$source" -B "$work/static" -G Ninja "${options[@]}" -DCMAKE_BUILD_TYPE=Release \
        "-DCMAKE_CXX_FLAGS_RELEASE=-O0 -DNDEBUG" -DBUILD_SHARED_LIBS=OFF \
        -DCMAKE_POSITION_INDEPENDENT_CODE=ON -DBUILD_LIST=core,imgproc,imgcodecs,videoio \
        -DBUILD_TESTS=OFF -DBUILD_PERF_TESTS=OFF -DBUILD_EXAMPLES=OFF -DBUILD_DOCS=OFF \
        -DBUILD_opencv_apps=OFF -DBUILD_JAVA=OFF -DBUILD_opencv_python3=OFF -DBUILD_ZLIB=OFF \
        -DCPU_BASELINE=SSE2 -DCPU_DISPATCH= -DOPENCL_INCLUDE_DIR=/usr/include/CL/ \
        -DOPENCV_GENERATE_PKGCONFIG=ON "-DCMAKE_INSTALL_PREFIX=$work/static/install"
    cmake --build "$work/static" --target install
    touch "$work/static/finished-$release"
}

# The module inside OpenCV's tree: all of its tests, in C++ and in Python.
test_in_tree() {
    step "OpenCV $version with the module inside"
    cmake --preset in-tree -B "$work/in-tree" -DOPENCV_SOURCE_DIR="$source"
    cmake --build "$work/in-tree"
    # As in test/CMakeLists.txt: OpenCV takes only GPUs by itself, and PoCL's largest groups lose memory.
    export OPENCV_OPENCL_DEVICE=${OPENCV_OPENCL_DEVICE:-:CPU:}
    export POCL_MAX_WORK_GROUP_SIZE=${POCL_MAX_WORK_GROUP_SIZE:-1024}
    export LINESPACE_REQUIRE_BACKENDS=${LINESPACE_REQUIRE_BACKENDS:-1}
    export LINESPACE_SAMPLES_DATA=$source/samples/data
    step "opencv_test_linespace inside OpenCV $version"
    "$work/in-tree/opencv/bin/opencv_test_linespace" --gtest_color=no | tee "$work/tests.txt" ||
        failed=1
    step "the Python test inside OpenCV $version"
    PYTHONPATH=$work/in-tree/opencv/lib/python3 /usr/bin/python3 \
        modules/linespace/misc/python/test/test_linespace.py 2>&1 | tee "$work/python-test.txt" ||
        failed=1
}

# The library and the programs by themselves, installed and used as README says.
test_standalone() {
    step "the library by itself with OpenCV $version"
    test/install/run.sh "$work/standalone" -DBUILD_SHARED_LIBS=OFF \
        -DCMAKE_COMPILE_WARNING_AS_ERROR=ON \
        "-DOpenCV_DIR=$(dirname "$(find "$work/static/install" -name OpenCVConfig.cmake)")"
}

cd "$root"
fetch
build_static
failed=0
test_standalone
[[ $scope == standalone ]] && exit
test_in_tree
step "OpenCV $version: the tests in C++ and in Python"
grep -E '^\[(==========|  PASSED  |  FAILED  |  SKIPPED )\].* tests?' "$work/tests.txt" | tail -n +2
tail -n 3 "$work/python-test.txt"
exit "$failed"
