// With CANPROOF_TOLD=FILE in the environment each test leaves a line there: its name, its seconds, and the mutants that
// would have computed something else in it. No other test can notice them.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <vector>

#include "host/mutation/alteration.hpp"

namespace canproof::test {

namespace {

class Teller : public testing::EmptyTestEventListener {
  public:
    explicit Teller(const char* file) : out_{std::fopen(file, "w")}, told_(host::generated_alterations().count + 2U) {}

    void OnTestStart(const testing::TestInfo& /*test*/) override {
        told_.assign(told_.size(), 0U);
        mutants::told = told_.data();
    }
    void OnTestEnd(const testing::TestInfo& test) override {
        mutants::told = nullptr;
        std::fprintf(out_, "%s.%s\t%.3f", test.test_suite_name(), test.name(),
                     static_cast<double>(test.result()->elapsed_time()) / 1000.0);
        for (std::size_t mutant = 1; mutant < told_.size(); ++mutant) {
            if (told_[mutant] != 0U) {
                std::fprintf(out_, "\t%zu", mutant - 1U);
            }
        }
        std::fprintf(out_, "\n");
        std::fflush(out_);
    }

  private:
    std::FILE* out_;
    std::vector<unsigned char> told_;
};

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
