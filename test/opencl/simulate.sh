#!/bin/bash
# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

# Runs PROGRAM (small_images.cpp) on devices that oclgrind simulates:
#   simulate.sh PROGRAM
# one that reports accesses beyond buffers and data races, and some of tight limits. Exit status 77:
# there is no oclgrind.
set -euo pipefail
program=${1:?usage: simulate.sh PROGRAM}
if ! command -v oclgrind >/dev/null; then
    echo "SKIPPED: oclgrind is not installed"
    exit 77
fi
export OPENCV_OPENCL_DEVICE=Oclgrind: OPENCV_OPENCL_CACHE_ENABLE=0
log=$(mktemp) said=$(mktemp)
trap 'rm -f "$log" "$said"' EXIT
all=10 few=6 # small images; what a limit does depends on few of their options
callers=$((2 * few)) # a detector and a call of each

# simulate KERNELS BACKEND IMAGES OPTION...
simulate() {
    local kernels=$1 backend=$2 images=$3
    shift 3
    echo "oclgrind $* ($backend, $kernels kernels, $images images)"
    : >"$log"
    local status=0
    LINESPACE_OPENCL_KERNELS=$kernels \
        oclgrind --log "$log" "$@" "$program" "$backend" "$images" || status=$?
    if [[ $status != 0 || -s $log ]]; then
        head -40 "$log"
        exit 1
    fi
}

# A processor's kernels are those without barriers and with the long loops.
simulate graphics opencl $all --data-races
simulate processor opencl $all --data-races
simulate graphics opencl $few --max-wgsize 16
simulate graphics opencl $few --local-mem-size 1024 # counts that want to be there are elsewhere
# Less memory than a table needs: the processor takes over, and each detector or call without one
# says so once.
simulate graphics cpu $few --global-mem-size 64 2>&1 | tee "$said"
warnings=$(grep -c 'the CPU path runs' "$said" || true)
if ((warnings == 0 || warnings > callers)); then
    echo "$warnings warnings of $callers detectors and calls"
    exit 1
fi
