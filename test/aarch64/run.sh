#!/bin/bash
# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

# Cross-builds the library and its accuracy tests for 64-bit ARM and runs the tests of the CPU path
# under qemu-user: run.sh [DIGESTS], a file that Linespace_InstructionSets.digests wrote on this
# machine's own processor; without it build/release's, if test/run.sh left one there.
#
# Takes half an hour. Exit status 77: a package cannot be had; LINESPACE_REQUIRE_AARCH64=1
# makes that a failure.
set -euo pipefail
cd "$(dirname "$0")/../.."
native=${1:-build/release/digests/accuracy/baseline.txt}
sysroot=$PWD/build/aarch64-sysroot
build=$PWD/build/aarch64

fail() {
    echo "FAILED: $*" >&2
    exit 1
}
skip() {
    [[ ${LINESPACE_REQUIRE_AARCH64:-} != 1 ]] || fail "$*"
    echo "SKIPPED: $*"
    exit 77
}
step() { echo "== $*"; }

step "packages: cross compiler, qemu-user, OpenCV for arm64"
samples/install_packages.sh run test aarch64 || skip "the packages for cross-building cannot be had"
test/fetch_opencv_source.sh || skip "OpenCV's sources cannot be had"
test/aarch64/make_sysroot.sh "$sysroot" || skip "Debian's OpenCV for arm64 cannot be had"

step "build"
test/build_preset.sh aarch64

# Programs find the sysroot's libraries; BLAS and LAPACK where no update-alternatives linked them.
lib=/usr/lib/aarch64-linux-gnu
run_on_arm() { qemu-aarch64 -L "$sysroot" -E "LD_LIBRARY_PATH=$lib/blas:$lib/lapack" "$@"; }

step "what was built"
program=$build/bin/opencv_test_linespace
machine=$(aarch64-linux-gnu-readelf --file-header "$program" | sed -n 's/^ *Machine: *//p')
echo "$program is for $machine"
[[ $machine == AArch64 ]] || fail "not a program for 64-bit ARM"
width=$(run_on_arm "$build/bin/linespace_vector_width") || fail "no vectors: $width"
echo "$width"
[[ $width == *"CV_NEON 1"* ]] || fail "OpenCV's vectors are not NEON"
python3 -B test/simd/check_vectors.py "$build/lib/libopencv_linespace.so" \
    --objdump aarch64-linux-gnu-objdump --hot addPlanes choosePixels mergeRows

# Without tests that spend minutes in their own brute force, in failing allocations, or that measure
# time: the processor they run on is emulated.
step "accuracy tests under $(qemu-aarch64 --version | head -n 1)"
filter='-*_Large.*:*_VoteBound.*:*_BadInput.*:*_Grid.rule*:*_StageTimes.*:'
filter+='*.lines_are_chords_with_their_votes*:*.the_same_on_every_*:*.a_line_alone*'
digests=$build/digests.txt
export LINESPACE_SAMPLES_DATA=$PWD/build/opencv-source/samples/data
LINESPACE_EXPECT_SET=baseline LINESPACE_DIGESTS=$digests OPENCV_OPENCL_RUNTIME=disabled LINESPACE_EGL_LIBRARY=disabled \
    run_on_arm "$program" --gtest_color=no "--gtest_filter=$filter"

step "the same bits as this machine's own processor"
if [[ -f $native ]]; then
    test/simd/compare_digests.sh "$native" "$digests"
else
    echo "Not compared: there are no digests in $native"
fi
