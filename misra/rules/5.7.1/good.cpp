// Nothing here may be flagged.
/* outer */
int after();
