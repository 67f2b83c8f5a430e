// SPDX-License-Identifier: Apache-2.0
#include "tests/support/stm32f405/bxcan_model.hpp"

#include <algorithm>

namespace canproof::test {

namespace {

namespace mcr = stm32f405::mcr;
namespace msr = stm32f405::msr;
namespace tsr = stm32f405::tsr;
namespace rfr = stm32f405::rfr;
namespace esr = stm32f405::esr;
namespace ir = stm32f405::ir;

// Offsets of the registers (RM0090 32.9.5), repeated here to check the struct of the driver.
constexpr std::size_t at_mcr = 0x000, at_msr = 0x004, at_tsr = 0x008, at_rf0r = 0x00C, at_rf1r = 0x010, at_ier = 0x014,
                      at_esr = 0x018, at_btr = 0x01C, at_transmit = 0x180, at_receive = 0x1B0, at_fmr = 0x200,
                      at_fm1r = 0x204, at_fs1r = 0x20C, at_ffa1r = 0x214, at_fa1r = 0x21C, at_banks = 0x240;
constexpr std::uint32_t finit = 1;

std::uint32_t identifier_of(const Frame& frame) {
    return (frame.extended ? (frame.id << 3U) | ir::extended : frame.id << 21U) | (frame.remote ? ir::remote : 0U);
}

std::uint32_t four_bytes(const Frame& frame, std::size_t from) {
    std::uint32_t bytes = 0;
    for (std::size_t i = 4; i > 0; --i) {
        bytes = (bytes << 8U) | frame.data[from + i - 1];
    }
    return bytes;
}

}  // namespace

BxcanModel::BxcanModel() : Peripheral{&block_, sizeof block_} {}

std::uint32_t BxcanModel::on_read(std::size_t offset) {
    if (offset >= at_transmit && offset < at_receive) {
        return read_mailbox((offset - at_transmit) / 16, (offset - at_transmit) / 4 % 4);
    }
    if (offset >= at_receive && offset < at_receive + 32) {
        return read_received((offset - at_receive) / 16, (offset - at_receive) / 4 % 4);
    }
    const auto fifo_status = [](const Fifo& fifo) {
        const auto count = static_cast<std::uint32_t>(fifo.frames.size());
        return count | (count == stm32f405::fifo_depth ? rfr::full : 0U) | (fifo.overrun ? rfr::overrun : 0U) |
               (fifo.releasing ? rfr::release : 0U);
    };
    switch (offset) {
        case at_mcr:
            return control_;
        case at_msr:
            follow_request();
            return (initialising_ ? msr::initialising : 0U) | (asleep_ ? msr::asleep : 0U);
        case at_tsr:
            return transmit_status();
        case at_rf0r:
            return fifo_status(fifos_[0]);
        case at_rf1r:
            return fifo_status(fifos_[1]);
        case at_ier:
            return interrupts_;
        case at_esr:
            return error_status();
        case at_btr:
            return bit_timing_;
        case at_fmr:
            return filter_master_;
        case at_fm1r:
            return filter_mode_;
        case at_fs1r:
            return filter_scale_;
        case at_ffa1r:
            return filter_fifo_;
        case at_fa1r:
            return filter_active_;
        default:
            break;
    }
    fault("a read of a gap or of a filter bank");
    return 0;
}

void BxcanModel::on_write(std::size_t offset, std::uint32_t bits) {
    if (offset >= at_transmit && offset < at_receive) {
        return write_mailbox((offset - at_transmit) / 16, (offset - at_transmit) / 4 % 4, bits);
    }
    if (offset >= at_fmr) {
        return write_filter(offset, bits);
    }
    switch (offset) {
        case at_mcr:
            return control(bits);
        case at_tsr:
            return write_transmit_status(bits);
        case at_rf0r:
            return write_fifo(0, bits);
        case at_rf1r:
            return write_fifo(1, bits);
        case at_ier:
            interrupts_ = bits;
            return;
        case at_btr:
            follow_request();  // the controller may leave the mode at once after the request to leave it
            if (!initialising_) {
                fault("CAN_BTR is written outside the initialisation mode");
            } else {
                bit_timing_ = bits;
            }
            return;
        default:
            fault("a write to a register that is only read, or to a gap");
    }
}

void BxcanModel::control(std::uint32_t bits) {
    if ((bits & mcr::reset) != 0U) {
        ++resets_;
        control_ = 0x00010002U;
        initialising_ = false;
        asleep_ = true;
        outgoing_ = {};
        on_bus_.reset();
        fifos_ = {};
        bus_off_ = recovers_ = false;
        transmit_errors_ = receive_errors_ = 0;
        return;
    }
    control_ = bits;
}

/// Lets the acknowledgement bits INAK and SLAK follow the request bits INRQ and SLEEP (RM0090 32.4.1, 32.4.2). The
/// model calls this at each access to a register.
void BxcanModel::follow_request() {
    asleep_ = asleep_ && (control_ & mcr::sleep) != 0U;
    const bool wanted = (control_ & mcr::initialise) != 0U;
    if (!answers_ || wanted == initialising_) {
        return;
    }
    if (wanted && !on_bus_) {  // a frame that is on the bus is completed before initialisation begins
        initialising_ = true;
        recovers_ = false;
    } else if (!wanted && !dominant_) {
        initialising_ = false;
        recovers_ = bus_off_;
        recessive_ = 0;
    }
}

std::uint32_t BxcanModel::transmit_status() const {
    std::uint32_t bits = 0;
    for (std::uint32_t i = 0; i < outgoing_.size(); ++i) {
        const Outgoing& one = outgoing_[i];
        bits |= (one.pending ? 0U : tsr::empty << i);
        bits |= ((one.completed ? tsr::completed : 0U) | (one.sent ? tsr::sent : 0U) | (one.aborting ? tsr::abort : 0U))
                << (tsr::stride * i);
    }
    return bits;
}

void BxcanModel::write_transmit_status(std::uint32_t bits) {
    for (std::uint32_t i = 0; i < outgoing_.size(); ++i) {
        Outgoing& one = outgoing_[i];
        const std::uint32_t own = bits >> (tsr::stride * i);
        if ((own & tsr::completed) != 0U) {
            one.completed = one.sent = false;
        }
        if ((own & tsr::abort) != 0U && one.pending) {
            if (on_bus_ == i) {
                one.aborting = true;  // end_transmission() completes the abort (RM0090 32.7.1)
            } else {
                complete(i, false);
            }
        }
    }
}

void BxcanModel::complete(std::size_t mailbox, bool sent) {
    Outgoing& one = outgoing_[mailbox];
    one.pending = one.aborting = false;
    one.completed = true;
    one.sent = sent;
}

std::uint32_t BxcanModel::read_mailbox(std::size_t mailbox, std::size_t part) const {
    const Waiting& content = outgoing_[mailbox].content;
    const std::uint32_t parts[]{content.identifier, content.length, content.low, content.high};
    return parts[part];
}

void BxcanModel::write_mailbox(std::size_t mailbox, std::size_t part, std::uint32_t bits) {
    Outgoing& one = outgoing_[mailbox];
    if (one.pending) {
        return fault("a mailbox is written while its frame waits");
    }
    std::uint32_t* const parts[]{&one.content.identifier, &one.content.length, &one.content.low, &one.content.high};
    *parts[part] = bits;
    if (part == 0 && (bits & ir::request) != 0U) {
        one = Outgoing{one.content, true, false, false, false};
    }
}

std::uint32_t BxcanModel::read_received(std::size_t fifo, std::size_t part) {
    const Fifo& one = fifos_[fifo];
    if (one.frames.empty()) {
        fault("an empty FIFO is read");
        return 0;
    }
    const Waiting& head = one.frames.front();
    const std::uint32_t parts[]{head.identifier, head.length, head.low, head.high};
    return parts[part];
}

void BxcanModel::write_fifo(std::size_t fifo, std::uint32_t bits) {
    Fifo& one = fifos_[fifo];
    if ((bits & rfr::overrun) != 0U) {
        one.overrun = false;
    }
    if ((bits & rfr::release) != 0U) {
        if (one.frames.empty()) {
            return fault("an empty FIFO is released");
        }
        one.releasing = true;
        if (!releases_slowly_) {
            finish_release();
        }
        if (on_release) {
            on_release();
        }
    }
}

void BxcanModel::finish_release() {
    for (Fifo& one : fifos_) {
        if (one.releasing) {
            one.frames.pop_front();
            one.releasing = false;
        }
    }
}

void BxcanModel::write_filter(std::size_t offset, std::uint32_t bits) {
    if (offset == at_fmr) {
        filter_master_ = bits;
        return;
    }
    if ((filter_master_ & finit) == 0U) {
        return fault("filters are written outside their initialisation mode");
    }
    switch (offset) {
        case at_fm1r:
            filter_mode_ = bits;
            return;
        case at_fs1r:
            filter_scale_ = bits;
            return;
        case at_ffa1r:
            filter_fifo_ = bits;
            return;
        case at_fa1r:
            filter_active_ = bits;
            return;
        default:
            break;
    }
    if (offset < at_banks) {
        return fault("a write to a gap");
    }
    filters_[(offset - at_banks) / 8][(offset - at_banks) / 4 % 2] = bits;
}

/// Returns the FIFO into which the filters put an identifier, or nothing if no filter passes it. Supports 32-bit banks
/// in mask mode, as the driver uses them (32.7.4).
std::optional<std::size_t> BxcanModel::fifo_of(std::uint32_t identifier) const {
    for (std::uint32_t bank = 0; bank < filters_.size(); ++bank) {
        const std::uint32_t own = 1U << bank;
        const bool fits = ((identifier ^ filters_[bank][0]) & filters_[bank][1]) == 0U;
        if ((filter_active_ & filter_scale_ & ~filter_mode_ & own) != 0U && fits) {
            return (filter_fifo_ & own) != 0U ? 1 : 0;
        }
    }
    return std::nullopt;
}

BxcanModel::Taken BxcanModel::receive(const Frame& frame, std::uint32_t bits_later) {
    time_ = (time_ + bits_later) & 0xFFFFU;
    follow_request();
    const auto fifo =
        initialising_ || bus_off_ || (filter_master_ & finit) != 0U ? std::nullopt : fifo_of(identifier_of(frame));
    if (!fifo) {
        return Taken::filtered;
    }
    const Waiting content{identifier_of(frame),
                          frame.length | ((control_ & mcr::time_stamps) != 0U ? time_ << 16U : 0U),
                          four_bytes(frame, 0), four_bytes(frame, 4)};
    Fifo& one = fifos_[*fifo];
    if (one.frames.size() < stm32f405::fifo_depth) {
        one.frames.push_back(content);
        return Taken::kept;
    }
    one.overrun = true;
    if ((control_ & mcr::lock_fifo) == 0U) {
        one.frames.back() = content;  // the new frame overwrites the last one (RM0090 32.7.3)
    }
    return Taken::lost;
}

/// Returns the pending mailbox with the lowest identifier. Among mailboxes with equal identifiers, the one with the
/// lowest number wins (RM0090 32.7.1).
std::optional<std::size_t> BxcanModel::winner() const {
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < outgoing_.size(); ++i) {
        const auto rank = [this](std::size_t mailbox) { return outgoing_[mailbox].content.identifier >> 1U; };
        if (outgoing_[i].pending && (!best || rank(i) < rank(*best))) {
            best = i;
        }
    }
    return best;
}

std::optional<Frame> BxcanModel::begin_transmission() {
    follow_request();
    // after a request for initialisation no new frame starts (RM0090 32.4.1)
    const bool is_leaving = (control_ & mcr::initialise) != 0U;
    if (on_bus_ || is_leaving || initialising_ || bus_off_ || dominant_) {
        return std::nullopt;
    }
    on_bus_ = winner();
    if (!on_bus_) {
        return std::nullopt;
    }
    const Waiting& content = outgoing_[*on_bus_].content;
    Frame frame{};
    frame.extended = (content.identifier & ir::extended) != 0U;
    frame.remote = (content.identifier & ir::remote) != 0U;
    frame.id = content.identifier >> (frame.extended ? 3U : 21U);
    frame.length = static_cast<std::uint8_t>(content.length & 0xFU);
    for (std::size_t i = 0; i < 8; ++i) {
        frame.data[i] = static_cast<std::uint8_t>((i < 4 ? content.low : content.high) >> (8 * (i % 4)));
    }
    return frame;
}

void BxcanModel::end_transmission(bool sent) {
    if (!on_bus_) {
        return;
    }
    const std::size_t mailbox = *on_bus_;
    on_bus_.reset();
    time_ = (time_ + 100U) & 0xFFFFU;
    if (sent || outgoing_[mailbox].aborting) {
        complete(mailbox, sent);
    }
    follow_request();
}

std::optional<Frame> BxcanModel::transmit() {
    const auto frame = begin_transmission();
    end_transmission(true);
    return frame;
}

void BxcanModel::count_errors(std::uint32_t transmit, std::uint32_t receive) {
    transmit_errors_ = transmit;
    receive_errors_ = receive;
    if (transmit > 255) {
        bus_off_ = true;
        recovers_ = false;
        on_bus_.reset();
    }
}

/// Lets recessive bits pass: 128 times 11 of them end bus-off (RM0090 32.7.6). With ABOM 0, they count only after the
/// software has left initialisation mode.
void BxcanModel::pass_recessive(std::uint32_t sequences) {
    follow_request();
    if (!bus_off_ || !(recovers_ || (control_ & mcr::leave_bus_off) != 0U)) {
        return;
    }
    recessive_ += sequences;
    if (recessive_ >= 128) {
        bus_off_ = recovers_ = false;
        transmit_errors_ = receive_errors_ = recessive_ = 0;
    }
}

std::uint32_t BxcanModel::error_status() const {
    const std::uint32_t worst = std::max(transmit_errors_, receive_errors_);
    return (worst >= 96 ? esr::warning : 0U) | (worst > 127 ? esr::passive : 0U) | (bus_off_ ? esr::bus_off : 0U) |
           (std::min<std::uint32_t>(transmit_errors_, 255) << 16U) |
           (std::min<std::uint32_t>(receive_errors_, 255) << 24U);
}

}  // namespace canproof::test
