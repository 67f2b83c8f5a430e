// SPDX-License-Identifier: Apache-2.0
// Standard input, output and error of a command.
#pragma once

#include <string>

namespace canproof::host {

/// Opens /dev/null, read only, for each standard descriptor that is closed. A file that a command opens then never gets
/// such a descriptor, and a write to a closed standard stream fails with an error.
void keep_standard_descriptors();

/// Writes a line to standard error. A failure is ignored: there is no place to report it.
void tell(const std::string& line) noexcept;

/// Flushes standard output. Throws InputError when not everything could be written.
void finish_standard_output();
bool standard_output_failed();

}  // namespace canproof::host
