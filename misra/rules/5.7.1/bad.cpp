// Each marked line must be flagged.
/* outer
   /* inner // flagged
*/
int after();
