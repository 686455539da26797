#!/bin/bash
# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

# Installs the Debian packages of one or more groups, and does nothing if all of them are there:
#   install_packages.sh run       what building and running the programs takes
#   install_packages.sh test      what the tests take on top of that
#   install_packages.sh accuracy  what perf/accuracy.sh takes on top of run
#   install_packages.sh aarch64   what test/aarch64/run.sh takes on top of run and test
#   install_packages.sh benchmark what perf/run.sh takes on top of run
set -euo pipefail

# libepoxy: of the sample that draws with OpenGL.
run=(g++ cmake ninja-build libopencv-dev nlohmann-json3-dev libcli11-dev opencv-doc libepoxy-dev)
test=(
    # venv: pip fetches the sources of newer versions of OpenCV.
    pkg-config python3 python3-dev python3-numpy python3-venv xz-utils
    # A software device for OpenCL and one for OpenGL without a display.
    pocl-opencl-icd ocl-icd-libopencl1 libegl1 libegl-mesa0 libgl1-mesa-dri
    # Another compiler of shaders; and what tells which libraries a library needs.
    glslang-tools binutils
    # The fuzzers.
    clang libclang-rt-dev
    # OpenCV's own build, reduced.
    opencl-c-headers zlib1g-dev libpng-dev libjpeg-dev
)
# A simulator of OpenCL devices that checks what kernels do with memory; Debian 13 has none.
if [[ $(. /etc/os-release && echo "${VERSION_CODENAME:-}") == bookworm ]]; then
    test+=(oclgrind)
fi
# xz-utils: OpenCV's sources, which configuring the tests looks for.
accuracy=(libopencv-contrib-dev python3 python3-numpy python3-scipy python3-matplotlib xz-utils)
# On the machine itself; OpenCV for arm64 is unpacked into build/, see test/aarch64/make_sysroot.sh.
aarch64=(g++-aarch64-linux-gnu qemu-user)
# pocl: the device of OpenCV's own OpenCL; mesa: a software device for OpenGL; venv: a newer OpenCV is installed into one.
benchmark=(
    libopencv-contrib-dev python3 python3-matplotlib python3-numpy python3-pandas python3-venv
    pocl-opencl-icd ocl-icd-libopencl1 libegl1 libegl-mesa0 libgl1-mesa-dri xz-utils
)

wanted=()
for group in "$@"; do
    case $group in
    run) wanted+=("${run[@]}") ;;
    test) wanted+=("${test[@]}") ;;
    accuracy) wanted+=("${accuracy[@]}") ;;
    aarch64) wanted+=("${aarch64[@]}") ;;
    benchmark) wanted+=("${benchmark[@]}") ;;
    *)
        echo "install_packages.sh: unknown group '$group'; known are run, test, accuracy, aarch64 and" \
            "benchmark" >&2
        exit 2
        ;;
    esac
done

missing=()
for package in "${wanted[@]}"; do
    status=$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null || true)
    [[ $status == installed ]] || missing+=("$package")
done
((${#missing[@]})) || exit 0

as_root=()
if ((EUID != 0)); then
    command -v sudo >/dev/null || {
        echo "Missing packages, and no sudo to install them. As root, run:" >&2
        echo "  apt-get update && apt-get install ${missing[*]}" >&2
        exit 1
    }
    as_root=(sudo)
fi
echo "Installing ${missing[*]}"
"${as_root[@]}" apt-get update -q
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -q -y --no-install-recommends "${missing[@]}"
