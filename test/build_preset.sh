#!/bin/bash
# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

# Configures and builds one of CMakePresets.json: build_preset.sh NAME [CMAKE_OPTION...]
set -euo pipefail
cd "$(dirname "$0")/.."
preset=${1:?usage: build_preset.sh NAME [CMAKE_OPTION...]}
shift
cmake --preset "$preset" "$@"
cmake --build --preset "$preset"
