// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
int spare(const int value) {
    int nobody{3};  // flagged
    return value;
}
namespace {
constexpr int unread{4};  // flagged
}
