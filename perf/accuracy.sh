#!/bin/bash
# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

# How accurate the Line Space is beside other detectors: installs what is missing (Debian 12 or 13),
# builds, runs, and writes build/accuracy/ (lines, tables, plots) and doc/accuracy.md.
#   perf/accuracy.sh [--data FOLDER] [--quick]
# --data   folder with the ground truth of the photographs, default $LINESPACE_EVAL_DATA; without it,
#          synthetic images only
# --quick  a few images of each section; everything, also the document, into build/accuracy-quick/
set -euo pipefail

data=${LINESPACE_EVAL_DATA:-}
quick=
while (($#)); do
    case $1 in
    --data)
        data=${2:?--data needs a folder}
        shift 2
        ;;
    --quick)
        quick=--quick
        shift
        ;;
    *)
        echo "usage: accuracy.sh [--data FOLDER] [--quick]" >&2
        exit 2
        ;;
    esac
done
if [[ -n $data ]]; then
    [[ -d $data ]] || {
        echo "accuracy.sh: no folder $data" >&2
        exit 2
    }
    data=$(realpath -- "$data")
fi
cd "$(dirname "$0")/.."
unset LINESPACE_EVAL_DATA # the folder is handed on by name

samples/install_packages.sh run accuracy
test/fetch_opencv_source.sh # what is configured includes OpenCV's own test harness
cmake --preset release
cmake --build --preset release --target linespace_accuracy

lines=build/accuracy document=doc/accuracy.md command=perf/accuracy.sh
if [[ -n $quick ]]; then
    lines=build/accuracy-quick document=$lines/accuracy.md command+=" --quick"
fi
rm -rf "$lines"
if [[ -n $data ]]; then
    command+=" --data FOLDER"
    data=(--data "$data")
else
    data=()
    echo "No --data: the photographs are left out."
fi
build/release/bin/linespace_accuracy --output "$lines" "${data[@]}" ${quick:+"$quick"}
/usr/bin/python3 -B perf/accuracy/report.py --lines "$lines" "${data[@]}" --document "$document" \
    --command "$command"
echo "See $document and $lines/."
