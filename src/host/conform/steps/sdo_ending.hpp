// SPDX-License-Identifier: Apache-2.0
// The expected end of a transfer in a step, and the value that it writes.
#pragma once

#include <optional>
#include <string>

#include "host/conform/language/expression.hpp"
#include "host/conform/steps/abort_list.hpp"
#include "host/conform/steps/step.hpp"

namespace canproof::host::conform {

/// The expected end of a transfer.
struct Ending {
    bool any{false};                 ///< `try`
    std::optional<AbortList> fails;  ///< absent: it must succeed
    std::string name;                ///< name after `->`
    Expression value;                ///< value after `=` of a read

    /// Parses `fails …` or `-> name`. Returns false when neither follows.
    bool take(Scanner& line);
    /// Throws SlaveFailed when the transfer ended otherwise; stores its value.
    void judge(const SdoOutcome& outcome, const ObjectPlace& place, Context& context) const;
};

/// Returns the bytes to write: the given bytes, or a number that is `width` bytes wide. With `width` 0 the data sheet
/// determines the width. Throws BrokenCase.
Bytes bytes_to_write(const Value& value, std::size_t width, const ObjectPlace& place, const Context& context);

}  // namespace canproof::host::conform
