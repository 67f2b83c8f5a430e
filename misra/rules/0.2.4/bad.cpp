// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
namespace {
int nobody_calls() { return 1; }  // flagged
}  // namespace
int other() { return 2; }
