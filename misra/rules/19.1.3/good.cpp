// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
#define KNOWN_NAME 4
#if KNOWN_NAME > 3
#endif
int now();
