#!/bin/bash
# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

# OpenCV_DIR is obeyed or refused with a reason, by the build and by the installed package:
#   opencv_dir.sh WORK_FOLDER
# The folders that this test gives contain fakes, configuration files without an OpenCV. The system
# has a real OpenCV, which must not be taken in their place.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
mkdir -p "${1:?usage: opencv_dir.sh WORK_FOLDER}"
work=$(cd "$1" && pwd)
rm -rf "${work:?}"/*
mkdir -p "$work/none" "$work/package" "$work/consumer"
unset OpenCV_DIR OpenCV_ROOT CMAKE_PREFIX_PATH
cd "$work"

# fake VERSION [FOLDER]: makes a fake of that version, by default in the folder VERSION; prints it.
fake() {
    local folder=$work/${2:-$1}
    mkdir -p "$folder"
    cat >"$folder/OpenCVConfig.cmake" <<END
set(OpenCV_FOUND TRUE)
set(OpenCV_VERSION $1)
string(REGEX MATCH "^([0-9]+).([0-9]+)" matched $1)
set(OpenCV_VERSION_MAJOR \${CMAKE_MATCH_1})
set(OpenCV_VERSION_MINOR \${CMAKE_MATCH_2})
foreach(library opencv_core opencv_imgproc)
  if(NOT TARGET \${library})
    add_library(\${library} INTERFACE IMPORTED)
  endif()
endforeach()
END
    echo "$folder"
}

fail() {
    cat "$work/output.txt" >&2
    echo "FAILED: $*" >&2
    exit 1
}

# refuses WORDS COMMAND...: the command fails with these words, and does so when it is repeated.
refuses() {
    local words=$1 time
    shift
    for time in first second; do
        if "$@" >"$work/output.txt" 2>&1; then
            fail "the $time '$*' did not fail; it must say: $words"
        fi
        # CMake breaks long lines.
        tr -s ' \n' ' ' <"$work/output.txt" | grep -qF -- "$words" ||
            fail "the $time '$*' does not say: $words"
    done
    echo "refused: $words"
}

# obeys FOLDER COMMAND...: the command takes the OpenCV of that folder.
obeys() {
    local folder=$1 found
    shift
    "$@" >"$work/output.txt" 2>&1 || fail "'$*' must take $folder"
    found=$(sed -n 's/^-- .*OpenCV [0-9.]* in //p' "$work/output.txt")
    [[ $found -ef $folder ]] || fail "'$*' takes '$found', not $folder"
    echo "obeyed: ${*: -1}: $folder"
}

# build NAME [ARGUMENT...]: configures the library in build-NAME.
build() {
    local name=$1
    shift
    cmake -S "$root" -G Ninja -DBUILD_TESTS=OFF -DBUILD_PERF_TESTS=OFF -DBUILD_SAMPLES=OFF \
        -B "$work/build-$name" "$@"
}
# build_in DIR NAME [ARGUMENT...]: the same with OpenCV_DIR=DIR in the environment.
build_in() {
    local OpenCV_DIR=$1
    shift
    export OpenCV_DIR
    build "$@"
}

fake 4.5.5 >/dev/null
fake 6.0.0 >/dev/null
fake 4.6.0 >/dev/null
fake 5.0.0 prefix/lib/cmake/opencv5 >/dev/null
fake 5.1.0 >/dev/null
fake 5.1.0 'c++ a(b)' >/dev/null
fake 5.1.0 'unsuitable' >/dev/null
echo 'set(PACKAGE_VERSION_UNSUITABLE TRUE)' >unsuitable/OpenCVConfig-version.cmake
fake 5.1.0 'not-found' >/dev/null
cat >>not-found/OpenCVConfig.cmake <<'END'
set(OpenCV_FOUND FALSE)
set(OpenCV_NOT_FOUND_MESSAGE "It lacks imgproc.")
END
ln -s 5.1.0 link
prefix=$work/prefix/lib/cmake/opencv5

# The variable.
refuses "OpenCV_DIR=$work/none has no OpenCVConfig.cmake" build none "-DOpenCV_DIR=$work/none"
refuses "$work/4.5.5 is OpenCV 4.5.5: must be at least 4.6 and below 6" \
    build old "-DOpenCV_DIR=$work/4.5.5"
refuses "$work/6.0.0 is OpenCV 6.0.0: must be at least 4.6 and below 6" \
    build new "-DOpenCV_DIR=$work/6.0.0"
refuses "the version file in OpenCV_DIR=$work/unsuitable says that this OpenCV does not suit" \
    build unsuitable "-DOpenCV_DIR=$work/unsuitable"
refuses "in $work/not-found does not give OpenCV's core and imgproc. It lacks imgproc." \
    build not-found "-DOpenCV_DIR=$work/not-found"
obeys 5.1.0 build 5.1 "-DOpenCV_DIR=$work/5.1.0"
obeys 5.1.0 build relative -DOpenCV_DIR=none/../5.1.0
(cd none && obeys "$work/5.1.0" build relative) # the folder is the first run's
obeys link build link "-DOpenCV_DIR=$work/link"
obeys 'c++ a(b)' build plus "-DOpenCV_DIR=$work/c++ a(b)"

# The environment.
refuses "the environment's OpenCV_DIR=$work/none has no OpenCVConfig.cmake" \
    build_in "$work/none" environment-none
refuses "OpenCV_DIR=$work/unsuitable has no OpenCVConfig.cmake that CMake accepts" \
    build_in "$work/unsuitable" environment-unsuitable
refuses "in $work/not-found does not give OpenCV's core and imgproc. It lacks imgproc." \
    build_in "$work/not-found" environment-not-found
refuses "$work/4.5.5 is OpenCV 4.5.5: must be" build_in "$work/4.5.5" environment-old
obeys "$prefix" build_in "$work/prefix" environment
obeys "$prefix" build environment # the environment of another shell has no OpenCV_DIR
obeys 5.1.0 build_in "$work/5.1.0" environment
obeys "$prefix" build_in "$work/5.1.0" environment "-DOpenCV_DIR=$prefix"
obeys 5.1.0 build_in ./none/../5.1.0 environment-relative
obeys link build_in "$work/link" environment-link
obeys 'c++ a(b)' build_in "$work/c++ a(b)" environment-plus
refuses "the environment's OpenCV_DIR=$work/none has no OpenCVConfig.cmake" \
    build_in "$work/none" environment-link

# Both, and CMAKE_PREFIX_PATH and OpenCV_ROOT, which CMake searches before the environment's folder.
obeys 4.6.0 build_in "$work/5.1.0" both "-DOpenCV_DIR=$work/4.6.0"
obeys "$prefix" build_in "$work/5.1.0" both-prefix "-DCMAKE_PREFIX_PATH=$work/prefix"
obeys "$prefix" build_in "$work/none" both-root "-DOpenCV_ROOT=$work/prefix"
obeys 5.1.0 build_in "$work/5.1.0" both-nothing "-DCMAKE_PREFIX_PATH=$work/none"
refuses "OpenCV_ROOT and CMAKE_PREFIX_PATH have none either" \
    build_in "$work/none" both-none "-DCMAKE_PREFIX_PATH=$work/none"

# The package of the build with 5.1, which needs its OpenCV and no other.
package=$work/build-5.1/modules/linespace
grep -x 'Requires: opencv5 >= 5.1, opencv5 < 5.2' "$package/opencv_linespace.pc"
cp "$package/opencv_linespace-config.cmake" \
    "$root/modules/linespace/cmake/linespace_find_opencv.cmake" package
echo 'add_library(opencv_linespace INTERFACE IMPORTED)' >package/opencv_linespace-targets.cmake
cat >consumer/CMakeLists.txt <<'END'
cmake_minimum_required(VERSION 3.18)
project(consumer LANGUAGES CXX)
find_package(opencv_linespace REQUIRED)
message(STATUS "OpenCV ${OpenCV_VERSION} in ${OpenCV_DIR}")
get_property(variables DIRECTORY PROPERTY VARIABLES)
if(variables MATCHES "linespace_(given|environment|prefix)[a-z_]*")
  message(FATAL_ERROR "the package leaves the variable ${CMAKE_MATCH_0}")
endif()
END
consume() {
    local name=$1
    shift
    cmake -S consumer -G Ninja -B "consumer-$name" "-Dopencv_linespace_DIR=$work/package" "$@"
}
refuses "OpenCV_DIR=$work/none has no OpenCVConfig.cmake" consume none "-DOpenCV_DIR=$work/none"
refuses "is OpenCV 4.6.0: must be at least 5.1 and below 5.2" \
    consume old "-DOpenCV_DIR=$work/4.6.0"
refuses "must be at least 5.1 and below 5.2" consume system
obeys 5.1.0 consume 5.1 "-DOpenCV_DIR=$work/5.1.0"
echo "All good."
