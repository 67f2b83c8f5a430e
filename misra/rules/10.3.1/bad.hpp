// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
namespace {  // flagged
inline constexpr int step{1};
}
