// SPDX-License-Identifier: Apache-2.0
// One broken register and the fault that it must cause.
#pragma once

#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "tests/host/register/small_register.hpp"

namespace canproof::host::test {

struct Broken {
    std::string name;
    std::string file;  ///< name of a file of the small register, which is replaced or added
    std::string text;
    unsigned line;
    std::string what;  ///< text that the fault must contain
    std::string fix;
};

inline void PrintTo(const Broken& broken, std::ostream* out) {
    *out << broken.name;
}

inline std::string case_name(const testing::TestParamInfo<Broken>& info) {
    return info.param.name;
}

/// A register with one fault: the fault is reported with its line, its reason and its fix.
class BrokenRegister : public testing::TestWithParam<Broken> {};

}  // namespace canproof::host::test
