// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
int now();
// flagged: the next line is lost \
int later();
