#!/bin/bash
# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

# Installs what is missing (Debian 12 or 13), builds everything and runs every test. What was built
# is kept in build/, so the next run is shorter. Arguments go to ctest, e.g. -R accuracy.
set -euo pipefail
cd "$(dirname "$0")/.."

samples/install_packages.sh run test accuracy benchmark
test/fetch_opencv_source.sh

# PoCL and Mesa are installed now: a test that finds no device must not pass as skipped.
export LINESPACE_REQUIRE_BACKENDS=${LINESPACE_REQUIRE_BACKENDS:-1}
if command -v ccache >/dev/null; then
    export CMAKE_CXX_COMPILER_LAUNCHER=ccache
fi

# Tests that measure nothing run beside others.
export CTEST_PARALLEL_LEVEL=${CTEST_PARALLEL_LEVEL:-$(nproc)}

test/build_preset.sh release
ctest --preset release "$@"
