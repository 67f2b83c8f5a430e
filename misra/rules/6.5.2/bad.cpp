// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
static int helper() { return 1; }  // flagged
static int count{helper()};        // flagged
