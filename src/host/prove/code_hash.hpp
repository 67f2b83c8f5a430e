// SPDX-License-Identifier: Apache-2.0
// The hash of all code that a theorem can execute, with the prover. While it stays the same, so does the verdict.
#pragma once

#include <string>

#include "host/prove/program.hpp"

namespace canproof::host::prove {

/// Returns the SHA-256 of the functions and global variables that the theorem reaches, without names of files and
/// numbers of lines. The hash also covers this program, and the versions of LLVM and z3.
std::string code_hash(const Program& program, const std::string& theorem);

}  // namespace canproof::host::prove
