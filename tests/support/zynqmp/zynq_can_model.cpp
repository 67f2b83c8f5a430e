// SPDX-License-Identifier: Apache-2.0
#include "tests/support/zynqmp/zynq_can_model.hpp"

#include <algorithm>

namespace canproof::test {

namespace {

// Offsets and bits of the registers (UG1087, module CAN), repeated here to check the driver's own definitions.
constexpr std::size_t at_srr = 0x00, at_msr = 0x04, at_brpr = 0x08, at_btr = 0x0C, at_sr = 0x18, at_isr = 0x1C,
                      at_icr = 0x24, at_txhpb = 0x40, at_rxfifo = 0x50, at_afr = 0x60, at_filters = 0x64;
constexpr std::uint32_t srst = 1, cen = 2;
constexpr std::uint32_t config = 1, normal = 8, errwrn = 1U << 6U, txbfll = 1U << 9U, acfbsy = 1U << 11U;
constexpr std::uint32_t rxoflw = 1U << 6U, rxnemp = 1U << 7U;
constexpr std::uint32_t ide = 1U << 19U, srrrtr = 1U << 20U;

/// Returns the words of a frame as the controller stores them: UG1085, Table 20-3.
std::array<std::uint32_t, 4> words_of(const Frame& frame) {
    std::uint32_t identifier = 0;
    if (frame.extended) {
        identifier =
            ((frame.id >> 18U) << 21U) | srrrtr | ide | ((frame.id & 0x3FFFFU) << 1U) | (frame.remote ? 1U : 0U);
    } else {
        identifier = (frame.id << 21U) | (frame.remote ? srrrtr : 0U);
    }
    std::array<std::uint32_t, 2> data{};
    for (std::size_t i = 0; i < 8; ++i) {
        data[i / 4] |= std::uint32_t{frame.data[i]} << (24 - 8 * (i % 4));
    }
    return {identifier, std::uint32_t{frame.length} << 28U, data[0], data[1]};
}

Frame frame_of(const std::array<std::uint32_t, 4>& words) {
    Frame frame{};
    frame.extended = (words[0] & ide) != 0U;
    frame.id = frame.extended ? ((words[0] >> 21U) << 18U) | ((words[0] >> 1U) & 0x3FFFFU) : words[0] >> 21U;
    frame.remote = (words[0] & (frame.extended ? 1U : srrrtr)) != 0U;
    frame.length = static_cast<std::uint8_t>(words[1] >> 28U);
    for (std::size_t i = 0; i < 8; ++i) {
        frame.data[i] = static_cast<std::uint8_t>(words[2 + i / 4] >> (24 - 8 * (i % 4)));
    }
    return frame;
}

}  // namespace

ZynqCanModel::ZynqCanModel() : Peripheral{&block_, sizeof block_} {}

std::uint32_t ZynqCanModel::on_read(std::size_t offset) {
    if (offset >= at_rxfifo && offset < at_afr) {
        return read_received((offset - at_rxfifo) / 4);
    }
    switch (offset) {
        case at_sr:
            return status();
        case at_isr:
            interrupts_ |= received_.empty() ? 0U : rxnemp;
            return interrupts_;
        case at_brpr:
            return prescaler_;
        case at_btr:
            return timing_;
        default:
            break;
    }
    fault("a read of a register that the driver does not need");
    return 0;
}

void ZynqCanModel::on_write(std::size_t offset, std::uint32_t bits) {
    if (offset >= at_filters) {
        return write_filter(offset, bits);
    }
    if (offset >= at_txhpb && offset < at_rxfifo) {
        return write_frame((offset - at_txhpb) / 4, bits);
    }
    switch (offset) {
        case at_srr:
            return write_reset(bits);
        case at_msr:
            mode_ = bits;
            return;
        case at_brpr:
            return write_timing(prescaler_, bits & 0xFFU);
        case at_btr:
            return write_timing(timing_, bits & 0x1FFU);
        case at_icr:
            interrupts_ = (interrupts_ & ~bits) | (received_.empty() ? 0U : rxnemp);  // set again at once
            return;
        case at_afr:
            busy_ = (used_ & ~bits) != 0U;  // a filter that is switched off is busy for a while
            used_ = bits;
            return;
        default:
            fault("a write to a register that is only read, or that the driver does not need");
    }
}

/// Handles a write of SRR (UG1087): SRST sets all registers to their values after reset, and the hardware then clears
/// SRST. ISR then shows an empty TXFIFO. The filters keep their content.
void ZynqCanModel::write_reset(std::uint32_t bits) {
    if ((bits & srst) != 0U) {
        ++resets_;
        reset_ = true;
        enabled_ = normal_ = full_ = on_bus_ = bus_off_ = false;
        mode_ = prescaler_ = timing_ = interrupts_ = 0;
        transmit_errors_ = receive_errors_ = recessive_ = 0;
        written_ = read_ = 0;
        received_.clear();
    } else {
        enabled_ = (bits & cen) != 0U;
        normal_ = normal_ && enabled_;
    }
}

void ZynqCanModel::write_timing(std::uint32_t& field, std::uint32_t bits) {
    if (enabled_ || reset_) {
        return fault("BRPR or BTR is written outside the configuration mode");
    }
    field = bits;
}

/// Handles a write of TXHPB. The driver must write all four words in ascending order (UG1085, Message Format).
void ZynqCanModel::write_frame(std::size_t word, std::uint32_t bits) {
    if (full_ || word != written_) {
        return fault("TXHPB is written while it is full, or its words in another order");
    }
    first_[word] = bits;
    written_ = (written_ + 1) % first_.size();
    full_ = written_ == 0 && !sends_at_once_;
    sent_at_once_ += written_ == 0 && sends_at_once_ ? 1 : 0;
}

void ZynqCanModel::write_filter(std::size_t offset, std::uint32_t bits) {
    const std::size_t filter = (offset - at_filters) / 8;
    if ((used_ & (1U << filter)) != 0U || busy_) {
        return fault("a filter is written while it is used or busy");
    }
    filters_[filter][(offset - at_filters) / 4 % 2] = bits;
}

/// Performs what the hardware does by itself, such as the end of a reset. The model calls this at each access.
void ZynqCanModel::follow() {
    reset_ = reset_ && !answers_;
    busy_ = busy_ && filters_stay_;
    normal_ = enabled_ && (normal_ || !dominant_) && mode_ == 0;
}

std::uint32_t ZynqCanModel::status() {
    const std::uint32_t before = enabled_ || reset_ ? 0U : config;  // a reset becomes visible only at the next read
    follow();
    return before | (normal_ ? normal : 0U) | (full_ ? txbfll : 0U) | (busy_ ? acfbsy : 0U) | error_state();
}

/// Returns the error bits of SR (UG1087): ESTAT in bits 7 and 8, and ERRWRN. Returns 0 in configuration mode.
std::uint32_t ZynqCanModel::error_state() const {
    const std::uint32_t worst = std::max(transmit_errors_, receive_errors_);
    if (!enabled_) {
        return 0;
    }
    const std::uint32_t state = bus_off_ ? 2U : (worst > 127 ? 3U : 1U);
    return (state << 7U) | (worst >= 96 ? errwrn : 0U);
}

std::uint32_t ZynqCanModel::read_received(std::size_t word) {
    if (received_.empty() || word != read_) {
        fault("an empty RXFIFO is read, or its words in another order");
        return 0;
    }
    const std::uint32_t bits = received_.front()[word];
    read_ = (read_ + 1) % first_.size();
    if (read_ == 0) {
        received_.pop_front();
    }
    return bits;
}

/// Returns whether a frame passes the filters. When no filter is in use, every frame passes (UG1085, RX Message
/// Acceptance Filters).
bool ZynqCanModel::passes(std::uint32_t identifier) const {
    bool any = used_ == 0;
    for (std::uint32_t i = 0; i < filters_.size(); ++i) {
        const bool used = (used_ & (1U << i)) != 0U;
        any = any || (used && ((identifier ^ filters_[i][1]) & filters_[i][0]) == 0U);
    }
    return any;
}

ZynqCanModel::Taken ZynqCanModel::receive(const Frame& frame) {
    follow();
    const auto words = words_of(frame);
    if (!normal_ || bus_off_ || !passes(words[0])) {
        return Taken::filtered;
    }
    if (received_.size() == zynqmp::fifo_depth) {
        interrupts_ |= rxoflw;
        return Taken::lost;
    }
    received_.push_back(words);
    interrupts_ |= rxnemp;
    return Taken::kept;
}

std::optional<Frame> ZynqCanModel::begin_transmission() {
    follow();
    if (!normal_ || bus_off_ || dominant_ || on_bus_ || !full_) {
        return std::nullopt;
    }
    on_bus_ = true;
    return frame_of(first_);
}

void ZynqCanModel::end_transmission(bool sent) {
    full_ = full_ && !(on_bus_ && sent);
    on_bus_ = false;
}

std::optional<Frame> ZynqCanModel::transmit() {
    const auto frame = begin_transmission();
    end_transmission(true);
    return frame;
}

void ZynqCanModel::count_errors(std::uint32_t transmit, std::uint32_t receive) {
    transmit_errors_ = transmit;
    receive_errors_ = receive;
    if (transmit > 255 && enabled_) {
        bus_off_ = true;
        on_bus_ = false;
        recessive_ = 0;
    }
}

/// Lets sequences of 11 recessive bits pass. After 128 sequences the controller leaves bus-off by itself.
void ZynqCanModel::pass_recessive(std::uint32_t sequences) {
    recessive_ += bus_off_ ? sequences : 0U;
    if (recessive_ >= 128) {
        bus_off_ = false;
        transmit_errors_ = receive_errors_ = recessive_ = 0;
    }
}

}  // namespace canproof::test
