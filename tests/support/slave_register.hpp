// SPDX-License-Identifier: Apache-2.0
// A slave with every service of CiA 301, described in a requirements register like any device. The conformance suite
// tests this slave. Its register is in tests/support/slave/spec and is compiled into the test program; its node-ID is
// 5.
#pragma once

#include "host/register/register.hpp"
#include "host/register/spec_files.hpp"

namespace canproof::test {

/// Returns the files of the slave's requirements register, each under its path.
const host::SpecFiles& slave_files();

/// Returns the part of the requirements register that describes the slave. The files are read at the first call only.
const host::Part& slave_part();

}  // namespace canproof::test
