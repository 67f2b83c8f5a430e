int now();  // flagged
// SPDX-License-Identifier: Apache-2.0
