#!/bin/bash
# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

# Runs every fuzzer of a build for some seconds: run.sh BUILD_FOLDER [SECONDS]. What it learns is
# kept in the build folder for the next run; an input that fails is written there, too, and named in
# the output.
set -euo pipefail
build=${1:?usage: run.sh BUILD_FOLDER [SECONDS]}
seconds=${2:-30}
for name in detector houghlines; do
    corpus=$build/corpus-$name
    mkdir -p "$corpus"
    "$build/bin/fuzz_$name" -max_total_time="$seconds" -max_len=2048 -timeout=20 -print_final_stats=1 \
        -artifact_prefix="$build/fuzz_$name-" "$corpus"
done
