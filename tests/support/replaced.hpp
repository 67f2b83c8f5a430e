// SPDX-License-Identifier: Apache-2.0
// Replaces part of a text.
#pragma once

#include <gtest/gtest.h>

#include <string>

namespace canproof::host::test {

/// Returns `text` with `to` in place of the first occurrence of `from`. The test fails when `text` does not contain
/// `from`.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

}  // namespace canproof::host::test
