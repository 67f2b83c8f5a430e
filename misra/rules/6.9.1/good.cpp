// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file: one alias throughout, and overloads that differ.
namespace aliases {
using Number = int;
int before(Number at);
int before(const Number at) { return at - 1; }
long before(const long at) { return at - 1; }
}  // namespace aliases
