#!/bin/bash
# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

# Times the Line Space beside every other method in one run: installs what is missing (Debian 12 or
# 13), builds, runs, and writes perf/results/: results.md, tables and single times (CSV), plots (PNG, SVG).
#   perf/run.sh [--quick] [--only SECTION]... [--ways] [--data FOLDER]
# --quick  small images, half a minute, into build/benchmark-quick/: shows that it works; times mean
#          nothing
# --only   only this section, into build/benchmark-only/: photographs, paper, opencl, opengl, sizes, densities, threads,
#          instruction-sets, stages or memory
# --ways   beside the section opengl, other ways to merge, to find maxima and to sort by OpenGL
#          (opengl-ways.md), some minutes
# --data   folder of OpenCV's sample photographs, default that of OpenCV's sources
# LINESPACE_NEWER_OPENCV_PYTHON names Pythons with newer versions of cv2, separated by colons, which
# take part; without it the newest opencv-python-headless of OpenCV 4 and that of OpenCV 5 are
# installed into build/newer-opencv/4 and /5, or left out where that fails. A run of all sections
# looks for a newer one, and keeps what there is where that fails.
# OPENCV_OPENCL_DEVICE chooses the device of the OpenCL column; by default PoCL's, a processor.
set -euo pipefail

quick=
only=()
ways=
data=
command=perf/run.sh
while (($#)); do
    case $1 in
    --quick)
        quick=--quick
        command+=" --quick"
        shift
        ;;
    --only)
        only+=(--only "${2:?--only needs a section}")
        command+=" --only $2"
        shift 2
        ;;
    --ways)
        ways=1
        command+=" --ways"
        shift
        ;;
    --data)
        data=$(realpath -- "${2:?--data needs a folder}")
        command+=" --data FOLDER"
        shift 2
        ;;
    *)
        echo "usage: run.sh [--quick] [--only SECTION]... [--ways] [--data FOLDER]" >&2
        exit 2
        ;;
    esac
done
cd "$(dirname "$0")/.."

samples/install_packages.sh run benchmark
test/fetch_opencv_source.sh # the photographs, and OpenCV's own test harness, which is configured too
cmake --preset release
cmake --build --preset release --target linespace_benchmark ${ways:+linespace_opengl_ways}

# Pythons whose cv2 is newer than the OpenCV that everything else uses are separated by colons.
newer=${LINESPACE_NEWER_OPENCV_PYTHON:-}
# add_newer_python MAJOR: installs the newest OpenCV of a major version and adds it.
add_newer_python() {
    local folder=build/newer-opencv/$1 package="opencv-python-headless==$1.*"
    local pip=("$folder/bin/pip" --quiet --disable-pip-version-check)
    if [[ -n $quick ]]; then
        : # what an earlier run has installed takes part
    elif [[ ! -e $folder/ready ]]; then
        rm -rf "$folder"
        {
            /usr/bin/python3 -m venv "$folder" && "${pip[@]}" install "$package" &&
                touch "$folder/ready"
        } || echo "Left out: a newer OpenCV ($package cannot be installed)" >&2
    elif ((${#only[@]} == 0)); then
        "${pip[@]}" install --upgrade "$package" ||
            echo "Kept: the OpenCV in $folder ($package cannot be looked for)" >&2
    fi
    if [[ -e $folder/ready ]]; then
        newer+=${newer:+:}$folder/bin/python
    fi
}
if [[ -z $newer ]]; then
    add_newer_python 4
    add_newer_python 5
fi

results=perf/results
if [[ -n $quick ]]; then
    results=build/benchmark-quick
elif ((${#only[@]})); then
    results=build/benchmark-only # a part must not replace the whole
fi
rm -rf "$results"
export OPENCV_OPENCL_DEVICE=${OPENCV_OPENCL_DEVICE-:CPU:}
# cv::HoughLines takes work groups as large as PoCL allows, which then loses some of their memory.
export POCL_MAX_WORK_GROUP_SIZE=${POCL_MAX_WORK_GROUP_SIZE-1024}
data=${data:-build/opencv-source/samples/data}
status=0
build/release/bin/linespace_benchmark --data "$data" \
    --output "$results" ${quick:+"$quick"} "${only[@]}" ${newer:+--newer-python "$newer"} || status=$?
# Where lines differ from the reference's, the report says which; the status is 1 all the same.
/usr/bin/python3 -B perf/benchmark/report.py --results "$results" --command "$command" || status=$?
if [[ -n $ways && (${#only[@]} == 0 || " ${only[*]} " == *" opengl "*) ]]; then
    build/release/bin/linespace_opengl_ways --data "$data" ${quick:+--sides 32 --turns 1} \
        >"$results/opengl-ways.md" || status=$?
fi
echo "See $results/results.md."
exit "$status"
