// Every test program uses what is precompiled for this one.
