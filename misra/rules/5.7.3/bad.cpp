// Each marked line must be flagged.
int now();
// flagged: the next line is lost \
int later();
