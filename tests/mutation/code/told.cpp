// SPDX-License-Identifier: Apache-2.0
// With CANPROOF_TOLD=FILE in the environment, each test writes one line to that file. The line has the name of the
// test, its source, its processor time in seconds, and mutants. These are all mutants that would have computed a
// different value during the test, or in a child process that the test has forked. Only the tests whose lines contain a
// mutant can notice it.
#include <gtest/gtest.h>
#include <sys/mman.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>

#include "host/codegen/alteration.hpp"

namespace canproof::test {

namespace {

/// Returns zeros that this process shares with the child processes that it forks.
unsigned char* shared_bytes(std::size_t count) {
    void* const bytes = mmap(nullptr, count, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (bytes == MAP_FAILED) {
        std::perror("mmap");
        std::_Exit(2);
    }
    return static_cast<unsigned char*>(bytes);
}

class Teller : public testing::EmptyTestEventListener {
  public:
    explicit Teller(const char* file) : out_{std::fopen(file, "w")} {}

    /// Writes the line `startup`: the mutants that were evaluated before the first test, in global objects.
    void OnTestProgramStart(const testing::UnitTest& /*all*/) override {
        if (mutants::told != nullptr) {
            std::copy_n(mutants::told, count_, told_);
            mutants::told = nullptr;
            write("startup", "-", 0.0);
        }
    }
    void OnTestStart(const testing::TestInfo& /*test*/) override {
        std::fill_n(told_, count_, static_cast<unsigned char>(0));
        mutants::told = told_;
        began_ = std::clock();
    }
    void OnTestEnd(const testing::TestInfo& test) override {
        mutants::told = nullptr;
        write(std::string{test.test_suite_name()} + "." + test.name(), test.file(),
              static_cast<double>(std::clock() - began_) / CLOCKS_PER_SEC);
    }

  private:
    void write(const std::string& name, const char* const file, const double seconds) {
        std::fprintf(out_, "%s\t%s\t%.3f", name.c_str(), file, seconds);
        for (std::size_t mutant = 1; mutant < count_; ++mutant) {
            if (told_[mutant] != 0U) {
                std::fprintf(out_, "\t%zu", mutant - 1U);
            }
        }
        std::fprintf(out_, "\n");
        std::fflush(out_);
    }

    std::FILE* out_;
    std::size_t count_{host::generated_alterations().count + 2U};
    unsigned char* told_{shared_bytes(count_)};
    std::clock_t began_{0};
};

/// Runs before the constructors of all global objects, so that mutants in values that they compute are recorded too.
__attribute__((constructor(101))) void listen_from_the_start() {
    if (std::getenv("CANPROOF_TOLD") != nullptr) {
        mutants::told = static_cast<unsigned char*>(std::calloc(host::generated_alterations().count + 2U, 1U));
    }
}

struct Listening {
    Listening() {
        if (const char* file = std::getenv("CANPROOF_TOLD")) {
            testing::UnitTest::GetInstance()->listeners().Append(new Teller{file});
        }
    }
};

const Listening listening;

}  // namespace

}  // namespace canproof::test
