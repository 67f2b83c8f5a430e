// SPDX-License-Identifier: Apache-2.0
// Functions of host headers that only tests call. They are emitted here, so that the program of mutants contains them
// together with their mutants.
#include <cstdint>

#include "host/sim/bus/acceptance.hpp"
#include "host/sim/bus/arbitrated_bus.hpp"
#include "host/sim/bus/bus_faults.hpp"
#include "host/sim/bus/bus_load.hpp"
#include "host/sim/bus/echo_matcher.hpp"
#include "host/sim/bus/fault_confinement.hpp"
#include "host/sim/bus/frame_readers.hpp"
#include "host/sim/bus/socketcand_client.hpp"
#include "host/sim/replay/own_frames.hpp"

namespace canproof::host {

template class EchoMatcher<int>;

namespace {

[[gnu::used]] bool (AcceptanceFilter::*const accepts)(const Frame&) const = &AcceptanceFilter::accepts;
[[gnu::used]] bool (BusFaultRates::*const any)() const = &BusFaultRates::any;
[[gnu::used]] std::uint32_t (FaultConfinement::*const transmit_errors)() const = &FaultConfinement::transmit_errors;
[[gnu::used]] std::uint32_t (FaultConfinement::*const receive_errors)() const = &FaultConfinement::receive_errors;
[[gnu::used]] std::size_t (SocketcandClient::*const held)() const = &SocketcandClient::held;
[[gnu::used]] std::uint64_t (ArbitratedBus::*const inspections)() const = &ArbitratedBus::inspections;
[[gnu::used]] std::size_t (BusLoad::*const periods)() const = &BusLoad::kept;
[[gnu::used]] std::size_t (FrameReaders::*const compared)() const = &FrameReaders::compared;
[[gnu::used]] std::size_t (FrameReaders::*const readers)() const = &FrameReaders::kept;
[[gnu::used]] std::size_t (OwnFrames::*const frames)() const = &OwnFrames::kept;

}  // namespace

}  // namespace canproof::host
