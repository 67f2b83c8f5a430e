// SPDX-License-Identifier: Apache-2.0
// Checks that the meaning of a line in a candump log does not depend on the lines before it, and that a frame that is
// read and written again has the same text.
#include <fmt/format.h>
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "host/base/input_error.hpp"
#include "host/sim/bus/candump.hpp"
#include "host/sim/bus/frame_text.hpp"

namespace canproof::host {

namespace {

struct Line {
    std::string text;
    std::uint64_t us{0};
    bool error{false};
    bool coded{false};
};

std::string any_bytes(std::size_t count) {
    std::string bytes;
    for (std::size_t i = 0; i < count; ++i) {
        bytes += *rc::gen::element<std::string>("00", "05", "FF", "A9");
    }
    return bytes;
}

/// Returns a log line at time `us` with any mark (R or T), any interface and any kind of frame.
Line any_line(std::uint64_t us) {
    Line line;
    line.us = us;
    std::string frame = *rc::gen::element<std::string>("000", "181", "7FF", "00000000", "00000181", "1FFFFFFF");
    switch (*rc::gen::inRange(0, 6)) {
        case 0:
            frame = fmt::format("2000{:04X}#{}", *rc::gen::element(0, 4, 0x0100), any_bytes(8));
            line.error = true;
            break;
        case 1:
            frame += "#" + any_bytes(8) + "_" + *rc::gen::element<std::string>("9", "F");
            line.coded = true;
            break;
        case 2:
            frame += "#R" + *rc::gen::element<std::string>("", "1", "8");
            break;
        default:
            frame += "#" + any_bytes(*rc::gen::inRange<std::size_t>(0, 9));
            break;
    }
    line.text =
        fmt::format("({}.{:06}) {} {}{}", us / 1000000U, us % 1000000U, *rc::gen::element<std::string>("can0", "vcan7"),
                    frame, *rc::gen::element<std::string>("", "", " R", " T"));
    return line;
}

std::vector<Line> any_lines() {
    std::vector<Line> lines(*rc::gen::inRange<std::size_t>(0, 30));
    std::uint64_t us = 0;
    for (Line& line : lines) {
        us += *rc::gen::element<std::uint64_t>(0, 1, 999999, 1000000);
        line = any_line(us);
    }
    return lines;
}

std::string text_of(const std::vector<Line>& lines) {
    std::string text;
    for (const Line& line : lines) {
        text += line.text + *rc::gen::element<std::string>("\n", "\n", "\n\n", "\n  \n");
    }
    return text;
}

}  // namespace

RC_GTEST_PROP(CandumpLaw, EachLineOfALogIsReadIndependentlyOfTheOtherLines, ()) {
    const std::vector<Line> lines = any_lines();
    std::istringstream in{text_of(lines)};
    CandumpReader reader{in, "law"};
    LoggedFrame read;  // one object receives all lines in turn, as in a replay
    std::uint64_t errors = 0;
    std::uint64_t coded = 0;
    for (const Line& line : lines) {
        errors += line.error ? 1U : 0U;
        coded += line.coded ? 1U : 0U;
        if (line.error) {
            continue;
        }
        RC_ASSERT(reader.next(read));
        const LoggedFrame alone = parse_candump_line(line.text, "law");
        RC_ASSERT(read.time == Instant{line.us});
        RC_ASSERT(alone.time == read.time);
        RC_ASSERT(read.interface == alone.interface);
        RC_ASSERT(read.mark == alone.mark);
        RC_ASSERT(!read.error);
        RC_ASSERT(read.coded == line.coded);
        RC_ASSERT(are_alike(read.frame, alone.frame));
    }
    RC_ASSERT(!reader.next(read));
    RC_ASSERT(reader.counts().error_frames == errors);
    RC_ASSERT(reader.counts().coded_lengths == coded);
}

/// Times must not decrease; this also applies to error frames and to frames with a length code.
RC_GTEST_PROP(CandumpLaw, LogIsRefusedAtTheFirstLineWhoseTimeGoesBackwards, ()) {
    std::vector<Line> lines = any_lines();
    lines.push_back(any_line(3600000000U));
    lines.push_back(any_line(3599999999U));
    std::istringstream in{text_of(lines)};
    CandumpReader reader{in, "law"};
    LoggedFrame read;
    const auto is_error = [](const Line& line) { return line.error; };
    const auto errors = std::count_if(lines.begin(), lines.end() - 1, is_error);
    for (auto left = static_cast<std::ptrdiff_t>(lines.size()) - 1 - errors; left > 0; --left) {
        RC_ASSERT(reader.next(read));
    }
    bool is_refused = false;
    try {
        reader.next(read);
    } catch (const InputError&) {
        is_refused = true;
    }
    RC_ASSERT(is_refused);
}

RC_GTEST_PROP(CandumpLaw, FramesCompareEqualExactlyWhenTheirCandumpTextsAreEqual, ()) {
    const auto any_frame = [] {
        Frame frame{};
        frame.id = *rc::gen::element<std::uint32_t>(0x000, 0x181);
        frame.extended = *rc::gen::arbitrary<bool>();
        frame.remote = *rc::gen::arbitrary<bool>();
        frame.length = *rc::gen::element<std::uint8_t>(0, 1, 2, 8);
        for (std::uint8_t& byte : frame.data) {  // also bytes that do not count: those beyond the length, and those of
                                                 // a remote frame
            byte = *rc::gen::element<std::uint8_t>(0, 0, 0, 1);
        }
        return frame;
    };
    const Frame one = any_frame();
    const Frame other = any_frame();
    RC_ASSERT(are_alike(one, other) == (format_frame(one) == format_frame(other)));
    const Frame again = parse_frame(format_frame(one), "law");
    RC_ASSERT(format_frame(again) == format_frame(one));
    RC_ASSERT(again.extended == one.extended);
    RC_ASSERT(again.remote == one.remote);
    RC_ASSERT(again.length == one.length);
}

}  // namespace canproof::host
