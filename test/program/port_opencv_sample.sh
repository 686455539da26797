# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

# Ports OpenCV's sample houghlines as a user would: the namespace of its call of HoughLines is
# changed, and a header and a library are added. The sample is taken from OpenCV's own sources;
# nothing of it is in this project. Original and port must both run, and draw what they find.
#   CXX, LIBRARY, EXAMPLE, OPENCV_SOURCE_DIR, OPENCV_INCLUDES (separated by ;): set by CMake
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
module=$here/../../modules/linespace
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

sample=$OPENCV_SOURCE_DIR/samples/cpp/tutorial_code/ImgTrans/houghlines.cpp
photo=$OPENCV_SOURCE_DIR/samples/data/sudoku.png
includes=()
IFS=';' read -ra folders <<<"$OPENCV_INCLUDES"
for folder in "${folders[@]}"; do includes+=(-I "$folder"); done

libraries=()
compile() {
    local source=$1 program=$2
    shift 2
    "$CXX" -std=c++11 "${includes[@]}" -include "$here/headless.hpp" "$@" -o "$program" "$source" \
        "${libraries[@]}" -lopencv_imgproc -lopencv_imgcodecs -lopencv_highgui -lopencv_core
}

echo "the port differs from the sample by one line:"
sed 's/\bHoughLines(/cv::linespace::HoughLines(/' "$sample" >port.cpp
diff "$sample" port.cpp || [[ $? == 1 ]]
[[ $(diff "$sample" port.cpp | grep -c '^>') == 1 ]]

compile "$sample" original
libraries=("$LIBRARY" -Wl,-rpath,"$(dirname "$LIBRARY")")
compile port.cpp port -I "$module/include" -include opencv2/linespace.hpp
nm -DC --undefined-only port | grep -q 'cv::linespace::HoughLines('
if nm -DC --undefined-only port | grep -q ' cv::HoughLines('; then
    echo "the port still calls cv::HoughLines" >&2
    exit 1
fi

for program in original port; do
    mkdir "$program.out"
    (cd "$program.out" && "../$program" "$photo")
    ls -l "$program.out"
    [[ $(find "$program.out" -name '*.png' -size +10k | wc -l) == 3 ]]
done
# The probabilistic transform is OpenCV's own in both; the standard one is drawn from our lines.
cmp original.out/*Probabilistic*.png port.out/*Probabilistic*.png
red() { # red pixels of the picture with the standard transform's lines
    PYTHONPATH=$here python3 -B -c 'import pathlib, sys, pictures
rows = pictures.read_png(pathlib.Path(sys.argv[1]))[3]
print(sum(bytes(row[i:i + 3]) == bytes((255, 0, 0)) for row in rows for i in range(0, len(row), 3)))
' "$1"/*Standard*.png
}
theirs=$(red original.out) ours=$(red port.out)
echo "red pixels: original $theirs, port $ours"
((ours > theirs / 2 && ours < theirs * 2))

echo "the module's own example:"
"$EXAMPLE" "$photo" example.png 150 | tee example.txt
[[ -s example.png ]]
(($(head -n 1 example.txt | cut -d ' ' -f 1) > 0))
"$EXAMPLE" none.png example.png && exit 1
"$EXAMPLE" && exit 1
echo "done"
