// SPDX-License-Identifier: Apache-2.0
#include "target/stm32f405/can_transmitter.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof::stm32f405 {

namespace {

/// Each round fills or frees a mailbox; after two rounds per mailbox nothing is left to do.
constexpr std::size_t most_rounds = 2U * mailbox_count;

constexpr std::uint32_t of_mailbox(const std::uint32_t bits, const std::size_t mailbox) noexcept {
    return bits << (tsr::stride * static_cast<std::uint32_t>(mailbox));
}

std::uint32_t identifier_register(const Frame& frame) noexcept {
    const std::uint32_t identifier =
        frame.extended ? ((frame.id << ir::extended_shift) | ir::extended) : (frame.id << ir::standard_shift);
    return identifier | (frame.remote ? ir::remote : 0U);
}

}  // namespace

void CanTransmitter::serve(TransmitQueue& queue) noexcept {
    collect(queue);
    if (queue.boot_up_waits()) {
        drop_all();
        collect(queue);
    }
    bool goes_on{true};
    for (std::size_t round = 0U; round < most_rounds; ++round) {
        if (goes_on) {
            goes_on = place_next(queue);
        }
    }
}

/// Begins with the last mailbox, because the queue puts each frame before all others with its identifier. The hardware
/// sends nothing while it is bus-off; the restart of the controller aborts the frames in its mailboxes.
static_assert(implements<req::CO_CAN_018>);
void CanTransmitter::give_back(TransmitQueue& queue) noexcept {
    const std::uint32_t status = registers_.transmit_status.read();
    for (std::size_t behind = mailbox_count; behind > 0U; --behind) {
        const Slot& slot = slots_[behind - 1U];
        const bool was_sent = (status & of_mailbox(tsr::sent, behind - 1U)) != 0U;
        if (slot.busy && !slot.unwanted && !was_sent && !queue.boot_up_waits()) {
            queue.put_back_at_bus_off(slot.frame);
        }
    }
    forget();
}

void CanTransmitter::forget() noexcept {
    slots_.fill(Slot{});
    is_alone_ = false;
}

std::size_t CanTransmitter::waiting() const noexcept {
    std::size_t count{0U};
    for (const Slot& slot : slots_) {
        count += slot.busy ? 1U : 0U;
    }
    return count;
}

/// Frees the mailboxes whose frames were sent or aborted. The hardware reports which of the two happened, because an
/// abort may come too late (RM0090 32.7.1). An aborted frame goes back to the queue, unless it must not be sent again
/// (`unwanted`) or a boot-up message waits.
static_assert(implements<req::CO_CAN_013>);
void CanTransmitter::collect(TransmitQueue& queue) noexcept {
    const std::uint32_t status = registers_.transmit_status.read();
    for (std::size_t mailbox = 0U; mailbox < mailbox_count; ++mailbox) {
        Slot& slot = slots_[mailbox];
        if (!slot.busy || ((status & of_mailbox(tsr::completed, mailbox)) == 0U)) {
            continue;
        }
        registers_.transmit_status.write(of_mailbox(tsr::completed, mailbox));  // writing 1 clears the flag
        const bool is_unwanted = slot.unwanted || queue.boot_up_waits();
        bool is_over = is_unwanted || ((status & of_mailbox(tsr::sent, mailbox)) != 0U);
        if (!is_over) {
            is_over = queue.put_back(slot.frame);
        }
        if (is_over) {
            slot = Slot{};
        } else {
            exchange(mailbox, queue);
        }
    }
    is_alone_ = is_alone_ && (waiting() != 0U);
}

/// Exchanges the frame of an aborted mailbox with the first frame of the full queue. The mailbox sends its own frame
/// again if the frame of the queue is not more urgent, or if a later mailbox has a frame with the identifier of the
/// frame of the queue.
static_assert(implements<req::CO_CAN_013>);
void CanTransmitter::exchange(const std::size_t mailbox, TransmitQueue& queue) noexcept {
    Slot& slot = slots_[mailbox];
    const Frame* const next = queue.front();
    bool is_in_order = (next != nullptr) && (next->id < slot.frame.id);
    for (std::size_t behind = mailbox + 1U; behind < mailbox_count; ++behind) {
        const Slot& other = slots_[behind];
        is_in_order = is_in_order && !(other.busy && (other.frame.id == next->id));
    }
    if (is_in_order) {
        const Frame aborted = slot.frame;
        slot.frame = queue.pop();
        static_cast<void>(queue.put_back(aborted));  // there is room: the frame that left the queue has freed a place
    }
    request(mailbox);
}

/// Moves a frame from the queue to a mailbox, or frees a mailbox for it. Returns false when there is nothing more to
/// do.
static_assert(implements<req::CO_CAN_006> && implements<req::CO_CAN_012>);
bool CanTransmitter::place_next(TransmitQueue& queue) noexcept {
    const Frame* const next = queue.front();
    const bool goes_alone = queue.boot_up_waits();
    if ((next == nullptr) || is_alone_ || (goes_alone && (waiting() != 0U))) {
        return false;
    }
    const std::size_t mailbox = place_for(next->id);
    if (mailbox == mailbox_count) {
        bool is_free{false};
        if (waiting() == mailbox_count) {
            is_free = make_room(next->id, queue);
        }
        return is_free;
    }
    is_alone_ = goes_alone;
    slots_[mailbox].frame = queue.pop();
    request(mailbox);
    return true;
}

/// Returns the first free mailbox behind all mailboxes whose frames have this identifier, because those frames must be
/// sent first; mailbox_count when there is none.
std::size_t CanTransmitter::place_for(const std::uint32_t id) const noexcept {
    std::size_t found{mailbox_count};
    for (std::size_t mailbox = 0U; mailbox < mailbox_count; ++mailbox) {
        const Slot& slot = slots_[mailbox];
        if (slot.busy && (slot.frame.id == id)) {
            found = mailbox_count;
        } else if (!slot.busy && (found == mailbox_count)) {
            found = mailbox;
        } else {
            // a frame with another identifier waits here, or a free mailbox is already found
        }
    }
    return found;
}

/// Returns the mailbox with the least urgent frame; among equal identifiers the newest one.
std::size_t CanTransmitter::least_urgent() const noexcept {
    std::size_t found{0U};
    for (std::size_t mailbox = 1U; mailbox < mailbox_count; ++mailbox) {
        if (slots_[mailbox].frame.id >= slots_[found].frame.id) {
            found = mailbox;
        }
    }
    return found;
}

bool CanTransmitter::make_room(const std::uint32_t id, TransmitQueue& queue) noexcept {
    const std::size_t mailbox = least_urgent();
    if (slots_[mailbox].aborting || (slots_[mailbox].frame.id <= id)) {
        return false;
    }
    abort(mailbox);
    collect(queue);
    return !slots_[mailbox].busy;
}

/// Aborts all frames. After a reset of the node they must not follow its boot-up message.
void CanTransmitter::drop_all() noexcept {
    for (std::size_t mailbox = 0U; mailbox < mailbox_count; ++mailbox) {
        if (slots_[mailbox].busy) {
            slots_[mailbox].unwanted = true;
            abort(mailbox);
        }
    }
}

void CanTransmitter::abort(const std::size_t mailbox) noexcept {
    slots_[mailbox].aborting = true;
    registers_.transmit_status.write(of_mailbox(tsr::abort, mailbox));
}

void CanTransmitter::request(const std::size_t mailbox) noexcept {
    Slot& slot = slots_[mailbox];
    slot.busy = true;
    slot.aborting = false;
    Mailbox& registers = registers_.transmit[mailbox];
    const std::uint32_t identifier = identifier_register(slot.frame);
    registers.identifier.write(identifier);
    registers.length.write(slot.frame.length);
    registers.data_low.write(static_cast<std::uint32_t>(field_le<0U, 4U>(slot.frame.data)));
    registers.data_high.write(static_cast<std::uint32_t>(field_le<4U, 4U>(slot.frame.data)));
    registers.identifier.write(identifier | ir::request);
}

}  // namespace canproof::stm32f405
