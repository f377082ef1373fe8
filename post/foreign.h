/* foreign.h - files of other programs, known by their first bytes. */
#ifndef HS_FOREIGN_H
#define HS_FOREIGN_H

/* Dies (exit 2) with what the file is and what to do, where it is one of those known. */
void foreign_refuse(const char *bytes, long length, const char *name);

/* Dies (exit 2) at a file of HDF5 that no netCDF has written. */
void foreign_refuse_hdf5(const char *bytes, long length, const char *name);

#endif
