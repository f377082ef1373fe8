#include "foreign.h"

#include <ctype.h>
#include <string.h>
#include <strings.h>

struct beginning {
    const char *bytes, *what;
};

static const struct beginning texts[] = {
    {"*Heading", "an input deck of Abaqus or CalculiX"},
    {"*Node", "an input deck of Abaqus or CalculiX"},
    {"*Part", "an input deck of Abaqus or CalculiX"},
    {"*Include", "an input deck of Abaqus or CalculiX"},
    {"*Keyword", "an input deck of LS-DYNA"},
    {"$MeshFormat", "a mesh of Gmsh"},
    {"***tesr", "a raster tessellation of Neper"},
    {"***tess", "a tessellation of Neper"},
    {"**", "an input deck of Abaqus, CalculiX or LS-DYNA"},
    {"# vtk DataFile", "a legacy VTK file"},
    {"<VTKFile", "a VTK file"},
    {"<?xml", "an XML file"},
    {"NRRD", "an NRRD image"},
    {"solid", "an STL surface"},
    {"ply", "a PLY surface"},
    {"BEGIN BULK", "a Nastran deck"},
    {"SOL ", "a Nastran deck"},
    {"Channel Text File", "an EBSD map (.ctf)"},
    {"# TEM_PIXperUM", "an EBSD map (.ang)"},
    {"LAMMPS", "a data file of LAMMPS"},
};

static const struct beginning binaries[] = {
    {"\x89PNG", "a PNG image"},
    {"II*", "a TIFF image"},
    {"MM", "a TIFF image"},
    {"\x1f\x8b", "a gzip file"},
    {"PK\x03\x04", "a ZIP archive"},
    {"ply", "a PLY surface"},
    {"NRRD", "an NRRD image"},
    {"$MeshFormat", "a mesh of Gmsh"},
    {"# vtk DataFile", "a legacy VTK file"},
    {"<VTKFile", "a VTK file"},
    {"<?xml", "an XML file"},
};

static const char *find(const struct beginning *all, size_t n, const char *bytes, size_t count)
{
    for (size_t i = 0; i < n; i++) {
        const size_t length = strlen(all[i].bytes);
        if (length <= count && strncasecmp(bytes, all[i].bytes, length) == 0) return all[i].what;
    }
    return NULL;
}

const char *foreign_format(const unsigned char *bytes, size_t count)
{
    size_t start = 0;
    const char *what =
        find(binaries, sizeof binaries / sizeof *binaries, (const char *)bytes, count);
    while (start < count && isspace(bytes[start])) start++;
    return what ? what
                : find(texts, sizeof texts / sizeof *texts, (const char *)bytes + start,
                       count - start);
}
