// SPDX-License-Identifier: Apache-2.0
// The pattern for the data bytes of a frame in a step of a conformance case. A step sends the bytes of the pattern, or
// expects a frame that matches the pattern and captures values of the frame.
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
    /// width in bytes; 0: the part is as long as its value, and a capture takes the rest of the frame
    std::size_t width{1};
    /// Computes the bytes to send. A null function when the part can only be expected, not sent.
    std::function<Bytes(const Scope&)> bytes;
    /// Returns whether `data` matches this part from position `at` on. May store values in the captures.
    std::function<bool(const Scope&, const Bytes& data, std::size_t at, Captures&)> matches;
};

class DataPattern {
  public:
    /// Parses bytes up to a word such as `within`, an arrow or the end of the line. Throws LanguageError for any other
    /// text that is no byte.
    static DataPattern parse(Scanner& line);

    /// Returns a pattern that matches any data.
    static DataPattern any();

    bool is_empty() const { return parts_.empty() && !rest_; }
    /// Makes the pattern also match data that continue after its last byte.
    void leave_rest_open() { rest_ = true; }
    /// Returns the bytes to send. A pattern that ends with `...` is padded with zeros to eight bytes. Throws BrokenCase
    /// for a byte without a fixed value, such as `??`, and for more than eight bytes.
    Bytes to_send(const Scope& scope) const;
    bool matches(const Scope& scope, const Bytes& data, Captures& captures) const;
    /// Returns the pattern with the present values of its variables inserted, so that the result no longer depends on a
    /// scope.
    DataPattern with_values_of(const Scope& scope) const;

  private:
    std::vector<DataPart> parts_;
    bool rest_{false};  ///< whether the pattern ends with `...`
};

/// Returns the data bytes of a frame.
Bytes data_of(const Frame& frame);

}  // namespace canproof::host::conform
