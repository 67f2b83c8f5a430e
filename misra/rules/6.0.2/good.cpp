// Nothing here may be flagged.
extern int row[4];
