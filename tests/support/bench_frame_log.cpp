// SPDX-License-Identifier: Apache-2.0
#include "tests/support/bench_frame_log.hpp"

#include <gtest/gtest.h>

#include <array>
#include <charconv>
#include <cstdio>
#include <cstdlib>

#include "tests/support/bench_watch.hpp"

namespace canproof::test {

namespace {

std::FILE* log_file = nullptr;

void write_line(Instant now, char direction, const Frame& frame) {
    // Formats without fmt, which may allocate memory: the test that checks that nothing allocates memory also writes a
    // log.
    constexpr const char* digits = "0123456789ABCDEF";
    std::array<char, 24> data{};
    auto* end = data.data();
    if (frame.remote) {
        *end++ = 'R';
        *end++ = static_cast<char>('0' + frame.length);
    }
    for (std::size_t i = 0; !frame.remote && i < frame.length; ++i) {
        *end++ = digits[frame.data[i] >> 4U];
        *end++ = digits[frame.data[i] & 0xFU];
    }
    *end++ = '\n';
    *end = '\0';
    std::array<char, 48> head{};
    // The C library of the microcontroller prints no numbers of 64 bits.
    char* const after_time = std::to_chars(head.data(), head.data() + head.size(), now.us).ptr;
    std::snprintf(after_time, head.size() - static_cast<std::size_t>(after_time - head.data()), " %c%0*lX#", direction,
                  frame.extended ? 8 : 3, static_cast<unsigned long>(frame.id));
    std::fputs(head.data(), log_file);
    std::fputs(data.data(), log_file);
}

class Headings : public testing::EmptyTestEventListener {
    void OnTestStart(const testing::TestInfo& test) override {
        std::fprintf(log_file, "# %s.%s\n", test.test_suite_name(), test.name());
    }
    void OnTestProgramEnd(const testing::UnitTest&) override { std::fflush(log_file); }
};

/// Opens a log if the environment variable CANPROOF_FRAME_LOG names a file.
[[maybe_unused]] const bool asked_for = [] {
    const char* const path = std::getenv("CANPROOF_FRAME_LOG");
    if (path != nullptr) {
        open_frame_log(path);
    }
    return path != nullptr;
}();

}  // namespace

void open_frame_log(const char* path) {
    static std::array<char, 4096> buffer;
    log_file = std::fopen(path, "wb");
    if (log_file == nullptr) {
        std::fprintf(stderr, "cannot write %s\n", path);
        std::exit(2);
    }
    std::setvbuf(log_file, buffer.data(), _IOFBF, buffer.size());
    bench_watch.heard = [](Instant now, const Frame& frame) { write_line(now, '<', frame); };
    bench_watch.said = [](Instant now, const Frame& frame) { write_line(now, '>', frame); };
    testing::UnitTest::GetInstance()->listeners().Append(new Headings);
}

}  // namespace canproof::test
