// SPDX-License-Identifier: Apache-2.0
// A limit on the descriptors of the process, for tests of what happens when there are no more.
#pragma once

#include <gtest/gtest.h>
#include <sys/resource.h>

namespace canproof::host::test {

class DescriptorLimit {
  public:
    /// Lets the process open only descriptors below `first_refused`, until the object is destroyed.
    explicit DescriptorLimit(int first_refused) {
        EXPECT_EQ(getrlimit(RLIMIT_NOFILE, &before_), 0);
        const rlimit now{static_cast<rlim_t>(first_refused), before_.rlim_max};
        EXPECT_EQ(setrlimit(RLIMIT_NOFILE, &now), 0);
    }
    ~DescriptorLimit() { EXPECT_EQ(setrlimit(RLIMIT_NOFILE, &before_), 0); }
    DescriptorLimit(const DescriptorLimit&) = delete;
    DescriptorLimit& operator=(const DescriptorLimit&) = delete;

  private:
    rlimit before_{};
};

}  // namespace canproof::host::test
