// SPDX-License-Identifier: Apache-2.0
// The code for one microcontroller (a port) gives a device a clock (base/time.hpp), a parameter memory
// (base/non_volatile_memory.hpp), and a CAN controller with the functions below, which never wait. stm32f405::Bxcan and
// zynqmp::Can are such controllers.
#pragma once

#include <type_traits>
#include <utility>

#include "firmware/base/time.hpp"
#include "firmware/canopen/node.hpp"
#include "firmware/canopen/transmit_queue.hpp"

namespace canproof::target {

template <typename Result, typename Returned>
constexpr bool is_result = std::is_same_v<Result, Returned>;

/// Says whether a class has the functions that the CAN controller of a port needs:
///   set_bit_rate(rate, now)  leaves the bus and joins it again at this rate
///   bit_rate()               the last requested rate; 0 before the first
///   advance(queue, now)      takes the hardware's next step, moves frames from the queue to it
///   receive(frame)           takes the oldest received frame; false when there is none
///   take_overrun()           whether a frame was lost since the last call
///   state(), is_on_bus()     error state; whether frames can be exchanged
template <typename Can>
constexpr bool is_can_port = is_result<void, decltype(std::declval<Can&>().set_bit_rate(std::uint32_t{}, Instant{}))>&&
    is_result<std::uint32_t, decltype(std::declval<const Can&>().bit_rate())>&&
        is_result<void, decltype(std::declval<Can&>().advance(std::declval<TransmitQueue&>(), Instant{}))>&&
            is_result<bool, decltype(std::declval<Can&>().receive(std::declval<Frame&>()))>&&
                is_result<bool, decltype(std::declval<Can&>().take_overrun())>&&
                    is_result<CanState, decltype(std::declval<const Can&>().state())>&&
                        is_result<bool, decltype(std::declval<const Can&>().is_on_bus())>;

}  // namespace canproof::target
