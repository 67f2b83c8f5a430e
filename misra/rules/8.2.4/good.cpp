// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
using One = int (*)();
One keep(const One one) { return one; }
