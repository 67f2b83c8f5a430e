// SPDX-License-Identifier: Apache-2.0
// Tests the model of the panel: what it shows of a session, and which actions of its page it accepts.
#include "host/app/panel/panel.hpp"

#include <gmock/gmock.h>

#include "host/app/panel/assets.hpp"
#include "host/app/panel/ring.hpp"
#include "host/sim/replay/replay.hpp"
#include "tests/host/app/panel/panel_bench.hpp"

namespace canproof::host::test {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;
using testing::StartsWith;

nlohmann::json frames_of(PanelBench& bench, const std::string& service) {
    nlohmann::json found = nlohmann::json::array();
    const nlohmann::json state = bench.get("/api/state");
    for (const auto& one : state.at("frames")) {
        if (one.at("service") == service) {
            found.push_back(one);
        }
    }
    return found;
}

}  // namespace

TEST(Panel, PanelShowsEmcyFrameAndErrorLampAboveTheShutdownTemperature) {
    PanelBench bench{{"ax188001@2"}};
    bench.run_until(1000);
    ASSERT_EQ(bench.send("602#2B30400100000000"), 200);  // 4030h:1 (delay of the error) = 0
    bench.run_until(1100);
    // The default of 4020h:1 (high shutdown threshold) is 250.0 °C.
    ASSERT_EQ(bench.stimulate("ax188001@2", "tc1_celsius", 300.0), 200);
    bench.run_until(2000);

    const nlohmann::json device = bench.get("/api/state").at("devices").at(0);
    EXPECT_THAT(device.at("emcy").at("text").get<std::string>(),
                StartsWith("F011h limit exceeded, channel 1, positive shutdown"));
    EXPECT_EQ(device.at("emcy").at("error"), true);
    EXPECT_EQ(device.at("error_register"), 1);
    EXPECT_EQ(device.at("lamps").at("error"), "on");
    const nlohmann::json frames = frames_of(bench, "EMCY");
    ASSERT_EQ(frames.size(), 2U);  // one of them is for the high warning limit
    EXPECT_EQ(frames.at(1).at("id"), "082");
    EXPECT_EQ(frames.at(1).at("from"), "ax188001@2");

    ASSERT_EQ(bench.stimulate("ax188001@2", "tc1_celsius", 25.0), 200);
    bench.run_until(3000);
    const nlohmann::json healed = bench.get("/api/state").at("devices").at(0);
    EXPECT_EQ(healed.at("emcy").at("error"), false);
    EXPECT_EQ(healed.at("lamps").at("error"), "off");
}

TEST(Panel, EachEdgeOfABlinkingLedIsListedWithItsTime) {
    PanelBench bench{{"cbx-ao412@3"}};
    bench.run_until(2000);
    // Pre-operational: the green status LED blinks, 200 ms on and 200 ms off (manual, Tables 5 and 7).
    const auto edges = bench.changes_of("cbx-ao412@3", "led_s");
    ASSERT_GE(edges.size(), 8U);
    for (std::size_t i = 2; i < edges.size(); ++i) {
        EXPECT_DOUBLE_EQ(edges[i].first - edges[i - 1].first, 200.0);
    }
    EXPECT_EQ(bench.get("/api/state").at("devices").at(0).at("lamps").at("led_s"), "blinking");
    ASSERT_EQ(bench.send("000#0103"), 200);
    bench.run_until(5000);
    EXPECT_EQ(bench.get("/api/state").at("devices").at(0).at("lamps").at("led_s"), "on");
    EXPECT_EQ(bench.get("/api/state").at("devices").at(0).at("state"), "operational");
}

TEST(Panel, RunLampOfADeviceWithoutLedsFollowsCia303_EvenWhenRarelyPolled) {
    PanelBench bench{{"ax188001@2"}};
    bench.run_until(1000);
    ASSERT_EQ(bench.send("000#0202"), 200);
    bench.run_until(6000);
    // Stopped: 200 ms on, 1000 ms off; rounds count from time 0, so that 4800 ms is the start of the fifth round.
    const auto edges = bench.changes_of("ax188001@2", "run");
    ASSERT_GE(edges.size(), 3U);
    EXPECT_THAT(std::vector(edges.end() - 3, edges.end()),
                ElementsAre(Pair(4800.0, 1.0), Pair(5000.0, 0.0), Pair(6000.0, 1.0)));
    EXPECT_EQ(bench.get("/api/state").at("devices").at(0).at("lamps").at("run"), "1 flash");
}

TEST(Panel, PanelShowsTheAccelerationThatFollowsFromThePitch) {
    PanelBench bench{{"ax060805@5"}};
    ASSERT_EQ(bench.stimulate("ax060805@5", "pitch", 90.0), 200);
    bench.run_until(10);
    const nlohmann::json inputs = bench.get("/api/panel").at("devices").at(0).at("inputs");
    const nlohmann::json values = bench.get("/api/state").at("devices").at(0).at("inputs");
    ASSERT_EQ(inputs.size(), values.size());
    int found = 0;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        if (inputs.at(i).at("name") == "acceleration_x") {
            ++found;
            EXPECT_NEAR(values.at(i).get<double>(), 1.0, 1e-6);  // a pitch of 90°: gravity is along X
        }
    }
    EXPECT_EQ(found, 1);
}

TEST(Panel, InvalidStimulusIsRefused_AndNotRecorded) {
    PanelBench bench{{"ax188001@2"}};
    bench.run_until(100);
    EXPECT_EQ(bench.stimulate("ax188001@2", "tc9_celsius", 1.0), 422);
    EXPECT_EQ(bench.stimulate("ax188001@2", "adc_filter", 50.0), 422);  // adc_filter is an output of the device
    EXPECT_EQ(bench.stimulate("ax188001@2", "tc1_celsius", 1821.0), 422);
    EXPECT_EQ(bench.stimulate("ax188001@2", "tc1_celsius", -271.0), 422);
    EXPECT_EQ(bench.stimulate("ax188001@2", "tc1_open", 2.0), 422);
    EXPECT_EQ(bench.stimulate("ax188001@2", "tc1_wire", 1.5), 422);
    EXPECT_EQ(bench.stimulate("ax130751", "tc1_celsius", 1.0), 404);
    EXPECT_THAT(bench.post("/api/stimulus", R"({"device":"ax130751","signal":"supply","value":12})").body,
                HasSubstr("there is ax188001@2"));
    EXPECT_THAT(bench.post("/api/stimulus", R"({"device":"ax188001@2","signal":"tc1_celsius","value":9999})").body,
                HasSubstr("from -270 to 1820, not 9999"));
    EXPECT_EQ(bench.stimuli_csv(), "seconds,signal,value\n");
}

TEST(Panel, NodeIdOfADeviceMayBeOmittedWhenItsNameIsUnique) {
    PanelBench bench{{"ax188001@5", "cbx-ao412@3", "cbx-ao412@4"}};
    EXPECT_EQ(bench.stimulate("ax188001", "tc1_celsius", 300.0), 200);  // the request in the README of the panel
    EXPECT_EQ(bench.stimuli_csv(), "seconds,signal,value\n0.000001,ax188001@5.tc1_celsius,300\n");
    EXPECT_THAT(bench.post("/api/stimulus", R"({"device":"cbx-ao412","signal":"supply","value":24})").body,
                HasSubstr("cbx-ao412@3, cbx-ao412@4"));
}

TEST(Panel, MalformedBodyIsRefused) {
    PanelBench bench{{"ax188001@2"}};
    for (const std::string body : {"", "{", "[]", "7", "{}", R"({"device":1,"signal":"x","value":1})",
                                   R"({"device":"ax188001@2","signal":"tc1_celsius","value":"1"})",
                                   R"({"device":"ax188001@2","signal":"tc1_celsius","value":1e999})"}) {
        EXPECT_EQ(bench.post("/api/stimulus", body).status, 400) << body;
    }
    EXPECT_EQ(bench.post("/api/frame", R"({"frame":["000#0100"]})").status, 400);
    EXPECT_EQ(bench.post("/api/frame", std::string(2000, '[')).status, 400);
    for (const std::string frame : {"", "000", "800#00", "000#0", "000#010203040506070809", "zzz#00"}) {
        EXPECT_EQ(bench.send(frame), 422) << frame;
    }
    EXPECT_EQ(bench.post("/api/nothing", "{}").status, 404);
}

TEST(Panel, PathOfThePageTakesNoPost) {
    PanelBench bench{{"ax188001@2"}};
    for (const std::string path : {"/", "/api/state", "/stimuli.csv"}) {
        const PanelResponse response = bench.post(path, "{}");
        EXPECT_EQ(response.status, 405) << path;
        EXPECT_EQ(response.allow, "GET, HEAD") << path;
    }
}

TEST(Panel, NameWithAZeroByteIsShownWholeInTheError) {
    PanelBench bench{{"ax188001@2"}};
    const std::string body = bench.post("/api/stimulus", R"({"device":"a\u0000b","signal":"x","value":1})").body;
    EXPECT_THAT(body, HasSubstr("a\xEF\xBF\xBD"
                                "b"));  // U+FFFD replaces the control character
}

TEST(Panel, RequestOfAForeignPageChangesNothing) {
    PanelBench bench{{"cbx-ao412@3"}};
    PanelRequest request;
    request.method = "POST";
    request.path = "/api/frame";
    request.host = "localhost:1";
    request.origin = "http://evil.example";
    request.content_type = "application/json";
    request.body = R"({"frame":"000#0103"})";
    EXPECT_EQ(bench.panel.answer(request).status, 403);
    bench.run_until(100);
    EXPECT_EQ(bench.get("/api/state").at("devices").at(0).at("state"), "pre-operational");
    EXPECT_EQ(frames_of(bench, "NMT").size(), 0U);
}

TEST(Panel, FramesAreRefusedWhileTheBusQueueIsFull_AndAcceptedLater) {
    PanelBench bench{{"cbx-ao412@3"}};
    int refused = 0;
    for (int i = 0; i < 5000 && refused == 0; ++i) {
        refused = bench.send("123#00") == 503 ? 1 : 0;
    }
    EXPECT_EQ(refused, 1);
    bench.run_until(2000);
    EXPECT_EQ(bench.send("123#00"), 200);
}

TEST(Panel, ReplayOfPanelActionsGivesTheSameFrames) {
    PanelBench bench{{"ax188001"}};
    bench.run_until(1000);
    ASSERT_EQ(bench.send("000#0100"), 200);
    ASSERT_EQ(bench.send("67F#2B30400100000000"), 200);
    for (int i = 0; i < 40; ++i) {
        bench.run_until(1100U + 30U * static_cast<std::uint64_t>(i));
        ASSERT_EQ(bench.stimulate("ax188001", "tc1_celsius", 20.1 * i), 200);
    }
    bench.run_until(4000);

    const auto own = [](const std::string& lines, const std::string& mark) {
        std::istringstream in{lines};
        std::vector<std::string> found;
        for (std::string line; std::getline(in, line);) {
            const auto end = line.rfind(mark);
            if (end != std::string::npos) {
                found.push_back(line.substr(line.rfind(' ', end - 1) + 1, end - line.rfind(' ', end - 1) - 1));
            }
        }
        return found;
    };
    std::istringstream stimuli{bench.stimuli_csv()};
    std::istringstream frames{bench.log.str()};
    ReplayInput input;
    input.stimuli = read_stimuli(stimuli, "stimuli.csv");
    input.frames = read_candump_log(frames, "log");
    std::ostringstream out;
    replay(*choose_device("ax188001").device, input, out, nullptr);
    ASSERT_EQ(input.stimuli.size(), 40U);
    std::vector<std::string> replayed;
    std::istringstream lines{out.str()};
    for (std::string line; std::getline(lines, line);) {
        replayed.push_back(line.substr(line.rfind(' ') + 1));
    }
    EXPECT_EQ(replayed, own(bench.log.str(), " T"));
    EXPECT_GE(replayed.size(), 5U);
}

TEST(Panel, StimuliContainTheDeviceNameInARunWithSeveralDevices) {
    PanelBench bench{{"ax188001@2", "ax130751@4"}};
    ASSERT_EQ(bench.stimulate("ax130751@4", "supply", 12.5), 200);
    EXPECT_EQ(bench.stimuli_csv(), "seconds,signal,value\n0.000001,ax130751@4.supply,12.5\n");
}

TEST(Panel, PageGetsOnlyFramesThatItHasNotReceivedBefore) {
    PanelBench bench{{"cbx-ao412@3"}};
    bench.run_until(100);
    const nlohmann::json first = bench.get("/api/state");
    const auto changes = first.at("next_change").get<std::uint64_t>();
    const auto frames = first.at("next_frame").get<std::uint64_t>();
    ASSERT_EQ(first.at("frames").size(), 1U);  // the boot-up message
    ASSERT_EQ(bench.send("000#0103"), 200);
    bench.run_until(110);
    const nlohmann::json second = bench.get("/api/state", changes, frames);
    ASSERT_EQ(second.at("frames").size(), 1U);
    EXPECT_EQ(second.at("frames").at(0).at("n"), 1);
    EXPECT_EQ(second.at("frames").at(0).at("text"), "cbx-ao412@3: start");
    EXPECT_EQ(bench.get("/api/state", 1U << 30U, 1U << 30U).at("frames").size(), 0U);
}

TEST(Panel, NumberOfFramesInOneAnswerIsLimited) {
    PanelBench bench{{"cbx-ao412@3"}};
    for (std::uint64_t ms = 1; ms <= 3000; ++ms) {
        ASSERT_EQ(bench.send("703#R"), 200);
        bench.run_until(2U * ms);
    }
    const nlohmann::json state = bench.get("/api/state");
    EXPECT_EQ(state.at("frames").size(), Panel::frames_at_once);
    EXPECT_GE(state.at("next_frame").get<std::uint64_t>(), 6000U);
}

TEST(Panel, ViewOfADeviceUsesOnlySignalsOfThisDevice) {
    PanelBench bench{{"ax060805", "ax130751@1", "ax188001@2", "cbx-ao412@3"}};
    const nlohmann::json panel = bench.get("/api/panel");
    for (const auto& device : panel.at("devices")) {
        std::set<std::string> inputs;
        std::set<std::string> channels;
        std::set<std::string> settings;
        for (const auto& one : device.at("inputs")) {
            inputs.insert(one.at("name"));
        }
        for (const auto& one : device.at("channels")) {
            (one.at("kind") == "setting" ? settings : channels).insert(one.at("name"));
        }
        const nlohmann::json& view = device.at("view");
        ASSERT_TRUE(view.contains("connectors")) << device.at("name");
        for (const auto& one : view.at("connectors")) {
            for (const auto& row : one.at("pins")) {
                for (const auto& pin : row) {
                    const bool known = pin.size() < 3U || inputs.count(pin.at(2)) + channels.count(pin.at(2)) == 1U;
                    EXPECT_TRUE(known) << pin;
                }
            }
        }
        for (const auto& one : view.at("gauges")) {
            EXPECT_EQ(channels.count(one.at("channel")), 1U) << one;
            EXPECT_TRUE(!one.contains("range") || inputs.count(one.at("range")) == 1U) << one;
        }
        for (const auto& one : view.value("lamps", nlohmann::json::array())) {
            EXPECT_EQ(channels.count(one.at("signal")), 1U) << one;
        }
        for (const char* key : {"labels", "words", "choices", "marks", "zero"}) {
            const nlohmann::json named = view.value(key, nlohmann::json::object());
            for (const auto& [signal, what] : named.items()) {
                EXPECT_EQ(inputs.count(signal), 1U) << signal;
            }
        }
        const nlohmann::json marks = view.value("marks", nlohmann::json::object());
        for (const auto& [signal, all] : marks.items()) {
            for (const auto& mark : all) {
                EXPECT_EQ(settings.count(mark.at("entry")), 1U) << mark;
            }
        }
    }
}

TEST(Panel, PageLoadsNothingFromOtherHosts) {
    for (const auto& [name, text] : panel_assets()) {
        for (std::size_t at = text.find("http"); at != std::string::npos; at = text.find("http", at + 1)) {
            // The page does not request the addresses that name XML namespaces.
            EXPECT_EQ(text.substr(at, 18), "http://www.w3.org/") << name;
        }
    }
    PanelBench bench{{"cbx-ao412"}};
    PanelRequest request;
    request.host = "localhost:1";
    EXPECT_THAT(bench.panel.answer(request).body, StartsWith("<!doctype html>"));
    request.path = "/../views/cbx-ao412.json";
    EXPECT_EQ(bench.panel.answer(request).status, 404);
    request.path = "/etc/passwd";
    EXPECT_EQ(bench.panel.answer(request).status, 404);
}

TEST(Panel, TwentyLatestNoticesAreDelivered) {
    PanelBench bench{{"cbx-ao412@3"}};
    for (int i = 0; i < 21; ++i) {
        bench.panel.notice(std::to_string(i));
    }
    const nlohmann::json state = bench.get("/api/state");
    EXPECT_EQ(state.at("notices").size(), 20U);
    EXPECT_EQ(state.at("notices").back(), "20");
    EXPECT_EQ(state.at("next_notice"), 21);
}

TEST(Panel, SimulationThatFallsBehindIsReported_AndRequestsAreAnswered) {
    PanelBench bench{{"cbx-ao412@3"}};
    ASSERT_EQ(bench.send("603#2B17100001000000"), 200);  // a heartbeat every millisecond
    bench.run_until(10);
    bench.slow_down(milliseconds(5));
    bench.run_until(1000);
    EXPECT_GT(bench.get("/api/state").at("bus").at("lag_us"), 900000);
    EXPECT_EQ(bench.get("/api/state").at("notices").size(), 1U);
    const auto before = bench.get("/api/state").at("now").get<std::uint64_t>();
    ASSERT_EQ(bench.send("703#R"), 200);
    EXPECT_LT(bench.get("/api/state").at("now").get<std::uint64_t>(),
              before + 100000U);  // one turn has handled only a part of the due work
    bench.slow_down(Duration{});
    bench.run_until(2000);
    EXPECT_EQ(bench.get("/api/state").at("bus").at("lag_us"), 0);
}

TEST(PanelRing, RingKeepsTheNewestEntriesAndTheirNumbers) {
    Ring<int> ring{3};
    for (int i = 10; i < 15; ++i) {
        ring.push(i);
    }
    std::vector<std::pair<std::uint64_t, int>> seen;
    const auto note = [&](std::uint64_t number, int item) { seen.emplace_back(number, item); };
    ring.for_each_from(0, 100, note);
    EXPECT_THAT(seen, ElementsAre(Pair(2U, 12), Pair(3U, 13), Pair(4U, 14)));
    seen.clear();
    ring.for_each_from(3, 1, note);
    EXPECT_THAT(seen, ElementsAre(Pair(4U, 14)));
    seen.clear();
    ring.for_each_from(9, 100, note);
    EXPECT_TRUE(seen.empty());
}

}  // namespace canproof::host::test
