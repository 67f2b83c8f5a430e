// SPDX-License-Identifier: Apache-2.0
// The panel: a simulation session that a web page shows and stimulates. The run loop advances the session. HTTP
// requests read its state and queue stimuli and frames for it.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>

#include "host/app/panel/recorder.hpp"
#include "host/http/request_guard.hpp"
#include "host/sim/run/pace.hpp"
#include "host/sim/run/run_session.hpp"

namespace canproof::host {

class Panel {
  public:
    static constexpr std::size_t frames_at_once = 400;
    static constexpr std::size_t changes_at_once = 8000;
    static constexpr std::size_t stimuli_kept = 100000;
    static constexpr std::size_t notices_kept = 20;

    using Clock = std::function<Instant()>;

    /// Makes a panel without a session. `clock` is a function that returns the time of the session.
    Panel(const Register& content, Clock clock);

    /// Returns the observer to pass to the session. It is valid as long as the panel exists.
    SessionObserver& observer() { return recorder_; }
    /// Attaches the session. Must be called once, before power-on. `parts[i]` is the requirements register's
    /// description of the device that is the session's node i.
    void take(RunSession& session, std::vector<const Part*> parts);

    void power_on();
    void advance_to(Instant now);
    Instant next_deadline() const;
    std::vector<Watch> watches() const;
    void notice(const std::string& text);
    /// Returns a sentence about the greatest delay of the simulation, for the end of the run; empty when no delay was
    /// reported.
    std::string summary() const { return pace_.summary(); }

    /// Answers any request; a request that is not allowed gets an error response.
    PanelResponse answer(const PanelRequest& request);

  private:
    PanelResponse get(const PanelRequest& request) const;
    PanelResponse post(const PanelRequest& request);
    nlohmann::json description() const;
    nlohmann::json state(std::uint64_t changes_from, std::uint64_t frames_from) const;
    nlohmann::json device_state(const Recorder::Device& device) const;
    std::string stimuli_csv() const;
    PanelResponse stimulate(const nlohmann::json& body);
    PanelResponse send(const nlohmann::json& body);

    Clock clock_;
    Pace pace_;
    Recorder recorder_;
    RunSession* session_{nullptr};
    std::vector<const Part*> parts_;
    std::vector<nlohmann::json> views_;
    Ring<Stimulus> stimuli_{stimuli_kept};
    Ring<std::string> notices_{notices_kept};
};

}  // namespace canproof::host
