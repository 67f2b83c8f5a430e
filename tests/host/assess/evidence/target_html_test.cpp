// SPDX-License-Identifier: Apache-2.0
// Tests the section of the evidence pack about the microcontroller, with invented figures.
#include "host/assess/evidence/target_html.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

namespace canproof::test {

namespace {

using testing::HasSubstr;
using testing::Not;

class TargetHtml : public testing::Test {
  protected:
    void SetUp() override { std::filesystem::create_directories(folder); }
    void TearDown() override { std::filesystem::remove_all(folder); }
    void leave(const std::string& file, const std::string& text) { std::ofstream{folder / file} << text; }

    const std::filesystem::path folder = std::filesystem::path{testing::TempDir()} / "target_html";
};

}  // namespace

TEST_F(TargetHtml, PageWithoutMeasurementsStatesThatNothingWasMeasured) {
    EXPECT_THAT(host::write_target_html(folder), HasSubstr("not measured in this build"));
}

TEST_F(TargetHtml, FirmwareSizeAboveItsBudgetIsMarkedOpen) {
    leave("footprint.json", R"({"budgets": {"devices": {"one": {"flash": 100, "ram": 20, "stack": 8}},
        "canopen": {"code": 40, "ram": 10, "stack": 9}},
        "devices": {"one": {"flash": 100, "ram": 21, "stack": 8, "canopen": {"code": 50, "ram": 10, "stack": 9}}}})");
    const std::string page = host::write_target_html(folder);
    EXPECT_THAT(page, HasSubstr("data-h=\"Flash\"><span class=holds>✓ 100 <small>of 100</small></span>"));
    EXPECT_THAT(page, HasSubstr("data-h=\"RAM with stack\"><span class=open>✗ 21 <small>of 20</small></span>"));
    EXPECT_THAT(page, HasSubstr("<span class=open>✗ 50 <small>of 40</small></span>"));
    EXPECT_THAT(page, HasSubstr("<span class=holds>✓ 9 <small>of 9</small></span>"));
}

TEST_F(TargetHtml, FlashedImageIsComparedWithItsOwnLimits) {
    const char* const head = R"({"budgets": {"devices": {"one": {"flash": 100, "ram": 20, "stack": 8}},
        "canopen": {"code": 40, "ram": 10, "stack": 9}},
        "devices": {"one": {"flash": 100, "ram": 20, "stack": 8, "canopen": {"code": 40, "ram": 10, "stack": 9})";
    leave("footprint.json", std::string{head} + R"(, "flashed": {"flash": 301, "ram": 70, "stack": 12,
        "limits": {"flash": 300, "ram": 75, "stack": 12}}}}})");
    const std::string page = host::write_target_html(folder);
    EXPECT_THAT(page, HasSubstr("self-tests: flash\"><span class=open>✗ 301 <small>of 300</small></span>"));
    EXPECT_THAT(page, HasSubstr("<span class=holds>✓ 70 <small>of 75</small></span>"));
    EXPECT_THAT(page, HasSubstr("deepest stack\"><span class=holds>✓ 12 <small>of 12</small></span>"));
    leave("footprint.json", std::string{head} + "}}}");
    EXPECT_THAT(host::write_target_html(folder), HasSubstr("no flashed image"));
}

TEST_F(TargetHtml, TestsAndFramesOfAllFirmwareImagesAreAddedUp) {
    leave("suites.json", R"({"images": {"a": {"tests": 3, "passed": 3, "frames": 10},
                                        "b": {"tests": 2, "passed": 1, "frames": 5}}, "differences": 1})");
    EXPECT_THAT(host::write_target_html(folder),
                HasSubstr("4 tests passed on QEMU's STM32F405; 15 frames compared with this machine, 1 difference"));
}

TEST_F(TargetHtml, InstructionsPerFrameAndProcessorLoadByAFullBusAreShown) {
    leave("suites.json", R"({"images": {}, "differences": 0})");
    leave("work.json", R"({"bit_rate": 1000000, "core_hz": 168000000, "cycles_an_instruction": 1.5, "devices": {"one": {
        "frame": {"count": 7, "instructions": 4321, "what": "605#40", "where": "Suite.<Test>"},
        "tick": {"count": 3, "instructions": 11200, "what": "-", "where": "x", "period_us": 2500, "load": 0.04, "holds": true},
        "share": {"count": 7, "instructions": 10000, "what": "605#41", "where": "x", "bus_load": 0.625, "holds": false},
        "due_frame": {"count": 1, "instructions": 99, "what": "605#42", "where": "x"},
        "power_on": {"count": 2, "instructions": 560000, "what": "-", "where": "x", "ms": 5.0, "holds": true},
        "command": {"count": 4, "instructions": 1232000, "what": "000#8105", "where": "x", "ms": 11.0, "holds": false}}}})");
    const std::string page = host::write_target_html(folder);
    EXPECT_THAT(page, HasSubstr("<td class=n data-h=\"Times\">7<td class=n data-h=\"Instructions at most\">4,321"
                                "<td data-h=\"Frame\"><code>605#40</code><td data-h=\"Where\">Suite.&lt;Test&gt;"));
    EXPECT_THAT(page, HasSubstr("<td data-h=\"Work\">frame at a deadline<td"));
    EXPECT_THAT(page, HasSubstr("<li><span class=open>✗ one: 62.5 % of the core by <code>605#41</code>"));
    EXPECT_THAT(page,
                HasSubstr("<li><span class=holds>✓ one: 4.0 % of the core for the worst-case tick, one every 2.5 ms"));
    EXPECT_THAT(page, HasSubstr("<li><span class=holds>✓ one: 5.0 ms of the core for the worst-case power-on"));
    EXPECT_THAT(page, HasSubstr("<li><span class=open>✗ one: 11.0 ms of the core for the worst-case command"));
    EXPECT_THAT(page, Not(HasSubstr("not measured in this build")));
}

}  // namespace canproof::test
