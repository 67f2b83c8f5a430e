// SPDX-License-Identifier: Apache-2.0
// Changes of the frames or the dictionary of a correct slave that several faults share.
#pragma once

#include <functional>

#include "tests/conformance/zoo/fault.hpp"
#include "tests/conformance/zoo/sdo_frames.hpp"

namespace canproof::test::zoo {

using FrameTest = std::function<bool(WrongSlave&, const Frame&)>;
using FrameChange = std::function<Frame(WrongSlave&, const Frame&)>;
using ObjectTest = std::function<bool(std::uint16_t index, std::uint8_t subindex)>;
using ValueChange = std::function<std::uint32_t(std::uint32_t value)>;

/// Return distortions of the received frames (`hear`), of the sent frames (`say`), of both, or of the dictionary.
Distortion hears(FrameHook hear);
Distortion says(FrameHook say);
Distortion hears_and_says(FrameHook hear, FrameHook say);
Distortion has_dictionary(std::function<void(host::Part&)> alter);

/// Return distortions that drop frames to the slave (is_deaf_to), or frames of the slave (keeps_back).
Distortion is_deaf_to(FrameTest which);
Distortion keeps_back(FrameTest which);
/// Changes an answer of the SDO server. Segments of a block upload stay unchanged.
Distortion answers_otherwise(FrameChange change);
/// Changes a request to the SDO server.
Distortion takes_requests_as(FrameChange change);
/// Replaces an abort code by another.
Distortion aborts_with(std::uint32_t code, std::uint32_t other);
/// Confirms downloads of these objects that the correct slave refuses with `code`; nothing is written.
Distortion confirms_refused(ObjectTest which, std::uint32_t code);
/// Makes the slave use another value than was written, while a read returns the written one. Expedited transfers only.
Distortion works_with(ObjectTest which, ValueChange change);

inline ObjectTest object(std::uint16_t index) {
    return [index](std::uint16_t other, std::uint8_t) { return other == index; };
}
inline ObjectTest entry(std::uint16_t index, std::uint8_t subindex) {
    return [=](std::uint16_t other, std::uint8_t sub) { return other == index && sub == subindex; };
}
/// Selects one sub-index of all objects from `first` to `last`.
inline ObjectTest entries(std::uint16_t first, std::uint16_t last, std::uint8_t subindex) {
    return [=](std::uint16_t index, std::uint8_t sub) { return index >= first && index <= last && sub == subindex; };
}
inline ObjectTest objects(std::uint16_t first, std::uint16_t last) {
    return [=](std::uint16_t index, std::uint8_t) { return index >= first && index <= last; };
}
inline ValueChange always(std::uint32_t value) {
    return [value](std::uint32_t) { return value; };
}
/// Returns a change that makes a value `parts` percent of itself, rounded down.
inline ValueChange percent(std::uint32_t parts) {
    return [parts](std::uint32_t value) { return static_cast<std::uint32_t>(std::uint64_t{value} * parts / 100U); };
}

}  // namespace canproof::test::zoo
