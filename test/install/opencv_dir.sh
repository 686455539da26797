#!/bin/bash
# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

# OpenCV_DIR is obeyed or refused with a reason, by the build and by the installed package:
#   opencv_dir.sh WORK_FOLDER
# The OpenCVs are a file each that tells a version; the system has a real one, which must not be
# taken in their place.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
work=${1:?usage: opencv_dir.sh WORK_FOLDER}
rm -rf "$work"
mkdir -p "$work/none" "$work/package" "$work/consumer"

# fake VERSION: a folder with an OpenCV of that version, which has targets and nothing else.
fake() {
    mkdir -p "$work/$1"
    cat >"$work/$1/OpenCVConfig.cmake" <<END
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
    echo "$work/$1"
}

# refuses WORDS COMMAND...: the command fails with these words, and does so again when it is repeated.
refuses() {
    local words=$1 time
    shift
    for time in first second; do
        if "$@" >"$work/output.txt" 2>&1; then
            echo "FAILED: the $time '$*' did not fail; it must say: $words" >&2
            exit 1
        fi
        # CMake breaks long lines.
        tr -s ' \n' ' ' <"$work/output.txt" | grep -qF -- "$words" || {
            cat "$work/output.txt" >&2
            echo "FAILED: the $time '$*' does not say: $words" >&2
            exit 1
        }
    done
    echo "refused: $words"
}

configure=(cmake -S "$root" -G Ninja -DBUILD_TESTS=OFF -DBUILD_PERF_TESTS=OFF -DBUILD_SAMPLES=OFF)
refuses "OpenCV_DIR=$work/none has no OpenCVConfig.cmake" \
    "${configure[@]}" -B "$work/build-none" "-DOpenCV_DIR=$work/none"
refuses "OpenCV_DIR=$work/none has no OpenCVConfig.cmake" \
    env "OpenCV_DIR=$work/none" "${configure[@]}" -B "$work/build-environment"
refuses "is OpenCV 4.5.5: must be at least 4.6 and below 6" \
    "${configure[@]}" -B "$work/build-old" "-DOpenCV_DIR=$(fake 4.5.5)"
refuses "is OpenCV 6.0.0: must be at least 4.6 and below 6" \
    "${configure[@]}" -B "$work/build-new" "-DOpenCV_DIR=$(fake 6.0.0)"

"${configure[@]}" -B "$work/build-5.1" "-DOpenCV_DIR=$(fake 5.1.0)" >/dev/null
grep -q '^Requires: opencv5 >= 5.1$' "$work/build-5.1/modules/linespace/opencv_linespace.pc"
echo "obeyed: OpenCV_DIR of 5.1.0; the pkg-config file requires opencv5"

# The package of that build, which needs its OpenCV and no other.
package=$work/build-5.1/modules/linespace
cp "$package/opencv_linespace-config.cmake" "$root/modules/linespace/cmake/linespace_find_opencv.cmake" \
    "$work/package"
echo 'add_library(opencv_linespace INTERFACE IMPORTED)' >"$work/package/opencv_linespace-targets.cmake"
cat >"$work/consumer/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.18)
project(consumer LANGUAGES CXX)
find_package(opencv_linespace REQUIRED)
message(STATUS "with OpenCV ${OpenCV_VERSION}")
END
consume=(cmake -S "$work/consumer" -G Ninja "-Dopencv_linespace_DIR=$work/package")
refuses "OpenCV_DIR=$work/none has no OpenCVConfig.cmake" \
    "${consume[@]}" -B "$work/consumer-none" "-DOpenCV_DIR=$work/none"
refuses "is OpenCV 4.6.0: must be at least 5.1 and below 5.2" \
    "${consume[@]}" -B "$work/consumer-old" "-DOpenCV_DIR=$(fake 4.6.0)"
refuses "must be at least 5.1 and below 5.2" "${consume[@]}" -B "$work/consumer-system"
"${consume[@]}" -B "$work/consumer-5.1" "-DOpenCV_DIR=$work/5.1.0" | grep 'with OpenCV 5.1.0'
echo "All good."
