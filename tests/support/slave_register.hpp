// A slave that has every service of CiA 301, described as any device is: what the conformance suite talks to. Its
// register lies in tests/support/slave/spec and is compiled in; node-ID 5.
#pragma once

#include "host/register/register.hpp"
#include "host/register/spec_files.hpp"

namespace canproof::test {

/// The files of that register by their path.
const host::SpecFiles& slave_files();

/// The slave's part of that register; read once.
const host::Part& slave_part();

}  // namespace canproof::test
