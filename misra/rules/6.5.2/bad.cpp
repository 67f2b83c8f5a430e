// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
static int helper() { return 1; }  // flagged
static int count{helper()};        // flagged
