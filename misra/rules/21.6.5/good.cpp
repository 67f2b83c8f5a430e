// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
struct Unknown;
void keep(Unknown* place);
