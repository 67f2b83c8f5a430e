// Standard input, output and error of a command.
#pragma once

namespace canproof::host {

/// A standard descriptor that is closed is given to /dev/null, read only: no file that a command opens takes its place,
/// and what is written there is told as an error.
void keep_standard_descriptors();

/// Everything written to standard output is out. Throws InputError when it is not.
void finish_standard_output();
bool standard_output_failed();

}  // namespace canproof::host
