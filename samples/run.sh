#!/bin/bash
# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

# Finds the lines of a photograph: installs what is missing (Debian 12 or 13), builds, writes
# build/lines.png and build/lines.json and prints the strongest lines.
#   samples/run.sh [IMAGE [OPTION...]]     IMAGE: default a building, one of OpenCV's sample images
# Options go to the program; see build/release/bin/linespace --help.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
image=${1:+$(realpath -- "$1")}
shift $(($# ? 1 : 0))
cd "$root"

# OpenCV's sample images are in its documentation package. Where that is not installed, or the
# system installs no documentation, one image is taken out of the package.
sample_photograph() {
    local name=building.jpg folder
    for folder in /usr/share/doc/opencv-doc/examples/data build/opencv-source/samples/data build; do
        if [[ -s $folder/$name ]]; then
            echo "$folder/$name"
            return
        fi
    done
    echo "Fetching a sample photograph (from the package opencv-doc, about 100 MB)" >&2
    local scratch
    scratch=$(mktemp -d)
    (cd "$scratch" && apt-get -q -o APT::Sandbox::User= download opencv-doc >&2) &&
        dpkg-deb --fsys-tarfile "$scratch"/opencv-doc_*.deb |
        tar -xO "./usr/share/doc/opencv-doc/examples/data/$name" >"$scratch/$name" &&
        mv "$scratch/$name" "build/$name"
    rm -rf "$scratch"
    [[ -s build/$name ]] || {
        echo "run.sh: no sample photograph; give one of your own: samples/run.sh IMAGE" >&2
        return 1
    }
    echo "build/$name"
}

samples/install_packages.sh run
cmake --preset release -DBUILD_TESTS=OFF -DBUILD_PERF_TESTS=OFF
cmake --build --preset release

[[ -n $image ]] || image=$(sample_photograph)
build/release/bin/linespace "$image" --output build/lines.png --lines build/lines.json "$@"
echo "See build/lines.png and build/lines.json."
