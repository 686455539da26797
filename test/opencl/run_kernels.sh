#!/bin/bash
# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

# Runs PROGRAM, the accuracy tests, on PoCL with one kind of kernels, compiled as OpenCL C 1.2 with
# warnings as errors:
#   run_kernels.sh processor|graphics PROGRAM [ARGUMENT...]
# and looks at what PoCL has compiled: kernels of that kind. Exit status 77: nothing, as OpenCV uses
# another device or none.
set -euo pipefail
kind=${1:?usage: run_kernels.sh processor|graphics PROGRAM [ARGUMENT...]}
shift
caches=$(mktemp -d)
trap 'rm -rf "$caches"' EXIT
# Only what is compiled is warned of: both caches begin empty.
export POCL_CACHE_DIR=$caches OPENCV_OPENCL_CACHE_ENABLE=0
export OPENCV_OPENCL_BUILD_EXTRA_OPTIONS="-cl-std=CL1.2 -Werror"
LINESPACE_OPENCL_KERNELS=$kind "$@"

# PoCL keeps a folder for each kernel and shape of its groups. A processor's kernels that take runs
# of chords have groups along the rows.
declare -A groups=([processor]=1-8-1 [graphics]=64-1-1)
shapes=$(find "$caches" -type d -path '*/mergeCells/*' -printf '%f\n' | cut -d- -f1-3 | sort -u)
if [[ -z $shapes ]]; then
    echo "SKIPPED: OpenCV uses no PoCL device"
    [[ ${LINESPACE_REQUIRE_BACKENDS:-} == 1 ]] && exit 1
    exit 77
fi
echo "groups of mergeCells: $shapes"
[[ $shapes == "${groups[$kind]}" ]]
find "$caches" -type d -name '*-*-*' -printf '%h\n' | sed 's|.*/||' | sort | uniq -c |
    awk '{printf "%s%s %s", (NR > 1 ? ", " : "variants compiled: "), $2, $1} END {print ""}'
