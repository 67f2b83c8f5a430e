// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
namespace {
int called() { return 1; }
}  // namespace
int other() { return called(); }
