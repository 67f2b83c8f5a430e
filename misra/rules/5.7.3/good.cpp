// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged: a path a\b within a comment joins no lines.
int later();
