// Standard input, output and error of a command.
#pragma once

#include <string>

namespace canproof::host {

/// A standard descriptor that is closed is given to /dev/null, read only: no file that a command opens takes its place,
/// and what is written there is told as an error.
void keep_standard_descriptors();

/// Puts a line on standard error. A line that cannot be written is lost: there is nobody else to report it to, and it
/// ends no command.
void tell(const std::string& line) noexcept;

/// Everything written to standard output is out. Throws InputError when it is not.
void finish_standard_output();
bool standard_output_failed();

}  // namespace canproof::host
