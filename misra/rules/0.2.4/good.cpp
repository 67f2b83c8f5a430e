// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
namespace {
int called() { return 1; }
}  // namespace
int other() { return called(); }
