// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The text of the progress bar, for every width and share that matter.

#include <cstdlib>
#include <iostream>

#include "progress.hpp"

namespace {

int failures = 0;

void expect(const std::string& actual, const std::string& expected)
{
    if (actual == expected)
        return;
    ++failures;
    std::cerr << "expected '" << expected << "'\n     got '" << actual << "'\n";
}

void expectTrue(bool condition, const std::string& what)
{
    if (condition)
        return;
    ++failures;
    std::cerr << "not true: " << what << '\n';
}

} // namespace

int main()
{
    using program::progressText;
    expect(progressText(0, 10, 0, 80, "a.png"), "  0% [>                   ] 0/10  a.png");
    expect(progressText(5, 10, 2, 80, "a.png"),
           " 50% [==========>         ] 5/10  2.5/s  0:02 left  a.png");
    expect(progressText(10, 10, 1, 80, "a.png"),
           "100% [====================] 10/10  10/s  0:00 left  a.png");
    expect(progressText(1, 1000, 10, 80, ""),
           "  0% [>                   ] 1/1000  0.1/s  2:46:30 left  ");
    expect(progressText(2, 3, 90, 40, "a"), " 66% 2/3  0.0/s  0:45 left  a");

    // Without a total there is neither a bar nor the time left.
    expect(progressText(7, 0, 2, 80, "a.mp4"), "7  3.5/s  a.mp4");

    // A long label loses its start, and never half a character.
    expect(progressText(0, 2, 0, 30, "folder/with/a/long/name.png"),
           "  0% 0/2  .../a/long/name.png");
    const std::string umlauts = "\xC3\xA4\xC3\xB6\xC3\xBC\xC3\xA4\xC3\xB6\xC3\xBC.png";
    for (int width = 1; width < 40; ++width)
    {
        const std::string text = progressText(0, 2, 0, width, umlauts);
        const std::size_t dots = text.find("...");
        const bool cut = dots != std::string::npos && dots + 3 < text.size();
        expectTrue(!cut || (text[dots + 3] & 0xC0) != 0x80, "whole characters in: " + text);
    }

    for (int width = 1; width < 200; ++width)
        for (int done = 0; done <= 100; ++done)
            expectTrue(
                progressText(done, 100, done * 100.0, width, "photographs/house.png").size() <
                    static_cast<std::size_t>(width),
                "fits into " + std::to_string(width) + " columns");

    // More done than announced, as by a video that understates its frames.
    expectTrue(progressText(12, 10, 1, 80, "a").find("100%") != std::string::npos, "at most 100 %");
    expectTrue(progressText(12, 10, 1, 80, "a").find('-') == std::string::npos, "no negative time");
    return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
