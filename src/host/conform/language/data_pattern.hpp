// The data bytes of a frame in a step: what is sent, or what is expected and captured.
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

/// One or more bytes of it.
struct DataPart {
    std::size_t width{1};  ///< bytes; 0: as many as the value has
    /// What to send; empty for a part that only an expectation can have.
    std::function<Bytes(const Scope&)> bytes;
    /// Whether `data` from `at` on is so; may capture.
    std::function<bool(const Scope&, const Bytes& data, std::size_t at, Captures&)> matches;
};

class DataPattern {
  public:
    /// Reads bytes up to the first word that is none. Throws LanguageError.
    static DataPattern parse(Scanner& line);

    /// Any data at all.
    static DataPattern any();

    bool is_empty() const { return parts_.empty() && !rest_; }
    /// The rest may be anything.
    void leave_rest_open() { rest_ = true; }
    /// What is sent; `...` fills up with zeros to eight bytes. Throws BrokenCase for `??` and for more than eight.
    Bytes to_send(const Scope& scope) const;
    bool matches(const Scope& scope, const Bytes& data, Captures& captures) const;

  private:
    std::vector<DataPart> parts_;
    bool rest_{false};  ///< it ends with `...`
};

/// The data of a frame.
Bytes data_of(const Frame& frame);

}  // namespace canproof::host::conform
