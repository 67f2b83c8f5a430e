// SPDX-License-Identifier: Apache-2.0
// Slaves and targets for the tests of the conformance engine.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "host/conform/link/virtual_target.hpp"
#include "host/conform/run/run_cases.hpp"
#include "host/sim/devices/generic_simulation.hpp"
#include "tests/support/slave_register.hpp"

namespace canproof::host::conform::test {

/// The simulated slave for conformance, with a hook for each frame that it sends: the frame is dropped when the hook
/// returns false. While `*stuck` is true, the next deadline of the slave stays at time 0.
class HookedSlave final : public SimulatedDevice {
  public:
    using Hook = std::function<bool(Frame&)>;

    explicit HookedSlave(Hook hook, const bool* stuck = nullptr)
        : SimulatedDevice{1}, inner_{canproof::test::slave_part()}, hook_{std::move(hook)}, stuck_{stuck} {}

    void set_node_id(NodeId node_id) override { inner_.set_node_id(node_id); }
    void power_on(Instant now) override {
        inner_.power_on(now);
        pass_on();
    }
    void receive(const Frame& frame, Instant now) override {
        inner_.receive(frame, now);
        pass_on();
    }
    void advance(Instant now) override {
        inner_.advance(now);
        pass_on();
    }
    Instant next_deadline() const override { return stuck_ != nullptr && *stuck_ ? Instant{} : inner_.next_deadline(); }
    bool set_input(const std::string& name, double value, Instant now) override {
        return inner_.set_input(name, value, now);
    }
    std::vector<double> inputs() const override { return inner_.inputs(); }
    const std::vector<std::string>& input_names() const override { return inner_.input_names(); }
    std::vector<double> outputs() const override { return inner_.outputs(); }
    const std::vector<std::string>& output_names() const override { return inner_.output_names(); }
    std::uint8_t node_id() const override { return inner_.node_id(); }
    NmtState state() const override { return inner_.state(); }
    std::uint32_t bit_rate() const override { return inner_.bit_rate(); }
    const ObjectDictionary* objects() const override { return inner_.objects(); }

  private:
    void pass_on() {
        for (; inner_.queue().front() != nullptr; inner_.queue().pop()) {
            Frame frame = *inner_.queue().front();
            if (hook_(frame)) {
                queue_.push(frame);
            }
        }
    }

    GenericSimulation inner_;
    Hook hook_;
    const bool* stuck_;
};

/// A target that behaves like a real bus: a failure does not always repeat, the slave cannot be switched off, and the
/// user may interrupt.
class BusLikeTarget final : public Target {
  public:
    explicit BusLikeTarget(std::unique_ptr<SimulatedDevice> device) : inner_{std::move(device), 5} {
        inner_.listen([this](const FrameRecord& record) { tell(record); });
        leave_out_remote_frames();
    }
    /// Simulates that the user presses Ctrl-C at that time.
    void interrupt_at(Instant time) { interrupt_at_ = time; }
    /// Makes the tester late by this time whenever it waits.
    void be_late_by(Duration delay) { delay_ = delay; }
    SimulatedDevice& device() { return inner_.device(); }

    Instant now() const override { return inner_.now(); }
    void send(const Frame& frame) override { inner_.send(frame); }
    std::size_t waiting() const override { return inner_.waiting(); }
    void advance(Instant until) override {
        if (interrupt_at_ <= inner_.now()) {
            throw Interrupted{};
        }
        inner_.advance(until + delay_);
    }
    void go_on() override { interrupt_at_ = never; }
    std::uint32_t bit_rate() const override { return inner_.bit_rate(); }
    const std::string& name() const override { return inner_.name(); }
    BusReport report() const override { return inner_.report(); }

  private:
    VirtualTarget inner_;
    Instant interrupt_at_{never};
    Duration delay_{};
};

inline std::unique_ptr<SimulatedDevice> sound_slave() {
    return std::make_unique<GenericSimulation>(canproof::test::slave_part());
}

inline std::unique_ptr<SimulatedDevice> hooked_slave(HookedSlave::Hook hook) {
    return std::make_unique<HookedSlave>(std::move(hook));
}

/// Returns the text of a case `id` with these keys and these steps.
inline std::string case_text(const std::string& id, const std::string& steps, const std::string& keys = "") {
    return "[[case]]\nid = \"" + id + "\"\ngroup = \"sdo\"\nshows = \"Something.\"\nsection = \"CiA 301 7.2.4.3\"\n" +
           keys + "\nsteps = '''\n" + steps + "\n'''\n";
}

/// Returns the cases of one file; every fault is added as text to `faults`.
inline CaseBook book_of(const std::string& text, std::vector<std::string>* faults = nullptr) {
    Faults found;
    CaseBook book = parse_cases({{"spec/conformance/some.toml", text}}, found);
    for (const Fault& one : found) {
        if (faults != nullptr) {
            faults->push_back(one.text());
        }
    }
    return book;
}

inline ConformSheet slave_sheet() {
    return sheet_of(canproof::test::slave_part());
}

inline ConformReport run_on(Target& target, const std::string& text, const ConformOptions& options = {}) {
    const ConformSheet sheet = slave_sheet();
    return run_cases(book_of(text), sheet, target, options);
}

/// Runs one case with these steps on the correct slave in virtual time.
inline CaseResult run_steps_on_slave(const std::string& steps, const std::string& keys = "") {
    VirtualTarget target{sound_slave(), 5};
    return run_on(target, case_text("some", steps, keys)).results.at(0);
}

}  // namespace canproof::host::conform::test
