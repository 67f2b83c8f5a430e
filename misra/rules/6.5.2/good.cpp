// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
namespace {
int helper() { return 1; }
}  // namespace
struct Row {
    static int first() { return helper(); }
};
