// SPDX-License-Identifier: Apache-2.0
// Functions that several faults share: each returns a change of the frames or of the dictionary of a correct slave.
#pragma once

#include <functional>

#include "tests/conformance/zoo/fault.hpp"
#include "tests/conformance/zoo/sdo_frames.hpp"

namespace canproof::test::zoo {

using FrameTest = std::function<bool(WrongSlave&, const Frame&)>;
using FrameChange = std::function<Frame(WrongSlave&, const Frame&)>;
using ObjectTest = std::function<bool(std::uint16_t index, std::uint8_t subindex)>;
using ValueChange = std::function<std::uint32_t(std::uint32_t value)>;

/// Return changes ("distortions") of the frames that the slave receives (`hear`), of those that it sends (`say`), of
/// both, or of its dictionary.
Distortion hears(FrameHook hear);
Distortion says(FrameHook say);
Distortion hears_and_says(FrameHook hear, FrameHook say);
Distortion has_dictionary(std::function<void(host::Part&)> alter);

/// Drop frames that match `which`: is_deaf_to() drops frames to the slave, keeps_back() drops frames that it sends.
Distortion is_deaf_to(FrameTest which);
Distortion keeps_back(FrameTest which);
/// Changes the answers of the SDO server, except segments of a block upload.
Distortion answers_otherwise(FrameChange change);
/// Changes the requests to the SDO server before the slave gets them.
Distortion takes_requests_as(FrameChange change);
/// Replaces the abort code `code` by `other`.
Distortion aborts_with(std::uint32_t code, std::uint32_t other);
/// Confirms downloads to objects of `which` that the correct slave refuses with `code`. Nothing is written.
Distortion confirms_refused(ObjectTest which, std::uint32_t code);
/// Makes the slave work with `change`(value) instead of the value that a client wrote; a read still returns the written
/// value. Works for expedited transfers only.
Distortion works_with(ObjectTest which, ValueChange change);

inline ObjectTest object(std::uint16_t index) {
    return [index](std::uint16_t other, std::uint8_t) { return other == index; };
}
inline ObjectTest entry(std::uint16_t index, std::uint8_t subindex) {
    return [=](std::uint16_t other, std::uint8_t sub) { return other == index && sub == subindex; };
}
/// Returns a test for sub-index `subindex` of all objects from `first` to `last`.
inline ObjectTest entries(std::uint16_t first, std::uint16_t last, std::uint8_t subindex) {
    return [=](std::uint16_t index, std::uint8_t sub) { return index >= first && index <= last && sub == subindex; };
}
inline ObjectTest objects(std::uint16_t first, std::uint16_t last) {
    return [=](std::uint16_t index, std::uint8_t) { return index >= first && index <= last; };
}
inline ValueChange always(std::uint32_t value) {
    return [value](std::uint32_t) { return value; };
}
/// Returns a change of a value to `parts` percent of it, rounded down.
inline ValueChange percent(std::uint32_t parts) {
    return [parts](std::uint32_t value) { return static_cast<std::uint32_t>(std::uint64_t{value} * parts / 100U); };
}

}  // namespace canproof::test::zoo
