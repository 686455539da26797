#!/bin/bash
# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

# Unpacks Debian's OpenCV for arm64, with all that it needs, into a folder: make_sysroot.sh FOLDER.
# It is the release of the machine's own packages, so its version is that of the installed OpenCV.
#
# apt works with lists, a status and an architecture of its own here, and nothing is installed: the
# machine needs no foreign architecture, and nothing on it changes.
set -euo pipefail
target=${1:?usage: make_sysroot.sh FOLDER}
version=$(dpkg-query --show --showformat='${Version}' libopencv-dev)

stamp=$target/.opencv-version
[[ -f $stamp && $(<"$stamp") == "$version" ]] && exit 0

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir -p "$scratch"/{lists,cache/archives}/partial
: >"$scratch/status" # nothing is installed, so apt gets all dependencies

keyring=/usr/share/keyrings/debian-archive-keyring.gpg
option=
[[ -f $keyring ]] && option="[signed-by=$keyring] "
apt-get indextargets --format "deb $option\$(SITE) \$(RELEASE) \$(COMPONENT)" \
    'Created-By: Packages' 'ORIGIN: Debian' | sort -u >"$scratch/sources.list"
[[ -s $scratch/sources.list ]] || {
    echo "make_sysroot.sh: apt knows no Debian archive here; run apt-get update" >&2
    exit 1
}
private=(
    -q -o "Dir::Etc::SourceList=$scratch/sources.list" -o Dir::Etc::SourceParts=/dev/null
    -o "Dir::State::Lists=$scratch/lists" -o "Dir::State::status=$scratch/status"
    -o "Dir::Cache=$scratch/cache" -o APT::Architecture=arm64 -o APT::Architectures=arm64
    -o APT::Sandbox::User= -o APT::Install-Recommends=false -o Acquire::Languages=none
    -o Debug::NoLocking=1
)

echo "Fetching OpenCV $version for arm64"
apt-get "${private[@]}" update
apt-get "${private[@]}" install --yes --download-only \
    libc6-dev "libopencv-dev=$version" >"$scratch/log" || {
    tail -n 20 "$scratch/log" >&2
    exit 1
}

# Debian's /lib is a link to /usr/lib, which older packages do not know: tar must keep it.
rm -rf "$target"
mkdir -p "$target/usr/lib"
ln -s usr/lib "$target/lib"
for package in "$scratch"/cache/archives/*.deb; do
    dpkg-deb --fsys-tarfile "$package" |
        tar -x -C "$target" --keep-directory-symlink --no-same-owner \
            --exclude='./usr/share' --exclude='./usr/bin' --exclude='./usr/sbin' \
            --exclude='./bin' --exclude='./sbin' --exclude='./etc' --exclude='./var'
done
echo "$version" >"$stamp"
