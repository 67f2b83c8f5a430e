// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
int spare(const int value) {
    int nobody{3};  // flagged
    return value;
}
namespace {
constexpr int unread{4};  // flagged
}
