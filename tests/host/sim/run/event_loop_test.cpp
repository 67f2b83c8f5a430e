// SPDX-License-Identifier: Apache-2.0
// Tests the event loop: ready descriptors, time-outs and signals. Each wait has a pause of zero, or ends because of an
// event that has already happened.
#include "host/sim/run/event_loop.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>

#include "host/sim/run/line_input.hpp"

namespace canproof::host::test {

namespace {

constexpr Duration long_pause = milliseconds(60000);  // reached only with a broken loop

class Pipe {
  public:
    Pipe() { EXPECT_EQ(pipe(ends_.data()), 0); }
    ~Pipe() {
        close(ends_[0]);
        shut();
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;

    int reader() const { return ends_[0]; }
    int writer() const { return ends_[1]; }
    void say(const std::string& text) const {
        EXPECT_EQ(write(ends_[1], text.data(), text.size()), static_cast<ssize_t>(text.size()));
    }
    void shut() {
        if (ends_[1] >= 0) {
            close(ends_[1]);
            ends_[1] = -1;
        }
    }

  private:
    std::array<int, 2> ends_{-1, -1};
};

}  // namespace

TEST(EventLoop, LoopWakesForReadyDescriptorsOnly) {
    EventLoop loop;
    Pipe busy;
    Pipe calm;
    busy.say("x");
    loop.wait({{busy.reader(), true, false}, {calm.reader(), true, false}}, long_pause);
    EXPECT_TRUE(loop.is_ready(busy.reader()));
    EXPECT_FALSE(loop.is_ready(calm.reader()));
    EXPECT_FALSE(loop.is_interrupted());
}

TEST(EventLoop, LoopWakesAtItsTimeout) {
    EventLoop loop;
    Pipe calm;
    loop.wait({{calm.reader(), true, false}}, Duration{0});
    EXPECT_FALSE(loop.is_ready(calm.reader()));
    loop.wait({{calm.reader(), true, false}}, Duration{1});
    EXPECT_FALSE(loop.is_ready(calm.reader()));
}

TEST(EventLoop, LoopWatchesOnlyTheDescriptorsOfItsLatestWait) {
    EventLoop loop;
    Pipe one;
    one.say("x");
    loop.wait({{one.reader(), true, false}}, long_pause);
    EXPECT_TRUE(loop.is_ready(one.reader()));
    loop.wait({}, Duration{0});
    EXPECT_FALSE(loop.is_ready(one.reader()));
    loop.wait({{one.writer(), false, true}}, long_pause);  // the pipe has room
    EXPECT_TRUE(loop.is_ready(one.writer()));
    loop.wait({{one.writer(), true, false}}, Duration{0});  // a writer is never ready for reading
    EXPECT_FALSE(loop.is_ready(one.writer()));
}

TEST(EventLoop, RegularFileIsAlwaysReady) {
    EventLoop loop;
    std::FILE* const file = std::tmpfile();
    ASSERT_NE(file, nullptr);
    loop.wait({{fileno(file), true, false}}, long_pause);
    EXPECT_TRUE(loop.is_ready(fileno(file)));
    std::fclose(file);
}

TEST(EventLoop, DescriptorReusedAfterAFileIsReadyOnlyWhenItHasData) {
    EventLoop loop;
    const Pipe source;
    std::FILE* file = std::tmpfile();
    ASSERT_NE(file, nullptr);
    const int descriptor = fileno(file);
    loop.wait({{descriptor, true, false}}, long_pause);
    EXPECT_TRUE(loop.is_ready(descriptor));
    loop.wait({}, Duration{0});
    EXPECT_FALSE(loop.is_ready(descriptor));
    ASSERT_EQ(dup2(source.reader(), descriptor), descriptor);  // the number now belongs to a pipe without data
    loop.wait({{descriptor, true, false}}, Duration{0});
    EXPECT_FALSE(loop.is_ready(descriptor));
    source.say("x");
    loop.wait({{descriptor, true, false}}, long_pause);
    EXPECT_TRUE(loop.is_ready(descriptor));
    std::fclose(file);
}

TEST(EventLoop, TerminationSignalIsReportedAndTheProcessContinues) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        const auto before = std::signal(signal, SIG_DFL);  // the process that started the tests may ignore the signal
        {
            EventLoop loop;
            std::raise(signal);
            loop.wait({}, long_pause);
            EXPECT_TRUE(loop.is_interrupted()) << signal;
        }
        std::signal(signal, before);
    }
}

TEST(EventLoop, IgnoredHangupSignalDoesNotEndTheLoop) {
    const auto before = std::signal(SIGHUP, SIG_IGN);  // SIGHUP is ignored, as under nohup
    {
        EventLoop loop;
        std::raise(SIGHUP);
        loop.wait({}, Duration{1});
        EXPECT_FALSE(loop.is_interrupted());
    }
    std::signal(SIGHUP, before);
}

TEST(LineInput, LineIsReturnedWhenItsEndHasArrived) {
    Pipe pipe;
    LineInput input{pipe.reader()};
    using Lines = std::vector<std::string>;
    pipe.say("000#01");
    EXPECT_EQ(input.read_lines(), Lines{});
    pipe.say("00\r\n\n703#R\n60");
    EXPECT_EQ(input.read_lines(), (Lines{"000#0100", "703#R"}));
    pipe.say("3#40");
    EXPECT_EQ(input.read_lines(), Lines{});
    EXPECT_TRUE(input.is_open());
    pipe.shut();
    EXPECT_EQ(input.read_lines(), Lines{"603#40"});
    EXPECT_FALSE(input.is_open());
}

TEST(LineInput, EndlessLineUsesBoundedMemory) {
    Pipe pipe;
    LineInput input{pipe.reader()};
    for (int i = 0; i < 4; ++i) {
        pipe.say(std::string(3000, 'x'));
        EXPECT_TRUE(input.read_lines().empty());
    }
    pipe.say("\n703#05\n");
    const auto lines = input.read_lines();
    ASSERT_FALSE(lines.empty());
    EXPECT_EQ(lines.back(), "703#05");
    EXPECT_LE(lines.front().size(), 2 * LineInput::longest_line);
}

}  // namespace canproof::host::test
