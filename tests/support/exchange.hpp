// SPDX-License-Identifier: Apache-2.0
// A conversation on the bus as a table of requests with all their answers.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace canproof::test {

/// One frame to the device and the frames with which the device answers, written as in a candump log. With an empty
/// list, no answer is expected.
struct Exchange {
    std::string request;
    std::vector<std::string> answers;
};

/// Sends the request of each row and compares the answers. A failure message gives the number of the row in the table.
template <typename Bench>
void talk(Bench& bench, const std::vector<Exchange>& table) {
    int line = 0;
    for (const Exchange& row : table) {
        ++line;
        EXPECT_EQ(bench.send(row.request), row.answers) << "line " << line << ": " << row.request;
    }
}

}  // namespace canproof::test
