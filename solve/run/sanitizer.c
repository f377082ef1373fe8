/* sanitizer.c - what Open MPI keeps until the end is no leak of ours (builds with SANITIZE=1 only).
 *
 * It allocates at start and end without freeing, and unloads its plugins, so that their frames can
 * no longer be told by name: their unloading is put off, and tests/sanitizer.supp names the
 * libraries. */
#include <mpi.h>

#ifdef HS_SANITIZE

#include <dlfcn.h>
#include <sanitizer/lsan_interface.h>

int MPI_Init(int *argc, char ***argv)
{
    __lsan_disable();
    int result = PMPI_Init(argc, argv);
    __lsan_enable();
    return result;
}

int MPI_Finalize(void)
{
    __lsan_disable();
    int result = PMPI_Finalize();
    __lsan_enable();
    return result;
}

int dlclose(void *handle)
{
    (void)handle;
    return 0;
}

#endif
