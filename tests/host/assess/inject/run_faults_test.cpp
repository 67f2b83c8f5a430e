// SPDX-License-Identifier: Apache-2.0
// Tests fault injection into a made-up device, where a fault in each byte of memory has one known effect.
#include "host/assess/inject/run_faults.hpp"

#include <gtest/gtest.h>

#include <csignal>

#include "host/assess/inject/injection_report.hpp"
#include "host/base/input_error.hpp"

namespace canproof::host::test {

namespace {

enum Place : std::size_t { unused, output, pdo, emergency, stuck, invalid, places };

/// Wakes every 10 ms until 100 ms. Its memory has one byte for each Place; a byte that is not 0 causes the effect after
/// which its Place is named.
class MadeUpDevice final : public SimulatedDevice {
  public:
    explicit MadeUpDevice(bool loops = false) : SimulatedDevice{1}, loops_{loops} {}

    void set_node_id(NodeId) override {}
    void power_on(Instant) override { deadline_ = Instant{10'000}; }
    void receive(const Frame&, Instant) override {}
    void advance(Instant now) override {
        while (loops_ && bytes_[unused] != 0) {
            looped_ = !looped_;
        }
        if (bytes_[invalid] != 0) {
            static_cast<void>(std::raise(SIGSEGV));
        }
        if (bytes_[stuck] == 0) {
            deadline_ = now.us < 100'000 ? Instant{now.us + 10'000} : never;
        }
        send(0x185, bytes_[pdo]);
        if (bytes_[emergency] != 0) {
            send(0x085, 1);
        }
    }
    Instant next_deadline() const override { return deadline_; }
    bool set_input(const std::string&, double, Instant) override { return false; }
    std::vector<double> inputs() const override { return {}; }
    const std::vector<std::string>& input_names() const override { return no_names_; }
    std::vector<double> outputs() const override { return {static_cast<double>(bytes_[output])}; }
    const std::vector<std::string>& output_names() const override { return output_names_; }
    std::uint8_t node_id() const override { return 5; }
    NmtState state() const override { return NmtState::operational; }
    std::uint32_t bit_rate() const override { return 0; }
    std::vector<MemoryRegion> regions() override { return {{"device", bytes_.data(), loops_ ? 1 : bytes_.size()}}; }

  private:
    void send(std::uint32_t id, std::uint8_t value) {
        Frame frame = data_frame(id, 1);
        frame.data[0] = value;
        static_cast<void>(queue_.push(frame));
    }

    bool loops_;
    volatile bool looped_{false};
    std::array<std::uint8_t, places> bytes_{};
    Instant deadline_{never};
    std::vector<std::string> no_names_;
    std::vector<std::string> output_names_{"volts"};
};

std::unique_ptr<SimulatedDevice> make_made_up() {
    return std::make_unique<MadeUpDevice>();
}

ReplayInput hundred_milliseconds() {
    ReplayInput input;
    input.until = Instant{100'000};
    return input;
}

InjectionCampaign run(const InjectionOptions& options) {
    return run_faults(make_made_up, hundred_milliseconds(), options, [](std::size_t) {});
}

InjectionOptions faults(std::size_t count, unsigned jobs = 1) {
    InjectionOptions options;
    options.faults = count;
    options.jobs = jobs;
    return options;
}

}  // namespace

TEST(RunFaults, FaultInEachByteOfTheInventedDeviceHasTheExpectedEffect) {
    const std::map<std::size_t, FaultEffect> expected{
        {unused, FaultEffect::masked},  {output, FaultEffect::wrong_output},
        {pdo, FaultEffect::wrong_pdo},  {emergency, FaultEffect::emergency},
        {stuck, FaultEffect::watchdog}, {invalid, FaultEffect::processor_fault}};
    const InjectionCampaign campaign = run(faults(120, 2));
    EXPECT_EQ(campaign.calls, 10U);
    ASSERT_EQ(campaign.runs.size(), 120U);
    std::set<std::size_t> hit;
    for (const InjectedRun& one : campaign.runs) {
        EXPECT_EQ(one.effect, expected.at(one.fault.byte)) << one.fault.byte << " at call " << one.fault.call;
        hit.insert(one.fault.byte);
    }
    EXPECT_EQ(hit.size(), static_cast<std::size_t>(places));
}

TEST(RunFaults, EndlessCallCountsAsAWatchdogReset) {
    InjectionOptions options = faults(1);
    options.most_seconds = 0.0;
    const auto campaign = run_faults([] { return std::make_unique<MadeUpDevice>(true); }, hundred_milliseconds(),
                                     options, [](std::size_t) {});
    ASSERT_EQ(campaign.runs.size(), 1U);
    EXPECT_EQ(campaign.runs[0].effect, FaultEffect::watchdog);
}

TEST(RunFaults, NumberOfProcessesDoesNotChangeTheResult) {
    EXPECT_EQ(injection_json("made-up", faults(60), run(faults(60, 1))),
              injection_json("made-up", faults(60), run(faults(60, 3))));
}

TEST(RunFaults, ProgressCountsEveryRun) {
    std::vector<std::size_t> seen;
    run_faults(make_made_up, hundred_milliseconds(), faults(5), [&seen](std::size_t done) { seen.push_back(done); });
    EXPECT_EQ(seen, (std::vector<std::size_t>{1, 2, 3, 4, 5}));
}

TEST(RunFaults, DeviceWithUnknownMemoryIsRefused) {
    class Closed final : public SimulatedDevice {
      public:
        Closed() : SimulatedDevice{1} {}
        void set_node_id(NodeId) override {}
        void power_on(Instant) override {}
        void receive(const Frame&, Instant) override {}
        void advance(Instant) override {}
        Instant next_deadline() const override { return never; }
        bool set_input(const std::string&, double, Instant) override { return false; }
        std::vector<double> inputs() const override { return {}; }
        const std::vector<std::string>& input_names() const override { return names_; }
        std::vector<double> outputs() const override { return {}; }
        const std::vector<std::string>& output_names() const override { return names_; }
        std::uint8_t node_id() const override { return 5; }
        NmtState state() const override { return NmtState::operational; }
        std::uint32_t bit_rate() const override { return 0; }

      private:
        std::vector<std::string> names_;
    };
    EXPECT_THROW(
        run_faults([] { return std::make_unique<Closed>(); }, hundred_milliseconds(), faults(1), [](std::size_t) {}),
        InputError);
}

}  // namespace canproof::host::test
