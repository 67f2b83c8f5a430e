// SPDX-License-Identifier: Apache-2.0
// A simulated slave on a bus with additional frames at random times, in virtual time.
#pragma once

#include <memory>
#include <random>

#include "host/conform/link/virtual_target.hpp"

namespace canproof::test::zoo {

/// A slave on a bus with additional frames, to which the slave must not react. Some are frames of another node's
/// services, or NMT commands to that node. Others are 29-bit frames, some of them with the values of the slave's own
/// 11-bit identifiers, or frames on restricted identifiers (CiA 301, 7.3.5). Some have priority over the frames of the
/// slave, some do not. The same seed gives the same frames at the same times.
class LoadedTarget final : public host::conform::Target {
  public:
    /// `load`: fraction of the bus that the additional frames occupy, 0 to 1. Above 0.7 the tester, which has one
    /// queue, cannot keep up.
    LoadedTarget(std::unique_ptr<host::SimulatedDevice> device, std::uint8_t node_id, double load, std::uint64_t seed);

    Instant now() const override { return inner_.now(); }
    void send(const Frame& frame) override { inner_.send(frame); }
    std::size_t waiting() const override { return inner_.waiting(); }
    void advance(Instant until) override;
    host::conform::PowerSwitch power_switch() const override { return inner_.power_switch(); }
    void power(bool on) override { inner_.power(on); }
    bool follows_bit_rate() const override { return true; }
    std::uint32_t bit_rate() const override { return inner_.bit_rate(); }
    const std::string& name() const override { return inner_.name(); }
    bool is_repeatable() const override { return true; }
    host::BusReport report() const override { return inner_.report(); }

  private:
    std::uint64_t draw(std::uint64_t below) { return generator_() % below; }
    Duration random_gap();
    Frame random_frame();

    host::conform::VirtualTarget inner_;
    std::uint8_t node_id_;
    double load_;
    std::mt19937_64 generator_;
    Instant next_{};
};

}  // namespace canproof::test::zoo
