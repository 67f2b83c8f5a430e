// SPDX-License-Identifier: Apache-2.0
// The exceptions that end a conformance case early, and the measurements and notes of a case.
#pragma once

#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "host/conform/link/measured.hpp"

namespace canproof::host::conform {

/// Reports that the slave does not do what the case demands.
class SlaveFailed : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Reports that the slave does not answer at all.
class NoAnswer : public SlaveFailed {
  public:
    using SlaveFailed::SlaveFailed;
};

/// Reports that the case does not apply; the text is the reason.
class CaseSkipped : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The measurements and notes of a case.
struct Journal {
    std::map<std::string, Measured> times;  ///< measured times by their meaning, such as `SDO answer`
    std::vector<std::string> notes;
    std::uint64_t judged{0};  ///< number of checks that the slave could have failed
};

}  // namespace canproof::host::conform
