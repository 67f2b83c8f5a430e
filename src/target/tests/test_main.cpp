// SPDX-License-Identifier: Apache-2.0
// Runs the tests of an image. Options: those of GoogleTest, --verdicts=FILE, --frame-log=FILE, --work=FILE and
// --every-work=FILE; --shard=I/N runs every Nth test, starting with test I, counted from 0.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "host/sim/bus/candump.hpp"
#include "semihosting.hpp"
#include "tests/support/bench_frame_log.hpp"
#include "work_log.hpp"

namespace {

using namespace canproof;

std::string running_test() {
    const testing::TestInfo* const test = testing::UnitTest::GetInstance()->current_test_info();
    return test == nullptr ? "-" : std::string{test->test_suite_name()} + "." + test->name();
}

/// Writes a line per test: `passed Suite.Test` or `failed Suite.Test`. GoogleTest's own XML would need the whole report
/// in RAM at once.
class Verdicts : public testing::EmptyTestEventListener {
  public:
    explicit Verdicts(const std::string& path) : file_{std::fopen(path.c_str(), "wb")} {}

  private:
    void OnTestEnd(const testing::TestInfo& test) override {
        std::fprintf(file_, "%s %s.%s\n", test.result()->Passed() ? "passed" : "failed", test.test_suite_name(),
                     test.name());
    }
    void OnTestProgramEnd(const testing::UnitTest&) override { std::fclose(file_); }

    std::FILE* file_;
};

bool is_of_a_frame(test::Work work) {
    return work != test::Work::power_on && work != test::Work::tick && work != test::Work::first_tick &&
           work != test::Work::crowded_tick;
}

void watch_work() {
    test::bench_watch.begins = target::work_begins;
    test::bench_watch.ends = [](test::Work work, const char* what) {
        target::work_stops();
        if (is_of_a_frame(work)) {
            target::note_frame(work, host::parse_frame(what, "test"), what, running_test());
        } else {
            target::note_work(work, "-", running_test());
        }
    };
    static void (*const write_down)(Instant, const Frame&) = test::bench_watch.said;
    test::bench_watch.said = [](Instant now, const Frame& frame) {
        write_down(now, frame);
        target::note_answer(frame);
    };
}

}  // namespace

extern "C" void image_main() {
    std::vector<std::string> words = target::begin_image();
    const std::string log = target::take_option(words, "frame-log");
    const std::string verdicts = target::take_option(words, "verdicts");
    const std::string work = target::take_option(words, "work");
    if (!log.empty()) {
        test::open_frame_log(log.c_str());
    }
    if (!verdicts.empty()) {
        testing::UnitTest::GetInstance()->listeners().Append(new Verdicts{verdicts});
    }
    if (!work.empty()) {
        watch_work();
    }
    const std::string every_work = target::take_option(words, "every-work");
    if (!every_work.empty()) {
        target::write_every_work(every_work);
    }
    const std::string shard = target::take_option(words, "shard");
    if (!shard.empty()) {
        setenv("GTEST_SHARD_INDEX", shard.substr(0, shard.find('/')).c_str(), 1);
        setenv("GTEST_TOTAL_SHARDS", shard.substr(shard.find('/') + 1).c_str(), 1);
    }
    std::vector<char*> argv;
    for (std::string& word : words) {
        argv.push_back(word.data());
    }
    int argc = static_cast<int>(argv.size());
    argv.push_back(nullptr);
    testing::InitGoogleTest(&argc, argv.data());
    const int status = RUN_ALL_TESTS();
    if (!work.empty()) {
        static_cast<void>(target::write_work(work));
    }
    std::exit(status);
}
