#!/bin/bash
# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

# Whether the evaluation works from start to end, on a few images: check.sh PROGRAM FOLDER
# PROGRAM is linespace_accuracy; FOLDER is emptied and written to. The photographs take part if
# LINESPACE_EVAL_DATA names them.
set -euo pipefail
program=${1:?usage: check.sh PROGRAM FOLDER}
folder=${2:?usage: check.sh PROGRAM FOLDER}

rm -rf "$folder"
"$program" --quick --output "$folder"
/usr/bin/python3 -B "$(dirname "$0")/report.py" --lines "$folder" --document "$folder/accuracy.md"

for plot in error-over-noise false-lines picture-steps; do
    for kind in png svg; do
        [[ -s $folder/$plot.$kind ]] || {
            echo "check.sh: no $plot.$kind" >&2
            exit 1
        }
    done
    grep -q "figures/accuracy-$plot.png" "$folder/accuracy.md"
done
# Eight clean edges are no matter of luck: ours finds them all.
grep -q '^Line Space oriented,1.0000,1.0000,' "$folder/table-steps-strongest-512-8.csv" || {
    echo "check.sh: Line Space oriented does not find eight clean edges" >&2
    exit 1
}
