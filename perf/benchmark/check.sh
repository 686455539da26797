#!/bin/bash
# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

# Whether the benchmark works from start to end, on small images: check.sh PROGRAM FOLDER
# PROGRAM is linespace_benchmark; FOLDER is emptied and written to. LINESPACE_SAMPLES_DATA names the
# photographs. Judges no time.
set -euo pipefail
program=${1:?usage: check.sh PROGRAM FOLDER}
folder=${2:?usage: check.sh PROGRAM FOLDER}

rm -rf "$folder"
"$program" --quick --output "$folder"
/usr/bin/python3 -B "$(dirname "$0")/report.py" --results "$folder"

for plot in photographs size density threads instruction-sets roofline; do
    for kind in png svg; do
        [[ -s $folder/$plot.$kind ]] || {
            echo "check.sh: no $plot.$kind" >&2
            exit 1
        }
    done
    grep -q "($plot.png)" "$folder/results.md"
done
for table in requirements paper photographs-128x96 opencl-128x96 limits-1 memory; do
    [[ -s $folder/table-$table.csv ]] || {
        echo "check.sh: no table-$table.csv" >&2
        exit 1
    }
done
# Nothing is said of OpenGL where there is none.
if ! grep -q '^opengl,' "$folder/times.csv"; then
    echo "check.sh: no OpenGL"
    [[ ${LINESPACE_REQUIRE_BACKENDS:-} != 1 ]]
elif [[ ! -s $folder/table-opengl.csv ]] || ! grep -q '^| OpenGL | .*, OpenGL ' "$folder/results.md"; then
    echo "check.sh: no table-opengl.csv, or no renderer" >&2
    exit 1
fi
grep -Eq '^lines of every timed call .*,yes$' "$folder/table-requirements.csv"
