// SPDX-License-Identifier: Apache-2.0
// Tests how this program starts other programs and waits for them.
#include "host/base/child_process.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>

#include "host/base/input_error.hpp"

namespace canproof::test {

namespace {

/// While an object of this class exists, SIGUSR1 interrupts the system calls of this process.
class InterruptingSignal {
  public:
    InterruptingSignal() {
        struct sigaction action {};
        action.sa_handler = [](int) {};
        sigaction(SIGUSR1, &action, &before_);
    }
    ~InterruptingSignal() { sigaction(SIGUSR1, &before_, nullptr); }
    InterruptingSignal(const InterruptingSignal&) = delete;
    InterruptingSignal& operator=(const InterruptingSignal&) = delete;

  private:
    struct sigaction before_ {};
};

}  // namespace

TEST(ChildProcess, ExitStatusIsReturnedAlthoughSignalsInterruptTheWait) {
    const InterruptingSignal signal;
    const char* const script = "for i in 1 2 3 4 5 6 7 8 9; do kill -USR1 $PPID; sleep 0.01; done; exit 3";
    EXPECT_EQ(host::wait_for_process(host::start_process({"sh", "-c", script}, {}, {})), 3);
}

TEST(ChildProcess, StatusOfAProcessEndedByASignalIs128PlusItsNumber) {
    EXPECT_EQ(host::wait_for_process(host::start_process({"sh", "-c", "kill -TERM $$"}, {}, {})), 128 + SIGTERM);
}

TEST(ChildProcess, ProgramThatCannotRunIsReportedWithTheReason) {
    try {
        host::start_process({"/nonexistent/program"}, {}, {});
        FAIL() << "the program does not exist";
    } catch (const host::InputError& error) {
        EXPECT_STREQ(error.what(),
                     "cannot run /nonexistent/program: No such file or directory; check that /nonexistent/program is "
                     "built or installed and may be executed");
    }
}

TEST(ChildProcess, AddedEnvironmentVariableReplacesThatOfTheCaller) {
    ASSERT_EQ(setenv("CANPROOF_TEST_SETTING", "caller", 1), 0);
    ASSERT_EQ(setenv("CANPROOF_TEST_SETTING_2", "kept", 1), 0);
    const char* const script =
        "test $(env | grep -c ^CANPROOF_TEST_SETTING=) = 1 && test $CANPROOF_TEST_SETTING = own && "
        "test $CANPROOF_TEST_SETTING_2 = kept";
    const pid_t child = host::start_process({"sh", "-c", script}, {"CANPROOF_TEST_SETTING=own"}, {});
    unsetenv("CANPROOF_TEST_SETTING");
    unsetenv("CANPROOF_TEST_SETTING_2");
    EXPECT_EQ(host::wait_for_process(child), 0);
}

TEST(ChildProcess, WaitForAProcessThatIsNoChildIsRefused) {
    EXPECT_THROW(host::wait_for_process(1), host::InputError);
}

TEST(ChildProcess, ReapingAProcessThatIsNoChildThrowsNothing) {
    host::reap_process(1);
    const pid_t child = host::start_process({"true"}, {}, {});
    host::reap_process(child);
    EXPECT_THROW(host::wait_for_process(child), host::InputError) << "it has been waited for";
}

}  // namespace canproof::test
