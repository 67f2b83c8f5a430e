// SPDX-License-Identifier: Apache-2.0
// Tests the verdicts of the conformance engine on slaves that are correct, wrong, silent or unstable.
#include "host/conform/run/run_cases.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/input_error.hpp"
#include "tests/host/conform/conform_bench.hpp"

namespace canproof::host::conform::test {

namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::uint32_t sdo_answer = 0x585;

TEST(ConformRun, CorrectSlavePasses) {
    const CaseResult result = run_steps_on_slave("sdo 40 00 10 00\nanswer 43 00 10 00\nread 1017:00 = 0");
    EXPECT_EQ(result.verdict, Verdict::passed) << result.why;
    EXPECT_EQ(result.times.at("SDO answer").times.size(), 2U);
}

TEST(ConformRun, FailingStepIsReportedWithItsLine) {
    const CaseResult result = run_steps_on_slave("read 1000:00\nread 1000:01 fails 06020000");
    EXPECT_EQ(result.verdict, Verdict::failed);
    EXPECT_THAT(result.why, HasSubstr("abort 06090011h instead of 06020000h"));
    EXPECT_THAT(result.step, HasSubstr("some.toml:9: read 1000:01"));
    EXPECT_FALSE(result.frames.empty());
}

TEST(ConformRun, SkippedCaseStatesWhyItWasSkipped) {
    EXPECT_THAT(run_steps_on_slave("read 1000:00", "needs = [\"5555\"]").why, HasSubstr("no object 5555h"));
    EXPECT_THAT(run_steps_on_slave("choose E: writable, const\nread $E").why, HasSubstr("writable, const"));
    EXPECT_THAT(run_steps_on_slave("read 1000:00 -> v\nskip unless $v == 1 \"of another type\"").why,
                HasSubstr("of another type"));
    const CaseResult left_out = run_steps_on_slave("each TPDO as P {\nnext unless 0 \"not this one\"\n}");
    EXPECT_EQ(left_out.verdict, Verdict::skipped);
    EXPECT_EQ(left_out.why, "not this one");
}

TEST(ConformRun, CaseThatCannotBeJudgedIsReportedAsBroken) {
    EXPECT_EQ(run_steps_on_slave("wait 1 ms").verdict, Verdict::broken);
    EXPECT_EQ(run_steps_on_slave("wait $unknown").verdict, Verdict::broken);
    EXPECT_EQ(run_steps_on_slave("while 1 {\nwait 1 us\n}").verdict, Verdict::broken);
}

TEST(ConformRun, ProcedureHasItsOwnVariables) {
    const std::string procedure =
        "[[procedure]]\nname = \"twice\"\ntakes = [\"a\"]\nsteps = '''\nlet b = $a * 2\nreturn $b\n'''\n";
    VirtualTarget target{sound_slave(), 5};
    const std::string steps = "let b = 1\ndo twice 21 -> c\ncheck $c == 42 \"twice\"\ncheck $b == 1 \"kept\"";
    const ConformReport report = run_on(target, case_text("some", steps) + procedure);
    EXPECT_EQ(report.results.at(0).verdict, Verdict::passed) << report.results.at(0).why;
}

TEST(ConformRun, ReturnOrNextCommandInTheRestoreStepsIsReported) {
    const CaseResult returned = run_steps_on_slave("read 1000:00", "restore = '''\nreturn 1\n'''");
    EXPECT_EQ(returned.verdict, Verdict::failed);
    ASSERT_EQ(returned.left.size(), 1U);
    EXPECT_EQ(returned.left.front(),
              "the restore step `return 1` failed: a `return` stands outside of a procedure; remove it");
    const CaseResult next =
        run_steps_on_slave("read 1000:00", "restore = '''\nnext unless 0 \"nothing to restore\"\n'''");
    EXPECT_EQ(next.verdict, Verdict::failed);
    ASSERT_EQ(next.left.size(), 1U);
    EXPECT_THAT(next.left.front(), HasSubstr("failed: nothing to restore"));
}

// The slave sends a heartbeat each 100 ms.
TEST(ConformRun, RestoreStepsCanExpectFramesThatAWatchStepHasCollected) {
    const CaseResult result =
        run_steps_on_slave("write 1017:00 = 100\nwatch 700+N as hb\nwait 1 s\ncheck $hb.count == 10 \"ten\"",
                           "restore = '''\nexpect 700+N: 7F within 200 ms\n'''");
    EXPECT_EQ(result.verdict, Verdict::passed) << result.why;
    EXPECT_THAT(result.left, IsEmpty());
}

TEST(ConformRun, SlaveThatIsStuckAfterACaseEndsTheRun) {
    bool written = false;
    bool stuck = false;
    VirtualTarget target{std::make_unique<HookedSlave>(
                             [&](Frame& frame) {
                                 written = written ||
                                           (frame.id == sdo_answer && frame.data[0] == 0x60 && frame.data[1] == 0x17);
                                 stuck = stuck || (written && frame.id == 0x705 && frame.data[0] == 0);
                                 return true;
                             },
                             &stuck),
                         5};
    const ConformReport report =
        run_on(target, case_text("some", "write 1017:00 = 50\nread 1000:00") + case_text("other", "read 1000:00"));
    ASSERT_EQ(report.results.size(), 2U);
    EXPECT_EQ(report.results[0].verdict, Verdict::no_answer);
    EXPECT_THAT(report.results[0].why, HasSubstr("afterwards: "));
    EXPECT_THAT(report.results[0].why, HasSubstr("does not advance at"));
    EXPECT_EQ(report.results[1].verdict, Verdict::not_run);
    EXPECT_EQ(report.results[1].why, "the slave stopped answering in the case some");
}

TEST(ConformRun, ReturnFromALoopInAProcedureRemovesTheLoopVariable) {
    const std::string procedure =
        "[[procedure]]\nname = \"second\"\ntakes = []\nsteps = '''\nfor x in 1, 2 {\nreturn $x\n}\n'''\n";
    VirtualTarget target{sound_slave(), 5};
    const ConformReport report = run_on(target, case_text("some", "do second -> c\nfail \"here\"") + procedure);
    EXPECT_EQ(report.results.at(0).why, "here");
}

TEST(ConformRun, PeriodCountAndSilenceStepsMeasureFrames) {
    const std::string steps = "write 1017:00 = 100\n";
    EXPECT_EQ(run_steps_on_slave(steps + "period 700+N = 100 ms +- 1 % over 10 jitter 1 %").verdict, Verdict::passed);
    const CaseResult late = run_steps_on_slave(steps + "period 700+N = 90 ms +- 5 % over 10");
    EXPECT_THAT(late.why, HasSubstr("the mean period is 100.0"));
    EXPECT_EQ(run_steps_on_slave(steps + "count 700+N for 1 s = 10 +- 1").verdict, Verdict::passed);
    EXPECT_EQ(run_steps_on_slave(steps + "count 700+N for 1 s <= 8").verdict, Verdict::failed);
    EXPECT_EQ(run_steps_on_slave(steps + "silence 700+N for 1 s").verdict, Verdict::failed);
}

TEST(ConformRun, SilenceStepWithSeveralFramesComparesTheDataOfEachFrame) {
    const std::string steps =
        "write 1017:00 = 100\n";  // a heartbeat every 100 ms, with the state 7Fh (pre-operational)
    EXPECT_EQ(run_steps_on_slave(steps + "silence 700+N: 05, 180+N for 1 s").verdict, Verdict::passed);
    EXPECT_EQ(run_steps_on_slave(steps + "silence 180+N: 7F, 700+N: 05 for 1 s").verdict, Verdict::passed);
    EXPECT_EQ(run_steps_on_slave(steps + "silence 700+N: 7F, 180+N for 1 s").verdict, Verdict::failed);
    EXPECT_EQ(run_steps_on_slave(steps + "silence 180+N, 700+N: 7F for 1 s").verdict, Verdict::failed);
    EXPECT_EQ(run_steps_on_slave(steps + "silence 180+N, 700+N for 1 s").verdict, Verdict::failed);
}

TEST(ConformRun, WatchStepCollectsFramesDuringOtherSteps) {
    const CaseResult result = run_steps_on_slave(
        "write 1017:00 = 100\nwatch 700+N as hb\nread 1000:00\nwait 1 s\nend hb\nwait 1 s\n"
        "check $hb.count == 10 \"ten\"\ncheck $hb.max <= 101 ms \"in time\"\ncheck $hb.data == hex(7F) \"state\"",
        "allow = []");
    EXPECT_EQ(result.verdict, Verdict::passed) << result.why;
}

// The slave sends ten heartbeats in a second, with the state 7Fh (pre-operational).
TEST(ConformRun, WatchStepUsesTheValuesThatVariablesHadAtItsStart) {
    const CaseResult changed = run_steps_on_slave(
        "write 1017:00 = 100\nlet state = 0x7F\nwatch 700+N: $state:u8 as hb\nlet state = 5\nwait 1 s\nend hb\n"
        "check $hb.count == 10 \"ten\"");
    EXPECT_EQ(changed.verdict, Verdict::passed) << changed.why;
    const std::string procedure =
        "[[procedure]]\nname = \"watching\"\ntakes = [\"state\"]\n"
        "steps = '''\nwatch 700+N: $state:u8 as hb\nreturn $hb\n'''\n";
    VirtualTarget target{sound_slave(), 5};
    const ConformReport report =
        run_on(target, case_text("some",
                                 "write 1017:00 = 100\ndo watching 0x7F -> seen\nread 1000:00\nwait 1 s\n"
                                 "check $seen.count == 10 \"ten\"") +
                           procedure);
    EXPECT_EQ(report.results.at(0).verdict, Verdict::passed) << report.results.at(0).why;
}

TEST(ConformRun, ElapsedTimeOfAnAnswerEndsWhenItsFrameArrives) {
    const CaseResult result = run_steps_on_slave(
        "sdo 40 00 10 00\nwait 100 ms\nanswer 43 00 10 00 -> a\ncheck $elapsed < 50 ms \"at once\"\n"
        "let first = $elapsed\nsdo 40 00 10 00\nwait 100 ms\nexpect 580+N: 43 ... -> e\n"
        "check $elapsed == $first \"as expect measures\"");
    EXPECT_EQ(result.verdict, Verdict::passed) << result.why;
}

TEST(ConformRun, BlockTransfersCarryEveryByte) {
    const CaseResult result = run_steps_on_slave(
        "choose D: domain, writable, readable\nfor n in 1, 7, 8, 889, 890 {\nblock write $D = pattern($n) crc\n"
        "block read $D = pattern($n) crc\nread $D = pattern($n)\n}\nblock write $D = pattern(100) crc lose 3\n"
        "block read $D = pattern(100) crc blksize 4 ack 2 once\nblock write $D = pattern(50) wrong crc fails 05040004");
    EXPECT_EQ(result.verdict, Verdict::passed) << result.why << result.step;
}

TEST(ConformRun, UnexpectedBootUpMessageFailsTheCase) {
    VirtualTarget target{hooked_slave([](Frame& frame) {
                             frame.data[0] = frame.id == 0x705 ? std::uint8_t{0} : frame.data[0];
                             return true;
                         }),
                         5};
    const ConformReport report = run_on(target, case_text("some", "write 1017:00 = 50\nread 1000:00\nwait 200 ms"));
    EXPECT_EQ(report.results.at(0).verdict, Verdict::failed);
    EXPECT_THAT(report.results.at(0).why, HasSubstr("boot-up message"));
}

TEST(ConformRun, ValuesWrittenByACaseAreRestored) {
    VirtualTarget target{sound_slave(), 5};
    const std::string before =
        "write 1017:00 = 700\nwrite 1010:01 = \"save\"\nreset node\nread 1017:00 = 700\nwrite 1017:00 = 800";
    const ConformReport report = run_on(
        target, case_text("writes", before, "risk = \"store\"") + case_text("reads", "power cycle\nread 1017:00 = 0"));
    EXPECT_EQ(report.results.at(0).verdict, Verdict::passed) << report.results.at(0).why;
    EXPECT_EQ(report.results.at(1).verdict, Verdict::passed) << report.results.at(1).why;
}

TEST(ConformRun, MappingIsRestoredInTheOrderThatASlaveAccepts) {
    // The case saves its changed mapping, so a restart does not restore it: only writes of the COB-ID and of the
    // mapping count do.
    const std::string steps =
        "read 1800:01 -> cob\nwrite 1800:01 = $cob | 0x80000000\nwrite 1A00:00 = 0\nwrite 1010:01 = \"save\"\n"
        "write 1800:02 = 254";
    VirtualTarget target{sound_slave(), 5};
    const ConformReport report =
        run_on(target, case_text("reads", "read 1A00:00 -> n\ncheck $n != 0 \"something is mapped\"") +
                           case_text("unmaps", steps, "risk = \"store\"") +
                           case_text("mapped-again", "power cycle\nread 1A00:00 -> n\ncheck $n != 0 \"mapped again\""));
    for (const CaseResult& one : report.results) {
        EXPECT_EQ(one.verdict, Verdict::passed) << one.id << ": " << one.why;
    }
}

TEST(ConformRun, ValueThatTheSlaveDoesNotRestoreIsReported) {
    int reads = 0;
    VirtualTarget target{hooked_slave([&reads](Frame& frame) {
                             // From its second read on, 1017h (producer heartbeat time) reads as 5.
                             const bool heartbeat = frame.id == sdo_answer && frame.data[0] == 0x4B &&
                                                    frame.data[1] == 0x17 && frame.data[2] == 0x10;
                             frame.data[4] = heartbeat && ++reads > 1 ? std::uint8_t{5} : frame.data[4];
                             return true;
                         }),
                         5};
    const CaseResult result = run_on(target, case_text("some", "write 1017:00 = 100")).results.at(0);
    EXPECT_EQ(result.verdict, Verdict::failed);
    ASSERT_EQ(result.left.size(), 1U);
    EXPECT_THAT(result.left.front(), HasSubstr("1017h:00 does not accept its former value 00 00"));
}

TEST(ConformRun, SilentSlaveIsDistinguishedFromAFailingSlave) {
    bool silent = false;
    const auto hook = [&silent](Frame& frame) {
        silent = silent || (frame.id == sdo_answer && frame.data[1] == 0x01 && frame.data[2] == 0x10);
        return !silent;
    };
    BusLikeTarget target{hooked_slave(hook)};
    const ConformReport report =
        run_on(target, case_text("ends-it", "read 1001:00") + case_text("after", "read 1000:00"));
    EXPECT_EQ(report.results.at(0).verdict, Verdict::no_answer);
    EXPECT_EQ(report.results.at(1).verdict, Verdict::not_run);
    EXPECT_THAT(report.results.at(1).why, HasSubstr("stopped answering in the case ends-it"));
    EXPECT_EQ(report.exit_status(), 1);
}

TEST(ConformRun, AbsentSlaveIsAnErrorWithoutAVerdict) {
    BusLikeTarget target{hooked_slave([](Frame&) { return false; })};
    EXPECT_THROW(run_on(target, case_text("some", "read 1000:00")), InputError);
}

TEST(ConformRun, FailingCaseThatPassesOnRepetitionIsReportedAsUnstable) {
    int answers = 0;
    BusLikeTarget target{hooked_slave([&answers](Frame& frame) {
        const bool type = frame.id == sdo_answer && frame.data[1] == 0x01 && frame.data[2] == 0x10;
        frame.data[0] = type && ++answers == 1 ? std::uint8_t{0x4B} : frame.data[0];
        return true;
    })};
    const ConformReport report = run_on(target, case_text("some", "sdo 40 01 10 00\nanswer 4F 01 10 00"));
    EXPECT_EQ(report.results.at(0).verdict, Verdict::unstable);
    EXPECT_EQ(report.results.at(0).runs, 2U);
    EXPECT_EQ(report.exit_status(), 1);
}

TEST(ConformRun, FailingCaseOnABusRunsFourTimes) {
    BusLikeTarget target{sound_slave()};
    const ConformReport report = run_on(target, case_text("some", "read 1000:00 fails any"));
    EXPECT_EQ(report.results.at(0).verdict, Verdict::failed);
    EXPECT_EQ(report.results.at(0).runs, 4U);
}

// The tester sends a heartbeat every 100 ms, and the slave expects one within 120 ms. A tester that is 30 ms late must
// report that it was late itself.
TEST(ConformRun, FailureReportStatesThatTheTesterWasLate) {
    const std::string steps =
        "write 1016:01 = ($other << 16) | 120\nproduce 700+$other: 05 every 100 ms\nwait 50 ms\nclear\n"
        "silence 080+N for 1 s";
    BusLikeTarget on_time{sound_slave()};
    EXPECT_EQ(run_on(on_time, case_text("some", steps)).results.at(0).verdict, Verdict::passed);
    BusLikeTarget late{sound_slave()};
    late.be_late_by(milliseconds(30));
    const CaseResult result = run_on(late, case_text("some", steps)).results.at(0);
    EXPECT_EQ(result.verdict, Verdict::failed);
    EXPECT_THAT(result.why, HasSubstr("; the tester itself was up to 30 ms late"));
    BusLikeTarget other{sound_slave()};
    EXPECT_THAT(run_on(other, case_text("some", "read 1000:00 fails any")).results.at(0).why,
                testing::Not(HasSubstr("late")));
}

TEST(ConformRun, CaseWithARiskRunsOnlyWithPermissionForThatRisk) {
    BusLikeTarget target{sound_slave()};
    ConformOptions options;
    options.allow_outputs = options.allow_store = options.allow_lss = false;
    const ConformReport report = run_on(
        target,
        case_text("a", "read 1000:00", "risk = \"output\"") + case_text("b", "read 1000:00", "risk = \"store\"") +
            case_text("c", "read 1000:00", "risk = \"lss\"") + case_text("d", "read 1000:00"),
        options);
    EXPECT_THAT(report.results.at(0).why, HasSubstr("--allow-outputs"));
    EXPECT_THAT(report.results.at(1).why, HasSubstr("--allow-store"));
    EXPECT_THAT(report.results.at(2).why, HasSubstr("--allow-lss"));
    EXPECT_EQ(report.results.at(3).verdict, Verdict::passed);
}

TEST(ConformRun, InterruptedRunRestoresTheValuesThatACaseHasWritten) {
    BusLikeTarget target{sound_slave()};
    target.interrupt_at(Instant{20'000'000});
    const ConformReport report =
        run_on(target, case_text("long", "write 1017:00 = 300\nwrite 1010:01 = \"save\"\nwait 60 s\nread 1000:00",
                                 "risk = \"store\""));
    EXPECT_TRUE(report.interrupted);
    EXPECT_EQ(report.results.at(0).verdict, Verdict::not_run);
    EXPECT_THAT(report.left, IsEmpty());
    EXPECT_EQ(report.exit_status(), 2);
    const auto after = run_on(target, case_text("reads", "read 1017:00 = 0", "prepare = \"none\""));
    EXPECT_EQ(after.results.at(0).verdict, Verdict::passed) << after.results.at(0).why;
}

TEST(ConformRun, CaseWithRemoteFramesIsSkippedOnABusWithoutThem) {
    BusLikeTarget target{sound_slave()};
    const ConformReport report = run_on(target, case_text("some", "send rtr 700+N\nexpect 700+N"));
    EXPECT_EQ(report.results.at(0).verdict, Verdict::skipped);
}

TEST(ConformRun, UnknownCaseNamesAreRefused) {
    VirtualTarget target{sound_slave(), 5};
    ConformOptions options;
    options.cases = {"nothing"};
    EXPECT_THROW(run_on(target, case_text("some", "read 1000:00"), options), InputError);
    options.cases = {};
    options.only = {"can"};
    EXPECT_THROW(run_on(target, case_text("some", "read 1000:00"), options), InputError);
}

TEST(ConformRun, BackgroundTrafficLoadsTheBusAsRequested) {
    const CaseResult result =
        run_steps_on_slave("traffic 80 % high\nread 1000:00\nwait 1 s\ntraffic off\nread 1000:00");
    EXPECT_EQ(result.verdict, Verdict::passed) << result.why;
    VirtualTarget target{sound_slave(), 5};
    const ConformReport report =
        run_on(target, case_text("some", "traffic 80 % high\nwait 1 s\nread 1000:00 fails any"));
    // 80 % of 125 kbit/s, with about 125 bits per frame, are 800 frames in one second.
    EXPECT_NEAR(static_cast<double>(report.results.at(0).frames.size()), 800.0, 40.0);
}

}  // namespace

}  // namespace canproof::host::conform::test
