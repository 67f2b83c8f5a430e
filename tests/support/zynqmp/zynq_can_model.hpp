// SPDX-License-Identifier: Apache-2.0
// A model of the Zynq UltraScale+'s CAN controller for its driver (UG1085 chapter 20, UG1087): registers with effects
// on reads and writes, and a bus that the test controls.
#pragma once

#include <deque>
#include <optional>

#include "firmware/canopen/frame.hpp"
#include "target/zynqmp/can_registers.hpp"
#include "tests/support/stm32f405/peripheral.hpp"

namespace canproof::test {

class ZynqCanModel final : public Peripheral {
  public:
    ZynqCanModel();

    zynqmp::CanRegisters& registers() { return block_; }

    // Settings for the behaviour of the hardware.
    ///< sets whether a reset leads to CONFIG (configuration mode)
    void answer_reset(bool answers) { answers_ = answers; }
    ///< sets whether ACFBSY (filters busy) stays set after a change of the filters
    void keep_filters_busy(bool busy) { filters_stay_ = busy; }
    ///< while the bus is dominant, the controller does not join it
    void hold_dominant(bool dominant) { dominant_ = dominant; }
    ///< sets whether a frame has left TXHPB as soon as its last word is written
    void send_at_once(bool sends) { sends_at_once_ = sends; }

    // Events on the bus.
    /// The result for a frame of another node: stored, lost because RXFIFO is full, or filtered out.
    enum class Taken { kept, lost, filtered };
    Taken receive(const Frame& frame);
    /// Puts the waiting frame on the bus. Returns nothing if no frame waits, if a frame is on the bus already, or if
    /// the controller cannot send.
    std::optional<Frame> begin_transmission();
    /// Ends the transmission. If `sent` is false, the controller sends the frame again.
    void end_transmission(bool sent);
    /// Calls begin_transmission() and end_transmission() with success.
    std::optional<Frame> transmit();
    void count_errors(std::uint32_t transmit, std::uint32_t receive);
    /// Lets sequences of 11 recessive bits pass.
    void pass_recessive(std::uint32_t sequences);

    std::uint32_t prescaler() const { return prescaler_; }
    std::uint32_t bit_timing() const { return timing_; }
    bool is_full() const { return full_; }  ///< a frame waits in TXHPB
    std::size_t resets() const { return resets_; }
    std::size_t sent_at_once() const { return sent_at_once_; }

  private:
    using Words = std::array<std::uint32_t, 4>;

    std::uint32_t on_read(std::size_t offset) override;
    void on_write(std::size_t offset, std::uint32_t bits) override;

    std::uint32_t status();
    std::uint32_t error_state() const;
    std::uint32_t read_received(std::size_t word);
    void write_reset(std::uint32_t bits);
    void write_timing(std::uint32_t& field, std::uint32_t bits);
    void write_frame(std::size_t word, std::uint32_t bits);
    void write_filter(std::size_t offset, std::uint32_t bits);
    void follow();
    bool passes(std::uint32_t identifier) const;

    zynqmp::CanRegisters block_{};
    bool answers_{true}, filters_stay_{false}, dominant_{false}, sends_at_once_{false};
    std::size_t sent_at_once_{0};
    bool reset_{false};    ///< a reset was requested and is not complete yet
    bool enabled_{false};  ///< CEN
    bool normal_{false};   ///< the controller has joined the bus
    std::uint32_t mode_{0}, prescaler_{0}, timing_{0};
    std::uint32_t interrupts_{0};  ///< ISR
    std::uint32_t used_{0};        ///< AFR
    bool busy_{false};             ///< ACFBSY
    std::array<std::array<std::uint32_t, 2>, zynqmp::filter_count> filters_{};
    Words first_{};               ///< TXHPB
    std::size_t written_{0};      ///< words written so far of an incomplete frame in TXHPB
    bool full_{false};            ///< TXBFLL
    bool on_bus_{false};          ///< the frame of TXHPB is on the bus
    std::deque<Words> received_;  ///< RXFIFO
    std::size_t read_{0};         ///< words read so far of the first frame in RXFIFO
    std::uint32_t transmit_errors_{0}, receive_errors_{0};
    bool bus_off_{false};
    std::uint32_t recessive_{0};
    std::size_t resets_{0};
};

}  // namespace canproof::test
