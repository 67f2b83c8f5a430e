// SPDX-License-Identifier: Apache-2.0
// How a step of a conformance case expects an SDO transfer to end, and the value that it writes.
#pragma once

#include <optional>
#include <string>

#include "host/conform/language/expression.hpp"
#include "host/conform/steps/abort_list.hpp"
#include "host/conform/steps/step.hpp"

namespace canproof::host::conform {

/// How a step expects an SDO transfer to end.
struct Ending {
    bool any{false};                 ///< whether the step begins with `try`, so that any end is accepted
    std::optional<AbortList> fails;  ///< accepted abort codes; absent: the transfer must succeed
    std::string name;                ///< name of the variable after `->`; empty: none
    Expression value;                ///< value after the `=` of a read; empty: any value

    /// Parses `fails …` or `-> name`. Returns false when neither of them follows.
    bool take(Scanner& line);
    /// Throws SlaveFailed when the transfer ended in another way than the step expects. Stores the value of the
    /// transfer in the variable `name`.
    void judge(const SdoOutcome& outcome, const ObjectPlace& place, Context& context) const;
};

/// Returns the bytes to write: the given bytes, or a number in `width` bytes. If `width` is 0, the data sheet
/// determines the width. Throws BrokenCase when the data sheet does not contain the width.
Bytes bytes_to_write(const Value& value, std::size_t width, const ObjectPlace& place, const Context& context);

}  // namespace canproof::host::conform
