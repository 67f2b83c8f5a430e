// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
// A path a\b within a comment is no joint.
int later();
