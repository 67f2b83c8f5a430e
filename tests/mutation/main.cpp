// SPDX-License-Identifier: Apache-2.0
// A test program that can alter cells (values) of the generated tables. `canproof mutate` runs it. Arguments in
// addition to those of GoogleTest:
//   --cells   prints `number TAB item TAB cell TAB change` for each alteration
//   --serve   reads lines `number TAB milliseconds TAB filter`. For each line, a forked copy of this process alters the
//             cell and runs the tests of the filter. The answer is `number TAB killed TAB Suite.Test` when this test
//             failed, or `number TAB survived`. A copy that takes more processor time than `milliseconds`, or waits
//             much longer than that, counts as killed.
// With CANPROOF_ALTER=number in the environment, this alteration takes place before the program computes anything from
// the altered value. With CANPROOF_ALTER_MILLISECONDS=milliseconds, the program ends when it has taken more processor
// time than this, or waits much longer.
#include <gtest/gtest.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <string>

#include "host/codegen/alteration.hpp"

namespace canproof::test {

namespace {

using host::generated_alterations;

// A process that waits is ended after this time in seconds, plus `most_processes_a_core` times its limit of processor
// time, because it may share its core with many other processes.
constexpr unsigned most_seconds_waited = 30;
constexpr unsigned most_processes_a_core = 20;

/// Ends this process after this many milliseconds of processor time, because an alteration may lead to an endless loop.
/// Also ends it after a much longer real time, because an alteration may make the process wait for ever.
void limit_to(const unsigned milliseconds) {
    constexpr unsigned in_a_second = 1000;
    constexpr suseconds_t microseconds = 1000;
    const unsigned seconds = milliseconds / in_a_second;
    const suseconds_t rest = static_cast<suseconds_t>(milliseconds % in_a_second) * microseconds;
    const itimerval limit{{0, 0}, {static_cast<time_t>(seconds), rest}};
    setitimer(ITIMER_PROF, &limit, nullptr);
    alarm(most_seconds_waited + most_processes_a_core * (seconds + 1U));
}

void alter(std::size_t number) {
    const auto all = generated_alterations();
    if (number >= all.count) {
        std::cerr << "there are " << all.count << " alterations; " << number << " is none of them\n";
        std::_Exit(2);
    }
    const host::Alteration& one = all.first[number];
    std::memcpy(one.address, &one.bits, one.size);
}

/// Runs before the constructors of all global objects, because these constructors compute values from the tables.
__attribute__((constructor(101))) void alter_as_environment_says() {
    if (const char* number = std::getenv("CANPROOF_ALTER")) {
        alter(std::strtoul(number, nullptr, 10));
        if (const char* limit = std::getenv("CANPROOF_ALTER_MILLISECONDS")) {
            limit_to(static_cast<unsigned>(std::strtoul(limit, nullptr, 10)));
        }
    }
}

void print_cells() {
    std::size_t number = 0;
    for (const host::Alteration& one : generated_alterations()) {
        std::printf("%zu\t%s\t%s\t%s\n", number++, one.item, one.cell, one.change);
    }
}

/// Ends the process at the first failure, and writes the name of the failed test to the process that runs `--serve`.
class FirstFailure : public testing::EmptyTestEventListener {
  public:
    explicit FirstFailure(int out) : out_{out} {}
    void OnTestStart(const testing::TestInfo& info) override {
        name_ = std::string{info.test_suite_name()} + "." + info.name();
    }
    void OnTestPartResult(const testing::TestPartResult& result) override {
        if (result.failed()) {
            static_cast<void>(!write(out_, name_.data(), name_.size()));
            std::_Exit(1);
        }
    }

  private:
    int out_;
    std::string name_;
};

/// One line of the input of `--serve`.
struct Wanted {
    std::size_t number;
    unsigned milliseconds;
    std::string filter;
};

Wanted wanted_by(const std::string& line) {
    char* rest = nullptr;
    const std::size_t number = std::strtoul(line.c_str(), &rest, 10);
    const auto milliseconds = static_cast<unsigned>(std::strtoul(rest, &rest, 10));
    return {number, milliseconds, *rest == '\t' ? rest + 1 : "*"};
}

[[noreturn]] void run_altered(const Wanted& wanted, int out) {
    alter(wanted.number);
    limit_to(wanted.milliseconds);
    static_cast<void>(std::freopen("/dev/null", "w", stdout));
    static_cast<void>(std::freopen("/dev/null", "w", stderr));
    auto& listeners = testing::UnitTest::GetInstance()->listeners();
    delete listeners.Release(listeners.default_result_printer());
    listeners.Append(new FirstFailure{out});
    testing::GTEST_FLAG(filter) = wanted.filter;
    std::_Exit(RUN_ALL_TESTS());
}

/// Runs a forked copy of this process and prints its result: the failed test, or `survived`.
void answer(const Wanted& wanted) {
    int ends[2];
    if (pipe(ends) != 0) {
        std::perror("pipe");
        std::_Exit(2);
    }
    const pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        run_altered(wanted, ends[1]);
    }
    close(ends[1]);
    std::string failed;
    char piece[256];
    for (ssize_t count = 0; (count = read(ends[0], piece, sizeof piece)) > 0;) {
        failed.append(piece, static_cast<std::size_t>(count));
    }
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) {
        std::printf("%zu\tsurvived\n", wanted.number);
    } else if (WIFSIGNALED(status)) {
        std::printf("%zu\tkilled\tsignal %d\n", wanted.number, WTERMSIG(status));
    } else {
        std::printf("%zu\tkilled\t%s\n", wanted.number, failed.c_str());
    }
    std::fflush(stdout);
}

void serve() {
    for (std::string line; std::getline(std::cin, line);) {
        answer(wanted_by(line));
    }
}

}  // namespace

}  // namespace canproof::test

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    const std::string word = argc > 1 ? argv[1] : "";
    if (word == "--cells") {
        canproof::test::print_cells();
        return 0;
    }
    if (word == "--serve") {
        canproof::test::serve();
        return 0;
    }
    return RUN_ALL_TESTS();
}
