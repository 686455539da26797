#!/bin/bash
# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

# Runs the accuracy tests as on a machine whose best instruction set is SET:
#   run_step.sh SET DIGESTS PROGRAM [ARGUMENT...]
# SET is one of those below. The tests fail if SET is not the best one in use then. Digests of what
# is computed go to DIGESTS/SET.txt and must be the same as those in DIGESTS/baseline.txt.
# Exit status 77: this machine does not have SET.
set -euo pipefail
set_of_step=${1:?usage: run_step.sh SET DIGESTS PROGRAM [ARGUMENT...]}
digests=$2
program=$3
shift 3

# OpenCV's names for OPENCV_CPU_DISABLE, ascending; not those of its macros (AVX512_SKX).
sets=(baseline AVX2 AVX512-SKX)

rank() {
    local i
    for i in "${!sets[@]}"; do
        if [[ ${sets[i]} == "$1" ]]; then
            echo "$i"
            return
        fi
    done
    echo "run_step.sh: unknown instruction set '$1'; known are ${sets[*]}" >&2
    exit 2
}

step=$(rank "$set_of_step")
best=$(env -u OPENCV_CPU_DISABLE -u LINESPACE_EXPECT_SET \
    "$program" --gtest_color=no '--gtest_filter=Linespace_InstructionSets.best' |
    sed -n 's/^Best instruction set in use: //p')
best_rank=$(rank "$best")
if ((best_rank < step)); then
    echo "SKIPPED: this machine has no $set_of_step, its best instruction set is $best"
    exit 77
fi

# OpenCV warns of sets that the machine does not have.
disabled=$(IFS=, && echo "${sets[*]:step+1:best_rank-step}")
mkdir -p "$digests"
OPENCV_CPU_DISABLE=$disabled LINESPACE_EXPECT_SET=$set_of_step \
    LINESPACE_DIGESTS=$digests/$set_of_step.txt "$program" "$@"
"$(dirname "$0")/compare_digests.sh" "$digests/baseline.txt" "$digests/$set_of_step.txt"
