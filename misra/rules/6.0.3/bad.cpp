// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
int everywhere();  // flagged
