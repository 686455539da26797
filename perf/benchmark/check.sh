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

# A stub stands for a Python with another OpenCV, whose HoughLines finds nothing: stub VERSION
stub() {
    mkdir -p "$folder/stub-$1"
    cat >"$folder/stub-$1/cv2.py" <<END
__version__, IMREAD_GRAYSCALE = "$1", 0
HoughLines = imread = setNumThreads = lambda *arguments: None
END
    printf '#!/bin/sh\nPYTHONPATH=%q exec /usr/bin/python3 -B "$@"\n' "$folder/stub-$1" \
        >"$folder/stub-$1/python"
    chmod +x "$folder/stub-$1/python"
}

rm -rf "$folder"
stub 98.6.1
stub 99.14.2
"$program" --quick --output "$folder" \
    --newer-python "$folder/stub-98.6.1/python:$folder/stub-99.14.2/python"
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
grep -q '^| other OpenCV | 98.6.1, 99.14.2 |$' "$folder/results.md"
for version in 98.6 99.14; do
    for section in photographs paper opencl opengl sizes densities; do
        if grep -q "^$section," "$folder/times.csv"; then
            grep -q "^$section,.*,HoughLines $version 1" "$folder/times.csv"
        fi
    done
    grep -q "^HoughLines $version 1°," "$folder/table-photographs-128x96.csv"
done
grep -Eq '^drop-in 1°,1°,.* \((98\.6|99\.14)\),' "$folder/table-fastest-128x96.csv"
grep -Eq '^lines of every timed call .*,yes$' "$folder/table-requirements.csv"
