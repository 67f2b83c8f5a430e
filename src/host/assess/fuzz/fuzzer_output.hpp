// SPDX-License-Identifier: Apache-2.0
// Parses the output of libFuzzer and the sanitizers.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace canproof::host {

/// One line of libFuzzer's progress output, with or without fork mode.
struct FuzzerProgress {
    std::uint64_t executions{0};
    std::uint64_t edges{0};
    std::uint64_t features{0};
};

/// Parses `#4096 pulse cov: 120 ft: 300 …` or `#4096: cov: 120 ft: 300 …`; returns nothing for any other line.
std::optional<FuzzerProgress> parse_progress(const std::string& line);

/// The reason why a run of a fuzz target ended too early.
struct Failure {
    std::string kind;                 ///< `heap-buffer-overflow`, `requirement violated`, `timeout`, …
    std::string place;                ///< `fuzz/pdo_fuzz.cpp:167`; empty when the output names no place
    std::vector<std::string> frames;  ///< functions of the code under test, innermost first, without arguments

    /// Returns a title that is equal for equal bugs. It consists of the kind and the place of the violated requirement,
    /// or of the kind and the three innermost functions.
    std::string title() const;
    /// Returns a hash of the title as eight hexadecimal digits.
    std::string signature() const;
};

/// Parses the output of a run with one input, which failed. The kind of the failure is `unknown` when the output
/// contains no known failure.
Failure parse_failure(const std::string& output);

}  // namespace canproof::host
