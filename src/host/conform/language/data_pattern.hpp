// SPDX-License-Identifier: Apache-2.0
// The data bytes of a frame in a step: to send, or to expect and capture.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "firmware/canopen/frame.hpp"
#include "host/conform/language/scanner.hpp"
#include "host/conform/language/value.hpp"

namespace canproof::host::conform {

using Captures = std::map<std::string, Value>;

/// One or more bytes of a pattern.
struct DataPart {
    std::size_t width{1};  ///< in bytes; 0: the width of the value
    /// Returns the bytes to send; empty for a part that only an expectation can have.
    std::function<Bytes(const Scope&)> bytes;
    /// Returns whether `data` matches from `at` on; may capture values.
    std::function<bool(const Scope&, const Bytes& data, std::size_t at, Captures&)> matches;
};

class DataPattern {
  public:
    /// Reads bytes up to the first word that is not a byte. Throws LanguageError.
    static DataPattern parse(Scanner& line);

    /// Returns a pattern that matches any data.
    static DataPattern any();

    bool is_empty() const { return parts_.empty() && !rest_; }
    /// Lets the pattern match any further bytes.
    void leave_rest_open() { rest_ = true; }
    /// Returns the bytes to send; `...` pads with zeros to eight bytes. Throws BrokenCase for `??` and for more than
    /// eight bytes.
    Bytes to_send(const Scope& scope) const;
    bool matches(const Scope& scope, const Bytes& data, Captures& captures) const;

  private:
    std::vector<DataPart> parts_;
    bool rest_{false};  ///< the pattern ends with `...`
};

/// Returns the data of a frame.
Bytes data_of(const Frame& frame);

}  // namespace canproof::host::conform
