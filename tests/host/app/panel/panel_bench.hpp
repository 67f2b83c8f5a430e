// SPDX-License-Identifier: Apache-2.0
// A panel for devices of the catalogue on the in-process bus, in virtual time.
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "host/app/panel/panel.hpp"
#include "host/selection/built_in.hpp"
#include "host/selection/chosen_devices.hpp"
#include "host/sim/bus/arbitrated_bus.hpp"

namespace canproof::host::test {

class PanelBench {
  public:
    explicit PanelBench(const std::vector<std::string>& names) {
        std::vector<std::unique_ptr<DeviceNode>> nodes;
        std::vector<const Part*> parts;
        for (const auto& name : names) {
            ChosenDevice chosen = choose_device(name);
            parts.push_back(chosen.part);
            nodes.push_back(std::make_unique<DeviceNode>(name, std::move(chosen.device)));
        }
        SessionOutputs outputs;
        outputs.log = &log;
        outputs.log_format = LogFormat::marked;
        outputs.observer = &panel.observer();
        session_ = std::make_unique<RunSession>(std::make_unique<ArbitratedBus>("inproc", 125000, BusFaultRates{}),
                                                std::move(nodes), std::vector<Stimulus>{}, outputs);
        panel.take(*session_, parts);
        panel.power_on();
    }

    void run_until(std::uint64_t ms) {
        now_ = Instant{ms * 1000U};
        panel.advance_to(now_);
    }
    /// Makes the clock advance by `cost` at each reading, so that each step of the panel takes this time.
    void slow_down(Duration cost) { cost_ = cost; }
    nlohmann::json get(const std::string& path, std::uint64_t changes = 0, std::uint64_t frames = 0) {
        PanelRequest request = from_own_page("GET", path);
        request.changes_from = changes;
        request.frames_from = frames;
        return nlohmann::json::parse(panel.answer(request).body);
    }
    PanelResponse post(const std::string& path, const std::string& body) {
        PanelRequest request = from_own_page("POST", path);
        request.content_type = "application/json";
        request.body = body;
        return panel.answer(request);
    }
    int stimulate(const std::string& device, const std::string& signal, double value) {
        return post("/api/stimulus", nlohmann::json{{"device", device}, {"signal", signal}, {"value", value}}.dump())
            .status;
    }
    int send(const std::string& frame) { return post("/api/frame", nlohmann::json{{"frame", frame}}.dump()).status; }
    std::string stimuli_csv() { return panel.answer(from_own_page("GET", "/stimuli.csv")).body; }

    /// Returns the edges of a channel: each time in milliseconds, and the value from then on.
    std::vector<std::pair<double, double>> changes_of(const std::string& device, const std::string& channel) {
        const nlohmann::json all = get("/api/panel");
        std::size_t at = 0;
        for (const auto& one : all.at("devices")) {
            for (const auto& candidate : one.at("channels")) {
                if (one.at("name") == device && candidate.at("name") == channel) {
                    return changes_at(at);
                }
                ++at;
            }
        }
        ADD_FAILURE() << "no channel " << channel;
        return {};
    }

    std::ostringstream log;
    Panel panel{built_in_register(), [this] {
                    now_ = now_ + cost_;
                    return now_;
                }};

  private:
    static PanelRequest from_own_page(const std::string& method, const std::string& path) {
        PanelRequest request;
        request.method = method;
        request.path = path;
        request.host = "localhost:1";
        request.origin = "http://localhost:1";
        return request;
    }
    std::vector<std::pair<double, double>> changes_at(std::size_t channel) {
        std::vector<std::pair<double, double>> found;
        const nlohmann::json state = get("/api/state");
        for (const auto& change : state.at("changes")) {
            if (change.at(1) == channel) {
                found.emplace_back(change.at(0).get<double>() / 1000.0, change.at(2).get<double>());
            }
        }
        return found;
    }

    Instant now_{};
    Duration cost_{};
    std::unique_ptr<RunSession> session_;
};

}  // namespace canproof::host::test
