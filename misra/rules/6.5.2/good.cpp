// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
namespace {
int helper() { return 1; }
}  // namespace
struct Row {
    static int first() { return helper(); }
};
