#!/bin/bash
# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

# Fetches Debian's source package of exactly the installed OpenCV: its test harness is in no binary
# package. Usage: fetch_opencv_source.sh [FOLDER], by default build/opencv-source of the checkout.
#
# apt works with lists and a sources list of its own here, so nothing on the system changes.
set -euo pipefail

root=$(cd "$(dirname "$0")/.." && pwd)
target=${1:-$root/build/opencv-source}
version=$(dpkg-query --show --showformat='${source:Version}' libopencv-core-dev)

stamp=$target/.debian-version
[[ -f $stamp && $(<"$stamp") == "$version" ]] && exit 0

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
chmod 755 "$scratch"
mkdir -p "$scratch"/{lists,cache,sources,tree}

keyring=/usr/share/keyrings/debian-archive-keyring.gpg
option=
[[ -f $keyring ]] && option="[signed-by=$keyring] "
apt-get indextargets --format "deb-src $option\$(SITE) \$(RELEASE) \$(COMPONENT)" \
    'Created-By: Packages' 'ORIGIN: Debian' | sort -u >"$scratch/sources.list"
[[ -s $scratch/sources.list ]] || {
    echo "fetch_opencv_source.sh: apt knows no Debian archive here; run apt-get update" >&2
    exit 1
}
private=(
    -o "Dir::Etc::SourceList=$scratch/sources.list" -o Dir::Etc::SourceParts=/dev/null
    -o "Dir::State::Lists=$scratch/lists" -o "Dir::Cache=$scratch/cache"
    -o APT::Sandbox::User= -o Acquire::Languages=none
)

echo "Fetching the source package of OpenCV $version"
apt-get "${private[@]}" update -q
# The package's description (.dsc) is missing in some mirrors and not needed: apt has the checksums.
(cd "$scratch/sources" && apt-get "${private[@]}" source -q --tar-only "opencv=$version")

tar -xf "$scratch"/sources/opencv_*.orig.tar.xz -C "$scratch/tree" --strip-components=1
echo "$version" >"$scratch/tree/.debian-version"
rm -rf "$target"
mkdir -p "$(dirname "$target")"
mv "$scratch/tree" "$target"
