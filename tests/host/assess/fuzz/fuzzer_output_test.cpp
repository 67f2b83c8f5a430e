// SPDX-License-Identifier: Apache-2.0
#include "host/assess/fuzz/fuzzer_output.hpp"

#include <gtest/gtest.h>

namespace canproof::host {
namespace {

TEST(FuzzerOutput, ProgressOfOneProcessIsRead) {
    const auto progress = parse_progress("#4096\tNEW    cov: 120 ft: 300 corp: 5/60b lim: 14 exec/s: 2048 rss: 80Mb");
    ASSERT_TRUE(progress);
    EXPECT_EQ(progress->executions, 4096U);
    EXPECT_EQ(progress->edges, 120U);
    EXPECT_EQ(progress->features, 300U);
}

TEST(FuzzerOutput, ProgressOfForkModeIsRead) {
    const auto progress = parse_progress(
        "#20554: cov: 3246 ft: 6459 corp: 208 exec/s: 1926 oom/timeout/crash: 0/0/0 time: 10s job: 3 dft_time: 0");
    ASSERT_TRUE(progress);
    EXPECT_EQ(progress->executions, 20554U);
    EXPECT_EQ(progress->edges, 3246U);
    EXPECT_EQ(progress->features, 6459U);
}

TEST(FuzzerOutput, LineThatStatesNoProgressIsIgnored) {
    EXPECT_FALSE(parse_progress("INFO: seed corpus: files: 26"));
    EXPECT_FALSE(parse_progress("#0 0x55 in main x.cpp:3"));
    EXPECT_FALSE(parse_progress(""));
}

/// Output of libFuzzer of clang 19 for a violated requirement.
const char* const violated =
    "requirement violated at /home/x/canproof/fuzz/pdo_fuzz.cpp:167\n"
    "==7== ERROR: libFuzzer: deadly signal\n"
    "    #0 0x55c5c7 in __sanitizer_print_stack_trace (/x/pdo_fuzz+0x1b1) (BuildId: 17)\n"
    "    #1 0x55c5c8 in abort (/lib/libc.so.6+0x1)\n"
    "    #2 0x55c5c9 in (anonymous namespace)::check_parameters((anonymous namespace)::Slave&) "
    "/home/x/canproof/fuzz/pdo_fuzz.cpp:167:13\n"
    "    #3 0x55c5ca in LLVMFuzzerTestOneInput /home/x/canproof/fuzz/pdo_fuzz.cpp:310:9\n"
    "\n";

TEST(FuzzerOutput, ViolatedRequirementIsIdentifiedByItsFileAndLine) {
    const Failure failure = parse_failure(violated);
    EXPECT_EQ(failure.kind, "requirement violated");
    EXPECT_EQ(failure.place, "fuzz/pdo_fuzz.cpp:167");
    EXPECT_EQ(failure.frames, std::vector<std::string>{"check_parameters"});
    EXPECT_EQ(failure.title(), "requirement violated at fuzz/pdo_fuzz.cpp:167");
    EXPECT_EQ(failure.signature().size(), 8U);
}

std::string overflow(const std::string& from) {
    return "==9==ERROR: AddressSanitizer: heap-buffer-overflow on address 0x6020 at pc 0x55\n"
           "WRITE of size 1 at 0x6020 thread T0\n"
           "    #0 0x1a in __asan_memcpy (/x/sdo+0x1)\n"
           "    #1 0x1b in canproof::ByteWriter::put(unsigned char) /y/src/firmware/base/bytes.hpp:40:5\n"
           "    #2 0x1c in canproof::SdoServer::" +
           from +
           "(canproof::Frame const&, canproof::Instant) /y/src/firmware/canopen/sdo_server.cpp:90:7\n"
           "\n"
           "0x6020 is located 0 bytes after 16-byte region\n"
           "allocated by thread T0 here:\n"
           "    #0 0x2a in operator new(unsigned long) (/x/sdo+0x9)\n"
           "    #1 0x2b in canproof::host::Memory::Memory(unsigned long) /y/src/host/devices/memory.cpp:9:1\n";
}

TEST(FuzzerOutput, SanitizerReportIsIdentifiedByItsFirstStackTrace) {
    const Failure failure = parse_failure(overflow("segment"));
    EXPECT_EQ(failure.kind, "heap-buffer-overflow");
    EXPECT_EQ(failure.title(), "heap-buffer-overflow in canproof::ByteWriter::put < canproof::SdoServer::segment");
    EXPECT_EQ(failure.signature(), parse_failure(overflow("segment")).signature());
    EXPECT_NE(failure.signature(), parse_failure(overflow("block")).signature());
}

TEST(FuzzerOutput, UndefinedBehavioursThatDifferInNumbersOnlyAreOneFinding) {
    const auto shift = [](int by) {
        return "/y/src/firmware/base/x.cpp:3:9: runtime error: shift exponent " + std::to_string(by) +
               " is too large for 64-bit type 'unsigned long'\n    #0 0x1a in canproof::mask(unsigned int) "
               "/y/src/firmware/base/x.cpp:3:9\n";
    };
    EXPECT_EQ(parse_failure(shift(64)).title(), parse_failure(shift(70)).title());
    EXPECT_NE(parse_failure(shift(64)).title().find("shift exponent"), std::string::npos);
}

TEST(FuzzerOutput, ValgrindReportNamesTheFunction) {
    const Failure failure = parse_failure(
        "==5== Conditional jump or move depends on uninitialised value(s)\n"
        "==5==    at 0x109A: canproof::SdoServer::answer(canproof::Frame&) (sdo_server.cpp:30)\n"
        "==5==    by 0x109B: LLVMFuzzerTestOneInput (sdo_server_fuzz.cpp:9)\n"
        "==5==  Uninitialised value was created by a stack allocation\n");
    EXPECT_EQ(failure.title(),
              "Conditional jump or move depends on uninitialised value(s) in canproof::SdoServer::answer");
}

TEST(FuzzerOutput, TimeoutIsRecognisedAndEmptyOutputIsAnUnknownFailure) {
    EXPECT_EQ(parse_failure("ALARM: working on the last Unit for 11 seconds\n==3== ERROR: libFuzzer: timeout after 11 "
                            "seconds\n")
                  .kind,
              "timeout");
    EXPECT_EQ(parse_failure("").title(), "unknown");
}

}  // namespace
}  // namespace canproof::host
