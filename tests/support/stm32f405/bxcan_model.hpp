// SPDX-License-Identifier: Apache-2.0
// A model of bxCAN for its driver (RM0090 chapter 32): registers with effects on reads and writes, and a bus that the
// test controls.
#pragma once

#include <deque>
#include <functional>
#include <optional>

#include "firmware/canopen/frame.hpp"
#include "target/stm32f405/bxcan_registers.hpp"
#include "tests/support/stm32f405/peripheral.hpp"

namespace canproof::test {

class BxcanModel final : public Peripheral {
  public:
    BxcanModel();

    stm32f405::BxcanRegisters& registers() { return block_; }

    // Settings for the behaviour of the hardware.
    ///< sets whether INAK follows INRQ (the request for initialisation)
    void answer_initialisation(bool answers) { answers_ = answers; }
    void hold_dominant(bool dominant) { dominant_ = dominant; }      ///< while the bus is dominant, INAK stays set
    void release_slowly(bool slowly) { releases_slowly_ = slowly; }  ///< if true, RFOM stays set until finish_release()
    void finish_release();
    std::function<void()> on_release{};  ///< called after each release of a place in a FIFO

    // Events on the bus.
    /// The result for a frame of another node: stored in its FIFO, lost to an overrun, or filtered out.
    enum class Taken { kept, lost, filtered };
    Taken receive(const Frame& frame, std::uint32_t bits_later = 50);
    /// Puts the frame of the winning mailbox on the bus. From then on, an abort does not stop this frame. Returns
    /// nothing if no frame waits, if a frame is on the bus already, or if the controller cannot send.
    std::optional<Frame> begin_transmission();
    /// Ends the transmission: the frame was sent, or was lost by an error or arbitration. A lost frame is sent again
    /// unless its abort was requested.
    void end_transmission(bool sent);
    /// Sends one frame successfully: calls begin_transmission(), then end_transmission(true).
    std::optional<Frame> transmit();
    void count_errors(std::uint32_t transmit, std::uint32_t receive);
    /// Lets the given number of sequences of 11 recessive bits pass.
    void pass_recessive(std::uint32_t sequences);

    bool is_initialising() const { return initialising_; }
    std::size_t pending(std::size_t fifo) const { return fifos_[fifo].frames.size(); }
    std::size_t resets() const { return resets_; }
    std::uint32_t bit_timing() const { return bit_timing_; }
    std::uint32_t interrupts() const { return interrupts_; }

  private:
    struct Waiting {
        std::uint32_t identifier, length, low, high;
    };
    struct Outgoing {
        Waiting content{};
        bool pending{false}, aborting{false}, completed{false}, sent{false};
    };
    struct Fifo {
        std::deque<Waiting> frames;
        bool overrun{false}, releasing{false};
    };

    std::uint32_t on_read(std::size_t offset) override;
    void on_write(std::size_t offset, std::uint32_t bits) override;

    std::uint32_t read_mailbox(std::size_t mailbox, std::size_t part) const;
    std::uint32_t read_received(std::size_t fifo, std::size_t part);
    std::uint32_t transmit_status() const;
    std::uint32_t error_status() const;
    void control(std::uint32_t bits);
    void write_transmit_status(std::uint32_t bits);
    void write_mailbox(std::size_t mailbox, std::size_t part, std::uint32_t bits);
    void write_fifo(std::size_t fifo, std::uint32_t bits);
    void write_filter(std::size_t offset, std::uint32_t bits);
    void follow_request();
    void complete(std::size_t mailbox, bool sent);
    std::optional<std::size_t> winner() const;
    std::optional<std::size_t> fifo_of(std::uint32_t identifier) const;

    stm32f405::BxcanRegisters block_{};
    std::uint32_t control_{0x00010002U};  // after a reset (RM0090 32.9.2): SLEEP and DBF
    bool initialising_{false}, asleep_{true};
    bool answers_{true}, dominant_{false}, releases_slowly_{false};
    std::uint32_t bit_timing_{0x01230000U};
    std::uint32_t interrupts_{0};
    std::uint32_t filter_master_{0x2A1C0E01U}, filter_mode_{0}, filter_scale_{0}, filter_fifo_{0}, filter_active_{0};
    std::array<std::array<std::uint32_t, 2>, stm32f405::filter_bank_count> filters_{};
    std::array<Outgoing, stm32f405::mailbox_count> outgoing_{};
    std::optional<std::size_t> on_bus_;
    std::array<Fifo, stm32f405::fifo_count> fifos_{};
    std::uint32_t transmit_errors_{0}, receive_errors_{0};
    bool bus_off_{false};
    bool recovers_{false};  ///< whether the software has left initialisation mode since bus-off
    std::uint32_t recessive_{0};
    std::uint32_t time_{0xFFC0U};  ///< time for the time stamps, in bit times; starts shortly before it wraps at 65,536
    std::size_t resets_{0};
};

}  // namespace canproof::test
