// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
namespace {
int nobody_calls() { return 1; }  // flagged
}  // namespace
int other() { return 2; }
