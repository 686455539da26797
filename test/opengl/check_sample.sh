#!/bin/bash
# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

# Whether the sample draws, finds lines and writes frames and a video: check_sample.sh PROGRAM FOLDER
# FOLDER is emptied and written to.
set -euo pipefail
program=${1:?usage: check_sample.sh PROGRAM FOLDER}
folder=${2:?usage: check_sample.sh PROGRAM FOLDER}

rm -rf "$folder"
status=0
said=$("$program" "$folder" --frames=3 2>&1) || status=$?
echo "$said"
if [[ $said == *"no OpenGL 4.3"* || $said == *"EGL cannot"* || $said == *"o display"* ]]; then
    echo "SKIPPED: there is no OpenGL 4.3"
    [[ ${LINESPACE_REQUIRE_BACKENDS:-} == 1 ]] && exit 1
    exit 77
fi
[[ $status == 0 ]]
# At least ten lines in a frame of some dozens of edges.
[[ $said =~ 3\ frames,\ ([0-9]+)\ lines ]]
((BASH_REMATCH[1] >= 30))
[[ -s $folder/frame000.png && -s $folder/frame002.png ]]
"$program" "$folder/video.avi" --frames=2 >/dev/null
[[ -s $folder/video.avi ]]
