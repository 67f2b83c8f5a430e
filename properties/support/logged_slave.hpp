// SPDX-License-Identifier: Apache-2.0
// The conformance slave for properties that perform a sequence of steps. It records all frames as a candump log. A
// property that fails prints this log, which `canproof replay` can read.
#pragma once

#include <fmt/format.h>
#include <rapidcheck.h>

#include "tests/support/slave_bench.hpp"

namespace canproof::test {

/// Returns a frame as `ID#DATA` or `ID#R`.
inline std::string frame_text(unsigned id, const std::vector<std::uint8_t>& data, bool remote = false) {
    std::string text = fmt::format("{:03X}#{}", id, remote ? "R" : "");
    for (const std::uint8_t byte : data) {
        text += fmt::format("{:02X}", byte);
    }
    return text;
}

class LoggedSlave : public SlaveBench {
  public:
    /// Sends a frame to the slave. Adds the frames that the slave sends to `heard`, each with its time in ms.
    void play(const std::string& frame) {
        note(frame);
        for (const auto& answer : send(frame)) {
            hear(answer);
        }
        play_pause(0);
    }
    void play_pause(std::uint64_t ms) {
        const std::uint64_t begin = now.us / 1000U;
        for (const auto& line : pass(ms)) {
            const auto colon = line.find(':');
            heard.emplace_back(begin + std::stoull(line.substr(0, colon)), line.substr(colon + 1));
        }
    }
    void hear(const std::string& frame) { heard.emplace_back(now.us / 1000U, frame); }
    void hear(const Frames& frames) {
        for (const auto& frame : frames) {
            hear(frame);
        }
    }

    /// Checks that `holds` is true. Otherwise prints `what`, the name of what differs, and the log, and fails the
    /// property.
    void demand(bool holds, const std::string& what) const {
        if (!holds) {
            RC_LOG() << what << " differs after\n" << log_;
        }
        RC_ASSERT(holds);
    }

    std::vector<std::pair<std::uint64_t, std::string>> heard;

  private:
    void note(const std::string& frame) {
        log_ += fmt::format("({}.{:06}) can0 {}\n", now.us / 1000000U, now.us % 1000000U, frame);
    }
    std::string log_;
};

/// Generates numbers from 0 to `limit`. Small numbers, and numbers near 50, 100 and `limit`, are more frequent.
inline rc::Gen<unsigned> number_up_to(unsigned limit) {
    return rc::gen::map(rc::gen::weightedOneOf<unsigned>(
                            {{4, rc::gen::inRange(0U, limit + 1)},
                             {3, rc::gen::element(0U, 1U, 2U, 3U, 4U, 5U, 10U, 49U, 50U, 51U, 99U, 100U, 101U)},
                             {1, rc::gen::element(limit, limit - 1)}}),
                        [limit](unsigned number) { return number > limit ? limit : number; });
}

}  // namespace canproof::test
