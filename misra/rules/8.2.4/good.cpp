// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
using One = int (*)();
One keep(const One one) { return one; }
