// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
#if UNKNOWN_NAME > 3  // flagged
#endif
int now();
