// SPDX-License-Identifier: Apache-2.0
// The description of a frame in a step of a conformance case: `rtr 700+N`, `ext 600+N: 40 00`, `580+N: 43 …`.
#pragma once

#include <string>

#include "host/conform/language/data_pattern.hpp"
#include "host/conform/language/expression.hpp"
#include "host/conform/link/link.hpp"
#include "host/conform/steps/step.hpp"

namespace canproof::host::conform {

struct FrameSpec {
    Expression id;
    bool extended{false};
    bool remote{false};
    bool any_data{true};  ///< whether the step describes no data, so that any data match
    DataPattern data{DataPattern::any()};
    Expression remote_length;  ///< length of a remote frame; empty: 0

    FrameKey key(const Scope& scope) const;
    /// Returns the frame to send. Throws BrokenCase when its values cannot form a frame.
    Frame frame(const Scope& scope) const;
};

FrameSpec parse_frame_spec(Scanner& line);
/// Parses only the identifier of a frame.
FrameSpec parse_frame_id(Scanner& line);

/// Returns identifier, format and type of a frame as text: `185h`, `600h remote` or `00000605h (29 bits)`.
std::string words_of(const FrameKey& key);

/// Stores the values that a step captured as variables and, if `name` is not empty, the complete frame as the variable
/// `name`. Sets the variable `elapsed` to the time in µs from the last sent frame to this frame.
void keep(Context& context, const FrameRecord& record, const Captures& captures, const std::string& name);

}  // namespace canproof::host::conform
