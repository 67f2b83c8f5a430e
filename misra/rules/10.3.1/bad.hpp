// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
namespace {  // flagged
inline constexpr int step{1};
}
