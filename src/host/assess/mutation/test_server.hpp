// SPDX-License-Identifier: Apache-2.0
// A running test program in which single cells (values in generated tables) can be altered. For each request, it alters
// a cell in a copy of its process and runs tests there. See tests/mutation/main.cpp.
#pragma once

#include <sys/types.h>

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "host/base/child_process.hpp"

namespace canproof::host {

std::vector<std::string> tab_separated(const std::string& line);

/// One alteration of a cell, as a line of the program's `--cells` output.
struct AlteredCell {
    std::size_t number{0};
    std::string item;
    std::string cell;
    std::string change;
};

/// Returns the alterations that the program can make. Throws InputError when it cannot be run or its output is invalid.
std::vector<AlteredCell> read_cells(const std::filesystem::path& program);

/// Tests to run with an alteration.
struct TestSelection {
    std::string filter;     ///< in the form of --gtest_filter
    double unaltered{0.0};  ///< processor time, in seconds, of these tests without an alteration

    /// Returns the limit, in milliseconds, of the processor time of these tests with an alteration, in a program that
    /// has started before. An endless loop reaches this limit.
    unsigned limit() const;
    /// Returns the same limit for a program that starts with the alteration.
    unsigned limit_with_start() const;
};

class TestServer {
  public:
    explicit TestServer(const std::filesystem::path& program);
    TestServer(const TestServer&) = delete;
    TestServer& operator=(const TestServer&) = delete;
    ~TestServer();

    /// Runs the selected tests with the cell altered. Returns the failed test, or how the process ended. Returns an
    /// empty text when all tests passed. Throws InputError when the server has ended.
    std::string run(std::size_t number, const TestSelection& tests);

  private:
    pid_t process_{-1};
    PipeStream to_;
    PipeStream from_;
};

/// Starts the program with alteration `number` (of a table cell or of the code) in force from the beginning, so that
/// values which the program computes at its start are wrong, too. Returns whether the run did not pass: a test failed,
/// the process died, or it reached the limit of the processor time.
bool fails_when_started_altered(const std::filesystem::path& program, std::size_t number, const TestSelection& tests);

/// Runs all tests of the program without an alteration and writes their results to the file `verdicts`. Each element of
/// `more_environment` is `NAME=value`. Throws InputError, with the names of the failed tests, when not all pass.
void pass_unaltered(const std::filesystem::path& program, const std::filesystem::path& verdicts,
                    const std::vector<std::string>& more_environment = {});

}  // namespace canproof::host
