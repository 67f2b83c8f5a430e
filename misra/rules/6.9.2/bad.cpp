// Each marked line must be flagged.
int count();             // flagged
unsigned long total();   // flagged
