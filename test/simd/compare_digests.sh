#!/bin/bash
# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

# Whether two runs computed the same bits: compare_digests.sh EXPECTED ACTUAL, files that the test
# Linespace_InstructionSets.digests wrote.
set -euo pipefail
expected=${1:?usage: compare_digests.sh EXPECTED ACTUAL}
actual=${2:?usage: compare_digests.sh EXPECTED ACTUAL}
[[ -s $expected ]] || {
    echo "FAILED: no digests in $expected" >&2
    exit 1
}
diff "$expected" "$actual" || {
    echo "FAILED: the digests above differ; < $expected, > $actual" >&2
    exit 1
}
echo "All $(wc -l <"$actual") digests are those of $expected"
