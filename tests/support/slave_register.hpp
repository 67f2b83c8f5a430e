// SPDX-License-Identifier: Apache-2.0
// A slave with every service of CiA 301, described like any device. The conformance suite tests it. Its requirements
// register is in tests/support/slave/spec and is compiled in; its node-ID is 5.
#pragma once

#include "host/register/register.hpp"
#include "host/register/spec_files.hpp"

namespace canproof::test {

/// Returns the files of the slave's register by their path.
const host::SpecFiles& slave_files();

/// Returns the part of the register that describes the slave. The register is read once.
const host::Part& slave_part();

}  // namespace canproof::test
