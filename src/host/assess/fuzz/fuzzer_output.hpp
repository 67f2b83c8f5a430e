// What libFuzzer and the sanitizers print, read.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace canproof::host {

/// One line of libFuzzer's progress, alone or in fork mode.
struct FuzzerProgress {
    std::uint64_t executions{0};
    std::uint64_t edges{0};
    std::uint64_t features{0};
};

/// `#4096 pulse cov: 120 ft: 300 …` or `#4096: cov: 120 ft: 300 …`; nothing for any other line.
std::optional<FuzzerProgress> parse_progress(const std::string& line);

/// Why a run ended before its time.
struct Failure {
    std::string kind;                 ///< `heap-buffer-overflow`, `requirement violated`, `timeout`, …
    std::string place;                ///< `fuzz/pdo_fuzz.cpp:167`; empty when the output names none
    std::vector<std::string> frames;  ///< functions of ours, innermost first, without arguments

    /// Equal for equal bugs: the kind with the requirement's place, or with the three innermost functions.
    std::string title() const;
    /// Eight hexadecimal digits of the title.
    std::string signature() const;
};

/// What the output of one run of one input says. An output that says nothing gives the kind `unknown`.
Failure parse_failure(const std::string& output);

}  // namespace canproof::host
